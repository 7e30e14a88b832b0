// SPDX-License-Identifier: GPL-3.0-or-later
/// Which faces of a mesh on a surface intersect, and what is near them.
#pragma once

#include "Mesh/SelfIntersections.h"
#include "Mesh/TrackedIntersections.h"
#include "Remeshing/MeshOnSurface.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace flattening
{

using FacePair = std::pair<MeshOnSurface::Face, MeshOnSurface::Face>;
using FacePairs = std::vector<FacePair>;

/// Pairs that are near more faces than this are left as they are: a guard. Work on one pair grows with
/// the square of the faces near it, and is a few seconds for so many. Twice as many as are near pairs
/// beside a vertex of three hundred faces.
constexpr std::size_t MostNearOnePair = 10000;

PlacedTriangle placed(const CornerTriangle& triangle);

/// Whether the two faces intersect.
bool intersect(const MeshOnSurface& surface, const FacePair& pair);

/// Updates what is known of the surface's intersections. Returns all pairs of faces that intersect, or
/// nothing if there are more of them than faces.
std::optional<FacePairs> intersectingFaces(const MeshOnSurface& surface,
  TrackedIntersections& known,
  const ProgressCallback& progress = {});

/// The pairs of faces in @p faces that intersect.
FacePairs intersectingFaces(const MeshOnSurface& surface,
  const std::vector<MeshOnSurface::Face>& faces,
  const ProgressCallback& progress = {});

/// The number of pairs of a face in @p some (ascending) and another one in @p near that intersect.
int countIntersections(const MeshOnSurface& surface,
  const std::vector<MeshOnSurface::Face>& some,
  const std::vector<MeshOnSurface::Face>& near);

/// The vertices that are at most @p edges edges away from one of the two faces, ascending.
std::vector<MeshOnSurface::Vertex> verticesAround(const MeshOnSurface& surface,
  const FacePair& pair,
  int edges);

/// The faces of all lists, ascending, each once.
std::vector<MeshOnSurface::Face> unitedFaces(const std::vector<std::vector<MeshOnSurface::Face>>& lists);

/// For each group of vertices the faces whose boxes meet the box around the group, widened by a quarter
/// of its size on each side. No group may be empty. Nothing if the lists together had more than two
/// entries for each face of the surface, and more than a million: most faces are then near many groups,
/// as where long thin faces cross, and work on the lists would grow with the square of the faces.
std::optional<std::vector<std::vector<MeshOnSurface::Face>>> facesNear(const MeshOnSurface& surface,
  const std::vector<std::vector<MeshOnSurface::Vertex>>& groups);

} // namespace flattening
