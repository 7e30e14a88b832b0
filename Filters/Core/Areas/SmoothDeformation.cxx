// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/SmoothDeformation.h"

#include "Areas/DeformationLattice.h"
#include "Areas/LatticeMatrix.h"
#include "Base/SparseFactorization.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

// LatticeSquares of the lattice along the longer side of its box. A compromise: with twice as many maps
// are as good, and a deformation takes five times as long.
constexpr int LatticeSquares = 40;
// The least number of vertices per square of the lattice around a map whose boundary is free. A choice:
// a lattice that is finer than the mesh moves the mesh no better, and took seconds for a hundred faces.
constexpr double LeastPerFreeSquare = 1.0;
// The box is larger than the map by this share of its longer side everywhere: the plane around the map
// takes part. A choice: any share of more than a square of the lattice gives about the same map.
constexpr double LatticeMargin = 0.1;
// In a domain, whose outside takes no part: the margin in squares of the lattice, so that all nodes that
// move the map belong to it, and the least and greatest number of vertices per square of the lattice's
// box. With fewer the faces of small maps are bent, with more the squares of large maps are larger than
// the patches of the refinement.
constexpr double DomainMargin = 1.5;
constexpr double LeastPerSquare = 16.0;
constexpr double GreatestPerSquare = 600.0;
// Limits of the time: Newton steps, and the relative decrease of the energy that ends
// them earlier.
constexpr int MostSteps = 12;
constexpr double LeastStepGain = 1e-3;
// A guard: shorter steps than 2^-20 change the energy by rounding only.
constexpr int MostStepHalvings = 20;
// The usual share of the linear decrease that a step must reach (Nocedal and Wright 2006, section 3.1).
constexpr double DecreaseShare = 1e-4;
// Added to the diagonal of the second derivative, as a share of its mean. A guard: the energy does not
// depend on where the map lies and how it is turned.
constexpr double RelativeDamping = 1e-8;

DeformationLattice latticeAround(const Points2& positions, double shareOfMargin, int squares)
{
  Eigen::AlignedBox2d box(
    positions.colwise().minCoeff().transpose(), positions.colwise().maxCoeff().transpose());
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(shareOfMargin * box.sizes().maxCoeff());
  box = Eigen::AlignedBox2d(box.min() - margin, box.max() + margin);
  return { box, squares };
}

int squaresOf(int vertices, bool isFree)
{
  const double finest = std::min<double>(
    LatticeSquares, std::sqrt(vertices / (isFree ? LeastPerFreeSquare : LeastPerSquare)));
  return static_cast<int>(std::max(finest, std::sqrt(vertices / GreatestPerSquare)));
}

std::vector<DeformationEnergy::BoundaryPoint> boundaryPoints(const DegreesOfFreedom& dofs,
  const DomainMap& map)
{
  const std::vector<int>& loop = dofs.loop();
  std::vector<DeformationEnergy::BoundaryPoint> points;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const std::size_t next = (k + 1) % loop.size();
    const double turn = next == 0 ? dofs.domain().perimeter() : 0.0;
    const double length = map.BoundaryParameters[next] + turn - map.BoundaryParameters[k];
    points.push_back({ map.Positions.row(loop[k]), length, dofs.countOf(loop[k]) == 0 });
  }
  return points;
}

// Puts the boundary vertices of a deformed map where the domain's boundary is nearest, and those that
// stay where they were.
void returnToBoundary(const DegreesOfFreedom& dofs, const DomainMap& before, DomainMap& moved)
{
  const std::vector<int>& loop = dofs.loop();
  const ConvexDomain& domain = dofs.domain();
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    auto place = moved.Positions.row(loop[k]);
    if (dofs.countOf(loop[k]) == 0)
    {
      place = before.Positions.row(loop[k]);
      continue;
    }
    const double way = domain.parameterOf(place) - domain.parameterOf(before.Positions.row(loop[k]));
    const double turn = domain.perimeter();
    moved.BoundaryParameters[k] += way - turn * std::round(way / turn);
    place = domain.at(moved.BoundaryParameters[k]);
  }
}

// Newton's method for the displacements of a lattice's nodes.
class DeformationDescent
{
public:
  DeformationDescent(const DeformationLattice& lattice, DeformationEnergy& energy)
    : Energy(energy)
    , Displacements(Points2::Zero(lattice.nodeCount(), 2))
    , Hessian(lattice)
  {
    this->Cholesky.expectConstantPattern();
  }

  void descend(const ProgressCallback& progress)
  {
    for (int step = 0; step < MostSteps; ++step)
    {
      report(progress, static_cast<double>(step) / MostSteps, "Smooth deformation");
      if (!this->makeStep())
      {
        return;
      }
    }
  }

  const Points2& displacements() const { return this->Displacements; }

private:
  // Returns whether the energy fell by enough for another step.
  bool makeStep()
  {
    Eigen::VectorXd gradient;
    const double before = this->Energy.derivatives(this->Displacements, gradient, this->Hessian);
    const double damping = RelativeDamping * this->Hessian.lower().diagonal().mean();
    this->Hessian.lower().diagonal().array() += damping;
    this->Cholesky.compute(this->Hessian.lower());
    if (this->Cholesky.info() != Eigen::Success)
    {
      return false;
    }
    const Eigen::VectorXd solution = this->Cholesky.solve(gradient);
    const Eigen::Map<const Points2> step(solution.data(), this->Displacements.rows(), 2);
    const double slope = gradient.dot(solution);
    double length = 1.0;
    for (int halving = 0; halving < MostStepHalvings; ++halving, length *= 0.5)
    {
      const Points2 next = this->Displacements - length * step;
      const double after = this->Energy.value(next);
      if (after <= before - DecreaseShare * length * slope)
      {
        this->Displacements = next;
        return before - after > LeastStepGain * before;
      }
    }
    return false;
  }

  DeformationEnergy& Energy;
  Points2 Displacements;
  LatticeMatrix Hessian;
  SparseCholesky Cholesky;
};

} // namespace

DomainMap smoothlyDeformed(const RefinementTerms& terms,
  const DegreesOfFreedom& dofs,
  const DomainMap& map,
  const Eigen::VectorXd& targets,
  DeformationEnergy::Shapes shapes,
  double areaWeight,
  const ProgressCallback& progress)
{
  const bool isFree = dofs.loop().empty();
  const int squares = squaresOf(static_cast<int>(map.Positions.rows()), isFree);
  const DeformationLattice lattice =
    latticeAround(map.Positions, isFree ? LatticeMargin : DomainMargin / squares, squares);
  DeformationEnergy energy(lattice, terms, map.Positions, targets, shapes);
  if (!isFree)
  {
    energy.keepOnBoundary(dofs.domain(), boundaryPoints(dofs, map));
  }
  DeformationDescent descent(lattice, energy);
  energy.setAreaWeight(areaWeight);
  descent.descend(progress);
  DomainMap moved{ lattice.moved(map.Positions, descent.displacements()), map.BoundaryParameters };
  if (!isFree)
  {
    returnToBoundary(dofs, map, moved);
  }
  return moved;
}

} // namespace flattening
