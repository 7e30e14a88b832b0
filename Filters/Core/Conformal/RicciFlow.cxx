// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/RicciFlow.h"

#include "Base/Errors.h"
#include "Base/LaggedCholeskySolver.h"
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

// Of the gradient, left over by a step's linear system.
constexpr double LinearTolerance = 1e-2;
constexpr int MostTrials = 40;
// Radians; what is accepted as flat.
constexpr double GreatestError = 1e-10;
// Radians; vertices that are farther off, if they are few, are settled before the others move on: in
// horns the energy is far from quadratic when it is nearly so elsewhere.
constexpr double OutlierError = 0.2;
constexpr int MostOutliersPerMille = 8;
constexpr int LeastMostOutliers = 20;
constexpr int OutlierRings = 4;
constexpr double OutlierTolerance = 0.02;
constexpr int MostLocalSteps = 20;
// Greatest change in one step of the difference of two neighbours' factors: a triangle whose sides
// differ by more than a thousand million has no angles in the precision at hand.
constexpr double LongestStep = 8.0;
// Radians; below, convergence is quadratic, and the iterations of all systems to come are those that
// reduce a residual as much as the error is to fall. If they are more than these, a new factor is
// cheaper.
constexpr double QuadraticError = 0.1;
constexpr double WorthAFactor = 30.0;
// Flips since the last factorization, as a share of the half-edges, that make its order of elimination a
// bad one, and unknowns for which it is worth a thread that looks for a new one, for the layout, while
// the last systems are solved.
constexpr double WornOrder = 1e-4;
constexpr int WorthAThread = 10000;
// A ridge on the Hessian, whose entries are cotangents, where the energy is flat.
constexpr double Ridge = 1e-3;
// Radians; what is degenerate next to infinity when no angle is farther off will stay so.
constexpr double SettledError = 0.1;

// Lets vertices beyond an edge at infinity become neighbours of infinity, and fixes their factors.
// Vertices of the mirror are not asked: only its ends are next to infinity.
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

// Faces within some rings of the vertices.
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
      this->iterate(progress);
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
      throw ConvergenceError(message.str());
    }
    const EliminationOrder& order = this->Solver.order();
    if (static_cast<int>(order.Unknowns.size()) == this->System.unknowns())
    {
      this->Result.Elimination = { this->System.vertices(order.Unknowns), order.Fill };
    }
    return this->Result;
  }

private:
  void iterate(const ProgressCallback& progress)
  {
    // The error falls quadratically at the end; progress is its logarithm's.
    const double tolerance = this->Options.Tolerance;
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
      if (stalled >= 4 && best < 1e-9)
      {
        break; // at the rounding floor
      }
    }
  }

  void evaluate()
  {
    this->Result.Flips += this->Triangulation.flipToDelaunay(this->Result.LogFactors);
    this->System.evaluate(this->Result.LogFactors);
  }

  // Near the solution the linear system is solved the more exactly the smaller the error, so that
  // convergence stays quadratic.
  Eigen::VectorXd direction(const ProgressCallback& progress)
  {
    SparseMatrix hessian = this->System.hessian();
    if (this->System.degenerateFaces() > 0)
    {
      hessian.diagonal().array() += Ridge;
    }
    const double error = this->System.error();
    if (error<QuadraticError&& this->Solver.iterationsFor(this->Options.Tolerance / error)> WorthAFactor)
    {
      this->Solver.forgetFactor();
    }
    this->renewOrder(hessian);
    const double tolerance =
      std::max(std::min(LinearTolerance, error), 0.1 * this->Options.Tolerance / error);
    Eigen::VectorXd step;
    const char* stage = this->Solver.hasFactor() ? "Ricci flow: solution" : "Ricci flow: factorization";
    if (!this->Solver.solve(
          hessian, -this->System.gradient(), tolerance, step, atFraction(progress, 0.0, stage)))
    {
      throw ConvergenceError("the Ricci flow's Hessian could not be factored after " +
                             std::to_string(this->Result.NewtonIterations) +
                             " Newton steps: remesh the surface (Surface To Disk, Remesh)");
    }
    return step;
  }

  void renewOrder(const SparseMatrix& hessian)
  {
    const int flips = this->Result.Flips - this->OrderedAtFlips;
    if (!this->Solver.hasFactor())
    {
      this->OrderedAtFlips = this->Result.Flips;
    }
    else if (this->System.error() < QuadraticError && this->System.unknowns() >= WorthAThread &&
             flips > WornOrder * this->Triangulation.halfedgeCount())
    {
      this->Solver.renewOrder(hessian);
      this->OrderedAtFlips = this->Result.Flips;
    }
  }

  // The energy is convex: along a descent direction its derivative grows, and a step is long enough as
  // soon as the derivative has shrunk, too long once it is as steep upwards as it was downwards.
  void step(const ProgressCallback& progress)
  {
    report(progress, 0.0, "Ricci flow: direction");
    const Eigen::VectorXd step = this->direction(progress);
    const double slope = this->System.gradient().dot(step);
    const double previous = this->System.error();
    const IntrinsicTriangulation::Factors origin = this->Result.LogFactors;
    double length = std::min(1.0, LongestStep / std::max(this->System.greatestDifference(step), 1e-300));
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
        (this->System.error() < SettledError || this->Result.NewtonIterations > 8) &&
        reachInfinity(this->Triangulation, this->TargetAngles, this->Settled, this->Result.LogFactors))
    {
      this->System.setFixed(this->Settled);
      this->evaluate();
    }
  }

  // Minimises the energy over the surroundings of the outliers, all else fixed.
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
    for (int k = 0; k < MostLocalSteps && local.System.error() > OutlierTolerance; ++k)
    {
      local.step({});
    }
    for (int v = 0; v < count; ++v)
    {
      this->Result.LogFactors[part.Vertices[v]] = local.Result.LogFactors[v];
    }
    this->Result.Flips += local.Result.Flips;
    this->Triangulation.replace(part);
    this->evaluate();
  }

  IntrinsicTriangulation& Triangulation;
  const Eigen::VectorXd& TargetAngles;
  const RicciFlowOptions& Options;
  std::vector<char> Settled;
  CurvatureSystem System;
  LaggedCholeskySolver Solver;
  RicciFlowResult Result;
  int OrderedAtFlips = 0;
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
