// SPDX-License-Identifier: GPL-3.0-or-later
/// The region of the plane that a flat surface covers, and polygons that users give for one.
#pragma once

#include "Core/Mesh/TriangleMesh.h"
#include "Core/Transport/ConvexDomain.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace flattening
{

/// What a flat surface covers: a disk around the origin, or the rectangle along the axes whose sides its
/// boundary lies on.
struct FlatDomain
{
  bool IsRectangle = false;
  Eigen::RowVector2d Centre = Eigen::RowVector2d::Zero();
  double Width = 0.0; ///< of the rectangle
  double Height = 0.0;
  double Scale = 1.0; ///< over a domain of area pi

  /// The same of area pi around the origin.
  std::shared_ptr<const ConvexDomain> normalised() const;
};

/// @p loop are the vertices of the boundary.
/// @throws InvalidInput if they are all in one place. Whether they lie on a circle is not checked.
FlatDomain flatDomain(const Points2& positions, const std::vector<int>& loop);

/// The corners in the plane of the one polygon in @p data, or of its one closed line if there is no
/// polygon, in order.
/// @throws InvalidInput if there is not exactly one, or if its z is not constant to 1e-6 of its extent.
Points2 polygonOutline(vtkPolyData* data);

} // namespace flattening
