// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces near a point of a surface.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// The square of the Euclidean distance of a face from a point.
double squaredDistance(const SurfaceMesh& mesh,
  SurfaceMesh::Face_index face,
  const Kernel::Point_3& point);

/// The part of an original face that is nearest to @p point; of equally near ones that with the least
/// number. Precondition: faces have been split, but no part of that face has been removed.
SurfaceMesh::Face_index partAt(const EditableSurface& surface,
  int originalFace,
  const Kernel::Point_3& point);

/// The faces closer to @p centre than @p radius that are connected to @p start by such faces, which
/// keeps the faces of another fold nearby out.
std::vector<SurfaceMesh::Face_index> facesInBall(const SurfaceMesh& mesh,
  SurfaceMesh::Face_index start,
  const Kernel::Point_3& centre,
  double radius);

/// The faces around the vertices nearest to @p centre along edges, until their area sums to @p area.
std::vector<SurfaceMesh::Face_index> facesNearestTo(const EditableSurface& surface,
  SurfaceMesh::Vertex_index centre,
  double area);

} // namespace flattening
