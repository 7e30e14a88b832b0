// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementDescent.h"

#include "Base/Errors.h"
#include "Mesh/PlaneVectors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

// Quasi-Newton steps per Newton step. A compromise of time: each costs a small part of a factorization,
// and later ones gain little.
constexpr int QuasiNewtonSteps = 8;
// A guard: shorter steps than 2^-11 change the energy by rounding only.
constexpr int LargestHalvings = 12;
// The usual share of the linear decrease that a step must reach (Nocedal and Wright 2006, section 3.1).
constexpr double ArmijoShare = 1e-4;
// A step that lowers the energy by a smaller share ends the round, which would gain little more.
constexpr double LeastGain = 1e-5;
// A quasi-Newton step that is shorter is short (endAfterShortStep). A compromise: on a whole brain with
// a small hole, a fifth of the time of transport and refinement went into the halvings of such steps.
constexpr double ShortStep = 0.1;
// How much of the way to the first flip a step may go. A convention; with 1 a face would have area 0.
constexpr double FlipShare = 0.9;
// Levenberg's damping, dimensionless like the Hessian, and how it follows the Newton step's length. Too
// little makes steps that slivers bend far, too much makes all steps short; it adapts within some
// rounds.
constexpr double FirstDamping = 1e-5;
constexpr double LeastDamping = 1e-7;
constexpr double LessDamping = 0.3;
constexpr double MoreDamping = 4.0;
// After a failed factorization each diagonal entry grows by a share of itself: at first by some
// roundings of double precision, then by RescueFactor times as much each time. A guard: shares of more
// than the greatest would stop the steps.
constexpr double LeastRescueShare = 1e-14;
constexpr double GreatestRescueShare = 1e-3;
constexpr double RescueFactor = 100.0;
// A guard: an update whose cosine of step and change of gradient is lower has no positive curvature, and
// the metric would get indefinite.
constexpr double LeastCurvature = 1e-12;
// Faces of one task of a thread. Results do not depend on it.
constexpr int PerTask = 4096;

// An order of elimination of the degrees of freedom. It is found for one unknown per vertex, in a
// quarter of the time, and expanded.
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

} // namespace

RefinementDescent::RefinementDescent(RefinementEnergy& energy,
  const DegreesOfFreedom& dofs,
  const RefinementTerms& terms,
  SparseCholesky::Kernel kernel,
  const ProgressCallback& progress)
  : Energy(energy)
  , Dofs(dofs)
  , Terms(terms)
  , Cholesky(expandedOrder(terms.Faces,
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

// Crushed faces may leave the matrix indefinite in its last digits. Then each diagonal entry grows by a
// share of itself: the vertices of these faces, whose entries are the largest, move less, and the others
// hardly change.
void RefinementDescent::factorise(const DomainMap& map, const ProgressCallback& progress)
{
  SparseMatrix matrix = this->Energy.hessian(map);
  const auto diagonalAt = [&](Eigen::Index column) -> double&
  { return matrix.valuePtr()[matrix.outerIndexPtr()[column]]; }; // the first of each column
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    diagonalAt(column) += this->Damping;
  }
  const auto succeeds = [&]
  {
    this->Cholesky.compute(matrix, progress, 0.0, "Face refinement: factorization");
    return this->Cholesky.info() == Eigen::Success;
  };
  bool isFactored = succeeds();
  for (double share = LeastRescueShare; !isFactored && share <= GreatestRescueShare;
       share *= RescueFactor)
  {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    {
      diagonalAt(column) *= 1.0 + share;
    }
    isFactored = succeeds();
  }
  if (isFactored)
  {
    this->Updates.clear();
    return;
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

// The length of the step at which the first face has no area. Boundary vertices are taken to move
// straight.
double RefinementDescent::lengthToFlip(const DomainMap& map, const Eigen::VectorXd& step) const
{
  const Points2 motions = this->Dofs.motions(map, step);
  const int m = static_cast<int>(this->Terms.Faces.rows());
  const int tasks = (m + PerTask - 1) / PerTask;
  std::vector<double> parts(tasks, std::numeric_limits<double>::infinity());
  tbb::parallel_for(0,
    tasks,
    [&](int task)
    {
      for (int f = task * PerTask; f < std::min(m, (task + 1) * PerTask); ++f)
      {
        const int a = this->Terms.Faces(f, 0);
        Eigen::Vector2d sides[2];
        Eigen::Vector2d changes[2];
        for (int k = 0; k < 2; ++k)
        {
          const int b = this->Terms.Faces(f, k + 1);
          sides[k] = map.Positions.row(b) - map.Positions.row(a);
          changes[k] = motions.row(b) - motions.row(a);
        }
        const double length = smallestPositiveRoot(cross(changes[0], changes[1]),
          cross(sides[0], changes[1]) + cross(changes[0], sides[1]),
          cross(sides[0], sides[1]));
        parts[task] = std::min(parts[task], length);
      }
    });
  return *std::min_element(parts.begin(), parts.end());
}

// Halves the step until the energy falls enough.
RefinementDescent::LineSearch RefinementDescent::searchLine(const DomainMap& map,
  double energy,
  const Eigen::VectorXd& step,
  double slope) const
{
  LineSearch search{ {}, 0.0, 1.0, false };
  if (this->KeepsOrientation)
  {
    search.Length = std::min(search.Length, FlipShare * this->lengthToFlip(map, step));
  }
  for (int halving = 0; halving < LargestHalvings && !search.Succeeded; ++halving)
  {
    search.Length *= halving == 0 ? 1.0 : 0.5;
    search.Map = this->Dofs.moved(map, step, search.Length);
    search.Energy = this->Energy.evaluate(search.Map);
    search.Succeeded = std::isfinite(search.Energy) &&
                       search.Energy <= energy + ArmijoShare * search.Length * slope &&
                       !edgesCross(search.Map.Positions, this->Terms.Outline);
  }
  return search;
}

// Less damping after a full Newton step, more after a short one.
void RefinementDescent::adaptDamping(double length)
{
  const double factor = length > 0.99 ? LessDamping : length < 0.2 ? MoreDamping : 1.0;
  this->Damping = std::max(factor * this->Damping, LeastDamping);
}

void RefinementDescent::learn(const Eigen::VectorXd& step, const Eigen::VectorXd& change)
{
  const double product = step.dot(change);
  if (product > LeastCurvature * step.norm() * change.norm())
  {
    this->Updates.push_back({ step, change, product });
  }
}

double RefinementDescent::round(DomainMap& map, const ProgressCallback& progress)
{
  if (this->Dofs.count() == 0) // every vertex is a fixed corner
  {
    return 0.0;
  }
  report(progress, 0.0, "Face refinement: whole mesh");
  const double before = this->Energy.evaluate(map);
  Eigen::VectorXd gradient = this->Energy.gradient(map);
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
    LineSearch search = this->searchLine(map, energy, step, slope);
    if (k == 0)
    {
      this->adaptDamping(search.Length);
    }
    if (!search.Succeeded)
    {
      break;
    }
    Eigen::VectorXd nextGradient = this->Energy.gradient(search.Map);
    this->learn(search.Length * step, nextGradient - gradient);
    const double gain = energy - search.Energy;
    map = std::move(search.Map);
    energy = search.Energy;
    gradient = std::move(nextGradient);
    const bool isShort = k > 0 && search.Length < ShortStep;
    if (gain < LeastGain * energy || (isShort && this->EndsAfterShortStep))
    {
      break;
    }
  }
  return before > 0.0 ? (before - energy) / before : 0.0;
}

} // namespace flattening
