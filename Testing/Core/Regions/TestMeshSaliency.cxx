// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/EigenVersions.h"
#include "Base/Errors.h"
#include "Regions/GaussianMeans.h"
#include "Regions/MeanCurvature.h"
#include "Regions/MeshSaliency.h"
#include "Support/RandomNumbers.h"
#include "Support/SampleSurfaces.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace
{

using namespace flattening;
using namespace flattening::samples;

Eigen::VectorXd areasOf(const TriangleMesh& mesh)
{
  return vertexAreas(mesh);
}

// A sphere with hills and dents, about 2,600 points for 4 levels.
TriangleMesh potato(int levels)
{
  TriangleMesh mesh = sphere(levels);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Eigen::RowVector3d x = mesh.Vertices.row(v);
    const double hills =
      0.1 * std::sin(5 * x[0] + 1) * std::cos(4 * x[1] + 0.3) + 0.05 * std::sin(9 * x[2]);
    mesh.Vertices.row(v) *= 30.0 * (1.0 + hills);
  }
  return mesh;
}

// Splits every face with x > 0 into three around its centroid, on the same surface: a finer half.
TriangleMesh refinedHalf(const TriangleMesh& mesh, int times)
{
  TriangleMesh refined = mesh;
  for (int time = 0; time < times; ++time)
  {
    std::vector<Eigen::RowVector3d> vertices;
    std::vector<Eigen::RowVector3i> faces;
    for (int v = 0; v < refined.vertexCount(); ++v)
    {
      vertices.emplace_back(refined.Vertices.row(v));
    }
    for (int f = 0; f < refined.faceCount(); ++f)
    {
      const Eigen::RowVector3i face = refined.Faces.row(f);
      const Eigen::RowVector3d centroid = refined.Vertices(face, flattening::all).colwise().mean();
      if (centroid[0] <= 0.0)
      {
        faces.push_back(face);
        continue;
      }
      const int middle = static_cast<int>(vertices.size());
      vertices.push_back(centroid);
      for (int k = 0; k < 3; ++k)
      {
        faces.emplace_back(face[k], face[(k + 1) % 3], middle);
      }
    }
    refined.Vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
    refined.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t v = 0; v < vertices.size(); ++v)
    {
      refined.Vertices.row(static_cast<Eigen::Index>(v)) = vertices[v];
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      refined.Faces.row(static_cast<Eigen::Index>(f)) = faces[f];
    }
  }
  return refined;
}

TEST(MeanCurvature, OfASphereAndATorusConverges)
{
  double before = 1.0;
  for (const int levels : { 3, 4, 5 })
  {
    TriangleMesh ball = sphere(levels);
    ball.Vertices *= 5.0;
    const Eigen::VectorXd measure = integratedMeanCurvature(ball);
    EXPECT_NEAR(measure.sum() / (4.0 * Pi * 5.0), 1.0, 4.0 / (1 << (2 * levels)));
    const double error =
      ((5.0 * measure.array() / areasOf(ball).array() - 1.0).abs() * areasOf(ball).array()).sum() /
      areasOf(ball).sum();
    std::printf("sphere of %d points: mean error of the mean curvature %.3f %%\n",
      ball.vertexCount(),
      100.0 * error);
    EXPECT_LT(error, before);
    before = 0.6 * error;
  }
  EXPECT_LT(before, 0.01);

  const TriangleMesh ring = torus(200, 60);
  const Eigen::VectorXd measure = integratedMeanCurvature(ring);
  const Eigen::VectorXd areas = areasOf(ring);
  double error = 0.0;
  for (int v = 0; v < ring.vertexCount(); ++v)
  {
    const double r = ring.Vertices.row(v).head<2>().norm(); // = 2 + cos / 2
    const double exact = (2.0 + 2.0 * (r - 2.0)) / (2.0 * 0.5 * r);
    error = std::max(error, std::abs(measure[v] / areas[v] - exact));
  }
  std::printf("torus of %d points: greatest error %.3f %% of 1 / 0.5\n", ring.vertexCount(), 50 * error);
  EXPECT_LT(error, 0.01 * 2.0);
}

TEST(MeanCurvature, OfAnEdgeOfACubeIsItsAngle)
{
  // Two squares at a right angle: length 2, angle pi / 2, on the two ends of the edge.
  const TriangleMesh edge = meshOf({ { 0, 0, 0 }, { 0, 0, 2 }, { 1, 0, 1 }, { 0, 1, 1 } },
    { { 0, 1, 2 }, { 1, 0, 3 } }); // outside is where x, y < 0
  const Eigen::VectorXd measure = integratedMeanCurvature(edge);
  EXPECT_NEAR(std::abs(measure[0]), 0.25 * 2.0 * 0.5 * Pi, 1e-14);
  EXPECT_EQ(measure[0], measure[1]);
  EXPECT_EQ(measure[2], 0.0);
}

