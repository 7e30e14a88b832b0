// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/ScaledCurvature.h"

#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// Waves along x, four to a unit, on a square of side 2.
TriangleMesh waves()
{
  return liftedGrid(80,
    [](double x, double y)
    { return Eigen::Vector3d(2.0 * x, 2.0 * y, 0.05 * std::sin(16.0 * EIGEN_PI * x)); });
}

TEST(ScaledCurvature, OfASphereIsOneEverywhere)
{
  const Eigen::VectorXd values = scaledCurvature(sphere(4));
  EXPECT_NEAR(values.minCoeff(), 1.0, 0.1);
  EXPECT_NEAR(values.maxCoeff(), 1.0, 0.1);
}

TEST(ScaledCurvature, OfAPlaneIsZero)
{
  const TriangleMesh flat =
    liftedGrid(20, [](double x, double y) { return Eigen::Vector3d(x, y, 0.3 * x + 7.0); });
  EXPECT_EQ(scaledCurvature(flat), Eigen::VectorXd::Zero(flat.vertexCount()));
}

TEST(ScaledCurvature, HasOppositeSignsOnRidgesAndInFurrows)
{
  const TriangleMesh mesh = waves();
  const Eigen::VectorXd values = scaledCurvature(mesh);
  int inRange = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double height = mesh.Vertices(v, 2) / 0.05;
    inRange += std::abs(values[v]) <= 1.0;
    const bool nearBorder = mesh.Vertices.row(v).head(2).minCoeff() < 0.1 ||
                            mesh.Vertices.row(v).head(2).maxCoeff() > 1.9;
    if (!nearBorder && std::abs(height) > 0.9)
    {
      EXPECT_GT(values[v] * height, 0.5) << v;
    }
  }
  // Nine tenths of the area, which all vertices but those of the border share alike.
  EXPECT_NEAR(static_cast<double>(inRange) / mesh.vertexCount(), 0.9, 0.02);
}

TEST(ScaledCurvature, DoesNotDependOnSizeAndPlace)
{
  const TriangleMesh mesh = waves();
  const Eigen::VectorXd values = scaledCurvature(mesh);
  for (const double scale : { 0x1p-600, 0x1p-10, 0x1p300 })
  {
    TriangleMesh other = mesh;
    other.Vertices *= scale;
    EXPECT_EQ(scaledCurvature(other), values) << scale;
  }
  EXPECT_LT((scaledCurvature(moved(mesh, 500.0, -300.0, 40.0)) - values).cwiseAbs().maxCoeff(), 1e-3);
}

} // namespace
