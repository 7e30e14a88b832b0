// SPDX-License-Identifier: GPL-3.0-or-later
/// Which faces of a resampled surface pass through each other, and what is near them.
#pragma once

#include "Mesh/SelfIntersections.h"
#include "Remeshing/MeshOnSurface.h"

#include <utility>
#include <vector>

namespace flattening
{

using FacePairs = std::vector<std::pair<ResampledSurface::Face, ResampledSurface::Face>>;

PlacedTriangle placed(const CornerTriangle& triangle);

/// All pairs, or those among some of the faces.
FacePairs intersectingFaces(const ResampledSurface& surface, const ProgressCallback& progress = {});
FacePairs intersectingFaces(const ResampledSurface& surface,
  const std::vector<ResampledSurface::Face>& faces,
  const ProgressCallback& progress = {});

/// How many pairs of `some`, ascending, with each other or with others of `near` intersect.
int countIntersections(const ResampledSurface& surface,
  const std::vector<ResampledSurface::Face>& some,
  const std::vector<ResampledSurface::Face>& near);

/// The faces of all lists, ascending, each once.
std::vector<ResampledSurface::Face> unitedFaces(
  const std::vector<std::vector<ResampledSurface::Face>>& lists);

/// Per group of vertices the faces that meet the box around it, which is widened by a quarter.
std::vector<std::vector<ResampledSurface::Face>> facesNear(const ResampledSurface& surface,
  const std::vector<std::vector<ResampledSurface::Vertex>>& groups);

} // namespace flattening
