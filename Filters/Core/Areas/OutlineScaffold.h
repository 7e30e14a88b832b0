// SPDX-License-Identifier: GPL-3.0-or-later
/// The gaps beside the free outline of a map as further faces of the refinement energy.
#pragma once

#include "Areas/RefinementTerms.h"
#include "Mesh/TriangleMesh.h"
#include "Mesh/VertexFaces.h"

#include <Eigen/Core>

namespace flattening
{

/// Fills the gaps of an outline (outlineGaps) with faces, so that no part of it moves across another
/// (Jiang, Schaefer and Panozzo 2017, "Simplicial complex augmentation framework for bijective maps").
/// The gaps should keep the areas and shapes that they have, with little weight. As the outline moves, a
/// new scaffold is made again and again.
class OutlineScaffold
{
public:
  /// Whether gaps in shallow bays (withoutShallowBays) are left out, which lets bays become convex, or
  /// are faces like the others, without which the outline may cross itself there.
  enum class ShallowBays
  {
    Open,
    Filled
  };

  /// @p terms are those of the mesh, with the edges of its boundary, in order, as their outline. None of
  /// these may cross at @p positions (n x 2). @p targets (m, > 0) are the areas that the faces of the
  /// mesh should have.
  OutlineScaffold(const RefinementTerms& terms,
    const Points2& positions,
    const Eigen::VectorXd& targets,
    ShallowBays bays = ShallowBays::Open);

  /// The terms of the faces of the mesh, followed by those of the gaps.
  const RefinementTerms& terms() const { return this->All; }
  const VertexFaces& facesOf() const { return this->FacesOf; }

  /// What RefinementEnergy needs for these, from what it is for the faces of the mesh (m, > 0).
  Eigen::VectorXd targets(const Eigen::VectorXd& ofMesh) const;
  Eigen::VectorXd areaWeights(const Eigen::VectorXd& ofMesh) const;
  Eigen::VectorXd counts(const Eigen::VectorXd& ofMesh) const;

private:
  RefinementTerms All;
  VertexFaces FacesOf;
  Eigen::VectorXd GapAreas;
  double MeanTarget;
};

} // namespace flattening
