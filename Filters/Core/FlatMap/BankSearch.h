// SPDX-License-Identifier: GPL-3.0-or-later
/// Finds the bank of a seam on which a face lies.
#pragma once

#include "FlatMap/MapPlaces.h"
#include "FlatMap/SeamBanks.h"
#include "Mesh/VertexFaces.h"

#include <array>
#include <optional>

namespace flattening
{

enum class PlacedAs : char
{
  Lost,       ///< a vertex is lost, or the centroid has no place
  AcrossSeam, ///< a corner lies beyond the seam
  Placed
};

/// A face of the target with its places on the map.
struct PlacedFace
{
  PlacedAs Result = PlacedAs::Lost;
  /// The places of those corners that do not have the place of their vertex.
  std::array<std::optional<SurfacePoint>, 3> OtherBank;
};

/// Finds the bank of each face, for placeFaces(). Refers to all of its arguments.
class BankSearch
{
public:
  BankSearch(const FlattenedSurface& flattened,
    const TriangleMesh& target,
    const PlaceSearch& search,
    const TransferredMap& map)
    : Surface(flattened.Surface)
    , Target(target)
    , Search(search)
    , Map(map)
    , OnMap(flattened)
    , Around(flattened.Surface.Faces, flattened.Surface.vertexCount())
  {
  }

  PlacedFace place(int face) const;

private:
  std::optional<SurfacePoint> placeOfCentroid(int face, const Eigen::Vector3d& centroid) const;
  bool isConnected(int from, int to, const Eigen::Vector3d& centre, double radius) const;

  const TriangleMesh& Surface;
  const TriangleMesh& Target;
  const PlaceSearch& Search;
  const TransferredMap& Map;
  MapPlaces OnMap;
  VertexFaces Around;
};

} // namespace flattening
