// SPDX-License-Identifier: GPL-3.0-or-later
#include "RicciFlow.h"

#include "Errors.h"
#include "SparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// Radians; what is degenerate next to infinity when no angle is farther off will stay so.
constexpr double SettledError = 0.1;

// Gradient and, on request, Hessian of the energy at one choice of factors.
class CurvatureSystem
{
public:
  CurvatureSystem(const IntrinsicTriangulation& triangulation,
    const Eigen::VectorXd& targetAngles,
    const std::vector<char>& fixed)
    : Triangulation(triangulation)
    , TargetAngles(targetAngles)
  {
    this->setFixed(fixed);
  }

  void setFixed(const std::vector<char>& fixed)
  {
    this->Row.assign(fixed.size(), -1);
    this->Vertex.clear();
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      if (!fixed[v])
      {
        this->Row[v] = static_cast<int>(this->Vertex.size());
        this->Vertex.push_back(static_cast<int>(v));
      }
    }
  }

  int unknowns() const { return static_cast<int>(this->Vertex.size()); }

  void evaluate(const IntrinsicTriangulation::Factors& u)
  {
    const int faces = this->Triangulation.faceCount();
    this->Gradient.resize(this->unknowns());
    for (int r = 0; r < this->unknowns(); ++r)
    {
      this->Gradient[r] = this->TargetAngles[this->Vertex[r]];
    }
    this->Cotangents.resize(3 * faces);
    this->DegenerateFaces = 0;
    for (int f = 0; f < faces; ++f)
    {
      const TriangleAngles t = this->Triangulation.scaledAngles(f, u);
      this->DegenerateFaces += t.Degenerate;
      for (int k = 0; k < 3; ++k)
      {
        this->Cotangents[3 * f + k] = t.Cotangent[k];
        this->subtract(
          this->Triangulation.origin(IntrinsicTriangulation::previous(3 * f + k)), t.Angle[k]);
      }
    }
    const auto& boundary = this->Triangulation.boundaryEdges();
    this->BoundaryCotangents.assign(boundary.size(), 0.0);
    for (std::size_t b = 0; b < boundary.size(); ++b)
    {
      if (boundary[b].Origin >= 0 && !boundary[b].AtInfinity)
      {
        const MirrorCellShape cell = mirrorCellShape(this->Triangulation.scaledMirrorCell(b, u));
        this->DegenerateFaces += cell.Degenerate;
        this->BoundaryCotangents[b] = cell.Cotangent;
        this->subtract(boundary[b].Origin, cell.AngleAtOrigin);
        this->subtract(this->Triangulation.tipOfBoundaryEdge(b), cell.AngleAtTip);
      }
    }
  }

  // Half the cotangent Laplacian at the factors of the last evaluate().
  SparseMatrix hessian() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * this->Cotangents.size());
    // An edge from a vertex to itself contributes nothing.
    const auto couple = [&](int origin, int tip, double weight)
    {
      const int i = this->Row[origin];
      const int j = this->Row[tip];
      if (i != j)
      {
        if (i >= 0)
        {
          entries.emplace_back(i, i, weight);
        }
        if (j >= 0)
        {
          entries.emplace_back(j, j, weight);
        }
        if (i >= 0 && j >= 0)
        {
          entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
        }
      }
    };
    for (int h = 0; h < this->Triangulation.halfedgeCount(); ++h)
    {
      couple(this->Triangulation.origin(h), this->Triangulation.tip(h), 0.5 * this->Cotangents[h]);
    }
    for (std::size_t b = 0; b < this->BoundaryCotangents.size(); ++b)
    {
      if (this->BoundaryCotangents[b] > 0.0)
      {
        couple(this->Triangulation.boundaryEdges()[b].Origin,
          this->Triangulation.tipOfBoundaryEdge(b),
          0.5 * this->BoundaryCotangents[b]);
      }
    }
    SparseMatrix matrix(this->unknowns(), this->unknowns());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  void addTo(IntrinsicTriangulation::Factors& u, const Eigen::VectorXd& step, double length) const
  {
    for (int r = 0; r < this->unknowns(); ++r)
    {
      u[this->Vertex[r]] += length * step[r];
    }
  }

  Eigen::VectorXd Gradient;
  int DegenerateFaces = 0;

