// SPDX-License-Identifier: GPL-3.0-or-later
/// Makes a level curve of a function on a surface a chain of edges.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Moves vertices onto the level curve that it passes closer than a fifth of an edge, along that edge,
/// and sets their values to the level: a cut would leave slivers between them and the curve. A vertex
/// stays where it is if it is on the boundary, if a face around it would tilt by more than 60 degrees or
/// come to lie on the curve whole, or if the part above the level would touch itself there.
/// @param values one per vertex, none of them the level itself (see offLevel).
void snapToLevel(EditableSurface& surface, std::vector<double>& values, double level);

/// Raises values equal to the level to the next number above: no vertex of the input is on the curve.
void offLevel(std::vector<double>& values, double level);

/// The edges with one end below the level and the other one above it.
std::vector<SurfaceMesh::Halfedge_index> edgesAcrossLevel(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level);

/// Splits these edges where the function, linear along them, takes the level, at a millionth of the edge
/// from its ends or farther; afterwards every face lies on one side, and the curve is a manifold.
/// @param values one per vertex; those of the new vertices, the level itself, are appended.
void splitAtLevel(EditableSurface& surface, std::vector<double>& values, double level);

} // namespace flattening
