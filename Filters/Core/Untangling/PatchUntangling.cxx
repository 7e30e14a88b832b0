// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/PatchUntangling.h"

#include "Base/SparseFactorization.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/GraphLaplacian.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

constexpr int LargestSteps = 300;
constexpr double FirstEpsilon = 0.1;
// Of the flipped face's area ratio: so small an epsilon turns no face over any more.
constexpr double HopelessShare = 1e-2;
// Of the energy: where a map without flipped faces is good enough.
constexpr double SmallestDecrease = 1e-4;
constexpr double ArmijoShare = 1e-4;
constexpr int LargestHalvings = 40;
// Of the Hessian's diagonal, which may be 0 otherwise.
constexpr double Damping = 1e-9;

// The next epsilon after a step that has brought the least area ratio to least <= 0 and the energy to a
// share of what it was: chi of that ratio falls to that share, by a tenth at least.
double smallerEpsilon(double epsilon, double least, double share)
{
  const double root = std::sqrt(epsilon * epsilon + least * least);
  const double chi = 0.5 * epsilon * epsilon / (root - least);
  const double next = std::min(0.9, share) * chi;
  return 2.0 * std::sqrt(next * (next - least));
}

class Minimisation
{
public:
  Minimisation(FlatPatch& patch, double areaWeight)
    : Patch(patch)
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
    while (result.Steps < LargestSteps && epsilon >= -HopelessShare * least)
    {
      const double before = this->energy(this->Patch.Positions, epsilon);
      const double after = this->follow(this->newtonDirection(epsilon), before, epsilon);
      ++result.Steps;
      if (least > 0.0 && !(before - after > SmallestDecrease * before))
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

  // Row 2 i + c by coordinate c of free vertex i; sets Slope.
  Eigen::MatrixXd newtonDirection(double epsilon)
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
    this->Cholesky.compute(hessian);
    Eigen::MatrixXd direction = Eigen::MatrixXd::Zero(unknowns, 1);
    if (this->Cholesky.info() == Eigen::Success)
    {
      direction = this->Cholesky.solve((-gradient).eval());
    }
    this->Slope = direction.col(0).dot(gradient);
    return direction;
  }

  // Goes along the direction as far as the energy falls enough; returns the energy there.
  double follow(const Eigen::MatrixXd& direction, double before, double epsilon)
  {
    double length = 1.0;
    for (int halving = 0; halving < LargestHalvings && this->Slope < 0.0; ++halving)
    {
      Points2 trial = this->Patch.Positions;
      for (int i = 0; i < this->Patch.FreeVertices; ++i)
      {
        trial(i, 0) += length * direction(2 * i, 0);
        trial(i, 1) += length * direction(2 * i + 1, 0);
      }
      const double value = this->energy(trial, epsilon);
      if (value <= before + ArmijoShare * length * this->Slope)
      {
        this->Patch.Positions = trial;
        return value;
      }
      length *= 0.5;
    }
    return before;
  }

  FlatPatch& Patch;
  std::vector<FoldoverEnergy> Energies;
  SparseCholesky Cholesky;
  double Slope = 0.0;
};

} // namespace

UntangledPatch untanglePatch(FlatPatch& patch, double areaWeight)
{
  return Minimisation(patch, areaWeight).run();
}

void relaxPatch(FlatPatch& patch)
{
  std::vector<Spring> springs;
  for (int f = 0; f < patch.Faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      springs.push_back({ patch.Faces(f, k), patch.Faces(f, (k + 1) % 3), 1.0 });
    }
  }
  std::vector<char> fixed(patch.Positions.rows(), 1);
  std::fill_n(fixed.begin(), patch.FreeVertices, 0);
  ComplexVector positions = complexOf(patch.Positions);
  relaxSprings(springs, fixed, positions);
  patch.Positions = pointsOf(positions);
}

} // namespace flattening
