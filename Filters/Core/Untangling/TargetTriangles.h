// SPDX-License-Identifier: GPL-3.0-or-later
/// Target triangles: the shapes and sizes that the faces of a flat map should have.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <functional>

namespace flattening
{

/// A positively oriented triangle whose first corner is the origin.
struct TargetTriangle
{
  Eigen::Vector2d Second;
  Eigen::Vector2d Third;
};

/// The target of a face, with the corners in the order of the face's vertices, in the units of the map.
/// Its position and rotation in the plane do not matter.
using TargetTriangles = std::function<TargetTriangle(int face)>;

/// Targets for a conformal map that should change as little as possible: triangles similar to those of
/// @p surface, scaled as @p positions (n x 2) are around the face, by the mean over its corners of the
/// logarithmic ratio of flat to surface length. Slivers are opened to an altitude of a fiftieth of their
/// longest side. The result keeps a copy of the scales and a reference to @p surface.
TargetTriangles similarTriangles(const TriangleMesh& surface, const Points2& positions);

/// Targets for an area-preserving map: triangles similar to those of @p surface that have the areas @p
/// areas (m, > 0). Slivers are opened as above. The result keeps a reference to @p surface.
TargetTriangles trianglesOfArea(const TriangleMesh& surface, const Eigen::VectorXd& areas);

} // namespace flattening
