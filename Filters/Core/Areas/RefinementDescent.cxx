// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementDescent.h"

#include "Base/Errors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

constexpr int QuasiNewtonSteps = 8;
constexpr int LargestHalvings = 12;
constexpr double ArmijoShare = 1e-4;
// Of the energy: steps that gain less end the round.
constexpr double LeastGain = 1e-5;
// Of the way to the first flip.
constexpr double FlipShare = 0.9;
// Levenberg's damping, dimensionless as the Hessian is, and how it follows the Newton step's length.
constexpr double FirstDamping = 1e-5;
constexpr double LeastDamping = 1e-7;
constexpr double LessDamping = 0.3;
constexpr double MoreDamping = 4.0;
// Where the matrix is indefinite.
constexpr double RescueDamping = 100.0;
constexpr int FactorTrials = 5;
// Of the product of two lengths: below, an update has no positive curvature.
constexpr double LeastCurvature = 1e-12;
constexpr int PerTask = 4096;

// The mesh's own order, found on one dof per vertex and expanded, in a quarter of the time.
EliminationOrder expandedOrder(const FaceMatrix& faces,
  const DegreesOfFreedom& dofs,
  SparseCholesky::Ordering ordering,
  const ProgressCallback& progress)
{
  const int vertexCount = dofs.vertexCount();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * faces.rows() + vertexCount);
  for (int v = 0; v < vertexCount; ++v)
  {
    entries.emplace_back(v, v, 1.0);
  }
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = faces(f, k);
      const int b = faces(f, (k + 1) % 3);
      entries.emplace_back(std::max(a, b), std::min(a, b), 1.0);
    }
  }
  SparseMatrix pattern(vertexCount, vertexCount);
  pattern.setFromTriplets(entries.begin(), entries.end());
  const EliminationOrder ofVertices = SparseCholesky::orderOf(
    std::move(pattern), ordering, progress, 0.0, "Face refinement: order of elimination");
  EliminationOrder order;
  order.Fill = std::numeric_limits<double>::infinity();
  for (const int v : ofVertices.Unknowns)
  {
    for (int k = 0; k < dofs.countOf(v); ++k)
    {
      order.Unknowns.push_back(dofs.first(v) + k);
    }
  }
  return order;
}

// The smallest positive root of a t^2 + b t + c, c > 0; infinite if there is none.
double smallestPositiveRoot(double a, double b, double c)
{
  const double none = std::numeric_limits<double>::infinity();
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0)
  {
    return none;
  }
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double smallest = none;
  for (const double root : { q / a, c / q })
  {
    if (root > 0.0)
    {
      smallest = std::min(smallest, root);
    }
  }
  return smallest;
}

