// SPDX-License-Identifier: GPL-3.0-or-later
/// What counts as a sliver: a triangle with a very short edge (a needle) or with a corner that lies
/// almost on the opposite edge (a cap). Every stage needs another bound, from what rounding leaves
/// undefined to what looks well shaped; all of them stand here, the strictest first.
#pragma once

namespace flattening::slivers
{

/// Repair collapses needles: shortest over longest edge of a face. A convention between rounding, 1e-16
/// of a coordinate, and the smallest edge that may mean something: with a smaller bound the angles that
/// the later stages compute are noise, with a larger one small features are lost.
constexpr double NeedleEdge = 1e-9;

/// Repair dissolves caps: altitude over longest edge of a face. A vertex so close to an open edge lies
/// on it (a T-junction). A convention between rounding and the smallest altitude that may mean
/// something, as for NeedleEdge.
constexpr double CapAltitude = 1e-10;

/// Intrinsic triangulations lengthen all edges until the triangle inequality holds with this excess, as
/// a share of the mean edge length, and no edge is shorter than the next bound. The angles of thinner
/// triangles would lose more digits of the logarithmic lengths than the tolerance of the Ricci flow
/// allows.
constexpr double IntrinsicExcess = 1e-10;
constexpr double IntrinsicEdge = 1e-7;

/// The face refinement computes the cotangents of a face as if its altitude over its longest edge were
/// at least this: a guard against dividing by 0.
constexpr double AngleAltitude = 1e-4;

/// The face refinement lowers the weight of the angles of a face whose altitude over its longest edge is
/// smaller than this: they are noise, and keeping them would cost area. A choice.
constexpr double ShapeAltitude = 0.1;

/// Untangling opens its target triangles to this altitude over their longest edge: a target of no
/// altitude would have an infinite energy, and a flat map cannot tell thinner shapes from a line. A
/// choice.
constexpr double TargetAltitude = 0.02;

/// Surface To Disk opens angles smaller than this, in degrees: on a surface that is not remeshed
/// everywhere (the default of the option), on a remeshed one along the cut, which alone has any. Below,
/// maps are less exact; a larger bound changes more of the surface.
constexpr double DiskAngle = 1.0;

/// Below this angle, in degrees, opening a face counts for more than the shape of the surface around it:
/// a change may turn faces away from the old surface.
constexpr double TinyAngle = 5.0;

/// Smoothing may leave intersecting faces with angles of no less than 5 degrees or, in a second attempt,
/// 1 degree (as sines). Larger bounds leave more pairs of faces intersecting, smaller ones make slivers.
constexpr double SmoothedSines[] = { 0.0872, 0.0175 };

/// Flips and moves that take intersecting faces apart leave no angle below 10 degrees (as a sine).
constexpr double SeparatedSine = 0.17;

/// Remeshing opens the angles that it has left below this, in degrees.
constexpr double RemeshedAngle = 15.0;

/// No operation of the remeshing makes an angle below 15 degrees (as a sine): RemeshedAngle, rounded up.
constexpr double RemeshedSine = 0.26;

/// A collapse along a cut may leave angles of 20 degrees (in radians), even if they were larger before.
constexpr double CutAngle = 0.35;

} // namespace flattening::slivers
