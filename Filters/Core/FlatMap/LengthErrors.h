// SPDX-License-Identifier: GPL-3.0-or-later
/// Statistics of how well a flat map keeps lengths.
#pragma once

#include <vector>

namespace flattening
{

/// The lengths between one source point and other points.
struct SourceLengths
{
  std::vector<double> Ratios;  ///< length on the map over length on the surface, >= 0 and finite
  std::vector<double> Weights; ///< of the pairs, > 0; as many as ratios
};

/// Errors of lengths, relative to those on the surface, after all lengths on the map were multiplied by
/// one scale. All are 0 if there is no pair.
struct LengthErrors
{
  double Scale = 0.0;         ///< units of the surface per unit of the map; it makes Mean least
  double Mean = 0.0;          ///< percent; of each source its mean by weight, every source the same
  double StandardError = 0.0; ///< percent; of Mean, from the differences between sources
  double P95 = 0.0;           ///< percent; 5 percent of the pairs, by weight, have a greater error
};

/// The statistics at the scale that makes the mean error least. Sources without pairs do not count.
LengthErrors lengthErrors(const std::vector<SourceLengths>& sources);

} // namespace flattening
