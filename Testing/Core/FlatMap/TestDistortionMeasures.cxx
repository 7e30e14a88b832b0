// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "FlatMap/DistortionMeasures.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace
{

using namespace flattening;

constexpr double Pi = 3.14159265358979323846;

FaceMatrix gridFaces(int n)
{
  FaceMatrix faces(2 * n * n, 3);
  const auto vertex = [n](int i, int j) { return i * (n + 1) + j; };
  Eigen::Index f = 0;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      faces.row(f++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
      faces.row(f++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  }
  return faces;
}

// A grid on [0,1]^2 whose inner vertices are moved at random, without flips.
Points2 irregularGrid(int n)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.2 / n, 0.2 / n);
  Points2 positions((n + 1) * (n + 1), 2);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const bool inner = i > 0 && i < n && j > 0 && j < n;
      positions.row(i * (n + 1) + j) << double(i) / n + (inner ? shift(random) : 0.0),
        double(j) / n + (inner ? shift(random) : 0.0);
    }
  }
  return positions;
}

// The flat positions under a linear map, placed somewhere in space by a rotation and a translation.
TriangleMesh liftedBy(const Eigen::Matrix2d& map, const Points2& flat, const FaceMatrix& faces)
{
  const Eigen::Matrix3d rotation =
    (Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized())).toRotationMatrix();
  TriangleMesh surface;
  surface.Faces = faces;
  surface.Vertices.resize(flat.rows(), 3);
  for (Eigen::Index v = 0; v < flat.rows(); ++v)
  {
    const Eigen::Vector2d p = map * flat.row(v).transpose();
    surface.Vertices.row(v) =
      (rotation * Eigen::Vector3d(p.x(), p.y(), 0) + Eigen::Vector3d(3, -5, 9)).transpose();
  }
  return surface;
}

TriangleMesh bumpOver(const Points2& flat, const FaceMatrix& faces)
{
  TriangleMesh surface;
  surface.Faces = faces;
  surface.Vertices.resize(flat.rows(), 3);
  for (Eigen::Index v = 0; v < flat.rows(); ++v)
  {
    const double x = flat(v, 0);
    const double y = flat(v, 1);
    surface.Vertices.row(v) << 30 * x, 30 * y + 5 * x * x, 12 * std::sin(5 * x) * std::cos(4 * y);
  }
  return surface;
}

void expectAll(const Eigen::VectorXd& values, double expected, double tolerance, const char* what)
{
  EXPECT_LE((values.array() - expected).abs().maxCoeff(), tolerance) << what;
}

