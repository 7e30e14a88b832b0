// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map to the disk by Boundary First Flattening.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/DiskCentring.h"

#include <vector>

namespace flattening
{

/// Finds the lengths that a conformal map gives to the edges of the boundary, then extends the boundary
/// to the inside (Sawhney and Crane 2017, "Boundary First Flattening", section 6.1).
///
/// On a circle the curvature is in proportion to the length: with scaled lengths l exp(u) the boundary
/// vertices get their share of 2 pi; the Cherrier equation, a Poisson equation with that boundary
/// curvature, tells new factors u, and so on. Every iteration is one solution by the same factors of the
/// cotangent Laplacian and halves the error. A Moebius map of the disk, under which nothing changes, is
/// taken out in each: the boundary length is kept centred.
///
/// Boundary vertices then are on the circle by construction. The paper goes on with the factors it has
/// and obtains positions whose boundary is a circle but for the discretisation error (1e-2 of the radius
/// on isosurfaces); moving it onto the circle would flip faces along it. Here the inside is the harmonic
/// extension of the circle instead, one more factorization. The cotangents are those of the intrinsic
/// Delaunay triangulation, not negative, so its faces are not flipped (see ConvexCombinationDisk.h);
/// faces of the surface that it does not have may be. Narrow parts whose images doubles do not tell
/// apart are spread as those of the Ricci flow are (see HornSpreading.h), by the scale that the Poisson
/// equation tells.
///
/// MaxCurvatureError and LayoutError are NaN, LogFactors not computed.
/// @p mesh is a disk with the boundary @p loop (see requireDisk). The map is centred, not rotated, and
/// its flipped faces are not counted.
/// @throws ConvergenceError if a matrix cannot be factored or the boundary does not settle; Cancelled.
ConformalDiskMap boundaryFirstDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const ProgressCallback& progress);

} // namespace flattening
