// SPDX-License-Identifier: GPL-3.0-or-later
/// Carries points with a planar mesh that was deformed.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/FlatMapLocation.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct CarriedPoints
{
  Points2 Positions;        ///< in the other shape of the mesh; where the point was, if it is not inside
  std::vector<char> Inside; ///< per point: 1 if it lies on the shape that it comes from
};

/// The piecewise linear map between a planar mesh and its flat map: a point keeps its barycentric
/// coordinates in its face.
class PlanarWarp
{
public:
  /// A point that lies off the mesh by no more than this share of its diagonal counts as inside: data
  /// and mesh may have been rounded to single precision.
  static constexpr double Rounding = 1e-6;

  /// @param mesh the undeformed mesh, in a plane of constant z. @param positions its vertices' (n x 2)
  /// in the flat map.
  /// @throws InvalidInput as FlatMapLocation, if z is not constant (to 1e-6 of the larger extent), or if
  /// the faces of @p mesh do not all face the same way (exactly; faces without area aside), so that it
  /// folds over itself.
  PlanarWarp(const TriangleMesh& mesh, const Points2& positions, const ProgressCallback& progress = {});

  /// From the undeformed mesh to the flat map. A point that is not finite is not inside.
  CarriedPoints carry(const Points2& points, const ProgressCallback& progress = {}) const;

  /// From the flat map to the undeformed mesh.
  CarriedPoints carryBack(const Points2& points, const ProgressCallback& progress = {}) const;

  double planeHeight() const { return this->PlaneHeight; } ///< z of the undeformed mesh
  bool facesDown() const { return this->FacesDown; }       ///< the undeformed mesh, towards negative z
  double meanSide() const { return this->MeanSide; }       ///< of the undeformed mesh's faces

private:
  double PlaneHeight;
  bool FacesDown;
  double MeanSide;
  double Diagonals[2]; // of the undeformed mesh and of the flat map
  FlatMapLocation Location;
};

} // namespace flattening