private:
  void subtract(int vertex, double angle)
  {
    if (this->Row[vertex] >= 0)
    {
      this->Gradient[this->Row[vertex]] -= angle;
    }
  }

  const IntrinsicTriangulation& Triangulation;
  const Eigen::VectorXd& TargetAngles;
  std::vector<int> Row;
  std::vector<int> Vertex;
  std::vector<double> Cotangents;
  std::vector<double> BoundaryCotangents; // of the mirror cells
};

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

} // namespace

RicciFlowResult discreteRicciFlow(IntrinsicTriangulation& triangulation,
  const Eigen::VectorXd& targetAngles,
  const std::vector<char>& fixed,
  const IntrinsicTriangulation::Factors& start,
  const RicciFlowOptions& options,
  const ProgressCallback& progress)
{
  RicciFlowResult result;
  result.LogFactors = start;
  CurvatureSystem system(triangulation, targetAngles, fixed);
  result.Flips += triangulation.flipToDelaunay(result.LogFactors);
  system.evaluate(result.LogFactors);
  if (system.unknowns() == 0)
  {
    return result;
  }

  // The error falls quadratically at the end; progress is its logarithm's.
  const auto error = [&system] { return system.Gradient.lpNorm<Eigen::Infinity>(); };
  const double startError = std::max(error(), 10.0 * options.Tolerance);
  double fraction = 0.0;
  std::vector<char> settled = fixed;
  SparseCholesky cholesky;
  double best = error();
  int stalled = 0;
  while (error() > options.Tolerance && result.NewtonIterations < options.MaximumIterations)
  {
    fraction = std::max(fraction,
      std::clamp(std::log(startError / error()) / std::log(startError / options.Tolerance), 0.0, 1.0));
    report(progress, fraction, "Ricci flow");

    // Where triangles are degenerate the energy is flat; a ridge keeps the step finite there. The
    // Hessian has no unit: its entries are cotangents.
    cholesky.setShift(system.DegenerateFaces > 0 ? 1e-3 : 0.0);
    cholesky.compute(system.hessian());
    if (cholesky.info() != Eigen::Success)
    {
      throw ConvergenceError("the Ricci flow's Hessian could not be factored after " +
                             std::to_string(result.NewtonIterations) +
                             " Newton steps: remesh the surface (Surface To Disk, Remesh)");
    }
    const Eigen::VectorXd step = -cholesky.solve(system.Gradient);
    // The energy is convex: along a descent direction its derivative grows, and a step is long enough
    // as soon as the derivative has shrunk, too long once it is as steep upwards as it was downwards.
    const double slope = system.Gradient.dot(step);
    const double previous = error();
    const IntrinsicTriangulation::Factors origin = result.LogFactors;
    double length = std::min(1.0, 8.0 / std::max(step.lpNorm<Eigen::Infinity>(), 1e-300));
    for (int trial = 0; trial < 40; ++trial, length *= 0.5)
    {
      result.LogFactors = origin;
      system.addTo(result.LogFactors, step, length);
      result.Flips += triangulation.flipToDelaunay(result.LogFactors);
      system.evaluate(result.LogFactors);
      if (system.Gradient.dot(step) <= -0.5 * slope || error() < 0.5 * previous)
      {
        break;
      }
    }
    ++result.NewtonIterations;
    if (system.DegenerateFaces > 0 && (error() < SettledError || result.NewtonIterations > 8))
    {
      if (reachInfinity(triangulation, targetAngles, settled, result.LogFactors))
      {
        system.setFixed(settled);
        result.Flips += triangulation.flipToDelaunay(result.LogFactors);
        system.evaluate(result.LogFactors);
      }
    }
    stalled = error() < 0.9 * best ? 0 : stalled + 1;
    best = std::min(best, error());
    if (stalled >= 4 && best < 1e-9)
    {
      break; // at the rounding floor
    }
  }
  result.MaxCurvatureError = error();
  if (system.DegenerateFaces > 0 || !(result.MaxCurvatureError <= 1e-10))
  {
    std::ostringstream message;
    message << "the Ricci flow stopped after " << result.NewtonIterations
            << " Newton steps at a curvature error of " << result.MaxCurvatureError << " with "
            << system.DegenerateFaces
            << " degenerate triangles: remesh the surface (Surface To Disk, Remesh)";
    throw ConvergenceError(message.str());
  }
  return result;
}

} // namespace flattening
