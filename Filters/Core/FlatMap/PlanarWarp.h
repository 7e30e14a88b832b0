// SPDX-License-Identifier: GPL-3.0-or-later
/// The piecewise linear map between a planar mesh and its flat map.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/FlatMapLocation.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The z of a mesh in a plane of constant z.
/// @throws InvalidInput if the mesh has no triangles or a point that is not finite, or if z is not
/// constant to 1e-6 of the larger extent.
double planeHeight(const TriangleMesh& mesh);

struct WarpedPoints
{
  Points2 Positions; ///< n x 2, in the other shape of the mesh; unmoved if the point is not inside
  std::vector<char> Inside; ///< one flag per point: 1 if it lies on the shape of the mesh it is given in
};

/// Maps points between a planar mesh and its flat map: a point keeps its barycentric coordinates in its
/// face.
class PlanarWarp
{
public:
  /// A point farther off the mesh than this share of the diagonal of its bounding box is outside. Data
  /// and mesh may have been rounded to single precision, about 1e-7; a smaller value loses points there.
  static constexpr double Rounding = 1e-6;

  /// @param mesh the undeformed mesh, in a plane of constant z (input units).
  /// @param positions the positions of its vertices in the flat map (n x 2).
  /// @throws InvalidInput as FlatMapLocation does; if z is not constant to 1e-6 of the larger extent; or
  /// if the faces with an area are not all oriented alike, so that the mesh folds over itself.
  PlanarWarp(const TriangleMesh& mesh, const Points2& positions, const ProgressCallback& progress = {});

  /// Maps points (n x 2) from the undeformed mesh to the flat map. A point that is not finite is
  /// outside.
  WarpedPoints warp(const Points2& points, const ProgressCallback& progress = {}) const;

  /// Maps points (n x 2) from the flat map to the undeformed mesh.
  WarpedPoints warpBack(const Points2& points, const ProgressCallback& progress = {}) const;

  double planeHeight() const { return this->PlaneHeight; } ///< z of the undeformed mesh
  /// Whether the undeformed mesh faces towards negative z.
  bool facesDown() const { return this->FacesDown; }
  double meanSide() const { return this->MeanSide; } ///< mean side of the undeformed mesh's triangles

private:
  double PlaneHeight;
  bool FacesDown;
  double MeanSide;
  double Diagonals[2]; // of the bounding boxes of the undeformed mesh and the flat map
  FlatMapLocation Location;
};

} // namespace flattening
