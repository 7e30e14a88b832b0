// SPDX-License-Identifier: GPL-3.0-or-later
/// Maps to the disk in which every inner vertex is a weighted mean of its neighbours.
#pragma once

#include "Base/Progress.h"
#include "Conformal/DiskCentring.h"
#include "Mesh/ComplexPositions.h"

#include <vector>

namespace flattening
{

/// What vertex To weighs in the mean that vertex From is, in any unit that all weights of From share; >=
/// 0. Weights of boundary vertices are not used.
struct NeighbourWeight
{
  int From;
  int To;
  double Weight;
};

/// Whether every pair of inner vertices weighs the same in each other; that saves half of the time.
enum class WeightSymmetry
{
  Symmetric,
  General
};

/// Places the vertices of the boundary @p loop on the unit circle, at @p angles (see BoundaryAngles.h)
/// but for a Moebius map of the circle that makes the whole obey @p centring, and every other vertex at
/// the weighted mean of its neighbours (Floater 1997, "convex combination map"): one factorization of a
/// sparse matrix. The centre is a linear function of the boundary, which shows how much every boundary
/// vertex weighs in it; the Moebius map is the one that puts the centre of these masses at 0.
///
/// With positive weights on every edge no face is flipped (Tutte 1963; Floater 2003, theorem 4.1),
/// chords between boundary vertices or not, as no three points of a circle are on a line. It ends in two
/// places. Weights and positions are rounded: where positions are closer to each other than 1e-15, or a
/// neighbour weighs less than that, faces may flip. And where one boundary vertex weighs half of the
/// centre or more, as where the centre is a neighbour of the boundary, no boundary on the circle has it
/// at 0: a Moebius map is then applied to all of the vertices.
/// @throws ConvergenceError if the matrix cannot be factored or the centre is not found; Cancelled.
ComplexVector convexCombinationDisk(const std::vector<NeighbourWeight>& weights,
  WeightSymmetry symmetry,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  const DiskCentring& centring,
  const ProgressCallback& progress = {});

} // namespace flattening
