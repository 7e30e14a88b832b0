// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/MapPlacement.h"

#include "Mesh/FaceOrientation.h"
#include "Untangling/MapUntangling.h"

namespace flattening
{

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
