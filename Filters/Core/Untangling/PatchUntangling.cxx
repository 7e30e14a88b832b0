// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/PatchUntangling.h"

#include "Base/SparseFactorization.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/GraphLaplacian.h"
#include "Untangling/SmoothPositivePart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

// Most Newton steps: a guard against endless work on a patch that cannot be untangled.
constexpr int MostSteps = 300;
// The first epsilon, in units of the most negative area ratio or of 1. A choice: with more, the energy
// hardly notices flipped faces; with less, its first steps are short.
constexpr double FirstEpsilon = 0.1;
// The ratio of epsilon to the most negative area ratio at which untangling is given up as hopeless: the
// energy is then so steep that no step untangles a face. A choice between lost patches and lost time.
constexpr double HopelessEpsilon = 1e-2;
// Relative decrease of the energy by a step at which a patch without flipped faces is good enough. Its
// shape is a matter of taste, so a smaller value only costs steps.
constexpr double LeastEnergyDecrease = 1e-4;
// Share of the predicted decrease that a step must reach: the usual constant of Armijo's rule.
constexpr double ArmijoShare = 1e-4;
// Most halvings of a step: a guard, for 2^-40 of a step moves nothing.
constexpr int MostHalvings = 40;
// Share of its own that is added to the diagonal of the Hessian, which may be singular otherwise. A
// guard: large against rounding, small against everything else.
constexpr double Damping = 1e-9;
// The number of unknowns from which on an abort does not wait for a factorization: a choice. With so
// many it takes some hundredths of a second, a thousand times as long as to begin a thread for it.
constexpr int ManyUnknowns = 10000;

// The next epsilon, after a step to the least area ratio @p least <= 0 that reduced the energy to a @p
// share: chi of that ratio is reduced to the same share, and by at least a tenth.
double smallerEpsilon(double epsilon, double least, double share)
{
  const double chi = smoothPositivePart(least, epsilon).Value;
  const double next = std::min(0.9, share) * chi;
  return 2.0 * std::sqrt(next * (next - least));
}

class Minimisation
{
public:
  Minimisation(FlatPatch& patch, double areaWeight, const ProgressCallback& progress)
    : Patch(patch)
    , Progress(progress)
  {
    for (const TargetTriangle& target : patch.Targets)
    {
      this->Energies.emplace_back(target, areaWeight);
    }
  }

  UntangledPatch run()
  {
    UntangledPatch result;
    double least = this->leastAreaRatio();
    double epsilon = least > 0.0 ? 0.0 : FirstEpsilon * std::max(1.0, -least);
    while (result.Steps < MostSteps && epsilon >= -HopelessEpsilon * least)
    {
      this->Fraction = static_cast<double>(result.Steps) / MostSteps;
      this->reportStep();
      const double before = this->energy(this->Patch.Positions, epsilon);
      const double after = this->follow(this->newtonDirection(epsilon), before, epsilon);
      ++result.Steps;
      if (least > 0.0 && !(before - after > LeastEnergyDecrease * before))
      {
        break;
      }
      least = this->leastAreaRatio();
      epsilon = least > 0.0 ? 0.0 : smallerEpsilon(epsilon, least, after / before);
    }
    result.Positive = least > 0.0;
    return result;
  }

private:
  void reportStep() const { report(this->Progress, this->Fraction, UntanglingStage); }

  FoldoverEnergy::Corners corners(const Points2& positions, int face) const
  {
    FoldoverEnergy::Corners result;
    for (int k = 0; k < 3; ++k)
    {
      result.row(k) = positions.row(this->Patch.Faces(face, k));
    }
    return result;
  }

