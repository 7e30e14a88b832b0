// SPDX-License-Identifier: GPL-3.0-or-later
/// One round of the minimisation of the refinement energy.
#pragma once

#include "Areas/RefinementEnergy.h"
#include "Base/Progress.h"

#include <utility>
#include <vector>

namespace flattening
{

/// A Newton step with the energy's Hessian, and quasi-Newton steps (L-BFGS) from there that have its
/// factor as their first metric: each costs one solution of the factored system where another Newton
/// step would cost a factorization.
class RefinementDescent
{
public:
  /// Finds an order of elimination. @throws Cancelled.
  RefinementDescent(RefinementEnergy& energy,
    const DegreesOfFreedom& dofs,
    const FaceMatrix& faces,
    SparseCholesky::Kernel kernel = SparseCholesky::Kernel::Blocks,
    const ProgressCallback& progress = {});

  /// Whether steps end before the first face is flipped. All faces must be positive then.
  void keepOrientation(bool keep) { this->KeepsOrientation = keep; }

  /// Damping follows how far steps can be made, which far from the minimum is not far; this makes it as
  /// little as in the beginning.
  void resetDamping();

  /// Makes the steps. Returns the share of the energy that it fell by; 0 if no step could be made.
  /// @throws Cancelled, ConvergenceError if the system cannot be factored.
  double round(DomainMap& map, const ProgressCallback& progress = {});

private:
  void factorise(const DomainMap& map, const ProgressCallback& progress);
  Eigen::VectorXd direction(const Eigen::VectorXd& gradient) const;
  double lengthToFlip(const DomainMap& map, const Eigen::VectorXd& step) const;

  RefinementEnergy& Energy;
  const DegreesOfFreedom& Dofs;
  const FaceMatrix& Faces;
  SparseCholesky Cholesky;
  bool KeepsOrientation = false;
  double Damping; // of the Hessian's diagonal
  struct Update
  {
    Eigen::VectorXd Step;
    Eigen::VectorXd Change; // of the gradient
    double Product;
  };
  std::vector<Update> Updates; // since the last factorization
};

} // namespace flattening
