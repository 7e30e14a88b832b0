// SPDX-License-Identifier: GPL-3.0-or-later
/// The areas that the vertices and faces of a map should have, from the surface and from weights.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The area that each vertex should get in a domain of area pi (n): a third of its incident faces' areas
/// times its weight, scaled to the sum pi (paper, section 4.1). @p weights (n, > 0) may be empty: all 1.
/// @throws InvalidInput if a weight is not a positive number, if weights leave a vertex less than 2e-16
/// of the domain, or if a vertex has no area.
Eigen::VectorXd targetAreas(const TriangleMesh& mesh, const Eigen::VectorXd& weights);

/// The area that each face should get, up to a common factor (m, > 0): its area times the mean weight of
/// its corners. Faces without area on the surface count as if they had a millionth of the mean area.
/// @p weights (n, > 0) may be empty: all 1.
Eigen::VectorXd faceTargets(const TriangleMesh& mesh, const Eigen::VectorXd& weights);

/// Target areas that straight-sided faces can have in the unit disk. Near the circle, faces that are
/// stretched along it and thinner than the segment that their longest side cuts off cannot lie beside
/// each other without flipping: where a small hole becomes the boundary, all faces are like that.
/// Returns
/// @p targets (m), raised for such faces to a share of the segment's area (side^3 / 12) and at most to a
/// share of the mean target, and scaled back to their sum. The length of a side is taken from
/// @p positions (n x 2), or from @p conformal (n x 2) stretched in proportion to the distance from the
/// centre if that is shorter.
Eigen::VectorXd resolvableAreas(const FaceMatrix& faces,
  const Points2& conformal,
  const Points2& positions,
  const Eigen::VectorXd& targets);

/// @p targets (m, > 0) scaled to the sum @p area.
Eigen::VectorXd scaledTargets(const Eigen::VectorXd& targets, double area);

/// How much the relative area error of each face counts in the refinement energy, against its target
/// area (m, >= 1), from the areas of the faces on the surface (m, >= 0): that of a face smaller than
/// half of their mean counts as if it were so large, up to 20 times its own. The shapes of large faces
/// around a small one pull at its corners; with weights of 1, one in a hundred faces of an isosurface is
/// off by more than 2 % at the minimum.
Eigen::VectorXd areaWeights(const Eigen::VectorXd& areas);

/// How much each face counts in the refinement energy, against its target area: its area on the surface
/// over its target (m, >= 0, up to a common factor), both as shares of their sums. So faces count by
/// what they are on the surface; by their targets, those with small area weights were no part of the
/// sum. Exactly 1 where @p targets are the areas of the faces.
Eigen::VectorXd faceCounts(const TriangleMesh& surface, const Eigen::VectorXd& targets);

} // namespace flattening
