// SPDX-License-Identifier: GPL-3.0-or-later
/// Untangling of flipped faces by moving one vertex each.
#pragma once

#include "Untangling/UntanglingMesh.h"

#include <optional>
#include <vector>

namespace flattening
{

/// The side opposite to a vertex in one of its faces, counter-clockwise.
struct OppositeSide
{
  Eigen::Vector2d First;
  Eigen::Vector2d Second;
  double Altitude; ///< least altitude that the vertex may have over the side, > 0
};

/// The point nearest to @p position at which a vertex has at least the given altitude over all @p sides
/// of its star, or none if there is no such point. At that point all faces of the star are positively
/// oriented, but for rounding.
std::optional<Eigen::Vector2d> nearestInKernel(const Eigen::Vector2d& position,
  const std::vector<OppositeSide>& sides);

/// Untangles the flipped face @p f of @p mesh by moving one of its corners, such that all faces around
/// that corner are positively oriented. Each of them gets a tenth of its target's altitude, or keeps the
/// altitude that it has if that is less. Of the three corners, the one is chosen whose move is the
/// shortest in relation to the edges around it.
/// @returns whether such a move was found; otherwise nothing has moved.
bool untangleByOneVertex(UntanglingMesh& mesh, int f);

} // namespace flattening
