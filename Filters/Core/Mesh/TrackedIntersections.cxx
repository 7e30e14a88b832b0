// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TrackedIntersections.h"

#include <boost/functional/hash.hpp>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>

namespace flattening
{
namespace
{

// With a larger share of new faces, a search among all is faster than a query for each new one.
constexpr double LargestShareOfNew = 0.25;

// A face as its points tell it from others, whichever of its corners is the first one.
struct FaceKey
{
  std::size_t Hash;
  int Face;
  int First; // the corner whose point is the smallest

  bool operator<(const FaceKey& other) const
  {
    return std::make_pair(this->Hash, this->Face) < std::make_pair(other.Hash, other.Face);
  }
};

std::array<double, 3> pointOf(const TriangleMesh& mesh, int face, int corner)
{
  const auto p = mesh.Vertices.row(mesh.Faces(face, corner % 3));
  return { p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 }; // the zeros of both signs are the same
}

std::vector<FaceKey> sortedKeys(const TriangleMesh& mesh)
{
  std::vector<FaceKey> keys(mesh.faceCount());
  tbb::parallel_for(0,
    mesh.faceCount(),
    [&](int f)
    {
      int first = 0;
      for (int k = 1; k < 3; ++k)
      {
        first = pointOf(mesh, f, k) < pointOf(mesh, f, first) ? k : first;
      }
      std::size_t hash = 0;
      for (int k = 0; k < 3; ++k)
      {
        const std::array<double, 3> point = pointOf(mesh, f, first + k);
        boost::hash_range(hash, point.begin(), point.end());
      }
      keys[f] = { hash, f, first };
    });
  tbb::parallel_sort(keys.begin(), keys.end());
  return keys;
}

// A face that was there before, and the corners of both that lie on the same point.
struct OldFace
{
  int Face = -1;
  int FirstOld = 0;
  int FirstNew = 0;
};

bool samePoints(const TriangleMesh& old, const TriangleMesh& now, const OldFace& before, int face)
{
  for (int k = 0; k < 3; ++k)
  {
    if (pointOf(old, before.Face, before.FirstOld + k) != pointOf(now, face, before.FirstNew + k))
    {
      return false;
    }
  }
  return true;
}

// For each face of the new mesh one of the old mesh on the same points, and none twice.
std::vector<OldFace> facesOnSamePoints(const TriangleMesh& old, const TriangleMesh& now)
{
  const std::vector<FaceKey> oldKeys = sortedKeys(old);
  const std::vector<FaceKey> newKeys = sortedKeys(now);
  std::vector<OldFace> same(now.faceCount());
  auto candidate = oldKeys.begin();
  for (const FaceKey& key : newKeys)
  {
    while (candidate != oldKeys.end() && candidate->Hash < key.Hash)
    {
      ++candidate;
    }
    if (candidate != oldKeys.end() && candidate->Hash == key.Hash)
    {
      same[key.Face] = { candidate->Face, candidate->First, key.First };
      ++candidate;
    }
  }
  // In the order of the faces, in which neighbours are near to each other in memory.
  tbb::parallel_for(0,
    now.faceCount(),
    [&](int f)
    {
      if (same[f].Face >= 0 && !samePoints(old, now, same[f], f))
      {
        same[f] = {};
      }
    });
  return same;
}

// Which vertex of the new mesh is which of the old one.
class VertexPairs
{
public:
  VertexPairs(const TriangleMesh& old, const TriangleMesh& now)
    : OldOf(now.vertexCount(), -1)
    , NewOf(old.vertexCount(), -1)
  {
  }

  // Whether the two may be the same vertex. Notes that they are.
  bool join(int oldVertex, int newVertex)
  {
    int& old = this->OldOf[newVertex];
    int& now = this->NewOf[oldVertex];
    if (old < 0 && now < 0)
    {
      old = oldVertex;
      now = newVertex;
    }
    return old == oldVertex && now == newVertex;
  }

private:
  std::vector<int> OldOf;
  std::vector<int> NewOf;
};

// For each face of the new mesh the one of the old mesh that it was, or -1 if it is new. Two faces that
// are not new share the same corners as before.
std::vector<int> facesBefore(const TriangleMesh& old, const TriangleMesh& now)
{
  const std::vector<OldFace> same = facesOnSamePoints(old, now);
  VertexPairs vertices(old, now);
  std::vector<int> before(now.faceCount(), -1);
  for (int f = 0; f < now.faceCount(); ++f)
  {
    bool isSame = same[f].Face >= 0;
    for (int k = 0; isSame && k < 3; ++k)
    {
      isSame = vertices.join(
        old.Faces(same[f].Face, (same[f].FirstOld + k) % 3), now.Faces(f, (same[f].FirstNew + k) % 3));
    }
    before[f] = isSame ? same[f].Face : -1;
  }
  return before;
}

// The pairs of faces that both were there before.
TrackedIntersections::Pairs pairsThatStay(const TrackedIntersections::Pairs& old,
  const std::vector<int>& before,
  int oldFaces)
{
  std::vector<int> faceNow(oldFaces, -1);
  for (std::size_t f = 0; f < before.size(); ++f)
  {
    if (before[f] >= 0)
    {
      faceNow[before[f]] = static_cast<int>(f);
    }
  }
  TrackedIntersections::Pairs stay;
  for (const auto& [i, j] : old)
  {
    if (faceNow[i] >= 0 && faceNow[j] >= 0)
    {
      stay.push_back(std::minmax(faceNow[i], faceNow[j]));
    }
  }
  return stay;
}

} // namespace

void TrackedIntersections::update(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  const std::optional<Pairs> old = std::move(this->Known);
  this->Known.reset();
  const auto most = static_cast<std::size_t>(mesh.faceCount());
  std::vector<int> before;
  std::vector<int> added;
  if (old && this->Mesh.faceCount() > 0)
  {
    before = facesBefore(this->Mesh, mesh);
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      if (before[f] < 0)
      {
        added.push_back(f);
      }
    }
  }
  FewPairs found;
  if (before.empty() || static_cast<double>(added.size()) > LargestShareOfNew * mesh.faceCount())
  {
    found = fewSelfIntersections(mesh, most, progress);
  }
  else
  {
    found = fewIntersectionsOf(mesh, added, most, progress);
    const Pairs stay = pairsThatStay(*old, before, this->Mesh.faceCount());
    found.Count += stay.size();
    if (found.Count <= most)
    {
      found.Pairs.insert(found.Pairs.end(), stay.begin(), stay.end());
      std::sort(found.Pairs.begin(), found.Pairs.end());
    }
  }
  this->Mesh = mesh;
  this->Count = found.Count;
  if (found.Count <= most)
  {
    this->Known = std::move(found.Pairs);
  }
}

} // namespace flattening
