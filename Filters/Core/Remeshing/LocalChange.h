// SPDX-License-Identifier: GPL-3.0-or-later
/// A local operation of remeshing before it is carried out: the triangles that it would replace.
#pragma once

#include <boost/container/small_vector.hpp>

#include <Eigen/Core>

#include <array>

namespace flattening
{

/// A corner of a triangle of the mesh, or of one that an operation would make. It points to values that
/// live only as long as the call of the guard that gets it.
struct Corner
{
  int Vertex;
  const Eigen::Vector3d* Position;
  const Eigen::Vector3d* Normal; ///< normal of the old surface there
};

using CornerTriangle = std::array<Corner, 3>;

/// The triangles that an operation would remove and those that would take their place.
struct LocalChange
{
  using Triangles = boost::container::small_vector<CornerTriangle, 16>;
  boost::container::small_vector<int, 16> Removed; ///< faces of Before
  Triangles Before;
  Triangles After;
};

/// The smallest of the sines of the triangle's angles; 0 if it has no area.
double smallestSine(const CornerTriangle& triangle);

/// The smallest sine of an angle of these triangles; 1 if there is none.
double smallestSine(const LocalChange::Triangles& triangles);

/// The smallest cosine between the normal of a triangle and one of the old surface's normals at its
/// corners: -1 if a triangle has no area, 1 if there is no triangle.
double smallestAlignment(const LocalChange::Triangles& triangles);

} // namespace flattening
