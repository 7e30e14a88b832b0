// SPDX-License-Identifier: GPL-3.0-or-later
/// Tests of the analytic surfaces, which other tests rely on: their formulas are compared with the
/// geometry of the meridian, and their meshes with the formulas.
#include "AnalyticSurfaces.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

const std::vector<std::pair<std::string, SurfaceOfRevolution>>& surfaces()
{
  static const std::vector<std::pair<std::string, SurfaceOfRevolution>> all{
    { "flat disk", flatDisk() },
    { "hemisphere", sphericalCap(0.5 * EIGEN_PI) },
    { "most of a sphere", sphericalCap(2.5) },
    { "paraboloid", paraboloid(1.0) },
    { "Gaussian bump", gaussianBump(1.0, 0.3) },
    { "capsule", capsule(3.0) },
  };
  return all;
}

// d log rho = ds / r, and dA = 2 pi r ds, by central differences.
TEST(AnalyticSurfaces, RadiiSolveTheirEquations)
{
  for (const auto& [name, surface] : surfaces())
  {
    for (double share = 0.03; share < 1.0; share += 0.0631)
    {
      const double t = share * surface.End;
      const double h = 1e-4 * surface.End;
      const double r = surface.Radius(t);
      const double length = std::hypot(
        surface.Radius(t + h) - surface.Radius(t - h), surface.Height(t + h) - surface.Height(t - h));
      EXPECT_NEAR(std::log(surface.ConformalRadius(t + h) / surface.ConformalRadius(t - h)),
        length / r,
        1e-5 * length / r)
        << name << " at " << t;
      EXPECT_NEAR(surface.Area * (surface.AreaShare(t + h) - surface.AreaShare(t - h)),
        2.0 * EIGEN_PI * r * length,
        1e-5 * r * length)
        << name << " at " << t;
    }
    EXPECT_NEAR(surface.ConformalRadius(surface.End), 1.0, 1e-14) << name;
    EXPECT_NEAR(surface.AreaShare(surface.End), 1.0, 1e-14) << name;
    EXPECT_EQ(surface.ConformalRadius(0.0), 0.0) << name;
    EXPECT_NEAR(surface.AreaShare(0.0), 0.0, 1e-15) << name;
  }
}

TEST(AnalyticSurfaces, MeshesAreDisksOfTheRightSizeAndArea)
{
  for (const auto& [name, surface] : surfaces())
  {
    for (const RevolutionMesh& mesh : { ringMesh(surface, 5000), sunflowerMesh(surface, 5000) })
    {
      EXPECT_NEAR(mesh.Mesh.vertexCount(), 5000, 250) << name;
      const std::vector<int> loop = requireDisk(mesh.Mesh);
      EXPECT_EQ(loop.size(), mesh.Mesh.vertexCount() - mesh.FirstBoundaryVertex) << name;
      EXPECT_EQ(loop.front(), mesh.FirstBoundaryVertex) << name;
      EXPECT_EQ(loop[1], mesh.FirstBoundaryVertex + 1) << name << ": clockwise";
      const double area = faceAreas(mesh.Mesh.Vertices, mesh.Mesh.Faces).sum();
      EXPECT_NEAR(area / surface.Area, 1.0, 2e-3) << name;
    }
  }
}

} // namespace