  double leastAreaRatio() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < this->Patch.Faces.rows(); ++f)
    {
      least = std::min(least, this->Energies[f].areaRatio(this->corners(this->Patch.Positions, f)));
    }
    return least;
  }

  double energy(const Points2& positions, double epsilon) const
  {
    double sum = 0.0;
    for (int f = 0; f < this->Patch.Faces.rows(); ++f)
    {
      sum += this->Energies[f].value(this->corners(positions, f), epsilon);
    }
    return sum;
  }

  // Row 2 i + c belongs to coordinate c of free vertex i. Sets Slope, too.
  Eigen::VectorXd newtonDirection(double epsilon)
  {
    const int unknowns = 2 * this->Patch.FreeVertices;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(21 * this->Patch.Faces.rows());
    for (int f = 0; f < this->Patch.Faces.rows(); ++f)
    {
      const auto derivatives =
        this->Energies[f].derivatives(this->corners(this->Patch.Positions, f), epsilon);
      for (int a = 0; a < 6; ++a)
      {
        const int row = 2 * this->Patch.Faces(f, a / 2) + a % 2;
        if (row >= unknowns)
        {
          continue;
        }
        gradient[row] += derivatives.Gradient[a];
        for (int b = 0; b < 6; ++b)
        {
          const int column = 2 * this->Patch.Faces(f, b / 2) + b % 2;
          if (column <= row)
          {
            const double damping = a == b ? 1.0 + Damping : 1.0;
            entries.emplace_back(row, column, damping * derivatives.Hessian(a, b));
          }
        }
      }
    }
    SparseMatrix hessian(unknowns, unknowns);
    hessian.setFromTriplets(entries.begin(), entries.end());
    this->factorise(std::move(hessian));
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(unknowns);
    if (this->Cholesky.info() == Eigen::Success)
    {
      direction = this->Cholesky.solve((-gradient).eval());
    }
    this->Slope = direction.dot(gradient);
    return direction;
  }

  void factorise(SparseMatrix hessian)
  {
    if (hessian.rows() < ManyUnknowns)
    {
      this->Cholesky.compute(hessian);
    }
    else
    {
      this->Cholesky.compute(std::move(hessian), this->Progress, this->Fraction, UntanglingStage);
    }
  }

  // Takes a step along the direction that is so short that the energy falls enough, and returns the
  // energy after it.
  double follow(const Eigen::VectorXd& direction, double before, double epsilon)
  {
    const Eigen::Map<const Points2> moves(direction.data(), this->Patch.FreeVertices, 2);
    double length = 1.0;
    for (int halving = 0; halving < MostHalvings && this->Slope < 0.0; ++halving)
    {
      Points2 trial = this->Patch.Positions;
      trial.topRows(this->Patch.FreeVertices) += length * moves;
      const double value = this->energy(trial, epsilon);
      if (value <= before + ArmijoShare * length * this->Slope)
      {
        this->Patch.Positions = trial;
        return value;
      }
      length *= 0.5;
      this->reportStep();
    }
    return before;
  }

  FlatPatch& Patch;
  const ProgressCallback& Progress;
  double Fraction = 0.0; // of the steps
  std::vector<FoldoverEnergy> Energies;
  SparseCholesky Cholesky;
  double Slope = 0.0; // derivative of the energy along the direction
};

} // namespace

UntangledPatch untanglePatch(FlatPatch& patch, double areaWeight, const ProgressCallback& progress)
{
  return Minimisation(patch, areaWeight, progress).run();
}

void relaxPatch(FlatPatch& patch, const ProgressCallback& progress)
{
  std::vector<NeighbourWeight> weights;
  for (int f = 0; f < patch.Faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int next = patch.Faces(f, (k + 1) % 3);
      weights.push_back({ patch.Faces(f, k), next, 1.0 });
      weights.push_back({ next, patch.Faces(f, k), 1.0 });
    }
  }
  std::vector<char> fixed(patch.Positions.rows(), 1);
  std::fill_n(fixed.begin(), patch.FreeVertices, 0);
  ComplexVector positions = complexOf(patch.Positions);
  WeightedMeans(std::move(weights), WeightSymmetry::Symmetric, fixed, progress).extend(positions);
  patch.Positions = pointsOf(positions);
}

} // namespace flattening
