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

/// Targets for a conformal map that should change as little as possible. The target of a face is
/// similar to the face on @p surface and has about the scale that the map @p positions (n x 2) has
/// there: the logarithm of its scale (flat over surface length) is the mean of logConformalFactors()
/// at the corners of the face. A face whose altitude over its longest side is less than a fiftieth of
/// that side, a sliver, gets a target with this altitude. The result keeps a copy of the scales and a
/// reference to @p surface.
TargetTriangles similarTriangles(const TriangleMesh& surface, const Points2& positions);

/// Targets for an area-preserving map: triangles similar to those of @p surface that have the areas @p
/// areas (m, > 0). Slivers get the same least altitude. The result keeps a reference to @p surface.
TargetTriangles trianglesOfArea(const TriangleMesh& surface, const Eigen::VectorXd& areas);

} // namespace flattening
