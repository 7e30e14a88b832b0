// SPDX-License-Identifier: GPL-3.0-or-later
/// Diameter, extent across and perimeter of a region on a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// A point on an edge between two vertices: From + Fraction (To - From). At a vertex, From and To are
/// equal.
struct EdgePoint
{
  int From = 0;
  int To = 0;
  double Fraction = 0.0;
};

struct SurfaceCurve
{
  std::vector<EdgePoint> Points; ///< consecutive points lie on one face
  double Length = 0.0;           ///< input units
};

/// The lengths of a region that is a disk, in input units.
struct RegionExtent
{
  SurfaceCurve Diameter;  ///< geodesic between two points of the region at the greatest distance
  SurfaceCurve Across;    ///< longest geodesic from one side of the diameter to the other, across it
  SurfaceCurve Outline;   ///< closed boundary along edges; jagged, so that it is too long
  double Perimeter = 0.0; ///< length of the boundary without waves of up to four edges
  double PerimeterError = 0.0; ///< change of Perimeter if the boundary is smoothed four times as often
  double EdgeLength = 0.0;     ///< mean length of the boundary edges, the accuracy of the boundary
};

/// Measures a region. From several points of the boundary the search for the diameter goes repeatedly to
/// the farthest point (heat method) and then moves the ends along the boundary; the length is that of
/// the exact geodesic between the ends within the region, a lower bound of the greatest distance of all
/// pairs. The geodesic across joins two boundary points on either side of the diameter whose distances
/// to the two ends of the diameter have the same difference.
/// @throws TopologyError, InvalidInput as requireDisk does; ConvergenceError if a distance cannot be
/// computed.
RegionExtent regionExtent(const TriangleMesh& region, const ProgressCallback& progress = {});

/// Length of a curve between the points where it meets the smoothed boundary @p loop, as the length of
/// RegionExtent::Diameter is measured.
double trimmedLength(const Points3& vertices, const SurfaceCurve& curve, const std::vector<int>& loop);

/// Length of the smoothed closed curve along @p loop, as RegionExtent::Perimeter is measured.
double smoothedPerimeter(const Points3& vertices, const std::vector<int>& loop);

} // namespace flattening
