// SPDX-License-Identifier: GPL-3.0-or-later
/// The choice of a tree of seams, the relief, that lets a surface become flat with less distortion.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

struct ReliefOptions
{
  /// The strain (ConformalStrain) that a relief must take away to be worth its length, if that is the
  /// square root of the surface's area, and in proportion if it is another (>= 0): of all reliefs that
  /// are tried, the one is taken for which the sum of the strain and of Gain times the length is least.
  /// Each branch counts as if it were longer by 0.05 square roots of the area. On brains 0.03 of strain
  /// is about one degree of mean angle error: with 0.01, a third of a degree is worth such a length.
  /// A half brain has 5.6, 5.0, 4.5 and 4.3 degrees with 0.05, 0.02, 0.01 and 0.005, after 1.2, 1.6, 2.3
  /// and 2.9 such lengths.
  double Gain = 0.01;
  /// The greatest length of all branches together, in square roots of the surface's area (> 0). The
  /// first branch of a closed surface is cut whatever its length. Of twelve scans, grey matter takes
  /// most, 15.
  double Longest = 20.0;
  /// The shortest relief is taken whose sum of strain and price is greater than the least sum by this
  /// share at most (>= 0; 0.02 means 2 %).
  double Slack = 0.0;
  /// The least strain of an open surface that gets a branch (>= 0).
  double LeastStrain = 0.0;
};

struct PlacedRelief
{
  /// The ends of the branches, in their order (input units): each is joined to the boundary and the
  /// branches before it by a shortest path. On a closed surface the first branch joins the first two.
  std::vector<Eigen::Vector3d> Tips;
  /// The strain of the surface as it is, without a branch, or opened at the first tip alone if it is
  /// closed.
  double StrainBefore = 0.0;
  double StrainAfter = 0.0; ///< with all branches
};

/// Places branches one after the other on a coarse copy of a connected surface of genus 0, with one
/// boundary or none. Candidates for the next tip are the places where the conformal factor of the map
/// with a free outline peaks, as Gaussian curvature has to go there. Of the candidates the one is taken
/// that lowers the strain most for its length (the greedy trade of length for distortion is that of Li
/// et al. 2018, "OptCuts", the peaks those of Chai et al. 2019, "Surface cutting by voting"), until no
/// longer relief can be worth its length; the branches after the best of these reliefs are taken back.
/// The first tip of a closed surface is the peak of the factor of a surface opened at any other point.
/// @param avoided  one flag per vertex, not 0 where no branch may be; empty: they may be anywhere
/// @throws InvalidInput if the flags are of another number than the vertices or all set, or an option is
/// out of range; ConvergenceError; Cancelled.
PlacedRelief placeRelief(const TriangleMesh& mesh,
  const std::vector<char>& avoided,
  const ReliefOptions& options,
  const ProgressCallback& progress = {});

} // namespace flattening
