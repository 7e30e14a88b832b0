// SPDX-License-Identifier: GPL-3.0-or-later
#include "PaperSurfaces.h"

#include "AnalyticSurfaces.h"
#include "ColonSurface.h"

#include <cmath>

namespace flattening::benchmarks
{
namespace
{

// A tube that is closed at one end.
BenchmarkSurface tube()
{
  return { analytic::sunflowerMesh(analytic::capsule(6.0), 1649).Mesh };
}

// A flat oval trunk, closed at the shoulders, with twelve pairs of ribs.
BenchmarkSurface chest()
{
  BenchmarkSurface surface{ analytic::sunflowerMesh(analytic::capsule(2.5), 1528).Mesh };
  for (int v = 0; v < surface.Mesh.vertexCount(); ++v)
  {
    auto point = surface.Mesh.Vertices.row(v);
    const double ribs = 1.0 + 0.03 * std::cos(2.0 * EIGEN_PI * 12.0 / 3.5 * point.z());
    point.x() *= 1.5 * ribs;
    point.y() *= ribs;
  }
  return surface;
}

} // namespace

std::vector<PaperSurface> paperSurfaces(const std::string& scan)
{
  const auto hemisphere = []
  {
    return BenchmarkSurface{
      analytic::sunflowerMesh(analytic::sphericalCap(0.5 * EIGEN_PI), 3456).Mesh
    };
  };
  return { { "tube", tube, 1649, 0.102, 0.278, 0.951 },
    { "hemisphere", hemisphere, 3456, 0.265, 0.815, 2.436 },
    { "square", [] { return squareGrid(52, 101); }, 5252, 0.474, 1.926, 7.104 },
    { "Gaussian", gaussianSquare, 10201, 0.812, 5.142, 15.705 },
    { "chest", chest, 1528, 0.097 },
    { "colon", [] { return unrolled(phantom::generateColon().Mesh, 1.88); }, 12762, 1.096 },
    { "brain", [scan] { return remeshedHalfBrain(scan, 1.852); }, 14499, 1.254 } };
}

} // namespace flattening::benchmarks
