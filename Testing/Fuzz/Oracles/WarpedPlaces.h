// SPDX-License-Identifier: GPL-3.0-or-later
/// The way of points of the plane to their places on the map of a planar mesh, and back.
#pragma once

#include "FlatPlaces.h"

#include <array>
#include <vector>

namespace fuzz
{

/// The filter takes distances from the mesh for rounding up to a share of the mesh's size between these
/// two: a point that is nearer than the first is on the mesh, one that is farther than the second is
/// not.
constexpr long double SurelyOn = 1e-9L;
constexpr long double SurelyOff = 2e-6L;
/// The rounding of a place in a face, as a share of the greatest coordinate.
constexpr long double PlaceRounding = 1e-14L;

/// A position in the plane.
using Position = std::array<long double, 2>;

/// The mesh before or after it was flattened.
struct PlanarMesh
{
  Triangles Mesh;         ///< with z set to 0
  long double Coordinate; ///< the greatest absolute value of x or y
  long double Size;       ///< the diagonal of the bounding rectangle
  Interval Heights;       ///< the range that z had, which is small
};

PlanarMesh planarMeshOf(Triangles mesh);

/// The meshes and the roundings by which a warp is judged.
struct Warp
{
  PlanarMesh Before;
  PlanarMesh After;
  bool RemovesOutside; ///< whether points that are not on the mesh are removed
};

/// The place to which a face takes a point.
struct WarpedPlace
{
  Position Place;
  long double Rounding; ///< by how much the place may be off
  Triangle Face;
};

struct WarpedPlaces
{
  long double Distance;            ///< of the point from the mesh
  std::vector<WarpedPlace> Places; ///< one for each face that may be the nearest
};

/// @param point z does not matter
WarpedPlaces warpedPlaces(const PlanarMesh& from, const PlanarMesh& to, const Point& point);

/// Whether a point is where one of the faces takes it, and in that face of the mesh @p to.
bool fits(const WarpedPlaces& warped, const PlanarMesh& to, const Point& point);

} // namespace fuzz
