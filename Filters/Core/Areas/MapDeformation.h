// SPDX-License-Identifier: GPL-3.0-or-later
/// Smooth deformations of a flat map after which no face is flipped.
#pragma once

#include "Areas/DeformationEnergy.h"
#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementTerms.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Mesh/VertexFaces.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// Deforms the flat maps of one surface (smoothlyDeformed). Where a deformation bends the sides of thin
/// faces so far that they flip, they are untangled, or a part of the deformation is taken.
class MapDeformation
{
public:
  /// The arguments must live as long as this does.
  MapDeformation(const TriangleMesh& surface,
    const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& dofs);

  /// The aim of a deformation.
  struct Request
  {
    DeformationEnergy::Shapes Shapes; ///< that faces should have
    double AreaWeight;                ///< of areas against shapes, > 0
    bool MayFlip;                     ///< whether a few faces more may be flipped afterwards
  };

  /// Deforms @p map. Without @p request.MayFlip no face of it may be flipped, nor is one afterwards; an
  /// outline without a crossing gets none. @p targets (m, > 0) are the areas that the faces should have.
  /// Returns false and leaves the map if every share of the deformation flips faces that cannot be
  /// untangled, or lets the outline cross itself. @throws Cancelled.
  bool deform(DomainMap& map,
    const Eigen::VectorXd& targets,
    const Request& request,
    const ProgressCallback& progress) const;

private:
  int countFlipped(const DomainMap& map) const;
  bool untangle(const DomainMap& before,
    DomainMap& map,
    const Eigen::VectorXd& targets,
    const ProgressCallback& progress) const;
  std::vector<char> onBoundary() const;

  const TriangleMesh& Surface;
  const RefinementTerms& Terms;
  const VertexFaces& FacesOf;
  const DegreesOfFreedom& Dofs;
};

} // namespace flattening
