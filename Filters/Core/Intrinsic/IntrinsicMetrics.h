// SPDX-License-Identifier: GPL-3.0-or-later
/// The metrics in which an intrinsic triangulation is made Delaunay: when an edge must be flipped, and
/// what becomes of its length.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"
#include "Intrinsic/SymmetricTrapezoid.h"
#include "Intrinsic/TriangleAngles.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace flattening::intrinsic
{

// An edge is flipped if the cosines of the angles opposite to it have a sum below minus this. It lies
// well above the rounding errors of cosines: with 0, cocircular vertices could flip an edge back and
// forth.
constexpr double FlipTolerance = 1e-12;

// The metric of the surface itself. No boundary edge is flipped.
struct FlatMetric
{
  const IntrinsicTriangulation& Triangulation;
  std::function<long double(int)> OtherDiagonal;

  long double logLength(int h) const { return this->Triangulation.logLength(h); }
  double cosine(int h) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    return cosineOpposite(t.logLength(h), t.logLength(t.next(h)), t.logLength(t.previous(h)));
  }
  bool mustFlip(int h) const
  {
    return this->cosine(h) + this->cosine(this->Triangulation.twin(h)) < -FlipTolerance;
  }
  long double flipped(int h) const { return this->OtherDiagonal(h); }
  bool mustOpen(int) const { return false; }
  long double opened(int) const { return 0.0L; }
  bool mustClose(int) const { return false; }
  long double closed(int) const { return 0.0L; }
};

// The metric at conformal factors u. The lengths after flips are computed at factors 0, because
// Ptolemy's relation holds for the lengths at all factors alike.
struct ConformalMetric
{
  const IntrinsicTriangulation& Triangulation;
  const IntrinsicTriangulation::Factors& U;

  long double logLength(int h) const { return this->Triangulation.scaledLogLength(h, this->U); }
  double cosine(int h) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    return cosineOpposite(t.scaledLogLength(h, this->U),
      t.scaledLogLength(t.next(h), this->U),
      t.scaledLogLength(t.previous(h), this->U));
  }
  SymmetricTrapezoid cell(int b) const { return this->Triangulation.scaledTrapezoid(b, this->U); }
  SymmetricTrapezoid unscaledCell(int b) const
  {
    const auto& edges = this->Triangulation.boundaryEdges();
    return { edges[b].LogLength, edges[b].LogCrossing, edges[edges[b].Next].LogCrossing };
  }

  bool mustFlip(int h) const
  {
    return this->cosine(h) + this->cosine(this->Triangulation.twin(h)) < -FlipTolerance;
  }
  long double flipped(int h) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const int o = t.twin(h);
    const long double x = t.logLength(t.previous(h)) + t.logLength(t.previous(o)); // ca + db
    const long double y = t.logLength(t.next(h)) + t.logLength(t.next(o));         // bc + ad
    return std::max(x, y) + std::log1p(std::exp(static_cast<double>(-std::abs(x - y)))) - t.logLength(h);
  }
  bool mustOpen(int b) const
  {
    const auto& edge = this->Triangulation.boundaryEdges()[b];
    return !edge.AtInfinity && edge.Inner >= 0 &&
           this->cosine(edge.Inner) + cosineOppositeEdge(this->cell(b)) < -FlipTolerance;
  }
  long double opened(int b) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const int h = t.boundaryEdges()[b].Inner;
    return crossingAtApex(this->unscaledCell(b), t.logLength(t.previous(h)), t.logLength(t.next(h)));
  }
  bool mustClose(int b) const
  {
    const auto& edge = this->Triangulation.boundaryEdges()[b];
    return edge.LogCrossing != IntrinsicTriangulation::OnMirror &&
           cosineOppositeCrossing(this->cell(b)) +
               cosineOppositeCrossing(this->cell(edge.Previous).reversed()) <
             -FlipTolerance;
  }
  long double closed(int b) const
  {
    return edgeAcross(
      this->unscaledCell(this->Triangulation.boundaryEdges()[b].Previous), this->unscaledCell(b));
  }
};

// The metric of the surface and its mirror image, unfolded into the plane with the mirror as x axis.
struct DoubledMetric : ConformalMetric
{
  std::function<long double(int)> OtherDiagonal;

  long double flipped(int h) const { return this->OtherDiagonal(h); }
  long double opened(int b) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const SymmetricTrapezoid cell = this->unscaledCell(b);
    const int h = t.boundaryEdges()[b].Inner;
    const auto inEdges = [&cell](long double logLength)
    { return std::exp(static_cast<double>(logLength - cell.LogEdge)); };
    const double p = inEdges(t.logLength(t.previous(h)));
    const double q = inEdges(t.logLength(t.next(h)));
    const double along = 0.5 * (1.0 + (p - q) * (p + q));
    const double across = std::sqrt(std::max(0.0, (p - along) * (p + along)));
    const double above = inEdges(cell.LogAtOrigin) +
                         along * (inEdges(cell.LogAtTip) - inEdges(cell.LogAtOrigin)) +
                         2.0 * across * trapezoidShape(cell).Extent;
    return cell.LogEdge + std::log(above);
  }
  long double closed(int b) const
  {
    const SymmetricTrapezoid after = this->unscaledCell(b);
    const SymmetricTrapezoid before =
      this->unscaledCell(this->Triangulation.boundaryEdges()[b].Previous);
    const auto inEdges = [&after](long double logLength)
    { return std::exp(static_cast<double>(logLength - after.LogEdge)); };
    const double x =
      trapezoidShape(after).Extent + inEdges(before.LogEdge) * trapezoidShape(before).Extent;
    const double y = 0.5 * (inEdges(after.LogAtTip) - inEdges(before.LogAtOrigin));
    return after.LogEdge + std::log(std::hypot(x, y));
  }
};

} // namespace flattening::intrinsic
