// SPDX-License-Identifier: GPL-3.0-or-later
/// Minimisation of the authalic energy, and of its sum with the conformal energy: baselines for maps to
/// the disk.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening::benchmarks
{

struct AuthalicOptions
{
  /// Iterations of the conjugate gradients.
  int Iterations = 100;
  /// Share of the conformal energy, in [0, 1): 0 for areas alone, 1/2 for a balance of both distortions.
  double ConformalShare = 0.0;
};

/// The map to the unit disk that makes an energy least by preconditioned nonlinear conjugate gradients,
/// with the boundary free to move along the circle. The energy of areas is T / A sum a^2 / t - A, a
/// being the flat areas and A their sum, t those of the surface and T their sum (Liu and Yueh 2024,
/// "Convergent Authalic Energy Minimization for Disk Area-Preserving Parameterizations", J. Sci. Comput.
/// 100). The conformal energy is Dirichlet's less sum a (Liu and Yueh 2024, "Energy-Based
/// Distortion-Balancing Parameterization for Open Surfaces", arXiv:2412.09909, add the two). It begins
/// with five iterations of stretchEnergyDiskMap(), and the preconditioner is the Laplacian of that
/// energy there. Faces may flip.
/// @throws InvalidInput, TopologyError, ConvergenceError (see stretchEnergyDiskMap).
Points2 authalicEnergyDiskMap(const TriangleMesh& mesh, const AuthalicOptions& options);

} // namespace flattening::benchmarks
