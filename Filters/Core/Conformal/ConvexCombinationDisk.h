// SPDX-License-Identifier: GPL-3.0-or-later
/// Convex combination maps to the disk: every interior vertex is a weighted mean of its neighbours.
#pragma once

#include "Base/Progress.h"
#include "Conformal/DiskNormalisation.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/GraphLaplacian.h"

#include <vector>

namespace flattening
{

/// Places the vertices of the boundary @p loop on the unit circle and every other vertex at the weighted
/// mean of its neighbours (Floater 1997, "convex combination map"), by one factorization of a sparse
/// matrix. The boundary has @p angles (radians, see BoundaryAngles.h) up to the Moebius map of the
/// circle with which the whole obeys @p centring: the centre is a linear function of the boundary, which
/// gives every boundary vertex a mass, and the Moebius map puts the centre of these masses at 0.
///
/// With positive weights on all edges no face is flipped (Tutte 1963; Floater 2003, theorem 4.1), even
/// with edges between boundary vertices, as no three points of a circle are on a line. There are two
/// exceptions. Where positions are closer to each other than 1e-15, or a neighbour's share is less than
/// that, rounding may flip faces. And if one boundary vertex carries half of the mass or more, as where
/// the centre is a neighbour of the boundary, no boundary on the circle has the centre at 0: a Moebius
/// map is applied to all vertices then.
/// @throws ConvergenceError if the matrix cannot be factored or the centre is not found; Cancelled.
ComplexVector convexCombinationDisk(const std::vector<NeighbourWeight>& weights,
  WeightSymmetry symmetry,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  const DiskCentring& centring,
  const ProgressCallback& progress = {});

} // namespace flattening
