// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/RicciFlow.h"

#include "Base/Errors.h"
#include "Base/LaggedSolver.h"
#include "Base/Progress.h"
#include "Conformal/CurvatureSystem.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// Evaluations that flip edges more often than this for each half-edge are excessive: they lead far
// through triangles that are nearly degenerate, and may be cut short. The others flip twice for each at
// most.
constexpr long long MostFlipsPerHalfedge = 5;
// A flow ends when the flips of its excessive evaluations are more than the first number for each
// half-edge and the second one together. A guard for the time, four seconds for 28,000 faces: on random
// surfaces ten of 7,700 flows ended so, and with half of both numbers thirty.
constexpr long long MostExcessiveFlipsPerHalfedge = 40;
constexpr long long ExcessiveFlipsOfSmallSurfaces = 100000;
constexpr const char* EndlessFlips =
  "the Ricci flow flips edges without an end, as the surface has triangles that are nearly degenerate: "
  "remesh the surface (Surface To Disk, Remesh)";
// Relative residual of a step's linear system. A choice: with more, steps lose their direction; with
// less, each takes more iterations of conjugate gradients without fewer steps.
constexpr double LinearTolerance = 1e-2;
// Most trial lengths of a step: a guard, for each trial shortens the step at least to a half.
constexpr int MostTrials = 40;
// Greatest curvature error that counts as flat (radians), ten times the default tolerance: a guard for
// flows that end at the rounding errors of large surfaces.
constexpr double GreatestError = 1e-10;
// The flow ends after this many steps that reduce the error by less than a tenth, if it is below the
// value (radians) at which only rounding can be the cause.
constexpr int MostStalledSteps = 4;
constexpr double RoundingError = 1e-9;
// Vertices whose angle sums are off by more than OutlierError (radians) are settled with the rest fixed
// before the others move on, if they are few: in protrusions the energy is far from quadratic when it is
// nearly quadratic elsewhere. On a closed brain a few such vertices kept the other hundred thousand from
// converging.
constexpr double OutlierError = 0.2;
// Few are at most 8 per mille of the unknowns, or 20: a choice, for more are not local.
constexpr int MostOutliersPerMille = 8;
constexpr int LeastMostOutliers = 20;
// Rings of faces around the outliers that move with them. A choice: fewer leave too little room, more
// cost time.
constexpr int OutlierRings = 4;
// Error (radians) at which the outliers are settled, a tenth of that which makes them outliers, and a
// guard against endless steps.
constexpr double OutlierTolerance = 0.02;
constexpr int MostLocalSteps = 20;
// Greatest change in one step of the difference between the factors of two neighbours. A triangle whose
// sides differ by more than a factor of 1e9 has no angles in the precision at hand. A bound on the
// factors themselves would slow down deep protrusions.
constexpr double LongestFlowStep = 8.0;
// Error (radians) below which convergence is quadratic. The iterations of conjugate gradients of all
// systems to come are then those that reduce a residual as much as the error is to fall.
constexpr double QuadraticError = 0.1;
// Number of such iterations from which on a new factor is cheaper. One costs as much as ten iterations
// on surfaces of 66,000 vertices, seventeen on a million, and leaves a few to do. Its order of
// elimination serves for the layout, too, which that of the first factor does not where many edges were
// flipped. With 30 surfaces of 66,000 to 260,000 vertices take about a tenth longer, and a million as
// long.
constexpr double WorthAFactor = 20.0;
// Number that is added to the diagonal of the Hessian, whose entries are cotangents, where the energy is
// flat because triangles are degenerate. A guard: small against cotangents, large against rounding.
constexpr double Ridge = 1e-3;
// Error (radians) below which, or number of steps after which, triangles that are degenerate next to
// infinity will stay so. A choice: too early, vertices are sent towards infinity without need.
constexpr double SettledError = 0.1;
constexpr int SettledSteps = 8;

// Lets vertices beyond an edge at infinity become neighbours of infinity, and fixes their factors.
// Vertices of the mirror are excluded: only its ends are next to infinity. Returns whether there were
// any.
bool reachInfinity(IntrinsicTriangulation& triangulation,
  const Eigen::VectorXd& targetAngles,
  std::vector<char>& fixed,
  IntrinsicTriangulation::Factors& u)
{
  std::vector<char> excluded = fixed;
  for (std::size_t v = 0; v < excluded.size(); ++v)
  {
    excluded[v] |= targetAngles[v] < 1.5 * EIGEN_PI;
  }
  bool any = false;
  while (const auto neighbour = triangulation.reachInfinity(u, excluded))
  {
    u[neighbour->Vertex] = neighbour->LogFactor;
    fixed[neighbour->Vertex] = excluded[neighbour->Vertex] = 1;
    any = true;
  }
  return any;
}