double crossProduct(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace

RefinementDescent::RefinementDescent(RefinementEnergy& energy,
  const DegreesOfFreedom& dofs,
  const FaceMatrix& faces,
  SparseCholesky::Kernel kernel,
  const ProgressCallback& progress)
  : Energy(energy)
  , Dofs(dofs)
  , Faces(faces)
  , Cholesky(expandedOrder(faces,
               dofs,
               kernel == SparseCholesky::Kernel::Blocks ? SparseCholesky::Ordering::Thorough
                                                        : SparseCholesky::Ordering::Quick,
               progress),
      kernel)
  , Damping(FirstDamping)
{
  this->Cholesky.expectConstantPattern();
}

void RefinementDescent::resetDamping()
{
  this->Damping = FirstDamping;
}

// With more damping where slivers leave the last digits of the matrix indefinite.
void RefinementDescent::factorise(const DomainMap& map, const ProgressCallback& progress)
{
  SparseMatrix matrix = this->Energy.hessian(map);
  double added = 0.0;
  for (int trial = 0; trial < FactorTrials; ++trial)
  {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    {
      matrix.valuePtr()[matrix.outerIndexPtr()[column]] +=
        this->Damping - added; // the diagonal is first
    }
    added = this->Damping;
    this->Cholesky.compute(matrix, progress, 0.0, "Face refinement: factorization");
    if (this->Cholesky.info() == Eigen::Success)
    {
      this->Updates.clear();
      return;
    }
    this->Damping *= RescueDamping;
  }
  throw ConvergenceError("the system of the face refinement cannot be factored: slivers set a floor in "
                         "double precision; remesh the surface (Surface To Disk, Remesh)");
}

// The two loops of L-BFGS.
Eigen::VectorXd RefinementDescent::direction(const Eigen::VectorXd& gradient) const
{
  Eigen::VectorXd rest = gradient;
  std::vector<double> shares(this->Updates.size());
  for (std::size_t i = this->Updates.size(); i-- > 0;)
  {
    const Update& update = this->Updates[i];
    shares[i] = update.Step.dot(rest) / update.Product;
    rest -= shares[i] * update.Change;
  }
  Eigen::VectorXd step = this->Cholesky.solve(rest);
  for (std::size_t i = 0; i < this->Updates.size(); ++i)
  {
    const Update& update = this->Updates[i];
    step += (shares[i] - update.Change.dot(step) / update.Product) * update.Step;
  }
  return -step;
}

// Where the first face has no area any more, if boundary vertices went straight on.
double RefinementDescent::lengthToFlip(const DomainMap& map, const Eigen::VectorXd& step) const
{
  const int m = static_cast<int>(this->Faces.rows());
  const int tasks = (m + PerTask - 1) / PerTask;
  std::vector<double> parts(tasks, std::numeric_limits<double>::infinity());
  const auto motion = [&](int v) -> Eigen::Vector2d
  {
    Eigen::Vector2d own = Eigen::Vector2d::Zero();
    for (int k = 0; k < this->Dofs.countOf(v); ++k)
    {
      own[k] = step[this->Dofs.first(v) + k];
    }
    return this->Dofs.directions(map, v) * own;
  };
  tbb::parallel_for(0,
    tasks,
    [&](int task)
    {
      for (int f = task * PerTask; f < std::min(m, (task + 1) * PerTask); ++f)
      {
        const int a = this->Faces(f, 0);
        const Eigen::Vector2d base = motion(a);
        Eigen::Vector2d sides[2];
        Eigen::Vector2d changes[2];
        for (int k = 0; k < 2; ++k)
        {
          const int b = this->Faces(f, k + 1);
          sides[k] = map.Positions.row(b) - map.Positions.row(a);
          changes[k] = motion(b) - base;
        }
        const double length = smallestPositiveRoot(crossProduct(changes[0], changes[1]),
          crossProduct(sides[0], changes[1]) + crossProduct(changes[0], sides[1]),
          crossProduct(sides[0], sides[1]));
        parts[task] = std::min(parts[task], length);
      }
    });
  return *std::min_element(parts.begin(), parts.end());
}

double RefinementDescent::round(DomainMap& map, const ProgressCallback& progress)
{
  Eigen::VectorXd gradient;
  report(progress, 0.0, "Face refinement: whole mesh");
  const double before = this->Energy.gradient(map, gradient);
  this->factorise(map, progress);
  double energy = before;
  for (int k = 0; k <= QuasiNewtonSteps; ++k)
  {
    report(progress, (k + 0.5) / (QuasiNewtonSteps + 1.0), "Face refinement");
    const Eigen::VectorXd step = this->direction(gradient);
    const double slope = gradient.dot(step);
    if (!(slope < 0.0))
    {
      break;
    }
    double length = 1.0;
    if (this->KeepsOrientation)
    {
      length = std::min(length, FlipShare * this->lengthToFlip(map, step));
    }
    DomainMap next;
    double nextEnergy = 0.0;
    bool accepted = false;
    for (int halving = 0; halving < LargestHalvings && !accepted; ++halving)
    {
      length *= halving == 0 ? 1.0 : 0.5;
      next = this->Dofs.moved(map, step, length);
      nextEnergy = this->Energy.value(next);
      accepted = nextEnergy <= energy + ArmijoShare * length * slope;
    }
    if (k == 0)
    {
      const double factor = length > 0.99 ? LessDamping : length < 0.2 ? MoreDamping : 1.0;
      this->Damping = std::max(factor * this->Damping, LeastDamping);
    }
    if (!accepted)
    {
      break;
    }
    Eigen::VectorXd nextGradient;
    this->Energy.gradient(next, nextGradient);
    Update update{ length * step, nextGradient - gradient, 0.0 };
    update.Product = update.Step.dot(update.Change);
    if (update.Product > LeastCurvature * update.Step.norm() * update.Change.norm())
    {
      this->Updates.push_back(std::move(update));
    }
    const double gain = energy - nextEnergy;
    map = std::move(next);
    energy = nextEnergy;
    gradient = std::move(nextGradient);
    if (gain < LeastGain * energy)
    {
      break;
    }
  }
  return before > 0.0 ? (before - energy) / before : 0.0;
}

} // namespace flattening
