// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConformalDisk.h"

#include "Base/Errors.h"
#include "Conformal/BoundaryFirstDisk.h"
#include "Conformal/DiskNormalisation.h"
#include "Conformal/MeanValueDisk.h"
#include "Conformal/RicciFlowDisk.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/MeshTopology.h"
#include "Untangling/ConformalFactors.h"
#include "Untangling/MapUntangling.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

void requireVertices(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const ConformalDiskOptions& options)
{
  const int n = mesh.vertexCount();
  const auto isOnBoundary = [&loop](int v)
  { return std::find(loop.begin(), loop.end(), v) != loop.end(); };
  if (options.CenterVertex >= n || (options.CenterVertex >= 0 && isOnBoundary(options.CenterVertex)))
  {
    throw InvalidInput("the centre vertex " + std::to_string(options.CenterVertex) +
                       " is not an interior vertex of the surface: choose one away from the boundary");
  }
  if (options.BoundaryVertex >= n ||
      (options.BoundaryVertex >= 0 && !isOnBoundary(options.BoundaryVertex)))
  {
    throw InvalidInput("the vertex for angle 0, " + std::to_string(options.BoundaryVertex) +
                       ", is not on the boundary: choose a boundary vertex");
  }
}

ConformalDiskMap centredMap(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const ConformalDiskOptions& options,
  const ProgressCallback& progress)
{
  const DiskCentring centring =
    options.CenterVertex >= 0 ? DiskCentring(mesh, options.CenterVertex) : DiskCentring(mesh);
  switch (options.Method)
  {
    case ConformalMethod::BoundaryFirst:
      return boundaryFirstDisk(mesh, loop, centring, progress);
    case ConformalMethod::MeanValue:
      return meanValueDisk(mesh, loop, centring, progress);
    case ConformalMethod::RicciFlow:
      break;
  }
  return ricciFlowDisk(mesh, loop, centring, options.Flow, progress);
}

// The angle by which a centred map is rotated.
double rotationOf(const ComplexVector& disk,
  const TriangleMesh& mesh,
  const std::vector<int>& loop,
  int boundaryVertex)
{
  if (boundaryVertex >= 0)
  {
    return -std::arg(disk[boundaryVertex]);
  }
  return intrinsicRotation(disk, mesh.Vertices, DiskCentring(mesh).weights())
    .value_or(-std::arg(disk[loop.front()]));
}

// The vertices that untangling must not move.
std::vector<int> fixedVertices(const std::vector<int>& loop, const ConformalDiskOptions& options)
{
  std::vector<int> fixed = loop;
  if (options.CenterVertex >= 0)
  {
    fixed.push_back(options.CenterVertex);
  }
  return fixed;
}

} // namespace

ConformalDiskMap conformalDiskMap(const TriangleMesh& mesh,
  const ConformalDiskOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  requireVertices(mesh, loop, options);
  ConformalDiskMap map = centredMap(mesh, loop, options, progress);
  ComplexVector disk = complexOf(map.Positions);
  const std::complex<double> rotation =
    std::polar(1.0, rotationOf(disk, mesh, loop, options.BoundaryVertex));
  for (std::complex<double>& z : disk)
  {
    z *= rotation;
  }
  map.Positions = pointsOf(disk);
  map.Untangling =
    untangleMap(mesh, fixedVertices(loop, options), map.Positions, subrange(progress, 0.95, 1.0));
  if (options.Method != ConformalMethod::RicciFlow)
  {
    map.LogFactors = logConformalFactors(mesh, map.Positions);
  }
  report(progress, 1.0, "Conformal disk");
  return map;
}

} // namespace flattening