template <typename Body>
std::string invalidInputOf(const Body& body)
{
  try
  {
    body();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  ADD_FAILURE() << "no InvalidInput";
  return {};
}

TEST(DistortionMeasures, IdentityIsPerfect)
{
  const FaceMatrix faces = gridFaces(6);
  const Points2 flat = irregularGrid(6);
  const FaceDistortion d = measureDistortion(liftedBy(Eigen::Matrix2d::Identity(), flat, faces), flat);
  expectAll(d.AreaRatio, 1.0, 1e-13, "AreaRatio");
  expectAll(d.AreaDistortion, 0.0, 1e-13, "AreaDistortion");
  expectAll(d.AngleDistortion, 0.0, 1e-13, "AngleDistortion");
  expectAll(d.BeltramiMagnitude, 0.0, 1e-13, "BeltramiMagnitude");
  expectAll(d.StretchL2, 1.0, 1e-13, "StretchL2");
  expectAll(d.SymmetricDirichlet, 4.0, 1e-12, "SymmetricDirichlet");
  expectAll(d.AngleError, 0.0, 1e-11, "AngleError");
  EXPECT_EQ(std::count(d.Flipped.begin(), d.Flipped.end(), 1), 0);
  EXPECT_NEAR(d.FlatArea.sum(), 1.0, 1e-14);
  EXPECT_NEAR(d.SurfaceArea.sum(), 1.0, 1e-13);
}

// A linear map with singular values 3 and 0.75: K = 4; after equalising the areas they are 2 and 1/2.
TEST(DistortionMeasures, AffineMap)
{
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  Eigen::Matrix2d left;
  left << c, -s, s, c;
  Eigen::Matrix2d right;
  right << s, c, -c, s;
  const Eigen::Matrix2d map = left * Eigen::Vector2d(3.0, 0.75).asDiagonal() * right;
  const FaceMatrix faces = gridFaces(6);
  const Points2 flat = irregularGrid(6);
  const FaceDistortion d = measureDistortion(liftedBy(map, flat, faces), flat);
  expectAll(d.AreaDistortion, 0.0, 1e-12, "AreaDistortion");
  expectAll(d.AngleDistortion, std::log(4.0), 1e-12, "AngleDistortion");
  expectAll(d.BeltramiMagnitude, 0.6, 1e-12, "BeltramiMagnitude");
  expectAll(d.StretchL2, std::sqrt((4.0 + 0.25) / 2.0), 1e-12, "StretchL2");
  expectAll(d.SymmetricDirichlet, 2.0 * (4.0 + 0.25), 1e-11, "SymmetricDirichlet");
}

// Two right triangles, not connected, the surface twice and four times their size: ratios of areas 4
// : 16.
TEST(DistortionMeasures, ConformalScaling)
{
  TriangleMesh surface;
  surface.Faces.resize(2, 3);
  surface.Faces << 0, 1, 2, 3, 4, 5;
  Points2 flat(6, 2);
  flat << 0, 0, 1, 0, 0, 1, 5, 5, 6, 5, 5, 6;
  surface.Vertices.resize(6, 3);
  surface.Vertices << 0, 0, 0, 0, 2, 0, 0, 0, 2, 1, 1, 1, 1, 5, 1, 1, 1, 5;
  const FaceDistortion d = measureDistortion(surface, flat);
  EXPECT_NEAR(d.AreaRatio[0], 0.5 / 0.2, 1e-14);
  EXPECT_NEAR(d.AreaRatio[1], 0.5 / 0.8, 1e-14);
  EXPECT_NEAR(d.AreaDistortion[0], std::log(0.4), 1e-14);
  EXPECT_NEAR(d.AreaDistortion[1], std::log(1.6), 1e-14);
  EXPECT_NEAR(d.StretchL2[1], std::sqrt(1.6), 1e-14);
  EXPECT_NEAR(d.SymmetricDirichlet[1], 2 * 1.6 + 2 / 1.6, 1e-14);
  expectAll(d.AngleDistortion, 0.0, 1e-15, "AngleDistortion");
  expectAll(d.AngleError, 0.0, 1e-13, "AngleError");
}

TEST(DistortionMeasures, MirroredIsAllFlippedAndElseTheSame)
{
  const FaceMatrix faces = gridFaces(6);
  const Points2 flat = irregularGrid(6);
  const TriangleMesh surface = bumpOver(flat, faces);
  Points2 mirrored = flat;
  mirrored.col(0) *= -1.0;
  const FaceDistortion d = measureDistortion(surface, flat);
  const FaceDistortion m = measureDistortion(surface, mirrored);
  EXPECT_EQ(std::count(m.Flipped.begin(), m.Flipped.end(), 1), faces.rows());
  EXPECT_LE((m.AreaDistortion - d.AreaDistortion).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LE((m.AngleDistortion - d.AngleDistortion).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LE((m.AngleError - d.AngleError).cwiseAbs().maxCoeff(), 1e-12);
}

// A vertex dragged over its neighbours folds faces over others; the boundary encloses what it did.
TEST(DistortionMeasures, FoldedFacesLeaveTheEnclosedAreaAlone)
{
  const FaceMatrix faces = gridFaces(6);
  const Points2 flat = irregularGrid(6);
  const TriangleMesh surface = liftedBy(Eigen::Matrix2d::Identity(), flat, faces);
  Points2 folded = flat;
  const int inner = 3 * 7 + 3;
  folded.row(inner) << 0.9, 0.9;
  const FaceDistortion d = measureDistortion(surface, folded);
  ASSERT_GT(std::count(d.Flipped.begin(), d.Flipped.end(), 1), 0);
  EXPECT_NEAR(d.TotalFlatArea, 1.0, 1e-14);
  EXPECT_GT(d.FlatArea.cwiseAbs().sum(), 1.05) << "the fold is too small to be seen";
  EXPECT_GT(d.AreaRatio.minCoeff(), 0.0);
}

// Another route to every measure: the Jacobian's SVD by Eigen, areas by Heron, angles by the law of
// cosines.
TEST(DistortionMeasures, AgreesWithIndependentComputation)
{
  const int n = 8;
  const FaceMatrix faces = gridFaces(n);
  const Points2 flat = irregularGrid(n);
  const TriangleMesh surface = bumpOver(flat, faces);
  const FaceDistortion d = measureDistortion(surface, flat);

  const auto lengths = [](const auto& points, const Eigen::RowVector3i& face)
  {
    return Eigen::Array3d((points.row(face[1]) - points.row(face[2])).norm(),
      (points.row(face[2]) - points.row(face[0])).norm(),
      (points.row(face[0]) - points.row(face[1])).norm());
  };
  const auto heron = [](const Eigen::Array3d& l)
  {
    const double h = 0.5 * l.sum();
    return std::sqrt(h * (h - l[0]) * (h - l[1]) * (h - l[2]));
  };
  const auto angle = [](const Eigen::Array3d& l, int k)
  {
    const double a = l[(k + 1) % 3];
    const double b = l[(k + 2) % 3];
    return std::acos((a * a + b * b - l[k] * l[k]) / (2 * a * b)) * 180.0 / Pi;
  };
  double surfaceTotal = 0.0;
  double flatTotal = 0.0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    surfaceTotal += heron(lengths(surface.Vertices, faces.row(f)));
    flatTotal += heron(lengths(flat, faces.row(f)));
  }
  EXPECT_NEAR(flatTotal, 1.0, 1e-10);

  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    Eigen::Matrix<double, 3, 2> surfaceEdges;
    Eigen::Matrix2d flatEdges;
    for (int k = 0; k < 2; ++k)
    {
      surfaceEdges.col(k) = surface.Vertices.row(faces(f, k + 1)) - surface.Vertices.row(faces(f, 0));
      flatEdges.col(k) = flat.row(faces(f, k + 1)) - flat.row(faces(f, 0));
    }
    const Eigen::Matrix<double, 3, 2> jacobian =
      std::sqrt(flatTotal / surfaceTotal) * surfaceEdges * flatEdges.inverse();
    const Eigen::Vector2d sigma =
      Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>>(jacobian).singularValues();
    const double squares = sigma.squaredNorm();
    EXPECT_NEAR(d.AreaDistortion[f], std::log(sigma[0] * sigma[1]), 1e-10);
    EXPECT_NEAR(d.AngleDistortion[f], std::log(sigma[0] / sigma[1]), 1e-10);
    EXPECT_NEAR(d.BeltramiMagnitude[f], (sigma[0] - sigma[1]) / (sigma[0] + sigma[1]), 1e-10);
    EXPECT_NEAR(d.StretchL2[f], std::sqrt(squares / 2), 1e-10);
    EXPECT_NEAR(d.SymmetricDirichlet[f], squares + sigma.cwiseInverse().squaredNorm(), 1e-9);

    const Eigen::Array3d surfaceLengths = lengths(surface.Vertices, faces.row(f));
    const Eigen::Array3d flatLengths = lengths(flat, faces.row(f));
    const double ratio = heron(flatLengths) / flatTotal / (heron(surfaceLengths) / surfaceTotal);
    EXPECT_NEAR(d.AreaRatio[f], ratio, 1e-10 * ratio);
    double error = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      error += std::abs(angle(surfaceLengths, k) - angle(flatLengths, k)) / 3;
    }
    EXPECT_NEAR(d.AngleError[f], error, 1e-6);
  }
  EXPECT_GT(d.AngleError.maxCoeff(), 5.0) << "the case is too easy to tell anything";
}

