// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementEnergy.h"

#include "Mesh/PlaneVectors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace flattening
{
namespace
{

// Faces or vertices of one task of a thread. It fixes the order of summation, and with it the last bits.
constexpr int ElementsPerTask = 2048;
// The share of the bound of the areas' second derivative in the Hessian: half of it converges twice as
// fast as all of it and is enough, since damping catches the rest.
constexpr double BoundShare = 0.5;
// The weight of the order of boundary vertices against areas, per square of an interval: small, so that
// areas decide how far vertices slide; with 0 they may pass each other.
constexpr double IntervalWeight = 1e-3;
// The stretch beyond which tiny intervals are held. A choice: with 5 and the same weight, four edges of
// a brain stay stretched more than ten times.
constexpr double IntervalLimit = 3.0;

// The sum task by task, in the same order for any number of threads.
template <typename Function>
double orderedSum(int count, const Function& function)
{
  const int tasks = (count + ElementsPerTask - 1) / ElementsPerTask;
  std::vector<double> parts(tasks, 0.0);
  tbb::parallel_for(0,
    tasks,
    [&](int task)
    {
      double sum = 0.0;
      for (int i = task * ElementsPerTask; i < std::min(count, (task + 1) * ElementsPerTask); ++i)
      {
        sum += function(i);
      }
      parts[task] = sum;
    });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

} // namespace

struct RefinementEnergy::FlatFace
{
  Eigen::Vector2d Sides[3]; // opposite to each corner, counter-clockwise
  double Area;
  double Dirichlet;

  // The derivative of the area by the position of a corner.
  Eigen::Vector2d areaSlope(int corner) const
  {
    return { -0.5 * this->Sides[corner].y(), 0.5 * this->Sides[corner].x() };
  }
};

RefinementEnergy::RefinementEnergy(const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& dofs)
  : Terms(terms)
  , FacesOf(facesOf)
  , Dofs(dofs)
  , Energy(0.0)
{
}

void RefinementEnergy::setEpsilon(double epsilon)
{
  this->Energy = FaceAreaEnergy(epsilon);
}

void RefinementEnergy::setEnclosed(const DomainMap& map)
{
  const std::vector<int>& loop = this->Dofs.loop();
  double twice = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    twice += cross(map.Positions.row(loop[k]), map.Positions.row(loop[(k + 1) % loop.size()]));
  }
  for (const auto& [from, to] : this->Terms.Outline) // of a free boundary, which has no loop on a domain
  {
    twice += cross(map.Positions.row(from), map.Positions.row(to));
  }
  this->Scale = 0.5 * twice / this->Targets.sum();
}

RefinementEnergy::FlatFace RefinementEnergy::flatFace(const Points2& positions, int face) const
{
  Eigen::Vector2d corners[3];
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = positions.row(this->Terms.Faces(face, k));
  }
  FlatFace flat;
  flat.Dirichlet = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    flat.Sides[k] = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    flat.Dirichlet += 0.25 * this->Terms.Cotangents(face, k) * flat.Sides[k].squaredNorm();
  }
  flat.Area = 0.5 * (flat.Sides[2].y() * flat.Sides[1].x() - flat.Sides[2].x() * flat.Sides[1].y());
  return flat;
}

int RefinementEnergy::cornerOf(int vertex, int face) const
{
  return this->Terms.Faces(face, 0) == vertex ? 0 : this->Terms.Faces(face, 1) == vertex ? 1 : 2;
}

FaceAreaEnergy::Value RefinementEnergy::faceValue(const FlatFace& flat, int face) const
{
  return this->Energy.value(flat.Area,
    this->Scale * this->Targets[face],
    flat.Dirichlet,
    { this->AreaWeights[face],
      this->Terms.ShapeWeights[face],
      this->Counts[face],
      this->Terms.ShapeLimits[face] });
}

