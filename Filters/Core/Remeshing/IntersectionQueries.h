// SPDX-License-Identifier: GPL-3.0-or-later
/// Which faces of a resampled surface pass through each other, and what is near them.
#pragma once

#include "Mesh/SelfIntersections.h"
#include "Remeshing/MeshOnSurface.h"

#include <utility>
#include <vector>

namespace flattening
{

using FacePairs = std::vector<std::pair<MeshOnSurface::Face, MeshOnSurface::Face>>;

PlacedTriangle placed(const CornerTriangle& triangle);

/// All pairs, or those among some of the faces.
FacePairs intersectingFaces(const MeshOnSurface& surface, const ProgressCallback& progress = {});
FacePairs intersectingFaces(const MeshOnSurface& surface,
  const std::vector<MeshOnSurface::Face>& faces,
  const ProgressCallback& progress = {});

/// How many pairs of `some`, ascending, with each other or with others of `near` intersect.
int countIntersections(const MeshOnSurface& surface,
  const std::vector<MeshOnSurface::Face>& some,
  const std::vector<MeshOnSurface::Face>& near);

/// The faces of all lists, ascending, each once.
std::vector<MeshOnSurface::Face> unitedFaces(const std::vector<std::vector<MeshOnSurface::Face>>& lists);

/// Per group of vertices the faces that meet the box around it, which is widened by a quarter.
std::vector<std::vector<MeshOnSurface::Face>> facesNear(const MeshOnSurface& surface,
  const std::vector<std::vector<MeshOnSurface::Vertex>>& groups);

} // namespace flattening
