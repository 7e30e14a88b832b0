// SPDX-License-Identifier: GPL-3.0-or-later
/// Makes a level curve of a function on a surface a chain of edges.
#pragma once

#include "EditableSurface.h"

#include <vector>

namespace flattening
{

/// The edges with one end below the level and the other one on or above it.
std::vector<SurfaceMesh::Halfedge_index> edgesAcrossLevel(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level);

/// Splits these edges where the function, linear along them, takes the level; afterwards every face lies
/// on one side, and the curve's vertices are new ones. A vertex on the level stays beside the curve, by
/// a millionth of its edges, so that the curve is a manifold; conditionBoundary unites the two.
/// @param values one per vertex; those of the new vertices, the level itself, are appended.
void splitAtLevel(EditableSurface& surface, std::vector<double>& values, double level);

} // namespace flattening