// By the formula, in double precision.
Eigen::VectorXd directMeans(const WeightedPoints& points, double deviation)
{
  Eigen::VectorXd means(points.Positions.rows());
  for (Eigen::Index v = 0; v < means.size(); ++v)
  {
    const Eigen::ArrayXd d2 =
      (points.Positions.rowwise() - points.Positions.row(v)).rowwise().squaredNorm().array();
    const Eigen::ArrayXd g =
      (-0.5 * d2 / (deviation * deviation)).exp() * (d2 < 4 * deviation * deviation).cast<double>();
    means[v] = (g * points.Integral.array()).sum() / (g * points.Mass.array()).sum();
  }
  return means;
}

TEST(GaussianMeans, AreThoseOfTheFormula)
{
  const TriangleMesh mesh = potato(4);
  const WeightedPoints points{ mesh.Vertices, areasOf(mesh), integratedMeanCurvature(mesh) };
  for (const double deviation : { 1.0, 3.0, 6.0, 12.0 }) // the sphere's radius is 30
  {
    const Eigen::VectorXd exact = directMeans(points, deviation);
    const double scale = exact.cwiseAbs().maxCoeff();
    const Eigen::VectorXd alone = gaussianMeans(points, deviation, 0.0);
    EXPECT_LT((alone - exact).cwiseAbs().maxCoeff(), 1e-6 * scale) << deviation;
    const Eigen::VectorXd together = gaussianMeans(points, deviation, 1.0 / 3.0);
    const double greatest = (together - exact).cwiseAbs().maxCoeff() / scale;
    const double mean = (together - exact).cwiseAbs().mean() / scale;
    std::printf("deviation %4.0f: in cells, greatest error %.4f, mean %.5f of the greatest mean\n",
      deviation,
      greatest,
      mean);
    EXPECT_LT(greatest, 0.02);
    EXPECT_LT(mean, 0.004);
  }
}

// All of it written down once more, without any search structure.
Eigen::VectorXd directSaliency(const TriangleMesh& mesh, double unit, bool areaWeighted)
{
  const Eigen::VectorXd areas = areasOf(mesh);
  WeightedPoints points{ mesh.Vertices, areas, integratedMeanCurvature(mesh) };
  if (!areaWeighted)
  {
    points.Integral.array() /= areas.array();
    points.Mass.setOnes();
  }
  std::vector<std::set<int>> neighbours(mesh.vertexCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      neighbours[mesh.Faces(f, k)].insert(mesh.Faces(f, (k + 1) % 3));
      neighbours[mesh.Faces(f, k)].insert(mesh.Faces(f, (k + 2) % 3));
    }
  }
  Eigen::VectorXd saliency = Eigen::VectorXd::Zero(mesh.vertexCount());
  for (int i = 2; i <= 6; ++i)
  {
    Eigen::VectorXd s = (directMeans(points, i * unit) - directMeans(points, 2 * i * unit)).cwiseAbs();
    s /= s.maxCoeff();
    double sum = 0.0;
    int count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const bool isMaximum =
        std::all_of(neighbours[v].begin(), neighbours[v].end(), [&](int w) { return s[w] < s[v]; });
      if (isMaximum && s[v] < 1.0)
      {
        sum += s[v];
        ++count;
      }
    }
    saliency += std::pow(1.0 - sum / count, 2) * s;
  }
  return saliency;
}

TEST(MeshSaliency, IsThatOfADirectEvaluation)
{
  const TriangleMesh mesh = potato(4);
  MeshSaliencyOptions options;
  options.Unit = 1.2; // a few edges
  for (const bool areaWeighted : { true, false })
  {
    options.AreaWeighted = areaWeighted;
    const Eigen::VectorXd exact = directSaliency(mesh, options.Unit, areaWeighted);
    options.SampleSpacing = 0.0;
    const Eigen::VectorXd alone = meshSaliency(mesh, options).Saliency;
    EXPECT_LT((alone - exact).cwiseAbs().maxCoeff(), 1e-4 * exact.maxCoeff());
    options.SampleSpacing = MeshSaliencyOptions().SampleSpacing;
    const Eigen::VectorXd together = meshSaliency(mesh, options).Saliency;
    const double greatest = (together - exact).cwiseAbs().maxCoeff() / exact.maxCoeff();
    const double mean = (together - exact).cwiseAbs().mean() / exact.maxCoeff();
    std::printf("in cells: greatest error %.4f, mean %.5f of the greatest saliency\n", greatest, mean);
    EXPECT_LT(greatest, 0.05);
    EXPECT_LT(mean, 0.02);
  }
}

TEST(MeshSaliency, DoesNotDependOnThreadsOrUnits)
{
  const TriangleMesh mesh = potato(4);
  const Eigen::VectorXd reference = meshSaliency(mesh).Saliency;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(meshSaliency(mesh).Saliency, reference);
  }
  TriangleMesh metres = mesh;
  metres.Vertices /= 1024.0;
  EXPECT_LT((meshSaliency(metres).Saliency - reference).cwiseAbs().maxCoeff(), 1e-4);
}

