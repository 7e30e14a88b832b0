// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map to the disk by Boundary First Flattening.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/DiskNormalisation.h"

#include <vector>

namespace flattening
{

/// Finds the lengths that a conformal map gives to the edges of the boundary, then extends the boundary
/// to the inside (Sawhney and Crane 2017, "Boundary First Flattening", section 6.1).
///
/// On a circle the curvature is proportional to the length: with scaled lengths l exp(u) every boundary
/// vertex gets its share of 2 pi. The Cherrier equation, a Poisson equation with that boundary
/// curvature, gives new factors u, and so on. Every iteration is one solution with the same
/// factorization of the cotangent Laplacian and halves the error. The iteration is free up to a Moebius
/// map of the disk, which each step fixes by centring the boundary length.
///
/// Boundary vertices are on the circle by construction. The paper derives positions from the factors,
/// whose boundary is a circle up to the discretisation error (1e-2 of the radius on isosurfaces); moving
/// it onto the circle would flip faces along it. Here the inside is the harmonic extension of the circle
/// instead, which takes one more factorization. The cotangents are those of the intrinsic Delaunay
/// triangulation and not negative, so that no intrinsic triangle is flipped (see
/// ConvexCombinationDisk.h); faces of the surface may be. Protrusions are spread as for the Ricci flow
/// (see ProtrusionSpreading.h), with factors from the Poisson equation.
///
/// MaxCurvatureError and LayoutError are NaN; LogFactors and Untangling are not computed; the map is
/// centred, not rotated.
/// @p mesh is a disk with the boundary @p loop (see requireDisk).
/// @throws ConvergenceError if a matrix cannot be factored or the boundary does not settle; Cancelled.
ConformalDiskMap boundaryFirstDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const ProgressCallback& progress);

} // namespace flattening
