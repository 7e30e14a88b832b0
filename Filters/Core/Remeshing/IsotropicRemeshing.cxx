// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IsotropicRemeshing.h"

#include "Base/Memory.h"
#include "Mesh/SliverThresholds.h"
#include "Remeshing/BoundaryEars.h"
#include "Remeshing/IsotropicRemesher.h"
#include "Remeshing/MeshOnSurface.h"
#include "Remeshing/PartwiseRemeshing.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <sstream>

namespace flattening
{
namespace
{

// At least so many equilateral faces must fit on the surface: a guard against a length in wrong units.
constexpr double FewestFaces = 20.0;
// The largest number of points that remeshing makes: a convention, some sixteen gigabytes.
constexpr double MostPoints = 2e7;

// The memory that remeshing takes for each point that it makes, as measured at one and four million.
constexpr double BytesPerPoint = 950.0;

// Splitting long thin triangles makes more points than stay: at most so many times as many are let
// happen, but always a number that takes little memory. A guard.
constexpr double MostIntermediate = 10.0;
constexpr double AlwaysAllowed = 1e6;

// Half the equilateral faces that fit on the surface.
double expectedVertices(const TriangleMesh& mesh, double length)
{
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  return 2.0 / std::sqrt(3.0) * area / length / length;
}

void requireSensibleLength(const TriangleMesh& mesh, double length)
{
  std::ostringstream message; // lengths of any order of magnitude
  if (!(length > 0.0) || !std::isfinite(length))
  {
    message << "the target edge length is " << formatted(length)
            << ": set a positive length in the units of the surface";
    throw InvalidInput(message.str());
  }
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  const double longest = std::sqrt(area / FewestFaces * 4.0 / std::sqrt(3.0)); // of equilateral faces
  if (length > longest)
  {
    message << "the target edge length " << length << " would leave fewer than " << FewestFaces
            << " faces: set it below " << longest;
    throw InvalidInput(message.str());
  }
  const double points = expectedVertices(mesh, length);
  message << "the target edge length " << length << " would make about " << points << " points";
  if (!(points <= MostPoints))
  {
    message << ", more than " << MostPoints << ": set it above "
            << std::sqrt(2.0 / std::sqrt(3.0) * area / MostPoints);
    throw InvalidInput(message.str());
  }
  message << "; this";
  requireMemory(message.str(), BytesPerPoint * points, "set a greater length");
}

// The largest number of vertices on the way.
std::size_t mostVertices(const TriangleMesh& mesh, double length)
{
  return static_cast<std::size_t>(
    std::clamp(MostIntermediate * (expectedVertices(mesh, length) + mesh.vertexCount()),
      AlwaysAllowed,
      MostPoints));
}

} // namespace

DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations,
  const ProgressCallback& progress,
  TrackedIntersections* intersections)
{
  requireSensibleLength(mesh, targetEdgeLength);
  report(progress, 0.0, "remeshing");
  const auto old = std::make_shared<const SurfaceWithWalk>(mesh);
  const VertexLimit limit{ mostVertices(mesh, targetEdgeLength) };
  std::optional<PlacedMesh> present =
    remeshedInParts(old, targetEdgeLength, limit, iterations, subrange(progress, 0.0, 0.8));
  const int roundsLeft = present ? 0 : iterations;
  if (!present)
  {
    present = placedOnItself(old->Walk);
  }
  MeshOnSurface surface(std::shared_ptr<const ClosestPointWalk>(old, &old->Walk), *present);
  present.reset();
  IsotropicRemesher remesher(surface, targetEdgeLength, limit);
  for (int i = 0; i < roundsLeft; ++i)
  {
    remesher.iterate(subrange(progress, 0.8 * i / iterations, 0.8 * (i + 1) / iterations));
  }
  remesher.flipToDelaunay(subrange(progress, 0.8, 0.85));
  removeSlivers(surface, slivers::RemeshedAngle, subrange(progress, 0.85, 0.9));
  openEars(surface, remesher.keepsSurface(), IsotropicRemesher::staysSound);
  removeSelfIntersections(surface, subrange(progress, 0.9, 0.95), intersections);
  return surface.derived(subrange(progress, 0.95, 1.0));
}

} // namespace flattening
