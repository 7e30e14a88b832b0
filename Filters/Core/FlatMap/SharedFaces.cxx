// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/SharedFaces.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace flattening
{
namespace
{

using Corners = std::array<int, 3>; // places, which vertices with the same coordinates share

// The number of each vertex' place, for the vertices of both surfaces, the first one's first.
std::vector<int> places(const Points3& first, const Points3& second)
{
  const auto count = static_cast<int>(first.rows());
  const auto point = [&](int v) { return v < count ? first.row(v) : second.row(v - count); };
  std::vector<int> order(first.rows() + second.rows());
  std::iota(order.begin(), order.end(), 0);
  const auto isBefore = [&point](int a, int b)
  {
    const auto p = point(a);
    const auto q = point(b);
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::sort(order.begin(), order.end(), isBefore);
  std::vector<int> place(order.size(), 0);
  for (std::size_t k = 1; k < order.size(); ++k)
  {
    place[order[k]] = place[order[k - 1]] + isBefore(order[k - 1], order[k]);
  }
  return place;
}

// The corner from which on the places of a face are compared.
int firstCorner(const Corners& places)
{
  return static_cast<int>(std::min_element(places.begin(), places.end()) - places.begin());
}

/// A face by the places of its corners, from the first corner on in its direction.
struct PlacedCorners
{
  Corners Places;
  SharedFace Face; // with the corners in the order of the places
};

bool operator<(const PlacedCorners& a, const PlacedCorners& b)
{
  return std::tie(a.Places, a.Face.Face) < std::tie(b.Places, b.Face.Face);
}

// The faces of a mesh in order. @param place of each of its vertices
std::vector<PlacedCorners> sortedFaces(const FaceMatrix& faces, const int* place)
{
  std::vector<PlacedCorners> sorted(faces.rows());
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f)
  {
    const Corners corners{ place[faces(f, 0)], place[faces(f, 1)], place[faces(f, 2)] };
    const int first = firstCorner(corners);
    const Corners turned{ first, (first + 1) % 3, (first + 2) % 3 };
    sorted[f] = { { corners[turned[0]], corners[turned[1]], corners[turned[2]] }, { f, turned } };
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

} // namespace

std::vector<SharedFace> sharedFaces(const TriangleMesh& surface, const TriangleMesh& target)
{
  const std::vector<int> place = places(surface.Vertices, target.Vertices);
  const std::vector<PlacedCorners> known = sortedFaces(surface.Faces, place.data());
  const int* targetPlace = place.data() + surface.vertexCount();

  std::vector<SharedFace> same(target.faceCount());
  std::vector<SharedFace> opposite(target.faceCount());
  int balance = 0; // faces of the same orientation less those of the opposite one
  for (int f = 0; f < target.faceCount(); ++f)
  {
    const Corners corners{
      targetPlace[target.Faces(f, 0)], targetPlace[target.Faces(f, 1)], targetPlace[target.Faces(f, 2)]
    };
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
    {
      continue;
    }
    const int first = firstCorner(corners);
    for (const int step : { 1, 2 })
    {
      const Corners turned{ first, (first + step) % 3, (first + 2 * step) % 3 };
      const Corners sought{ corners[turned[0]], corners[turned[1]], corners[turned[2]] };
      const auto found = std::lower_bound(known.begin(), known.end(), PlacedCorners{ sought, {} });
      if (found != known.end() && found->Places == sought)
      {
        SharedFace& shared = step == 1 ? same[f] : opposite[f];
        shared.Face = found->Face.Face;
        for (int k = 0; k < 3; ++k)
        {
          shared.Corners[turned[k]] = found->Face.Corners[k];
        }
        balance += step == 1 ? 1 : -1;
      }
    }
  }
  std::vector<SharedFace> result = balance >= 0 ? same : opposite;
  const std::vector<SharedFace>& others = balance >= 0 ? opposite : same;
  std::vector<char> isTaken(surface.faceCount(), 0);
  for (const SharedFace& shared : result)
  {
    if (shared.Face >= 0)
    {
      isTaken[shared.Face] = 1;
    }
  }
  for (int f = 0; f < target.faceCount(); ++f)
  {
    if (result[f].Face < 0 && others[f].Face >= 0 && !isTaken[others[f].Face])
    {
      result[f] = others[f];
    }
  }
  return result;
}

SurfacePoint cornerOf(const TriangleMesh& surface, const SharedFace& shared, int k)
{
  const int corner = shared.Corners[k];
  SurfacePoint at{ shared.Face, surface.Vertices.row(surface.Faces(shared.Face, corner)), {} };
  at.Weights[corner] = 1.0;
  return at;
}

} // namespace flattening
