// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/MapPlacement.h"

#include "Base/Errors.h"
#include "Mesh/FaceOrientation.h"
#include "Untangling/MapUntangling.h"

namespace flattening
{
namespace
{

// The least scale of a map over the distance of its centre from the origin. A guard: smaller maps lose
// their shape to rounding.
constexpr double LeastScale = 1e-9;

} // namespace

void requireResolved(const Placement& placement)
{
  const double distance = placement.Centre.cwiseAbs().maxCoeff();
  if (!(placement.Scale > LeastScale * distance))
  {
    throw InvalidInput(
      "the map gets a radius of about " + formatted(placement.Scale) +
      ", but the domain's outline lies at a distance of " + formatted(distance) +
      " from the origin, where double precision does not hold so small a map: scale the "
      "outline to the area of the surface, or move its centre to the origin");
  }
}

PlacedMap placeMap(const TriangleMesh& surface,
  const std::vector<int>& fixed,
  const Points2& positions,
  const Placement& placement)
{
  PlacedMap placed;
  placed.Positions = (placement.Scale * positions).rowwise() + placement.Centre;
  placed.FlippedFaces = countFlippedFaces(placed.Positions, surface.Faces);
  if (placed.FlippedFaces > 0 && countFlippedFaces(positions, surface.Faces) == 0)
  {
    placed.FlippedFaces = untangleMap(surface, fixed, placed.Positions).FlippedFaces;
  }
  return placed;
}

} // namespace flattening
