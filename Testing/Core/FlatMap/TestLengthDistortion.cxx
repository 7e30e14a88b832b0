// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "FlatMap/LengthDistortion.h"
#include "Support/SampleSurfaces.h"

#include <AnalyticSurfaces.h>

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace flattening;
using namespace flattening::samples;

namespace
{

TriangleMesh flatGrid(int n)
{
  return liftedGrid(n, [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); });
}

TriangleMesh bumps(int n)
{
  return liftedGrid(n,
    [](double x, double y) { return Eigen::Vector3d(x, y, 0.2 * std::sin(7 * x) * std::cos(9 * y)); });
}

LengthOptions within(double radius, int samples = 60)
{
  LengthOptions options;
  options.Radius = radius;
  options.Samples = samples;
  return options;
}

// The mean error of ratios at the scale that makes it least, by trying scales.
double leastMeanError(const std::vector<double>& ratios, const std::vector<double>& weights)
{
  double weight = 0.0;
  for (const double w : weights)
  {
    weight += w;
  }
  double least = std::numeric_limits<double>::infinity();
  for (double scale = 0.2; scale < 5.0; scale *= 1.0005)
  {
    double error = 0.0;
    for (std::size_t i = 0; i < ratios.size(); ++i)
    {
      error += weights[i] * std::abs(scale * ratios[i] - 1.0);
    }
    least = std::min(least, 100.0 * error / weight);
  }
  return least;
}

void expectNoError(const LengthErrors& errors)
{
  EXPECT_LT(errors.Mean, 1e-9);
  EXPECT_LT(errors.StandardError, 1e-9);
  EXPECT_LT(errors.P95, 1e-9);
}

// The plane, turned and three times as large on the map.
TEST(LengthDistortion, ThePlaneHasNoErrors)
{
  const TriangleMesh mesh = flatGrid(20);
  Points2 flat(mesh.vertexCount(), 2);
  flat.col(0) = -3.0 * mesh.Vertices.col(1);
  flat.col(1) = 3.0 * mesh.Vertices.col(0);
  const LengthDistortion lengths = measureLengths(mesh, flat, within(0.3));
  expectNoError(lengths.Local);
  expectNoError(lengths.WithinMap);
  expectNoError(lengths.Global);
  EXPECT_LT(lengths.RingDistanceError, 1e-9);
  EXPECT_NEAR(lengths.Local.Scale, 1.0 / 3.0, 1e-12);
  EXPECT_LT(lengths.VertexErrors.maxCoeff(), 1e-9);
  EXPECT_GE(lengths.VertexErrors.minCoeff(), 0.0) << "some vertex has no source near it";
}

TEST(LengthDistortion, FoldedPaperHasNoErrors)
{
  const TriangleMesh paper = rectangleGrid(21, 21, 1.5);
  TriangleMesh folded = paper;
  for (int v = 0; v < folded.vertexCount(); ++v)
  {
    const double beyond = std::max(paper.Vertices(v, 0), 0.0);
    folded.Vertices(v, 0) -= 1.8 * beyond; // back over itself
    folded.Vertices(v, 2) += 0.6 * beyond;
  }
  const LengthDistortion lengths = measureLengths(folded, paper.Vertices.leftCols<2>(), within(0.8));
  expectNoError(lengths.Local);
  expectNoError(lengths.Global);
}

// A prism of 24 sides that was cut open along an edge, and its development. Lengths within the map are
// right; across the seam, a length near 0 on the surface is the whole circumference on the map.
TEST(LengthDistortion, CylinderWithASeam)
{
  const int n = 24;
  const double side = 2.0 * std::sin(Pi / n);
  TriangleMesh mesh = rectangleGrid(n + 1, 17, n * side);
  mesh.Vertices.col(1) *= 4.0; // in a low cylinder nearly half of the lengths cross the seam
  const Points2 flat = mesh.Vertices.leftCols<2>();
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double angle = 2.0 * Pi * (v % (n + 1) % n) / n;
    mesh.Vertices.row(v) << std::cos(angle), std::sin(angle), flat(v, 1);
  }
  const LengthDistortion lengths = measureLengths(mesh, flat, within(1.0, 400));
  expectNoError(lengths.WithinMap);
  EXPECT_LT(lengths.RingDistanceError, 1e-9);
  EXPECT_GT(lengths.Local.Mean, 20.0);
  EXPECT_GT(lengths.Global.Mean, 5.0);
  EXPECT_NEAR(lengths.Local.Scale, 1.0, 1e-9) << "most local lengths do not cross the seam";
  // Far from the seam all lengths are right.
  EXPECT_LT(lengths.VertexErrors[8 * (n + 1) + n / 2], 1e-9);
  EXPECT_GT(lengths.VertexErrors[8 * (n + 1)], 50.0);
}

