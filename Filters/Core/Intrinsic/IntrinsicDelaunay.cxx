// SPDX-License-Identifier: GPL-3.0-or-later
// The flips that make an IntrinsicTriangulation Delaunay.
#include "Base/Errors.h"
#include "Base/Progress.h"
#include "Intrinsic/IntrinsicMetrics.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/Halfedges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

using intrinsic::ConformalMetric;
using intrinsic::DoubledMetric;
using intrinsic::FlatMetric;

constexpr const char* DelaunayStage = "Intrinsic Delaunay triangulation";

// A guard: an edge whose opposite angles have cosines of a larger sum is Delaunay, although the quick
// cosines are not exact. Their errors are far smaller, unless a side is 1e-13 times as long as the
// others.
constexpr double CertainlyDelaunay = 1e-3;
// Flips for each half-edge after which a surface counts as one that cannot be made Delaunay. A guard:
// the flips of a metric end by themselves but for rounding. Strips of n points on either side whose
// triangles are fans need n / 8.
constexpr long long MostFlipsOfMetric = 1000;
// The same for conformal factors, which later steps of a flow change again.
constexpr long long MostFlipsOfFactors = 10;
// Bounds of small surfaces are greater by this.
constexpr long long FlipsOfSmallSurfaces = 1000;
// Flips between two reports: about ten milliseconds.
constexpr long long FlipsPerReport = 50000;

} // namespace

// Flips edges, and opens and closes the mirror's cells, until none violates the Delaunay condition of a
// metric. A side is a half-edge, or -1 - b for boundary edge b, as in glue().
template <typename Metric>
class IntrinsicTriangulation::DelaunayFlips
{
public:
  DelaunayFlips(IntrinsicTriangulation& triangulation, const Metric& metric)
    : Surface(triangulation)
    , Lengths(metric)
    , Queued(triangulation.halfedgeCount(), 0)
    , BoundaryQueued(triangulation.Boundary.size(), 0)
  {
  }

  // Flips until no edge violates the condition, or until there were more than @p mostPerHalfedge flips
  // for each half-edge. Returns whether none violates it.
  bool run(long long mostPerHalfedge, const ProgressCallback& progress)
  {
    this->pushInnerEdges();
    this->pushBoundaryEdges();
    const long long most = mostPerHalfedge * this->Surface.halfedgeCount() + FlipsOfSmallSurfaces;
    while (!this->Queue.empty() && this->Flips < most)
    {
      if (this->Flips % FlipsPerReport == 0)
      {
        report(progress, 0.0, DelaunayStage);
      }
      const int side = this->Queue.front();
      this->Queue.pop_front();
      this->mark(side) = 0;
      if (side >= 0)
      {
        this->settleInnerEdge(side);
      }
      else
      {
        this->settleBoundaryEdge(-1 - side);
      }
    }
    this->Surface.closeGaps();
    return this->Queue.empty();
  }

  // As run(), for a metric of the surface. Returns the number of flips. @throws ConvergenceError
  long long runToTheEnd(const ProgressCallback& progress)
  {
    if (!this->run(MostFlipsOfMetric, progress))
    {
      throw ConvergenceError("the triangulation could not be made Delaunay after " +
                             std::to_string(this->Flips) +
                             " flips of edges: remesh the surface (Surface To Disk, Remesh)");
    }
    return this->Flips;
  }

  long long flips() const { return this->Flips; }

private:
  char& mark(int side) { return side >= 0 ? this->Queued[side] : this->BoundaryQueued[-1 - side]; }

  void push(int side)
  {
    side = side < 0 ? side : std::min(side, this->Surface.Twins[side]);
    if (!this->mark(side))
    {
      this->mark(side) = 1;
      this->Queue.push_back(side);
    }
  }

  bool mayFlip(int h) const
  {
    const int twin = this->Surface.Twins[h];
    return this->Surface.Origins[h] >= 0 && twin >= 0 && face(twin) != face(h);
  }

