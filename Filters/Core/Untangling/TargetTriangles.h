// SPDX-License-Identifier: GPL-3.0-or-later
/// The triangles that the faces of a flat map should become.
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

/// Of face f, its corners in the order of the face's vertices, in the units of the map. Any place and
/// turn of the triangle in the plane is as good.
using TargetTriangles = std::function<TargetTriangle(int face)>;

/// Triangles similar to those of @p surface, of the scale that @p positions (n x 2) have around the
/// face: the mean over its corners of the logarithmic ratio of flat to surface length there. They are
/// the targets of a conformal map that should change as little as can be. Slivers are opened to an
/// altitude of a fiftieth of their longest side, as no map could tell their shapes apart from a line.
/// Valid whatever becomes of @p positions, while @p surface lives.
TargetTriangles similarTriangles(const TriangleMesh& surface, const Points2& positions);

/// Triangles similar to those of @p surface of the areas @p areas (m, > 0). They are the targets of an
/// area-preserving map. Slivers are opened as above. Valid while @p surface lives.
TargetTriangles trianglesOfArea(const TriangleMesh& surface, const Eigen::VectorXd& areas);

} // namespace flattening
