// SPDX-License-Identifier: GPL-3.0-or-later
/// The lengths by which a region on a surface is described.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// A point on an edge: From + Fraction (To - From); at a vertex From and To are the same.
struct EdgePoint
{
  int From = 0;
  int To = 0;
  double Fraction = 0.0;
};

struct SurfaceCurve
{
  std::vector<EdgePoint> Points; ///< consecutive ones lie on one face
  double Length = 0.0;           ///< input units
};

/// Of a region that is a disk; all lengths in input units.
struct RegionExtent
{
  SurfaceCurve Diameter;       ///< the greatest geodesic distance of two of its points
  SurfaceCurve Across;         ///< the greatest between the two sides of the diameter, square to it
  SurfaceCurve Outline;        ///< the boundary along edges, closed; jagged, so that it is too long
  double Perimeter = 0.0;      ///< length of the boundary without waves of up to four edges
  double PerimeterError = 0.0; ///< what it changes by if smoothed four times as often
  double EdgeLength = 0.0;     ///< mean length of the boundary's edges: within it the boundary is known
};

/// The diameter's ends are found by going to the farthest point again and again from several points of
/// the boundary (heat method) and then moving along the boundary; its length is that of the exact
/// geodesic between them within the region. It is a lower bound of the greatest distance of all pairs.
/// Across goes from one side of the boundary to the other between points whose distances to the two ends
/// differ by the same.
/// @throws TopologyError, InvalidInput as requireDisk; ConvergenceError if a distance cannot be
/// computed.
RegionExtent regionExtent(const TriangleMesh& region, const ProgressCallback& progress = {});

/// Length of a curve between the ends of the smoothed boundary @p loop, as that of
/// RegionExtent::Diameter.
double trimmedLength(const Points3& vertices, const SurfaceCurve& curve, const std::vector<int>& loop);

/// Length of the closed curve along @p loop, smoothed as RegionExtent::Perimeter.
double smoothedPerimeter(const Points3& vertices, const std::vector<int>& loop);

} // namespace flattening
