// SPDX-License-Identifier: GPL-3.0-or-later
/// From exact cells to exact faces: moves the vertices of a transported map until every face has its
/// area and none is flipped.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Transport/ConvexDomain.h"

#include <memory>
#include <vector>

namespace flattening
{

struct FaceRefinementOptions
{
  /// What angles count against areas, in [0, 1): 0 asks for areas, with just enough care for angles to
  /// make the map unique.
  double AngleWeight = 0.0;
};

/// The map to be refined, and what it came from.
struct TransportedMap
{
  std::shared_ptr<const ConvexDomain> Domain;
  std::vector<int> Loop;    ///< of the boundary, counter-clockwise
  std::vector<int> Corners; ///< members of the loop that stay
  const Points2& Conformal; ///< n x 2
  const Points2& Positions; ///< n x 2, the same after the transport
  /// n x 2, a map to the domain with no or few faces flipped: the conformal one, if it is one.
  const Points2& OnDomain;
  bool IsContinued = false; ///< Positions were refined before, for nearly the same areas
};

struct FaceRefinementResult
{
  Points2 Positions;
  int Rounds = 0;        ///< each is a pass over the patches whose faces are not right yet
  int RepairedFaces = 0; ///< that were flipped between the two stages, and no longer are
  /// Share of the way from the conformal to the transported map at which a map without flipped faces was
  /// found to begin with again; 1: that was not necessary.
  double StartShare = 1.0;
  int FlippedFaces = 0; ///< not positively oriented (exact)
  /// Whether the map is one-to-one: no face is flipped, and the boundary vertices are in order on the
  /// boundary of a convex domain.
  bool Bijective = false;
};

/// Minimises the energy (RefinementEnergy) in patches of the mesh (RefinementPatches), and where whole
/// regions have too much area or too little, in steps of the whole mesh as well (RefinementDescent). In
/// the first stage faces are free to flip, which converges fast. Then the few flipped faces are turned
/// over (untangleMap); the second stage ends every step before a face flips. Should faces be left
/// that cannot be turned over, the second stage starts from as far along the way from the conformal map
/// as no face is flipped.
/// @p faceTargets (m, >= 0) are the areas that the faces should have, up to a common factor. The errors
/// that are left are not in the result: see measureDistortion().
/// @throws InvalidInput if AngleWeight is out of its range, ConvergenceError, Cancelled.
FaceRefinementResult refineFaces(const TriangleMesh& surface,
  const TransportedMap& map,
  const Eigen::VectorXd& faceTargets,
  const FaceRefinementOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