RefinementEnergy::IntervalTerm RefinementEnergy::intervalTerm(const DomainMap& map,
  const BoundaryInterval& interval) const
{
  const double turn = interval.Second < interval.First ? this->Dofs.domain().perimeter() : 0.0;
  const double length =
    map.BoundaryParameters[interval.Second] - map.BoundaryParameters[interval.First] + turn;
  const double weight = IntervalWeight * interval.Share * interval.Share;
  const double rho = length / interval.Share;
  if (!(rho > 0.0))
  {
    return { std::numeric_limits<double>::infinity(), 0.0, 0.0 };
  }
  const double excess = std::max(0.0, rho / IntervalLimit - 1.0);
  const double byShare = excess > 0.0 ? 2.0 * interval.LimitWeight / IntervalLimit : 0.0;
  return { weight * (rho - 1.0 - std::log(rho)) + interval.LimitWeight * excess * excess,
    (weight * (1.0 - 1.0 / rho) + byShare * excess) / interval.Share,
    (weight / (rho * rho) + byShare / IntervalLimit) / (interval.Share * interval.Share) };
}

double RefinementEnergy::evaluateFace(const Points2& positions, int face)
{
  const FlatFace flat = this->flatFace(positions, face);
  const FaceAreaEnergy::Value value = this->faceValue(flat, face);
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const int last = (k + 2) % 3;
    const Eigen::Vector2d byDirichlet = 0.5 * (this->Terms.Cotangents(face, next) * flat.Sides[next] -
                                                this->Terms.Cotangents(face, last) * flat.Sides[last]);
    this->Slopes[3 * face + k] = value.ByArea * flat.areaSlope(k) + value.ByDirichlet * byDirichlet;
  }
  this->Values[face] = value;
  return value.Energy;
}

double RefinementEnergy::evaluate(const DomainMap& map)
{
  const int faces = static_cast<int>(this->Terms.Faces.rows());
  this->Values.resize(faces);
  this->Slopes.resize(3 * static_cast<std::size_t>(faces));
  double sum = orderedSum(faces, [&](int f) { return this->evaluateFace(map.Positions, f); });
  for (const BoundaryInterval& interval : this->Terms.Intervals)
  {
    sum += this->intervalTerm(map, interval).Energy;
  }
  return sum;
}

Eigen::VectorXd RefinementEnergy::gradient(const DomainMap& map) const
{
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(this->Dofs.count());
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(map.Positions.rows()), ElementsPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        Eigen::Vector2d slope = Eigen::Vector2d::Zero();
        for (const int f : this->FacesOf[v])
        {
          slope += this->Slopes[3 * f + this->cornerOf(v, f)];
        }
        const Eigen::Vector2d own = this->Dofs.directions(map, v).transpose() * slope;
        gradient.segment(this->Dofs.first(v), this->Dofs.countOf(v)) = own.head(this->Dofs.countOf(v));
      }
    });
  for (const BoundaryInterval& interval : this->Terms.Intervals)
  {
    const IntervalTerm term = this->intervalTerm(map, interval);
    const int own = this->Dofs.dofOfMember(interval.First);
    const int next = this->Dofs.dofOfMember(interval.Second);
    if (own >= 0)
    {
      gradient[own] -= term.Slope;
    }
    if (next >= 0)
    {
      gradient[next] += term.Slope;
    }
  }
  return gradient;
}

Eigen::VectorXd RefinementEnergy::areaRatios(const DomainMap& map) const
{
  return signedFaceAreas(map.Positions, this->Terms.Faces).array() /
         (this->Scale * this->Targets.array());
}