// The same surface with one half finer: with areas as weights it stays the same, without it does not.
TEST(MeshSaliency, WeightedByAreaDoesNotDependOnTheTriangles)
{
  const TriangleMesh coarse = potato(5);
  const TriangleMesh fine = refinedHalf(coarse, 2);
  double error[2];
  for (const bool areaWeighted : { false, true })
  {
    MeshSaliencyOptions options;
    options.Unit = 0.8;
    options.AreaWeighted = areaWeighted;
    const Eigen::VectorXd a = meshSaliency(coarse, options).PerScale[2];
    const Eigen::VectorXd b = meshSaliency(fine, options).PerScale[2].head(a.size());
    error[areaWeighted] = (a - b).norm() / a.norm();
  }
  std::printf(
    "half of the surface nine times as fine: S changes by %.1f %% unweighted, %.2f %% by area\n",
    100 * error[0],
    100 * error[1]);
  EXPECT_LT(error[1], 0.1 * error[0]);
}

TEST(MeshSaliency, NothingStandsOutOnASphere)
{
  // The curvature is 1, to the accuracy of the mesh. The ball of the smallest scale is three edges wide.
  const MeshSaliency saliency = meshSaliency(sphere(6), { 0.02 });
  for (const Eigen::VectorXd& scale : saliency.PerScale)
  {
    EXPECT_TRUE(scale.allFinite());
    EXPECT_LT(scale.maxCoeff(), 0.02);
  }
  EXPECT_TRUE(meshSaliency(tetrahedron(), { 0.05 }).Saliency.allFinite());
}

TEST(MeshSaliency, RegionsAreConnectedAndSortedByArea)
{
  const TriangleMesh mesh = sphere(4);
  // Three caps of different size.
  const std::vector<std::pair<Eigen::RowVector3d, double>> caps = {
    { { 0, 0, 1 }, 0.2 }, { { 1, 0, 0 }, 0.5 }, { { -1, 0, 0 }, 0.35 }
  };
  Eigen::VectorXd values = Eigen::VectorXd::Zero(mesh.vertexCount());
  std::vector<int> expected(mesh.vertexCount(), 0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    for (std::size_t c = 0; c < caps.size(); ++c)
    {
      if (std::acos(std::min(1.0, mesh.Vertices.row(v).dot(caps[c].first))) <= caps[c].second)
      {
        values[v] = 1.0 + 0.1 * c;
        expected[v] = c == 0 ? 3 : static_cast<int>(c);
      }
    }
  }
  const double all = std::numeric_limits<double>::max();
  EXPECT_EQ(salientRegions(mesh, values, 0.9, 0.0, all), expected);
  // Areas of caps: 2 pi (1 - cos): 0.125, 0.769, 0.381.
  for (int& region : expected)
  {
    region = region == 3 ? 0 : region;
  }
  EXPECT_EQ(salientRegions(mesh, values, 0.9, 0.25, all), expected);
  for (int& region : expected)
  {
    region = region == 2 ? 1 : 0;
  }
  EXPECT_EQ(salientRegions(mesh, values, 0.9, 0.25, 0.5), expected);
}

TEST(MeshSaliency, PercentilesAreOfTheArea)
{
  const TriangleMesh mesh = sphere(4);
  const Eigen::VectorXd height = mesh.Vertices.col(2);
  for (const double share : { 0.1, 0.5, 0.9 }) // Archimedes: area is proportional to height
  {
    EXPECT_NEAR(areaPercentile(mesh, height, share), 2.0 * share - 1.0, 0.02);
  }
}

TEST(MeshSaliency, RefusesWhatMakesNoSense)
{
  const TriangleMesh mesh = potato(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double unit : { -1.0, nan, std::numeric_limits<double>::infinity(), 10.0, 1e-9 })
  {
    EXPECT_THROW(meshSaliency(mesh, { unit }), InvalidInput) << unit;
  }
  EXPECT_THROW(meshSaliency(mesh, { 0.0, 0 }), InvalidInput);
  EXPECT_THROW(meshSaliency(mesh, { 0.0, 21 }), InvalidInput);
  TriangleMesh broken = mesh;
  broken.Vertices(3, 1) = nan;
  EXPECT_THROW(meshSaliency(broken), InvalidInput);
  TriangleMesh point = mesh;
  point.Vertices.setZero();
  EXPECT_THROW(meshSaliency(point), InvalidInput);
}

TEST(MeshSaliency, CanBeStopped)
{
  EXPECT_THROW(
    meshSaliency(potato(3), {}, [](double fraction, const char*) { return fraction < 0.5; }), Cancelled);
}

} // namespace
