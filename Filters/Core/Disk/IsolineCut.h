// SPDX-License-Identifier: GPL-3.0-or-later
/// Makes an isoline of a function on a surface (the curve on which it takes one value) a chain of edges.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Edges up to this many times longer than wanted start no further round of refinement. A convention:
/// with a factor of 1, edges that are longer by rounding alone would start one.
constexpr double EdgeLengthSlack = 1.1;

/// Moves vertices that the isoline passes closer than a fifth of an edge onto it, along that edge, and
/// sets their values to the level: a cut would leave slivers between them and the isoline. A vertex
/// stays where it is if it is on the boundary, if a face around it would tilt by more than 60 degrees or
/// have all corners on the isoline, or if the part above the level would touch itself there.
/// @param values one per vertex, none of them the level itself (see raiseValuesAt).
void snapToIsoline(EditableSurface& surface, std::vector<double>& values, double level);

/// Raises values equal to the level to the next number above, so that no vertex is on the isoline.
void raiseValuesAt(std::vector<double>& values, double level);

/// The edges with one end below the level and the other one above it.
std::vector<SurfaceMesh::Halfedge_index> edgesAcrossIsoline(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level);

/// Whether the isoline crosses so many edges that refining the faces along it further would not help a
/// boundary of @p boundaryVertices: faces of ordinary shapes are short enough by then, and of slivers
/// side by side there would only be more.
bool crossesMoreThanEnough(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level,
  int boundaryVertices);

/// The faces that take values within @p distance of the level and have an edge longer than
/// @p longestEdge (input units).
std::vector<EditableSurface::Face> longFacesAtIsoline(const EditableSurface& surface,
  const std::vector<double>& values,
  double level,
  double distance,
  double longestEdge);

/// Splits the edges across the isoline where the function, linear along them, takes the level, but not
/// closer to an end than a millionth of the edge. Afterwards every face lies on one side, and the
/// isoline is a manifold.
/// @param values one per vertex; the values of the new vertices, the level itself, are appended.
void splitAtIsoline(EditableSurface& surface, std::vector<double>& values, double level);

} // namespace flattening
