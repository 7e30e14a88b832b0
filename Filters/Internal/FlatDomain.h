// SPDX-License-Identifier: GPL-3.0-or-later
/// The domain in the plane that a flat surface covers, and polygons given as a domain.
#pragma once

#include "Core/Mesh/TriangleMesh.h"
#include "Core/Transport/ConvexDomain.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace flattening
{

/// The domain of a flat surface: a disk around the origin, or the rectangle along the axes on whose
/// sides its boundary lies.
struct FlatDomain
{
  bool IsRectangle = false;
  Eigen::RowVector2d Centre = Eigen::RowVector2d::Zero();
  double Width = 0.0;  ///< width of the rectangle
  double Height = 0.0; ///< height of the rectangle
  double Scale = 1.0;  ///< ratio of its lengths to those of the similar domain of area pi

  /// The similar domain of area pi around the origin.
  std::shared_ptr<const ConvexDomain> normalised() const;
};

/// The domain of a flat surface. It is not checked whether the boundary lies on a circle.
/// @param positions n x 2.
/// @param loop the vertices of the boundary.
/// @throws InvalidInput if all boundary vertices have the same position.
FlatDomain flatDomain(const Points2& positions, const std::vector<int>& loop);

/// The corners (k x 2) of the only polygon of @p data or, if it has no polygon, of its only closed line.
/// @throws InvalidInput if there is not exactly one, or if z is not constant to 1e-6 of the extent.
Points2 polygonOutline(vtkPolyData* data);

} // namespace flattening
