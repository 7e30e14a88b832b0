// SPDX-License-Identifier: GPL-3.0-or-later
/// Minimisation of the authalic energy, and its balance with the conformal energy: baselines for maps to
/// the disk.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening::benchmarks
{

/// The map to the unit disk that makes the authalic energy least by preconditioned nonlinear conjugate
/// gradients, with the boundary free to move along the circle. The energy is T / A sum a^2 / t - A, a
/// being the flat areas and A their sum, t those of the surface and T their sum (Liu and Yueh 2024,
/// "Convergent Authalic Energy Minimization for Disk Area-Preserving Parameterizations", J. Sci. Comput.
/// 100). It begins with five iterations of stretchEnergyDiskMap(), and the preconditioner is the
/// Laplacian of that energy there. Faces may flip.
/// @throws InvalidInput, TopologyError, ConvergenceError (see stretchEnergyDiskMap).
Points2 authalicEnergyDiskMap(const TriangleMesh& mesh, int iterations = 100);

/// The map to the unit disk (n x 2), and its two energies.
struct BalancedMap
{
  Points2 Positions;
  double AuthalicEnergy = 0.0;
  double ConformalEnergy = 0.0;
};

/// The map to the unit disk with the least conformal energy (Dirichlet's less A) among those whose
/// authalic energy is as large (Liu and Yueh 2024, "Energy-Based Distortion-Balancing Parameterization
/// for Open Surfaces", arXiv:2412.09909), by the augmented Lagrangian, each of whose minimisations goes
/// as in authalicEnergyDiskMap(). The energies say how near to each other it came. Faces may flip.
/// @throws as authalicEnergyDiskMap().
BalancedMap balancedDiskMap(const TriangleMesh& mesh);

} // namespace flattening::benchmarks
