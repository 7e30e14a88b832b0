// SPDX-License-Identifier: GPL-3.0-or-later
/// The minimisation of the refinement energy by Newton and quasi-Newton steps.
#pragma once

#include "Areas/RefinementEnergy.h"
#include "Base/Progress.h"

#include <utility>
#include <vector>

namespace flattening
{

/// A round is a Newton step, followed by quasi-Newton steps (L-BFGS; Nocedal and Wright 2006, algorithm
/// 7.4) with the factored Hessian as initial metric: each costs one solution of the factored system
/// where another Newton step would cost a factorization.
class RefinementDescent
{
public:
  /// Finds an order of elimination. The references must live as long as this does. @throws Cancelled.
  RefinementDescent(RefinementEnergy& energy,
    const DegreesOfFreedom& dofs,
    const RefinementTerms& terms,
    SparseCholesky::Kernel kernel = SparseCholesky::Kernel::Blocks,
    const ProgressCallback& progress = {});

  /// Whether steps end before the first face flips. If so, all faces must be positive at the start.
  void keepOrientation(bool keep) { this->KeepsOrientation = keep; }

  /// Whether a round ends after a quasi-Newton step that had to be short: on a large mesh, the many
  /// trials of such steps take longer than they bring. In patches they part the last faces that lie
  /// across each other.
  void endAfterShortStep(bool end) { this->EndsAfterShortStep = end; }

  /// Sets the damping to its initial value. It grows where steps have to be short, as far from the
  /// minimum.
  void resetDamping();

  /// Makes the steps of one round. Returns the relative decrease of the energy; 0 if no step was
  /// possible.
  /// @throws Cancelled, ConvergenceError if the system cannot be factored.
  double round(DomainMap& map, const ProgressCallback& progress = {});

private:
  struct Update // of a quasi-Newton metric
  {
    Eigen::VectorXd Step;
    Eigen::VectorXd Change; // of the gradient
    double Product;
  };
  struct LineSearch
  {
    DomainMap Map;
    double Energy;
    double Length; // of the last step that was tried
    bool Succeeded;
  };
  void factorise(const DomainMap& map, const ProgressCallback& progress);
  Eigen::VectorXd direction(const Eigen::VectorXd& gradient) const;
  LineSearch searchLine(const DomainMap& map,
    double energy,
    const Eigen::VectorXd& step,
    double slope) const;
  void adaptDamping(double length);
  void learn(const Eigen::VectorXd& step, const Eigen::VectorXd& change);
  double lengthToFlip(const DomainMap& map, const Eigen::VectorXd& step) const;

  RefinementEnergy& Energy;
  const DegreesOfFreedom& Dofs;
  const RefinementTerms& Terms;
  SparseCholesky Cholesky;
  bool KeepsOrientation = false;
  bool EndsAfterShortStep = false;
  double Damping;              // added to the Hessian's diagonal
  std::vector<Update> Updates; // since the last factorization
};

} // namespace flattening
