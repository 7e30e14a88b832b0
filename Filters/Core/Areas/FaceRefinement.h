// SPDX-License-Identifier: GPL-3.0-or-later
/// From exact cells to exact faces: moves the vertices of a transported map until every face has its
/// target area and none is flipped.
#pragma once

#include "Areas/WarmStart.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Transport/ConvexDomain.h"

#include <memory>
#include <vector>

namespace flattening
{

/// The options of the face refinement.
struct FaceRefinementOptions
{
  /// The weight of angles against areas, in [0, 1): 0 asks for areas, with just enough weight of the
  /// angles to make the map unique.
  double AngleWeight = 0.0;
  /// Whether a map on the way to the transported one, where its faces cannot be untangled, is returned
  /// as it is (see FaceRefinementResult::StartShare): it can be transported again from there.
  bool StopsOnTheWay = false;
};

/// The weight of shapes against areas in the refinement energy, > 0.
/// @throws InvalidInput if AngleWeight is out of its range.
double shapeWeight(const FaceRefinementOptions& options);

/// The map to be refined, and the maps from which it was made.
struct TransportedMap
{
  std::shared_ptr<const ConvexDomain> Domain;
  std::vector<int> Loop;    ///< the boundary vertices, counter-clockwise
  std::vector<int> Corners; ///< indices into Loop of the vertices that stay
  const Points2& Conformal; ///< n x 2, the conformal map
  const Points2& Positions; ///< n x 2, the map to be refined
  /// n x 2, a map to the domain with no or few faces flipped. It is the conformal map itself if that is
  /// a map to the domain, and otherwise a map made from it.
  const Points2& OnDomain;
  RefinementStart Start = RefinementStart::Transport; ///< what Positions come from
};

/// The refined map, and how it was found.
struct FaceRefinementResult
{
  Points2 Positions;     ///< n x 2
  int Rounds = 0;        ///< number of passes over the patches whose faces are not right yet
  int RepairedFaces = 0; ///< faces that were flipped after the first stage and untangled
  /// Where on the way from TransportedMap::OnDomain (0) to the transported map (1) the map lies from
  /// which the second stage started, or would have (StopsOnTheWay). 1 if the refinement did not have to
  /// go back on this way, or found no map there that could be untangled.
  double StartShare = 1.0;
  int FlippedFaces = 0; ///< faces not positively oriented (exact)
  /// Whether the map is one-to-one: no face is flipped, and the boundary vertices are in order on the
  /// boundary of a convex domain.
  bool Bijective = false;

  bool isOnTheWay() const { return this->StartShare > 0.0 && this->StartShare < 1.0; }
};

/// Minimises the energy (RefinementEnergy) in patches of the mesh (RefinementPatches), and where whole
/// regions have too much or too little area, by smooth deformations of the domain (smoothlyDeformed) or,
/// where these would flip faces, by steps of the whole mesh (RefinementDescent). In the first stage
/// faces are free to flip, which converges fast. Then the few flipped faces are untangled (untangleMap);
/// the second stage ends every step before a face flips. If not all of the flipped faces can be
/// untangled, the refinement tries a map between TransportedMap::OnDomain and the transported map, and
/// then OnDomain itself. The second stage starts from the first of them in which all flipped faces can
/// be untangled (docs/mathematics.md, "On the way"), or with StopsOnTheWay does not take place if that
/// map is not OnDomain itself. If there is none, the second stage does not take place either, and faces
/// remain flipped.
/// @p faceTargets (m, >= 0) are the areas that the faces should have, up to a common factor. See
/// measureDistortion() for the errors that are left.
/// @throws InvalidInput if AngleWeight is out of its range, ConvergenceError, Cancelled.
FaceRefinementResult refineFaces(const TriangleMesh& surface,
  const TransportedMap& map,
  const Eigen::VectorXd& faceTargets,
  const FaceRefinementOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
