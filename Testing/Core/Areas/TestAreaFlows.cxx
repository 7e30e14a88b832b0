// SPDX-License-Identifier: GPL-3.0-or-later
/// The flows of the paper's Table 1 that benchmarks compare with, on surfaces whose maps are known.
#include "AnalyticSurfaces.h"
#include "LieAdvection.h"
#include "MinimalFlow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::benchmarks;

constexpr double NoLimit = std::numeric_limits<double>::infinity(); // of time

using Radius = SurfaceOfRevolution::Function;

// The image under a radial map, turned about the origin by @p angle of the radius.
Points2 turnedMap(const RevolutionMesh& mesh, const Radius& radius, const Radius& angle)
{
  Points2 positions(mesh.Mesh.vertexCount(), 2);
  for (int v = 0; v < mesh.Mesh.vertexCount(); ++v)
  {
    const double r = radius(mesh.Parameter[v]);
    const double phi = mesh.Angle[v] + angle(r);
    positions.row(v) << r * std::cos(phi), r * std::sin(phi);
  }
  return positions;
}

Points2 radialMap(const RevolutionMesh& mesh, const Radius& radius)
{
  return turnedMap(mesh, radius, [](double) { return 0.0; });
}

// The mean over the surface of how far a vertex's share of the map is from its share of the surface.
double meanAreaError(const TriangleMesh& mesh, const Points2& positions)
{
  const auto shares = [&](const Eigen::VectorXd& areas) -> Eigen::VectorXd
  { return vertexAreas(mesh.Faces, areas, mesh.vertexCount()) / areas.sum(); };
  return (shares(signedFaceAreas(positions, mesh.Faces)) - shares(faceAreas(mesh.Vertices, mesh.Faces)))
    .lpNorm<1>();
}

double rms(const Points2& difference)
{
  return std::sqrt(difference.squaredNorm() / static_cast<double>(difference.rows()));
}

void expectOnTheDisk(const RevolutionMesh& mesh, const Points2& positions)
{
  EXPECT_GT(signedFaceAreas(positions, mesh.Mesh.Faces).minCoeff(), 0.0);
  for (int v = mesh.FirstBoundaryVertex; v < mesh.Mesh.vertexCount(); ++v)
  {
    EXPECT_NEAR(positions.row(v).norm(), 1.0, 1e-12);
  }
}

// From the conformal map, which is radial, to the radial map that keeps areas: there is but one.
void expectAdvectionToTheKnownMap(const SurfaceOfRevolution& surface)
{
  const RevolutionMesh mesh = sunflowerMesh(surface, 3000);
  const Points2 conformal = radialMap(mesh, surface.ConformalRadius);
  ASSERT_GT(meanAreaError(mesh.Mesh, conformal), 0.2);
  const FlowResult flow = lieAdvection(mesh.Mesh, conformal, 0.01, NoLimit);
  const double error = meanAreaError(mesh.Mesh, flow.Positions);
  const Points2 known = radialMap(mesh, [&](double t) { return surface.brenierRadius(t); });
  std::cout << flow.Steps << " steps; mean area error " << meanAreaError(mesh.Mesh, conformal) << " -> "
            << error << "; off the known map by " << rms(conformal - known) << " -> "
            << rms(flow.Positions - known) << "\n";
  EXPECT_TRUE(flow.Converged);
  EXPECT_GT(flow.Steps, 0);
  EXPECT_LE(flow.Steps, 10); // a step divides the error by e, or its root or fourth root
  EXPECT_LE(error, 0.01);
  EXPECT_LT(rms(flow.Positions - known), 0.05 * rms(conformal - known));
  expectOnTheDisk(mesh, flow.Positions);
}

TEST(LieAdvection, AHemisphereGoesToTheKnownMap)
{
  expectAdvectionToTheKnownMap(sphericalCap(EIGEN_PI / 2.0));
}

TEST(LieAdvection, ABumpGoesToTheKnownMap)
{
  expectAdvectionToTheKnownMap(gaussianBump(1.0, 0.3));
}

TEST(LieAdvection, WhatKeepsItsAreasStaysWhereItIs)
{
  const RevolutionMesh mesh = sunflowerMesh(flatDisk(), 500);
  const Points2 flat = mesh.Mesh.Vertices.leftCols<2>();
  const FlowResult flow = lieAdvection(mesh.Mesh, flat, 0.01, NoLimit);
  EXPECT_TRUE(flow.Converged);
  EXPECT_EQ(flow.Steps, 0);
  EXPECT_EQ(flow.Positions, flat);
}

TEST(LieAdvection, EndsWhenItsTimeIsOver)
{
  const SurfaceOfRevolution bump = gaussianBump(1.0, 0.3);
  const RevolutionMesh mesh = sunflowerMesh(bump, 500);
  EXPECT_FALSE(lieAdvection(mesh.Mesh, radialMap(mesh, bump.ConformalRadius), 1e-12, 0.0).Converged);
}

// From a map that keeps areas, but turns circles against each other, to the one without curl. Each
// circle keeps its area, so areas stay as they are.
void expectTurnIsTakenBack(const SurfaceOfRevolution& surface)
{
  const RevolutionMesh mesh = sunflowerMesh(surface, 3000);
  const Points2 conformal = radialMap(mesh, surface.ConformalRadius);
  const Radius radius = [&](double t) { return surface.brenierRadius(t); };
  const Points2 known = radialMap(mesh, radius);
  const Points2 start = turnedMap(mesh, radius, [](double r) { return 0.5 * (1.0 - r * r); });
  ASSERT_GT(signedFaceAreas(start, mesh.Mesh.Faces).minCoeff(), 0.0);
  const FlowResult flow = minimalFlow(mesh.Mesh, conformal, start, NoLimit);
  std::cout << flow.Steps << " steps; off the map without curl by " << rms(start - known) << " -> "
            << rms(flow.Positions - known) << "; mean area error " << meanAreaError(mesh.Mesh, start)
            << " -> " << meanAreaError(mesh.Mesh, flow.Positions) << "\n";
  EXPECT_TRUE(flow.Converged);
  EXPECT_GT(flow.Steps, 0);
  EXPECT_LT(rms(flow.Positions - known), 0.2 * rms(start - known));
  EXPECT_LT(meanAreaError(mesh.Mesh, flow.Positions), 0.02);
  // The least costly map is the one without curl.
  const Eigen::VectorXd mass = vertexAreas(mesh.Mesh);
  const auto cost = [&](const Points2& map)
  { return mass.dot((map - conformal).rowwise().squaredNorm()); };
  EXPECT_LT(cost(flow.Positions), cost(start));
  expectOnTheDisk(mesh, flow.Positions);
}

TEST(MinimalFlow, TheTurnOfADiskIsTakenBack)
{
  expectTurnIsTakenBack(flatDisk());
}

TEST(MinimalFlow, TheTurnOfAHemisphereIsTakenBack)
{
  expectTurnIsTakenBack(sphericalCap(EIGEN_PI / 2.0));
}

TEST(MinimalFlow, AMapWithoutCurlStaysWhereItIs)
{
  const RevolutionMesh mesh = sunflowerMesh(sphericalCap(EIGEN_PI / 2.0), 1000);
  const SurfaceOfRevolution cap = sphericalCap(EIGEN_PI / 2.0);
  const Points2 known = radialMap(mesh, [&](double t) { return cap.brenierRadius(t); });
  const FlowResult flow = minimalFlow(mesh.Mesh, radialMap(mesh, cap.ConformalRadius), known, NoLimit);
  EXPECT_TRUE(flow.Converged);
  EXPECT_EQ(flow.Steps, 0);
}

} // namespace
