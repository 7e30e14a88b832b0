// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementEnergy.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

constexpr int PerTask = 2048;
// Of the bound of the areas' second derivative: half of it converges twice as fast and is enough.
constexpr double BoundShare = 0.5;
// What the order of the boundary counts against areas, by the square of a gap.
constexpr double GapWeight = 1e-3;

// Sums task by task, in the same order whatever the number of threads.
template <typename Function>
double orderedSum(int count, const Function& function)
{
  const int tasks = (count + PerTask - 1) / PerTask;
  std::vector<double> parts(tasks, 0.0);
  tbb::parallel_for(0,
    tasks,
    [&](int task)
    {
      double sum = 0.0;
      for (int i = task * PerTask; i < std::min(count, (task + 1) * PerTask); ++i)
      {
        sum += function(i);
      }
      parts[task] = sum;
    });
  double sum = 0.0;
  for (const double part : parts)
  {
    sum += part;
  }
  return sum;
}

Eigen::Vector2d quarterTurn(const Eigen::Vector2d& v)
{
  return { -v.y(), v.x() };
}

} // namespace

struct RefinementEnergy::FlatFace
{
  Eigen::Vector2d Sides[3]; // opposite to each corner, counter-clockwise
  double Area;
  double Dirichlet;

  // Of the area, by the place of a corner.
  Eigen::Vector2d areaSlope(int corner) const { return 0.5 * quarterTurn(this->Sides[corner]); }
};

RefinementEnergy::RefinementEnergy(const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& unknowns)
  : Terms(terms)
  , FacesOf(facesOf)
  , Unknowns(unknowns)
  , Energy(FaceAreaEnergy::Options())
  , Values(terms.Faces.rows())
{
}

void RefinementEnergy::setEpsilon(double epsilon)
{
  FaceAreaEnergy::Options options;
  options.Epsilon = epsilon;
  this->Energy = FaceAreaEnergy(options);
}

void RefinementEnergy::setEnclosed(const FlatState& state)
{
  const std::vector<int>& loop = this->Unknowns.loop();
  double twice = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const Eigen::RowVector2d a = state.Positions.row(loop[k]);
    const Eigen::RowVector2d b = state.Positions.row(loop[(k + 1) % loop.size()]);
    twice += a.x() * b.y() - a.y() * b.x();
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

FaceAreaEnergy::Value RefinementEnergy::faceValue(const FlatFace& flat, int face) const
{
  return this->Energy.value(
    flat.Area, this->Scale * this->Targets[face], flat.Dirichlet, this->Terms.ShapeWeights[face]);
}

double RefinementEnergy::gapValue(const FlatState& state,
  const BoundaryGap& gap,
  double& slope,
  double& curvature) const
{
  const double turn = gap.Second < gap.First ? this->Unknowns.domain().perimeter() : 0.0;
  const double length = state.Places[gap.Second] - state.Places[gap.First] + turn;
  const double weight = GapWeight * gap.Share * gap.Share;
  const double rho = length / gap.Share;
  if (!(rho > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  slope = weight * (1.0 - 1.0 / rho) / gap.Share;
  curvature = weight / (rho * rho * gap.Share * gap.Share);
  return weight * (rho - 1.0 - std::log(rho));
}

double RefinementEnergy::value(const FlatState& state) const
{
  double sum = orderedSum(static_cast<int>(this->Terms.Faces.rows()),
    [&](int f) { return this->faceValue(this->flatFace(state.Positions, f), f).Energy; });
  for (const BoundaryGap& gap : this->Terms.Gaps)
  {
    double slope;
    double curvature;
    sum += this->gapValue(state, gap, slope, curvature);
  }
  return sum;
}

double RefinementEnergy::gradient(const FlatState& state, Eigen::VectorXd& gradient)
{
  double sum = orderedSum(static_cast<int>(this->Terms.Faces.rows()),
    [&](int f)
    {
      this->Values[f] = this->faceValue(this->flatFace(state.Positions, f), f);
      return this->Values[f].Energy;
    });
  gradient.setZero(this->Unknowns.count());
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(state.Positions.rows()), PerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        Eigen::Vector2d slope = Eigen::Vector2d::Zero();
        for (const int f : this->FacesOf[v])
        {
          const FlatFace flat = this->flatFace(state.Positions, f);
          const int k = this->Terms.Faces(f, 0) == v ? 0 : this->Terms.Faces(f, 1) == v ? 1 : 2;
          const int next = (k + 1) % 3;
          const int last = (k + 2) % 3;
          const Eigen::Vector2d byDirichlet =
            0.5 * (this->Terms.Cotangents(f, next) * flat.Sides[next] -
                    this->Terms.Cotangents(f, last) * flat.Sides[last]);
          slope +=
            this->Values[f].ByArea * flat.areaSlope(k) + this->Values[f].ByDirichlet * byDirichlet;
        }
        const Eigen::Vector2d own = this->Unknowns.directions(state, v).transpose() * slope;
        gradient.segment(this->Unknowns.first(v), this->Unknowns.countOf(v)) =
          own.head(this->Unknowns.countOf(v));
      }
    });
  for (const BoundaryGap& gap : this->Terms.Gaps)
  {
    double slope = 0.0;
    double curvature;
    sum += this->gapValue(state, gap, slope, curvature);
    const int own = this->Unknowns.unknownOfMember(gap.First);
    const int next = this->Unknowns.unknownOfMember(gap.Second);
    if (own >= 0)
    {
      gradient[own] -= slope;
    }
    if (next >= 0)
    {
      gradient[next] += slope;
    }
  }
  return sum;
}