// The faces within some rings of the vertices.
std::vector<int> facesAround(const IntrinsicTriangulation& t,
  const std::vector<int>& vertices,
  int rings)
{
  std::vector<char> isNear(t.vertexCount(), 0);
  for (const int v : vertices)
  {
    isNear[v] = 1;
  }
  std::vector<int> faces;
  for (int ring = 0; ring < rings; ++ring)
  {
    faces.clear();
    for (int f = 0; f < t.faceCount(); ++f)
    {
      if (isNear[t.origin(3 * f)] || isNear[t.origin(3 * f + 1)] || isNear[t.origin(3 * f + 2)])
      {
        faces.push_back(f);
      }
    }
    for (const int f : faces)
    {
      isNear[t.origin(3 * f)] = isNear[t.origin(3 * f + 1)] = isNear[t.origin(3 * f + 2)] = 1;
    }
  }
  return faces;
}

// Newton's method on the convex energy.
class FlowSolver
{
public:
  FlowSolver(IntrinsicTriangulation& triangulation,
    const Eigen::VectorXd& targetAngles,
    const std::vector<char>& fixed,
    const IntrinsicTriangulation::Factors& start,
    const RicciFlowOptions& options)
    : Triangulation(triangulation)
    , TargetAngles(targetAngles)
    , Options(options)
    , Settled(fixed)
    , System(triangulation, targetAngles, fixed)
  {
    this->Result.LogFactors = start;
    this->evaluate();
  }

  RicciFlowResult run(const ProgressCallback& progress)
  {
    if (this->System.unknowns() > 0)
    {
      try
      {
        this->iterate(progress);
      }
      catch (const ConvergenceError& error)
      {
        this->stop(error.what());
      }
    }
    this->Result.MaxCurvatureError = this->System.unknowns() > 0 ? this->System.error() : 0.0;
    if (this->System.unknowns() > 0 &&
        (this->System.degenerateFaces() > 0 || !(this->Result.MaxCurvatureError <= GreatestError)))
    {
      std::ostringstream message;
      message << "the Ricci flow stopped after " << this->Result.NewtonIterations
              << " Newton steps at a curvature error of " << this->Result.MaxCurvatureError << " with "
              << this->System.degenerateFaces()
              << " degenerate triangles: remesh the surface (Surface To Disk, Remesh)";
      this->stop(message.str());
    }
    if (this->IsExcessive)
    {
      this->stop(EndlessFlips);
    }
    this->Result.Order = this->System.vertexOrder(this->Solver.order());
    return this->Result;
  }

private:
  [[noreturn]] void stop(const std::string& message) const
  {
    throw RicciFlowStopped(message, this->Result.NewtonIterations, this->ExcessiveFlips);
  }

  void iterate(const ProgressCallback& progress)
  {
    // The error falls quadratically at the end, so progress is measured by its logarithm.
    const double tolerance = this->Options.Tolerance;
    if (!(tolerance > 0.0))
    {
      throw InvalidInput("the tolerance of the curvature is " + formatted(tolerance) +
                         ": set it to a small positive number of radians");
    }
    const double startError = std::max(this->System.error(), 10.0 * tolerance);
    double fraction = 0.0;
    double best = this->System.error();
    int stalled = 0;
    while (this->System.error() > tolerance &&
           this->Result.NewtonIterations < this->Options.MaximumIterations)
    {
      const double gain = std::log(startError / this->System.error());
      fraction = std::max(fraction, std::clamp(gain / std::log(startError / tolerance), 0.0, 1.0));
      this->step(subrange(progress, fraction, fraction));
      ++this->Result.NewtonIterations;
      this->settleInfinity();
      this->settleOutliers();
      stalled = this->System.error() < 0.9 * best ? 0 : stalled + 1;
      best = std::min(best, this->System.error());
      if (stalled >= MostStalledSteps && best < RoundingError)
      {
        break;
      }
    }
  }

  void evaluate()
  {
    const long long flips = this->Triangulation.flipToDelaunay(this->Result.LogFactors);
    this->Result.Flips += flips;
    this->IsExcessive = flips > MostFlipsPerHalfedge * this->Triangulation.halfedgeCount();
    this->ExcessiveFlips += this->IsExcessive ? flips : 0;
    if (this->ExcessiveFlips > MostExcessiveFlipsPerHalfedge * this->Triangulation.halfedgeCount() +
                                 ExcessiveFlipsOfSmallSurfaces)
    {
      throw ConvergenceError(EndlessFlips);
    }
    this->System.evaluate(this->Result.LogFactors);
  }

  // The Newton step. The smaller the error, the more exactly the linear system is solved, so that
  // convergence stays quadratic.
  Eigen::VectorXd direction(const ProgressCallback& progress)
  {
    SparseMatrix hessian = this->System.hessian();
    if (this->System.degenerateFaces() > 0)
    {
      hessian.diagonal().array() += Ridge;
    }
    const double error = this->System.error();
    const double iterationsLeft = this->Solver.iterationsFor(this->Options.Tolerance / error);
    if (error < QuadraticError && iterationsLeft > WorthAFactor)
    {
      this->Solver.forgetPreconditioner();
    }
    const double tolerance =
      std::max(std::min(LinearTolerance, error), 0.1 * this->Options.Tolerance / error);
    Eigen::VectorXd step;
    const char* stage =
      this->Solver.hasPreconditioner() ? "Ricci flow: solution" : "Ricci flow: preconditioner";
    if (!this->Solver.solve(
          hessian, -this->System.gradient(), tolerance, step, atFraction(progress, 0.0, stage)))
    {
      throw ConvergenceError("the Ricci flow's Hessian could not be factored after " +
                             std::to_string(this->Result.NewtonIterations) +
                             " Newton steps: remesh the surface (Surface To Disk, Remesh)");
    }
    return step;
  }

