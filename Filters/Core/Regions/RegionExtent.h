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
  SurfaceCurve Diameter; ///< geodesic between two points of the region at the greatest distance
  /// The longest geodesic that crosses the diameter, from the boundary on one side of it to the boundary
  /// on the other.
  SurfaceCurve Across;
  SurfaceCurve Outline;   ///< closed boundary along edges; jagged, so that it is too long
  double Perimeter = 0.0; ///< length of the boundary, smoothed so that waves of up to four edges vanish
  /// How much Perimeter would change with four times as many smoothing steps.
  double PerimeterError = 0.0;
  double EdgeLength = 0.0; ///< mean length of the boundary edges, the accuracy of the boundary
};

/// Measures a region. The search for the diameter starts at several points of the boundary. From each it
/// goes to the farthest point (heat method), from there again to the farthest point, and so on while the
/// distance grows. The ends of the longest geodesic are then moved along the boundary as long as that
/// makes the geodesic longer. The length of the diameter is the length of the exact geodesic within the
/// region between its two ends, up to where it meets the smoothed boundary. Since the search may miss
/// the most distant pair of points, their distance may be greater than this length.
///
/// For the extent across, the difference "distance to the first end of the diameter minus distance to
/// the second" tells how far along the diameter a point lies. Geodesics across join two boundary points,
/// one on each side of the diameter, with nearly equal differences; the longest of those that are tried
/// is returned.
/// @throws TopologyError, InvalidInput as requireDisk does; ConvergenceError if a distance cannot be
/// computed.
RegionExtent regionExtent(const TriangleMesh& region, const ProgressCallback& progress = {});

/// Length of @p curve without the parts at its two ends that project beyond the smoothed boundary @p
/// loop; 0 if these are longer, as on a region of a few triangles. RegionExtent::Diameter and Across
/// have their lengths measured in the same way.
double trimmedLength(const Points3& vertices, const SurfaceCurve& curve, const std::vector<int>& loop);

/// Length of the smoothed closed curve along @p loop, as RegionExtent::Perimeter is measured.
double smoothedPerimeter(const Points3& vertices, const std::vector<int>& loop);

} // namespace flattening
