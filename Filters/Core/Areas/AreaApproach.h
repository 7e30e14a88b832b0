// SPDX-License-Identifier: GPL-3.0-or-later
/// The way of the areas of a flat map to their targets.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// The areas go from those of a map to the targets along straight lines in their logarithms. Steps on
/// the way keep the changes of areas small, as far as a deformation can follow them.
class AreaApproach
{
public:
  /// @p positions (n x 2) are those of the map, @p targets (m, > 0) the areas that its faces should
  /// have, up to a common factor. An area that is 0 or less counts as the least positive number.
  AreaApproach(const Points2& positions, const FaceMatrix& faces, const Eigen::VectorXd& targets);

  /// The standard deviation of the logarithms of the ratios of areas to targets, weighted by the
  /// targets.
  double distance() const;

  /// The number of equal steps to the targets of which none changes distance() by more than 0.3; from 1
  /// to 100, so that longer ways have longer steps.
  int steps() const;

  /// The areas (m) after @p share of the way, with the sum @p area.
  Eigen::VectorXd targets(double share, double area) const;

private:
  Eigen::ArrayXd First; // logarithms
  Eigen::ArrayXd Last;
};

} // namespace flattening
