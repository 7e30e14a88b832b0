// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces near a place on a surface.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Square of the Euclidean distance of a face from a point.
double squaredDistance(const SurfaceMesh& mesh,
  SurfaceMesh::Face_index face,
  const Kernel::Point_3& point);

/// Of the parts of an original face the one nearest to @p point; null if nothing is left of it.
SurfaceMesh::Face_index partAt(const EditableSurface& surface,
  int originalFace,
  const Kernel::Point_3& point);

/// The faces closer to @p centre than @p radius that are connected to @p start by such faces: not those
/// of another fold nearby.
std::vector<SurfaceMesh::Face_index> facesInBall(const SurfaceMesh& mesh,
  SurfaceMesh::Face_index start,
  const Kernel::Point_3& centre,
  double radius);

/// The faces around the vertices nearest to @p centre along edges, until their area sums to @p area.
std::vector<SurfaceMesh::Face_index> facesNearestTo(const EditableSurface& surface,
  SurfaceMesh::Vertex_index centre,
  double area);

} // namespace flattening
