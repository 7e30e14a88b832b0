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

// Gradient and, on request, Hessian of the energy at one choice of factors.
class CurvatureSystem
{
public:
  CurvatureSystem(const IntrinsicTriangulation& triangulation,
    const Eigen::VectorXd& targetAngles,
    const std::vector<char>& fixed)
    : Triangulation(triangulation)
    , TargetAngles(targetAngles)
    , Row(fixed.size(), -1)
  {
    const std::vector<int>& used = triangulation.anyOutgoing();
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      if (!fixed[v] && used[v] >= 0)
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
      const TriangleAngles t = triangleAngles(this->Triangulation.scaledLogLength(3 * f, u),
        this->Triangulation.scaledLogLength(3 * f + 1, u),
        this->Triangulation.scaledLogLength(3 * f + 2, u));
      this->DegenerateFaces += t.Degenerate;
      for (int k = 0; k < 3; ++k)
      {
        this->Cotangents[3 * f + k] = t.Cotangent[k];
        const int opposite = this->Triangulation.origin(IntrinsicTriangulation::previous(3 * f + k));
        if (this->Row[opposite] >= 0)
        {
          this->Gradient[this->Row[opposite]] -= t.Angle[k];
        }
      }
    }
  }

  // Half the cotangent Laplacian at the factors of the last evaluate().
  SparseMatrix hessian() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * this->Cotangents.size());
    for (int h = 0; h < this->Triangulation.halfedgeCount(); ++h)
    {
      const double w = 0.5 * this->Cotangents[h];
      const int i = this->Row[this->Triangulation.origin(h)];
      const int j = this->Row[this->Triangulation.tip(h)];
      if (i >= 0)
      {
        entries.emplace_back(i, i, w);
      }
      if (j >= 0)
      {
        entries.emplace_back(j, j, w);
      }
      if (i >= 0 && j >= 0)
      {
        // An edge from a vertex to itself contributes nothing in total: i and j then coincide.
        entries.emplace_back(std::max(i, j), std::min(i, j), i == j ? -2.0 * w : -w);
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
  const IntrinsicTriangulation& Triangulation;
  const Eigen::VectorXd& TargetAngles;
  std::vector<int> Row;
  std::vector<int> Vertex;
  std::vector<double> Cotangents;
};

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
