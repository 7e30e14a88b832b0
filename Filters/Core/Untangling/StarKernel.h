// SPDX-License-Identifier: GPL-3.0-or-later
/// Where one vertex of a flat mesh may lie.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace flattening
{

/// The side opposite to a vertex in one of its faces, counter-clockwise.
struct OppositeSide
{
  Eigen::Vector2d First;
  Eigen::Vector2d Second;
  double Altitude; ///< the least that the vertex may have over it, > 0
};

/// The place nearest to @p position at which a vertex has the asked altitude over all @p sides of its
/// star; none if there is no such place. One that is found makes all faces of the star positive, but
/// for rounding.
std::optional<Eigen::Vector2d> nearestInKernel(const Eigen::Vector2d& position,
  const std::vector<OppositeSide>& sides);

} // namespace flattening
