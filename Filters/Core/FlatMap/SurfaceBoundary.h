// SPDX-License-Identifier: GPL-3.0-or-later
/// The boundary of a surface and the seams along which it was cut open.
#pragma once

#include "Mesh/ClosestPointTree.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace flattening
{

/// The boundary of an oriented manifold. An edge of it belongs to a seam if another edge of the
/// boundary, the other bank, has the same ends in space, and the opposite direction; all others are the
/// border. The surface must outlive it.
class SurfaceBoundary
{
public:
  enum class Part : char
  {
    None,  ///< not on the boundary
    Seam,  ///< the surface goes on at another bank
    Border ///< the surface ends here; the end of a seam that meets the border belongs to it
  };

  /// @throws InvalidInput, TopologyError as analyseTopology does.
  explicit SurfaceBoundary(const TriangleMesh& surface);

  bool hasSeams() const { return this->HasSeams; }

  /// The part of the boundary that a point of the surface lies on.
  Part partAt(const SurfacePoint& at) const;

  /// Whether the last edge of a seam that ends inside the surface lies inside a triangle in space, one
  /// corner per row, at least in part. Only the part that is nearer to it than @p tolerance counts.
  bool hasSeamEndIn(const Eigen::Matrix3d& triangle, double tolerance) const;

private:
  const TriangleMesh& Surface;
  std::map<std::pair<int, int>, Part> Edges; // the smaller vertex first
  std::vector<Part> Vertices;
  std::vector<std::pair<int, int>> Ends; // the last vertex of a seam and the one before
  bool HasSeams = false;
};

} // namespace flattening
