// SPDX-License-Identifier: GPL-3.0-or-later
/// Isotropic remeshing of a large surface in parts, at the same time.
#pragma once

#include "Base/Progress.h"
#include "Remeshing/IsotropicRemesher.h"
#include "Remeshing/MeshOnSurface.h"

#include <memory>
#include <optional>
#include <utility>

namespace flattening
{

/// A surface and what finds points on it.
struct SurfaceWithWalk
{
  explicit SurfaceWithWalk(TriangleMesh surface)
    : Mesh(std::move(surface))
    , Walk(Mesh)
  {
  }

  TriangleMesh Mesh;
  ClosestPointWalk Walk;
};

/// The surface is cut into layers (SurfaceLayers), and all rounds but the last are done in each of them
/// while the borders between them stay. Other layers, in the middle of which those borders lie, do the
/// last round and flip edges to Delaunay. The layers depend on the surface alone, so that the result is
/// the same with any number of threads. Returns nothing if the surface is too small for several parts,
/// has too few layers, or no round is wanted.
/// @param surface  the old one, on which the new one is to lie
/// @param length  that the edges should have, input units
/// @throws Cancelled; InvalidInput if there are too many vertices.
std::optional<PlacedMesh> remeshedInParts(const std::shared_ptr<const SurfaceWithWalk>& surface,
  double length,
  const VertexLimit& limit,
  int rounds,
  const ProgressCallback& progress);

} // namespace flattening