  // The energy is convex: along a descent direction its derivative grows, and a step is long enough as
  // soon as the derivative has shrunk. It is too long once the energy rises more than half as steeply as
  // it fell.
  void step(const ProgressCallback& progress)
  {
    report(progress, 0.0, "Ricci flow: direction");
    const Eigen::VectorXd step = this->direction(progress);
    const double slope = this->System.gradient().dot(step);
    const double previous = this->System.error();
    const IntrinsicTriangulation::Factors origin = this->Result.LogFactors;
    double length =
      std::min(1.0, LongestFlowStep / std::max(this->System.greatestDifference(step), 1e-300));
    for (int trial = 0; trial < MostTrials; ++trial)
    {
      report(progress, 0.0, "Ricci flow: step");
      this->Result.LogFactors = origin;
      this->System.addTo(this->Result.LogFactors, step, length);
      this->evaluate();
      const double after = this->System.gradient().dot(step);
      if (after <= -0.5 * slope || this->System.error() < 0.5 * previous)
      {
        return;
      }
      length *= std::clamp(slope / (slope - after), 0.1, 0.5);
    }
  }

  void settleInfinity()
  {
    if (this->System.degenerateFaces() > 0 &&
        (this->System.error() < SettledError || this->Result.NewtonIterations > SettledSteps) &&
        reachInfinity(this->Triangulation, this->TargetAngles, this->Settled, this->Result.LogFactors))
    {
      this->System.setFixed(this->Settled);
      this->evaluate();
    }
  }

  // Lowers the error to the tolerance of outliers. Returns whether this succeeded.
  bool settle()
  {
    try
    {
      for (int k = 0; k<MostLocalSteps&& this->System.error()> OutlierTolerance; ++k)
      {
        this->step({});
      }
    }
    catch (const ConvergenceError&)
    {
      return false;
    }
    return this->System.error() <= OutlierTolerance;
  }

  // Minimises the energy over the surroundings of the outliers, with all other vertices fixed. Where the
  // fixed vertices leave no flat solution, the surroundings stay as they are, for the end of such an
  // attempt is farther from the flat surface than its beginning.
  void settleOutliers()
  {
    const std::vector<int> outliers = this->System.verticesOffBy(OutlierError);
    const int most = this->System.unknowns() * MostOutliersPerMille / 1000;
    if (outliers.empty() || static_cast<int>(outliers.size()) > std::max(LeastMostOutliers, most))
    {
      return;
    }
    IntrinsicTriangulation::Part part =
      this->Triangulation.part(facesAround(this->Triangulation, outliers, OutlierRings));
    const int count = part.Triangulation.vertexCount();
    std::vector<char> fixed(count);
    Eigen::VectorXd targets(count);
    IntrinsicTriangulation::Factors start(count);
    for (int v = 0; v < count; ++v)
    {
      fixed[v] = this->Settled[part.Vertices[v]];
      targets[v] = this->TargetAngles[part.Vertices[v]];
      start[v] = this->Result.LogFactors[part.Vertices[v]];
    }
    for (const auto& edge : part.Triangulation.boundaryEdges())
    {
      fixed[edge.Origin] = 1;
      fixed[part.Triangulation.tip(edge.Inner)] = 1;
    }
    FlowSolver local(part.Triangulation, targets, fixed, start, this->Options);
    if (local.System.unknowns() == 0)
    {
      return;
    }
    if (!local.settle())
    {
      return;
    }
    for (int v = 0; v < count; ++v)
    {
      this->Result.LogFactors[part.Vertices[v]] = local.Result.LogFactors[v];
    }
    this->Result.Flips += local.Result.Flips;
    this->ExcessiveFlips += local.ExcessiveFlips;
    this->Triangulation.replace(part);
    this->evaluate();
  }

  IntrinsicTriangulation& Triangulation;
  const Eigen::VectorXd& TargetAngles;
  const RicciFlowOptions& Options;
  std::vector<char> Settled;
  CurvatureSystem System;
  LaggedSolver Solver;
  long long ExcessiveFlips = 0; // the flips of excessive evaluations
  bool IsExcessive = false;     // whether the last one is, so that it may not be Delaunay
  RicciFlowResult Result;
};

} // namespace

RicciFlowResult discreteRicciFlow(IntrinsicTriangulation& triangulation,
  const Eigen::VectorXd& targetAngles,
  const std::vector<char>& fixed,
  const IntrinsicTriangulation::Factors& start,
  const RicciFlowOptions& options,
  const ProgressCallback& progress)
{
  return FlowSolver(triangulation, targetAngles, fixed, start, options).run(progress);
}

} // namespace flattening
