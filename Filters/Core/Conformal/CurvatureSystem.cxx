// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/CurvatureSystem.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// Faces per task of a parallel loop: enough to outweigh the cost of a task.
constexpr int AngleFacesPerTask = 1024;

} // namespace

Eigen::VectorXd flatAngleSums(const IntrinsicTriangulation& t)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Constant(t.vertexCount(), 2.0 * EIGEN_PI);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    if (t.twin(h) < 0)
    {
      sums[t.origin(h)] = sums[t.tip(h)] = EIGEN_PI;
    }
  }
  return sums;
}

CurvatureSystem::CurvatureSystem(const IntrinsicTriangulation& triangulation,
  const Eigen::VectorXd& targetAngles,
  const std::vector<char>& fixed)
  : Triangulation(triangulation)
  , TargetAngles(targetAngles)
{
  this->setFixed(fixed);
}

void CurvatureSystem::setFixed(const std::vector<char>& fixed)
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

void CurvatureSystem::evaluate(const IntrinsicTriangulation::Factors& u)
{
  const IntrinsicTriangulation& t = this->Triangulation;
  this->Angles.resize(t.faceCount());
  tbb::parallel_for(tbb::blocked_range<int>(0, t.faceCount(), AngleFacesPerTask),
    [&](const tbb::blocked_range<int>& faces)
    {
      for (int f = faces.begin(); f < faces.end(); ++f)
      {
        this->Angles[f] = t.scaledAngles(f, u);
      }
    });

  this->Gradient = this->TargetAngles(this->Vertex);
  this->DegenerateFaces = 0;
  for (int f = 0; f < t.faceCount(); ++f)
  {
    const TriangleAngles& angles = this->Angles[f];
    this->DegenerateFaces += angles.Degenerate;
    for (int k = 0; k < 3; ++k)
    {
      this->subtract(t.origin(IntrinsicTriangulation::previous(3 * f + k)), angles.Angle[k]);
    }
  }
  const auto& boundary = t.boundaryEdges();
  this->BoundaryCotangents.assign(boundary.size(), 0.0);
  for (std::size_t b = 0; b < boundary.size(); ++b)
  {
    if (boundary[b].Origin >= 0 && !boundary[b].AtInfinity)
    {
      const TrapezoidShape cell = trapezoidShape(t.scaledTrapezoid(b, u));
      this->DegenerateFaces += cell.Degenerate;
      this->BoundaryCotangents[b] = cell.Cotangent;
      this->subtract(boundary[b].Origin, cell.AngleAtOrigin);
      this->subtract(t.tipOfBoundaryEdge(b), cell.AngleAtTip);
    }
  }
}

std::vector<int> CurvatureSystem::verticesOffBy(double error) const
{
  std::vector<int> vertices;
  for (int r = 0; r < this->unknowns(); ++r)
  {
    if (std::abs(this->Gradient[r]) > error)
    {
      vertices.push_back(this->Vertex[r]);
    }
  }
  return vertices;
}

SparseMatrix CurvatureSystem::hessian() const
{
  const IntrinsicTriangulation& t = this->Triangulation;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(t.halfedgeCount() / 2 + this->BoundaryCotangents.size() + this->unknowns());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(this->unknowns());
  // An edge from a vertex to itself contributes nothing.
  const auto couple = [&](int origin, int tip, double weight)
  {
    const int i = this->Row[origin];
    const int j = this->Row[tip];
    if (i != j)
    {
      if (i >= 0)
      {
        diagonal[i] += weight;
      }
      if (j >= 0)
      {
        diagonal[j] += weight;
      }
      if (i >= 0 && j >= 0)
      {
        entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
      }
    }
  };
  const auto cotangent = [this](int h) { return this->Angles[h / 3].Cotangent[h % 3]; };
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const int twin = t.twin(h);
    if (twin < h)
    {
      couple(t.origin(h), t.tip(h), 0.5 * (cotangent(h) + (twin >= 0 ? cotangent(twin) : 0.0)));
    }
  }
  for (std::size_t b = 0; b < this->BoundaryCotangents.size(); ++b)
  {
    if (this->BoundaryCotangents[b] > 0.0)
    {
      couple(t.boundaryEdges()[b].Origin, t.tipOfBoundaryEdge(b), 0.5 * this->BoundaryCotangents[b]);
    }
  }
  for (int r = 0; r < this->unknowns(); ++r)
  {
    entries.emplace_back(r, r, diagonal[r]);
  }
  SparseMatrix matrix(this->unknowns(), this->unknowns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double CurvatureSystem::greatestDifference(const Eigen::VectorXd& step) const
{
  const auto at = [this, &step](int v) { return this->Row[v] >= 0 ? step[this->Row[v]] : 0.0; };
  double greatest = 0.0;
  for (int h = 0; h < this->Triangulation.halfedgeCount(); ++h)
  {
    greatest =
      std::max(greatest, std::abs(at(this->Triangulation.origin(h)) - at(this->Triangulation.tip(h))));
  }
  return greatest;
}

EliminationOrder CurvatureSystem::vertexOrder(EliminationOrder order) const
{
  if (static_cast<int>(order.Unknowns.size()) != this->unknowns())
  {
    return {};
  }
  for (int& unknown : order.Unknowns)
  {
    unknown = this->Vertex[unknown];
  }
  return order;
}

void CurvatureSystem::addTo(IntrinsicTriangulation::Factors& u,
  const Eigen::VectorXd& step,
  double length) const
{
  for (int r = 0; r < this->unknowns(); ++r)
  {
    u[this->Vertex[r]] += length * step[r];
  }
}

void CurvatureSystem::subtract(int vertex, double angle)
{
  if (this->Row[vertex] >= 0)
  {
    this->Gradient[this->Row[vertex]] -= angle;
  }
}

} // namespace flattening