  // Cosines of the angles opposite to all half-edges, by one exponential per side: not to the last
  // digit.
  std::vector<double> quickCosines() const
  {
    std::vector<double> cosines(this->Surface.halfedgeCount());
    tbb::parallel_for(tbb::blocked_range<int>(0, this->Surface.faceCount(), HalfedgesPerTask / 3),
      [&](const tbb::blocked_range<int>& faces)
      {
        for (int f = faces.begin(); f < faces.end(); ++f)
        {
          double length[3];
          for (int k = 0; k < 3; ++k)
          {
            length[k] = std::exp(
              static_cast<double>(this->Lengths.logLength(3 * f + k) - this->Lengths.logLength(3 * f)));
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

  void pushInnerEdges()
  {
    const int count = this->Surface.halfedgeCount();
    const std::vector<double> cosines = this->quickCosines();
    std::vector<char> mustFlip(count, 0);
    tbb::parallel_for(tbb::blocked_range<int>(0, count, HalfedgesPerTask),
      [&](const tbb::blocked_range<int>& halfedges)
      {
        for (int h = halfedges.begin(); h < halfedges.end(); ++h)
        {
          const int twin = this->Surface.Twins[h];
          mustFlip[h] = twin > h && !(cosines[h] + cosines[twin] > CertainlyDelaunay) &&
                        this->mayFlip(h) && this->Lengths.mustFlip(h);
        }
      });
    for (int h = 0; h < count; ++h)
    {
      if (mustFlip[h])
      {
        this->push(h);
      }
    }
  }

  void pushBoundaryEdges()
  {
    for (int b = 0; b < static_cast<int>(this->Surface.Boundary.size()); ++b)
    {
      if (this->Surface.Boundary[b].Origin >= 0 &&
          (this->Lengths.mustClose(b) || this->Lengths.mustOpen(b)))
      {
        this->push(-1 - b);
      }
    }
  }

  void settleInnerEdge(int h)
  {
    if (!this->mayFlip(h) || !this->Lengths.mustFlip(h))
    {
      return;
    }
    const int t = this->Surface.Twins[h];
    // Which half-edge stands for an edge may change with the slots: clear the marks of the four sides.
    const int sides[4] = { next(h), previous(h), next(t), previous(t) };
    for (const int side : sides)
    {
      this->mark(side) = 0;
      this->mark(this->Surface.Twins[side]) = 0;
    }
    this->Surface.flip(h, this->Lengths.flipped(h));
    ++this->Flips;
    for (const int side : sides)
    {
      this->push(side);
    }
  }

  void settleBoundaryEdge(int b)
  {
    std::vector<BoundaryEdge>& boundary = this->Surface.Boundary;
    if (boundary[b].Origin < 0)
    {
      return;
    }
    if (this->Lengths.mustClose(b))
    {
      const int before = boundary[b].Previous;
      const int f = this->Surface.closeBoundaryVertex(b, this->Lengths.closed(b));
      this->Queued.resize(this->Surface.halfedgeCount(), 0);
      ++this->Flips;
      for (const int side : { 3 * f + 1, 3 * f + 2, -1 - before, -1 - boundary[before].Next })
      {
        this->push(side);
      }
    }
    else if (this->Lengths.mustOpen(b))
    {
      this->Surface.openBoundaryEdge(b, this->Lengths.opened(b));
      this->BoundaryQueued.resize(boundary.size(), 0);
      ++this->Flips;
      const int added = boundary[b].Next;
      for (const int side : { -1 - b, -1 - added, -1 - boundary[added].Next })
      {
        this->push(side);
      }
    }
  }

  IntrinsicTriangulation& Surface;
  const Metric& Lengths;
  // Sides that may violate the condition, first come, first served. With the last one first, Ricci flows
  // flip more edges, and more of them fail: 5.4 instead of 4.9 % of the flows on random surfaces.
  std::deque<int> Queue;
  std::vector<char> Queued;         // per half-edge: whether the queue has it
  std::vector<char> BoundaryQueued; // the same per boundary edge
  long long Flips = 0;
};

// Logarithm of the length of the other diagonal of the two triangles at h, unfolded into the plane.
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

long long IntrinsicTriangulation::flipToDelaunay(const ProgressCallback& progress)
{
  const FlatMetric metric{ *this, [this](int h) { return this->otherDiagonal(h); } };
  return DelaunayFlips<FlatMetric>(*this, metric).runToTheEnd(progress);
}

long long IntrinsicTriangulation::flipDoubleToDelaunay(const ProgressCallback& progress)
{
  const Factors none = Factors::Zero(this->VertexCount);
  const DoubledMetric metric{ { *this, none }, [this](int h) { return this->otherDiagonal(h); } };
  return DelaunayFlips<DoubledMetric>(*this, metric).runToTheEnd(progress);
}

long long IntrinsicTriangulation::flipToDelaunay(const Factors& u)
{
  const ConformalMetric metric{ *this, u };
  DelaunayFlips<ConformalMetric> flips(*this, metric);
  flips.run(MostFlipsOfFactors, {});
  return flips.flips();
}

} // namespace flattening
