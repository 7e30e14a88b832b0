// SPDX-License-Identifier: GPL-3.0-or-later
/// The cells between a surface and its mirror image, which is glued to it along the boundary.
#pragma once

namespace flattening
{

/// The surface and its mirror image make a closed surface, which is symmetric about the mirror line, the
/// boundary. The faces of its Delaunay triangulation that the mirror line crosses are isosceles
/// triangles and trapezoids, inscribed in circles whose centres lie on that line. One edge of the
/// surface, from its origin to its tip, and its image are the legs of such a trapezoid; the crossing
/// edges from each end to its image are the bases. Half of it, the part on this side of the mirror, is a
/// mirror cell. The crossing length of a vertex on the mirror is 0, and an edge on the mirror has a cell
/// without area.
struct SymmetricTrapezoid
{
  long double LogEdge; ///< logarithm of the edge's length
  long double
    LogAtOrigin;        ///< logarithm of the crossing length at the origin; minus infinity on the mirror
  long double LogAtTip; ///< logarithm of the crossing length at the tip; minus infinity on the mirror

  SymmetricTrapezoid reversed() const { return { this->LogEdge, this->LogAtTip, this->LogAtOrigin }; }
};

/// Angles and width of a mirror cell.
struct TrapezoidShape
{
  double AngleAtOrigin; ///< radians, within the cell
  double AngleAtTip;    ///< radians, within the cell
  double Cotangent;     ///< cotangent of the angle of the edge, seen from the circle; 0 if degenerate
  double Extent;        ///< length along the mirror, in units of the edge
  bool Degenerate;      ///< no such trapezoid exists: the crossing lengths differ by more than two edges
};
TrapezoidShape trapezoidShape(const SymmetricTrapezoid& cell);

/// Cosine of the angle under which the edge is seen from the other points of the cell's circle.
double cosineOppositeEdge(const SymmetricTrapezoid& cell);

/// Cosine of the angle under which the crossing edge at the origin is seen from the tip; below -1 where
/// the cell is degenerate.
double cosineOppositeCrossing(const SymmetricTrapezoid& cell);

/// Logarithm of the crossing length of the apex f of a triangle whose side is the edge of @p cell, from
/// Ptolemy's relations between the six points f, origin, tip and their images; @p logOriginApex and
/// @p logTipApex are those of the other two sides.
long double crossingAtApex(const SymmetricTrapezoid& cell,
  long double logOriginApex,
  long double logTipApex);

/// The inverse of crossingAtApex(): the logarithm of the distance between the origin of @p before and
/// the tip of
/// @p after, two cells next to each other, when the vertex between them leaves the mirror.
long double edgeAcross(const SymmetricTrapezoid& before, const SymmetricTrapezoid& after);

} // namespace flattening