Eigen::VectorXd RefinementEnergy::areaRatios(const FlatState& state) const
{
  return signedFaceAreas(state.Positions, this->Terms.Faces).array() /
         (this->Scale * this->Targets.array());
}

// The columns of a vertex hold its own block and those of its neighbours of higher number.
void RefinementEnergy::findPattern()
{
  const int n = static_cast<int>(this->Unknowns.count());
  const Eigen::Index vertices = this->FacesOf.vertexCount();
  std::vector<int> starts(n + 1, 0);
  std::vector<int> rows;
  this->Rows.assign(9 * this->Terms.Faces.rows(), -1);
  std::vector<int> neighbours;
  for (int v = 0; v < vertices; ++v)
  {
    neighbours.clear();
    for (const int f : this->FacesOf[v])
    {
      for (int k = 0; k < 3; ++k)
      {
        neighbours.push_back(this->Terms.Faces(f, k));
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    neighbours.erase(neighbours.begin(), std::lower_bound(neighbours.begin(), neighbours.end(), v));

    const auto before = [&](int u)
    {
      int count = 0;
      for (const int w : neighbours)
      {
        if (w == u)
        {
          break;
        }
        count += this->Unknowns.countOf(w);
      }
      return count;
    };
    for (const int f : this->FacesOf[v])
    {
      const int k = this->Terms.Faces(f, 0) == v ? 0 : this->Terms.Faces(f, 1) == v ? 1 : 2;
      for (int j = 0; j < 3; ++j)
      {
        if (this->Terms.Faces(f, j) >= v)
        {
          this->Rows[9 * f + 3 * k + j] = before(this->Terms.Faces(f, j));
        }
      }
    }
    for (int own = 0; own < this->Unknowns.countOf(v); ++own)
    {
      const int column = this->Unknowns.first(v) + own;
      for (const int u : neighbours)
      {
        for (int k = 0; k < this->Unknowns.countOf(u); ++k)
        {
          if (this->Unknowns.first(u) + k >= column)
          {
            rows.push_back(this->Unknowns.first(u) + k);
          }
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

// Of one face, by the places of two of its corners.
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

void RefinementEnergy::addVertexBlocks(const FlatState& state, int vertex)
{
  const int own = this->Unknowns.countOf(vertex);
  const Eigen::Matrix2d directions = this->Unknowns.directions(state, vertex);
  const int* starts = this->Hessian.outerIndexPtr();
  double* values = this->Hessian.valuePtr();
  const int first = this->Unknowns.first(vertex);
  if (own > 0)
  {
    std::fill(values + starts[first], values + starts[first + own], 0.0);
  }
  for (const int f : this->FacesOf[vertex])
  {
    const FlatFace flat = this->flatFace(state.Positions, f);
    const int k = this->Terms.Faces(f, 0) == vertex ? 0 : this->Terms.Faces(f, 1) == vertex ? 1 : 2;
    for (int j = 0; j < 3; ++j)
    {
      const int row = this->Rows[9 * f + 3 * k + j];
      const int other = this->Terms.Faces(f, j);
      if (row < 0)
      {
        continue;
      }
      const Eigen::Matrix2d entries =
        this->Unknowns.directions(state, other).transpose() * this->block(flat, f, j, k) * directions;
      for (int c = 0; c < own; ++c)
      {
        double* column = values + starts[first + c] - c; // row 0 of the column's vertex is cut off
        for (int r = other == vertex ? c : 0; r < this->Unknowns.countOf(other); ++r)
        {
          column[row + r] += entries(r, c);
        }
      }
    }
  }
}

const SparseMatrix& RefinementEnergy::hessian(const FlatState& state)
{
  if (this->Rows.empty())
  {
    this->findPattern();
  }
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(state.Positions.rows()), PerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        this->addVertexBlocks(state, v);
      }
    });
  for (const BoundaryGap& gap : this->Terms.Gaps)
  {
    double slope = 0.0;
    double curvature = 0.0;
    this->gapValue(state, gap, slope, curvature);
    const int a = this->Unknowns.unknownOfMember(gap.First);
    const int b = this->Unknowns.unknownOfMember(gap.Second);
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
