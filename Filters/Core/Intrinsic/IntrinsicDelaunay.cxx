// SPDX-License-Identifier: GPL-3.0-or-later
// The flips that make an IntrinsicTriangulation Delaunay.
#include "Intrinsic/IntrinsicMetrics.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

using intrinsic::ConformalMetric;
using intrinsic::DoubledMetric;
using intrinsic::FlatMetric;

constexpr int HalfedgesPerTask = 4096;
// Two opposite angles whose cosines have a larger sum need not be looked at more closely.
constexpr double CertainlyDelaunay = 1e-3;

} // namespace

// Of the angles opposite to all half-edges, by one exponential per side: not to the last digit.
template <typename Metric>
std::vector<double> IntrinsicTriangulation::cosines(const Metric& metric) const
{
  std::vector<double> cosines(this->halfedgeCount());
  tbb::parallel_for(tbb::blocked_range<int>(0, this->faceCount(), HalfedgesPerTask / 3),
    [&](const tbb::blocked_range<int>& faces)
    {
      for (int f = faces.begin(); f < faces.end(); ++f)
      {
        double length[3];
        for (int k = 0; k < 3; ++k)
        {
          length[k] =
            std::exp(static_cast<double>(metric.logLength(3 * f + k) - metric.logLength(3 * f)));
        }
        for (int k = 0; k < 3; ++k)
        {
          const double a = length[k];
          const double b = length[(k + 1) % 3];
          const double c = length[(k + 2) % 3];
          cosines[3 * f + k] = ((b - a) * (b + a) + c * c) / (2.0 * b * c);
        }
      }
    });
  return cosines;
}

template <typename Metric>
int IntrinsicTriangulation::flipAll(const Metric& metric)
{
  std::vector<int> stack; // sides, as in glue()
  std::vector<char> queued(this->halfedgeCount(), 0);
  std::vector<char> boundaryQueued(this->Boundary.size(), 0);
  const auto mark = [&](int side) -> char&
  { return side >= 0 ? queued[side] : boundaryQueued[-1 - side]; };
  const auto push = [&](int side)
  {
    side = side < 0 ? side : std::min(side, this->Twins[side]);
    if (!mark(side))
    {
      mark(side) = 1;
      stack.push_back(side);
    }
  };
  const auto mayFlip = [&](int h)
  { return this->Origins[h] >= 0 && this->Twins[h] >= 0 && face(this->Twins[h]) != face(h); };
  const std::vector<double> cosines = this->cosines(metric);
  std::vector<char> mustFlip(this->halfedgeCount(), 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, this->halfedgeCount(), HalfedgesPerTask),
    [&](const tbb::blocked_range<int>& halfedges)
    {
      for (int h = halfedges.begin(); h < halfedges.end(); ++h)
      {
        mustFlip[h] = this->Twins[h] > h &&
                      !(cosines[h] + cosines[this->Twins[h]] > CertainlyDelaunay) && mayFlip(h) &&
                      metric.mustFlip(h);
      }
    });
  for (int h = 0; h < this->halfedgeCount(); ++h)
  {
    if (mustFlip[h])
    {
      push(h);
    }
  }
  for (int b = 0; b < static_cast<int>(this->Boundary.size()); ++b)
  {
    if (this->Boundary[b].Origin >= 0 && (metric.mustClose(b) || metric.mustOpen(b)))
    {
      push(-1 - b);
    }
  }
  // Delaunay flips end by themselves; the bound only guards against rounding on degenerate metrics.
  const long long bound = 10LL * this->halfedgeCount() + 1000;
  long long flips = 0;
  while (!stack.empty() && flips < bound)
  {
    const int side = stack.back();
    stack.pop_back();
    mark(side) = 0;
    if (side >= 0 && mayFlip(side) && metric.mustFlip(side))
    {
      const int t = this->Twins[side];
      // Which half-edge stands for an edge may change with the slots: clear the marks of the four sides.
      const int sides[4] = { next(side), previous(side), next(t), previous(t) };
      for (const int s : sides)
      {
        mark(s) = 0;
        mark(this->Twins[s]) = 0;
      }
      this->flip(side, metric.flipped(side));
      ++flips;
      for (const int s : sides)
      {
        push(s);
      }
    }
    const int b = -1 - side;
    if (side >= 0 || this->Boundary[b].Origin < 0)
    {
      continue;
    }
    if (metric.mustClose(b))
    {
      const int before = this->Boundary[b].Previous;
      const int f = this->closeBoundaryVertex(b, metric.closed(b));
      queued.resize(this->halfedgeCount(), 0);
      ++flips;
      for (const int s : { 3 * f + 1, 3 * f + 2, -1 - before, -1 - this->Boundary[before].Next })
      {
        push(s);
      }
    }
    else if (metric.mustOpen(b))
    {
      this->openBoundaryEdge(b, metric.opened(b));
      boundaryQueued.resize(this->Boundary.size(), 0);
      ++flips;
      const int added = this->Boundary[b].Next;
      for (const int s : { -1 - b, -1 - added, -1 - this->Boundary[added].Next })
      {
        push(s);
      }
    }
  }
  this->closeGaps();
  return static_cast<int>(flips);
}

// Log-length of the other diagonal of the two triangles at h, unfolded into the plane.
long double IntrinsicTriangulation::otherDiagonal(int h) const
{
  const int t = this->Twins[h];
  const long double unit = this->LogLengths[h]; // edge h from (0,0) to (1,0)
  const auto apex = [&](int fromOrigin, int fromTip, double side)
  {
    const double p = std::exp(static_cast<double>(this->LogLengths[fromOrigin] - unit));
    const double q = std::exp(static_cast<double>(this->LogLengths[fromTip] - unit));
    const double x = 0.5 * (1.0 + (p - q) * (p + q));
    return Eigen::Vector2d(x, side * std::sqrt(std::max(0.0, (p - x) * (p + x))));
  };
  const Eigen::Vector2d c = apex(previous(h), next(h), 1.0);
  const Eigen::Vector2d d = apex(next(t), previous(t), -1.0);
  return unit + std::log((c - d).norm());
}

int IntrinsicTriangulation::flipToDelaunay()
{
  return this->flipAll(FlatMetric{ *this, [this](int h) { return this->otherDiagonal(h); } });
}

int IntrinsicTriangulation::flipDoubleToDelaunay()
{
  const Factors none = Factors::Zero(this->VertexCount);
  return this->flipAll(
    DoubledMetric{ { *this, none }, [this](int h) { return this->otherDiagonal(h); } });
}

int IntrinsicTriangulation::flipToDelaunay(const Factors& u)
{
  return this->flipAll(ConformalMetric{ *this, u });
}

} // namespace flattening
