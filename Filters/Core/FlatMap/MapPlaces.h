// SPDX-License-Identifier: GPL-3.0-or-later
/// Compares places on a flattened surface by where they are on its map.
#pragma once

#include "FlatMap/FlatMapTransfer.h"
#include "Mesh/ClosestPointTree.h"

#include <algorithm>

namespace flattening
{

/// Positions on the map of places on the flattened surface.
class MapPlaces
{
public:
  explicit MapPlaces(const FlattenedSurface& flattened)
    : Flattened(flattened)
  {
  }

  Eigen::RowVector2d position(const SurfacePoint& at) const
  {
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += at.Weights[k] * this->corner(at.Face, k);
    }
    return sum;
  }

  bool areEqual(const SurfacePoint& a, const SurfacePoint& b) const
  {
    return this->position(a) == this->position(b);
  }

  /// Whether they are closer than a millionth of the longest side of their triangles.
  bool areSame(const SurfacePoint& a, const SurfacePoint& b) const
  {
    return (this->position(a) - this->position(b)).norm() <=
           SameOnMap * std::max(this->longestSide(a.Face), this->longestSide(b.Face));
  }

private:
  // The value is between rounding and the distance of the two banks at the vertex before the end of a
  // seam, which is as long as the sides there.
  static constexpr double SameOnMap = 1e-6;

  Eigen::RowVector2d corner(int face, int k) const
  {
    return this->Flattened.Positions.row(this->Flattened.Surface.Faces(face, k));
  }
  double longestSide(int face) const
  {
    return std::max({ (this->corner(face, 0) - this->corner(face, 1)).norm(),
      (this->corner(face, 1) - this->corner(face, 2)).norm(),
      (this->corner(face, 2) - this->corner(face, 0)).norm() });
  }

  const FlattenedSurface& Flattened;
};

} // namespace flattening