TEST(DistortionMeasures, SmallDistortionsAreNotLostToCancellation)
{
  const double epsilon = 1e-10;
  const FaceMatrix faces = gridFaces(3);
  const Points2 flat = irregularGrid(3);
  const Eigen::Matrix2d map = Eigen::Vector2d(1.0 + epsilon, 1.0).asDiagonal();
  TriangleMesh surface;
  surface.Faces = faces;
  surface.Vertices = Points3::Zero(flat.rows(), 3);
  surface.Vertices.leftCols<2>() = flat * map;
  const FaceDistortion d = measureDistortion(surface, flat);
  expectAll(d.AngleDistortion, epsilon, 1e-14, "AngleDistortion");
  expectAll(d.BeltramiMagnitude, epsilon / 2, 1e-14, "BeltramiMagnitude");
}

TEST(DistortionMeasures, NothingDependsOnUnits)
{
  const FaceMatrix faces = gridFaces(5);
  const Points2 flat = irregularGrid(5);
  const TriangleMesh surface = bumpOver(flat, faces);
  TriangleMesh tiny = surface;
  tiny.Vertices *= 1e-9;
  const FaceDistortion d = measureDistortion(surface, flat);
  const FaceDistortion t = measureDistortion(tiny, 1e7 * flat);
  EXPECT_LE((d.AreaRatio - t.AreaRatio).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LE((d.SymmetricDirichlet - t.SymmetricDirichlet).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LE((d.StretchL2 - t.StretchL2).cwiseAbs().maxCoeff(), 1e-13);
}

// Weights 1 and 3: what was asked for is a face three times as large. A flat mesh with just that is
// perfect.
TEST(DistortionMeasures, WeightsAreTheTarget)
{
  TriangleMesh surface;
  surface.Faces.resize(2, 3);
  surface.Faces << 0, 1, 2, 3, 4, 5;
  surface.Vertices.resize(6, 3);
  surface.Vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 0, 0, 10, 0, 0, 9, 1, 0;
  Points2 flat = surface.Vertices.leftCols<2>();
  flat.bottomRows<3>() *= std::sqrt(3.0);
  Eigen::VectorXd weights(6);
  weights << 2, 2, 2, 5, 6, 7;
  const FaceDistortion d = measureDistortion(surface, flat, weights);
  expectAll(d.AreaRatio, 1.0, 1e-14, "AreaRatio");
  expectAll(d.AreaDistortion, 0.0, 1e-14, "AreaDistortion");
  expectAll(d.StretchL2, 1.0, 1e-14, "StretchL2");
  EXPECT_NEAR(measureDistortion(surface, flat).AreaRatio[1], 1.5, 1e-14);
}

TEST(DistortionMeasures, DegenerateFacesHaveDocumentedValues)
{
  // Face 0 is sound, 1 has no area on the surface, 2 none in the flat.
  TriangleMesh surface;
  surface.Faces.resize(3, 3);
  surface.Faces << 0, 1, 2, 3, 4, 5, 6, 7, 8;
  surface.Vertices.resize(9, 3);
  surface.Vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, /**/ 1, 1, 1, 2, 2, 2, 3, 3, 3, /**/ 5, 0, 0, 6, 0, 0,
    5, 1, 0;
  Points2 flat(9, 2);
  flat << 0, 0, 1, 0, 0, 1, /**/ 5, 5, 6, 5, 5, 6, /**/ 7, 7, 8, 8, 9, 9;
  const FaceDistortion d = measureDistortion(surface, flat);
  EXPECT_EQ(d.SurfaceDegenerate, (std::vector<char>{ 0, 1, 0 }));
  EXPECT_EQ(d.FlatDegenerate, (std::vector<char>{ 0, 0, 1 }));
  EXPECT_EQ(d.Flipped, (std::vector<char>{ 0, 0, 1 }));
  EXPECT_DOUBLE_EQ(d.AreaRatio[0], 1.0); // half of both total areas
  EXPECT_EQ(d.AreaRatio[1], 1.0);
  EXPECT_EQ(d.AreaRatio[2], 0.0);
  for (const int f : { 1, 2 })
  {
    EXPECT_EQ(d.AreaDistortion[f], 0.0);
    EXPECT_EQ(d.AngleDistortion[f], 0.0);
    EXPECT_EQ(d.BeltramiMagnitude[f], 0.0);
    EXPECT_EQ(d.StretchL2[f], 1.0);
    EXPECT_EQ(d.SymmetricDirichlet[f], 4.0);
    EXPECT_EQ(d.AngleError[f], 0.0);
  }
}

TEST(DistortionMeasures, ThinnestFacesStayFinite)
{
  TriangleMesh surface;
  surface.Faces.resize(2, 3);
  surface.Faces << 0, 1, 2, 0, 2, 3;
  surface.Vertices.resize(4, 3);
  surface.Vertices << 0, 0, 0, 1, 1e-300, 0, 1, 1, 0, 0, 1, 0;
  Points2 flat(4, 2);
  flat << 0, 0, 0.5, 0.5 - 1e-17, 1, 1, 0, 1; // exactly collinear after rounding
  for (const double x : { 0.5, 0.5 + 1e-16, 0.5 + 1e-12 })
  {
    flat(1, 0) = x;
    const FaceDistortion d = measureDistortion(surface, flat);
    for (const auto* measure : { &d.AreaRatio,
           &d.AreaDistortion,
           &d.AngleDistortion,
           &d.BeltramiMagnitude,
           &d.StretchL2,
           &d.SymmetricDirichlet,
           &d.AngleError })
    {
      EXPECT_TRUE(measure->allFinite()) << x;
    }
  }
}

TEST(DistortionMeasures, BadInput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FaceMatrix faces = gridFaces(2);
  const Points2 flat = irregularGrid(2);
  const TriangleMesh surface = bumpOver(flat, faces);

  TriangleMesh bad = surface;
  bad.Vertices(4, 2) = nan;
  EXPECT_NE(
    invalidInputOf([&] { measureDistortion(bad, flat); }).find("vertex 4 has a surface coordinate"),
    std::string::npos);
  Points2 badFlat = flat;
  badFlat(3, 0) = std::numeric_limits<double>::infinity();
  EXPECT_NE(
    invalidInputOf([&] { measureDistortion(surface, badFlat); }).find("vertex 3 has a flat coordinate"),
    std::string::npos);
  for (const double weight : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(9);
    weights[7] = weight;
    EXPECT_NE(invalidInputOf([&] { measureDistortion(surface, flat, weights); }).find("vertex 7"),
      std::string::npos);
  }
  bad.Vertices.setZero();
  EXPECT_NE(invalidInputOf([&] { measureDistortion(bad, flat); }).find("surface has zero area"),
    std::string::npos);
  badFlat.setOnes();
  EXPECT_NE(
    invalidInputOf([&] { measureDistortion(surface, badFlat); }).find("flat surface has zero area"),
    std::string::npos);
}

} // namespace