// A cone that was cut from its apex to its rim, and its development, a sector of 260 degrees, which is
// not convex: the shortest path within it between points beside the seam goes through the apex.
TEST(LengthDistortion, ConeWithASeam)
{
  const int spokes = 40;
  const int rings = 12;
  const double angle = 260.0 / 180.0 * Pi / spokes;
  const double slope = std::sin(angle / 2.0) / std::sin(Pi / spokes); // of radius against length
  TriangleMesh mesh;
  mesh.Vertices = Points3::Zero(1 + rings * (spokes + 1), 3);
  Points2 flat = Points2::Zero(mesh.Vertices.rows(), 2);
  mesh.Faces.resize(spokes + 2 * spokes * (rings - 1), 3);
  const auto at = [](int ring, int spoke) { return 1 + (ring - 1) * (spokes + 1) + spoke; };
  int f = 0;
  for (int i = 1; i <= rings; ++i)
  {
    const double length = static_cast<double>(i) / rings;
    for (int j = 0; j <= spokes; ++j)
    {
      const double around = 2.0 * Pi * (j % spokes) / spokes;
      mesh.Vertices.row(at(i, j)) << slope * length * std::cos(around),
        slope * length * std::sin(around), -std::sqrt(1.0 - slope * slope) * length;
      flat.row(at(i, j)) << length * std::cos(j * angle), length * std::sin(j * angle);
      if (j < spokes && i == 1)
      {
        mesh.Faces.row(f++) << 0, at(1, j), at(1, j + 1);
      }
      else if (j < spokes)
      {
        mesh.Faces.row(f++) << at(i - 1, j), at(i, j), at(i, j + 1);
        mesh.Faces.row(f++) << at(i - 1, j), at(i, j + 1), at(i - 1, j + 1);
      }
    }
  }
  for (const double radius : { 0.4, 3.0 })
  {
    const LengthDistortion lengths = measureLengths(mesh, flat, within(radius));
    expectNoError(lengths.WithinMap);
    EXPECT_GT(lengths.Local.Mean, 1.0);
    EXPECT_GT(lengths.Global.Mean, 5.0);
  }
}

// The map x -> 2 x: a length in direction t becomes root(4 cos^2 t + sin^2 t) times as long, and the
// directions are even. Near the boundary they are not quite: the boundary
// takes part of the directions off.
TEST(LengthDistortion, AStretchHasTheErrorOfAllDirections)
{
  const TriangleMesh mesh = flatGrid(60);
  Points2 flat = mesh.Vertices.leftCols<2>();
  flat.col(0) *= 2.0;
  std::vector<double> ratios;
  for (int i = 0; i < 2000; ++i)
  {
    const double t = Pi * (i + 0.5) / 2000;
    ratios.push_back(std::hypot(2.0 * std::cos(t), std::sin(t)));
  }
  const double expected = leastMeanError(ratios, std::vector<double>(ratios.size(), 1.0));
  const LengthDistortion lengths = measureLengths(mesh, flat, within(0.12, 400));
  EXPECT_NEAR(lengths.Local.Mean, expected, 0.02 * expected);
  EXPECT_EQ(lengths.WithinMap.Mean, lengths.Local.Mean) << "there is no seam, and the map is convex";
  EXPECT_LT(lengths.Local.P95, 100.0);
  EXPECT_GT(lengths.Local.P95, lengths.Local.Mean);
}

// Lambert's equal-area projection of the hemisphere: every length is known on both sides. All pairs of
// vertices are an independent way to the mean over the surface.
TEST(LengthDistortion, LambertsProjectionOfTheHemisphere)
{
  const analytic::SurfaceOfRevolution hemisphere = analytic::sphericalCap(0.5 * Pi);
  const analytic::RevolutionMesh mesh = analytic::sunflowerMesh(hemisphere, 600);
  const int n = mesh.Mesh.vertexCount();
  Points2 flat(n, 2);
  for (int v = 0; v < n; ++v)
  {
    flat.row(v) = hemisphere.brenierRadius(mesh.Parameter[v]) *
                  Eigen::RowVector2d(std::cos(mesh.Angle[v]), std::sin(mesh.Angle[v]));
  }
  const Eigen::VectorXd areas = vertexAreas(mesh.Mesh);
  for (const double radius : { 0.5, 10.0 })
  {
    std::vector<double> ratios;
    std::vector<double> weights;
    for (int v = 0; v < n; ++v)
    {
      const std::size_t first = weights.size();
      double weight = 0.0;
      for (int w = 0; w < n; ++w)
      {
        const Eigen::Vector3d a = mesh.Mesh.Vertices.row(v);
        const Eigen::Vector3d b = mesh.Mesh.Vertices.row(w);
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
        if (v != w && angle <= radius)
        {
          ratios.push_back((flat.row(v) - flat.row(w)).norm() / angle);
          weights.push_back(areas[w]);
          weight += areas[w];
        }
      }
      for (std::size_t i = first; i < weights.size(); ++i)
      {
        weights[i] *= areas[v] / weight;
      }
    }
    std::vector<double> fewerRatios; // every 17th pair: trying scales takes long
    std::vector<double> fewerWeights;
    for (std::size_t i = 0; i < ratios.size(); i += 17)
    {
      fewerRatios.push_back(ratios[i]);
      fewerWeights.push_back(weights[i]);
    }
    const double expected = leastMeanError(fewerRatios, fewerWeights);
    const LengthDistortion lengths = measureLengths(mesh.Mesh, flat, within(radius, n));
    EXPECT_NEAR(lengths.Local.Mean, expected, 0.03 * expected) << radius;
    EXPECT_GT(expected, 3.0);
    if (radius > Pi)
    {
      EXPECT_NEAR(lengths.Global.Mean, expected, 4.0 * lengths.Global.StandardError + 0.02 * expected);
    }
  }
}