// A vertex and its neighbours of higher number, ascending.
std::vector<int> RefinementEnergy::higherNeighbours(int vertex) const
{
  std::vector<int> neighbours;
  for (const int f : this->FacesOf[vertex])
  {
    for (int k = 0; k < 3; ++k)
    {
      if (this->Terms.Faces(f, k) >= vertex)
      {
        neighbours.push_back(this->Terms.Faces(f, k));
      }
    }
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  return neighbours;
}

// Where the blocks of a vertex and of each neighbour begin in the columns of the vertex.
void RefinementEnergy::findBlockRows(int vertex, const std::vector<int>& neighbours)
{
  const auto rowOf = [&](int neighbour)
  {
    int row = 0;
    for (auto before = neighbours.begin(); *before != neighbour; ++before)
    {
      row += this->Dofs.countOf(*before);
    }
    return row;
  };
  for (const int f : this->FacesOf[vertex])
  {
    const int k = this->cornerOf(vertex, f);
    for (int j = 0; j < 3; ++j)
    {
      if (this->Terms.Faces(f, j) >= vertex)
      {
        this->Rows[9 * f + 3 * k + j] = rowOf(this->Terms.Faces(f, j));
      }
    }
  }
}

// The columns of a vertex hold its own block and those of its neighbours of higher number.
void RefinementEnergy::findPattern()
{
  const int n = this->Dofs.count();
  std::vector<int> starts(n + 1, 0);
  std::vector<int> rows;
  this->Rows.assign(9 * this->Terms.Faces.rows(), -1);
  for (int v = 0; v < this->FacesOf.vertexCount(); ++v)
  {
    const std::vector<int> neighbours = this->higherNeighbours(v);
    this->findBlockRows(v, neighbours);
    for (int column = this->Dofs.first(v); column < this->Dofs.first(v + 1); ++column)
    {
      for (const int u : neighbours)
      {
        for (int row = std::max(column, this->Dofs.first(u)); row < this->Dofs.first(u + 1); ++row)
        {
          rows.push_back(row);
        }
      }
      starts[column + 1] = static_cast<int>(rows.size());
    }
  }
  this->Hessian.resize(n, n);
  this->Hessian.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(starts.begin(), starts.end(), this->Hessian.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), this->Hessian.innerIndexPtr());
}

// The second derivative of a face's energy by the positions of two of its corners.
Eigen::Matrix2d RefinementEnergy::block(const FlatFace& flat, int face, int a, int b) const
{
  const FaceAreaEnergy::Value& value = this->Values[face];
  const auto positive = [&](int corner) { return std::max(0.0, this->Terms.Cotangents(face, corner)); };
  const double laplacian =
    a == b ? 0.5 * (positive((a + 1) % 3) + positive((a + 2) % 3)) : -0.5 * positive(3 - a - b);
  const double spread = value.ByDirichlet + BoundShare * std::abs(value.ByArea);
  return value.Curvature * flat.areaSlope(a) * flat.areaSlope(b).transpose() +
         spread * laplacian * Eigen::Matrix2d::Identity();
}

void RefinementEnergy::addVertexBlocks(const DomainMap& map, int vertex)
{
  const int own = this->Dofs.countOf(vertex);
  const Eigen::Matrix2d directions = this->Dofs.directions(map, vertex);
  const int* starts = this->Hessian.outerIndexPtr();
  double* values = this->Hessian.valuePtr();
  const int first = this->Dofs.first(vertex);
  if (own > 0)
  {
    std::fill(values + starts[first], values + starts[first + own], 0.0);
  }
  for (const int f : this->FacesOf[vertex])
  {
    const FlatFace flat = this->flatFace(map.Positions, f);
    const int k = this->cornerOf(vertex, f);
    for (int j = 0; j < 3; ++j)
    {
      const int row = this->Rows[9 * f + 3 * k + j];
      const int other = this->Terms.Faces(f, j);
      if (row < 0)
      {
        continue;
      }
      const Eigen::Matrix2d entries =
        this->Dofs.directions(map, other).transpose() * this->block(flat, f, j, k) * directions;
      for (int c = 0; c < own; ++c)
      {
        double* column = values + starts[first + c] - c; // row 0 of the column's vertex is cut off
        for (int r = other == vertex ? c : 0; r < this->Dofs.countOf(other); ++r)
        {
          column[row + r] += entries(r, c);
        }
      }
    }
  }
}

const SparseMatrix& RefinementEnergy::hessian(const DomainMap& map)
{
  if (this->Rows.empty())
  {
    this->findPattern();
  }
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(map.Positions.rows()), ElementsPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        this->addVertexBlocks(map, v);
      }
    });
  for (const BoundaryInterval& interval : this->Terms.Intervals)
  {
    const double curvature = this->intervalTerm(map, interval).Curvature;
    const int a = this->Dofs.dofOfMember(interval.First);
    const int b = this->Dofs.dofOfMember(interval.Second);
    for (const int own : { a, b })
    {
      if (own >= 0)
      {
        this->Hessian.coeffRef(own, own) += curvature;
      }
    }
    if (a >= 0 && b >= 0)
    {
      this->Hessian.coeffRef(std::max(a, b), std::min(a, b)) -= curvature;
    }
  }
  return this->Hessian;
}

} // namespace flattening