TEST(LengthDistortion, StandardErrorsTellHowFarOffFewSourcesAre)
{
  const TriangleMesh mesh = bumps(20);
  Points2 flat = mesh.Vertices.leftCols<2>();
  flat.col(0) = flat.col(0).array().square() + flat.col(0).array();
  const LengthErrors few = measureLengths(mesh, flat, within(0.3, 30)).Local;
  const LengthErrors all = measureLengths(mesh, flat, within(0.3, 1000000)).Local;
  EXPECT_GT(few.StandardError, 0.1);
  EXPECT_LT(std::abs(few.Mean - all.Mean), 3.0 * few.StandardError);
  EXPECT_LT(all.StandardError, 0.3 * few.StandardError);
}

TEST(LengthDistortion, ThreadsAndUnitsChangeNothing)
{
  const TriangleMesh mesh = bumps(24);
  const Points2 flat = mesh.Vertices.leftCols<2>();
  const LengthDistortion first = measureLengths(mesh, flat, within(0.4));
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const LengthDistortion again = measureLengths(mesh, flat, within(0.4));
    EXPECT_EQ(again.Local.Mean, first.Local.Mean);
    EXPECT_EQ(again.Global.StandardError, first.Global.StandardError);
    EXPECT_EQ(again.WithinMap.P95, first.WithinMap.P95);
    EXPECT_EQ(again.RingDistanceError, first.RingDistanceError);
    EXPECT_EQ(again.VertexErrors, first.VertexErrors);
  }
  const double unit = std::ldexp(1.0, 700);
  TriangleMesh huge = mesh;
  huge.Vertices *= unit;
  const LengthDistortion scaled = measureLengths(huge, flat, within(0.4 * unit));
  EXPECT_EQ(scaled.Local.Mean, first.Local.Mean);
  EXPECT_EQ(scaled.Local.Scale, first.Local.Scale * unit);
}

TEST(LengthDistortion, ProgressGrowsAndCanCancel)
{
  const TriangleMesh mesh = bumps(24);
  const Points2 flat = mesh.Vertices.leftCols<2>();
  double last = 0.0;
  int calls = 0;
  measureLengths(mesh,
    flat,
    within(0.4),
    [&](double fraction, const char*)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.0);
      last = fraction;
      ++calls;
      return true;
    });
  EXPECT_GT(calls, 20);
  EXPECT_GT(last, 0.5);
  for (const int stopAt : { 1, calls / 4 })
  {
    int count = 0;
    EXPECT_THROW(
      measureLengths(mesh, flat, within(0.4), [&](double, const char*) { return ++count < stopAt; }),
      Cancelled);
    EXPECT_EQ(count, stopAt);
  }
}

TEST(LengthDistortion, BadOptions)
{
  const TriangleMesh mesh = flatGrid(6);
  const Points2 flat = mesh.Vertices.leftCols<2>();
  const auto message = [&](const LengthOptions& options)
  { return messageOf<InvalidInput>([&] { measureLengths(mesh, flat, options); }); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(message(within(0.0)), "the LengthRadius is 0: set it to a positive length"));
  EXPECT_TRUE(contains(message(within(-1.0)), "the LengthRadius is -1"));
  EXPECT_TRUE(contains(message(within(nan)), "the LengthRadius is nan"));
  EXPECT_TRUE(contains(message(within(1.0 / 0.0)), "the LengthRadius is inf"));
  EXPECT_TRUE(contains(message(within(1.0, 0)), "LengthSamples is 0: a standard error needs 2"));
  EXPECT_TRUE(contains(message(within(1.0, 1)), "LengthSamples is 1"));
  EXPECT_TRUE(contains(message(within(1e-6)), "as near to each other as the LengthRadius of 1e-06"));
  Points2 infinite = flat;
  infinite(3, 0) = 1.0 / 0.0;
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { measureLengths(mesh, infinite); }), "not finite"));
}

// A map that is pressed to a line has lengths, and a collapsed one has none.
TEST(LengthDistortion, DegenerateMapsGiveFiniteNumbers)
{
  const TriangleMesh mesh = flatGrid(8);
  Points2 flat = mesh.Vertices.leftCols<2>();
  flat.col(1).setZero();
  for (int i = 0; i < 2; ++i)
  {
    const LengthDistortion lengths = measureLengths(mesh, flat, within(0.5));
    EXPECT_TRUE(std::isfinite(lengths.Local.Mean));
    EXPECT_TRUE(std::isfinite(lengths.WithinMap.P95));
    EXPECT_TRUE(std::isfinite(lengths.Global.StandardError));
    EXPECT_TRUE(lengths.VertexErrors.allFinite());
    flat.setZero();
  }
}

} // namespace
