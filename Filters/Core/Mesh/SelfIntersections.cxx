// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SelfIntersections.h"

#include "Base/InterruptibleCall.h"
#include "Mesh/BoxTree.h"
#include "Mesh/EditableSurface.h"

#include <CGAL/intersections.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace flattening
{
namespace
{

using Pairs = std::vector<std::pair<int, int>>;
using PairsOfThreads = tbb::enumerable_thread_specific<Pairs>;

Pairs sorted(const PairsOfThreads& found)
{
  Pairs pairs;
  for (const Pairs& part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Kernel::Point_3 point(const PlacedTriangle& t, int k)
{
  const Eigen::Vector3d& p = t.Points[k % 3];
  return { p.x(), p.y(), p.z() };
}

Kernel::Triangle_3 triangle(const PlacedTriangle& t)
{
  return { point(t, 0), point(t, 1), point(t, 2) };
}

// Tells of two triangles with a common corner whether the edge opposite to it of one meets the other.
bool intersectAtCorner(const PlacedTriangle& a, int cornerOfA, const PlacedTriangle& b, int cornerOfB)
{
  return CGAL::do_intersect(
           triangle(a), Kernel::Segment_3(point(b, cornerOfB + 1), point(b, cornerOfB + 2))) ||
         CGAL::do_intersect(
           triangle(b), Kernel::Segment_3(point(a, cornerOfA + 1), point(a, cornerOfA + 2)));
}

// Tells of two triangles with a common edge whether they are folded onto each other. The corners are the
// ones that they do not share.
bool overlapAcrossEdge(const PlacedTriangle& a, int cornerOfA, const PlacedTriangle& b, int cornerOfB)
{
  const Kernel::Point_3 from = point(a, cornerOfA + 1);
  const Kernel::Point_3 to = point(a, cornerOfA + 2);
  const Kernel::Point_3 apexOfA = point(a, cornerOfA);
  const Kernel::Point_3 apexOfB = point(b, cornerOfB);
  return CGAL::coplanar(from, to, apexOfA, apexOfB) &&
         CGAL::coplanar_orientation(from, to, apexOfA, apexOfB) == CGAL::POSITIVE;
}

PlacedTriangle placedFace(const TriangleMesh& mesh, int f)
{
  PlacedTriangle triangle;
  for (int k = 0; k < 3; ++k)
  {
    triangle.Vertices[k] = mesh.Faces(f, k);
    triangle.Points[k] = mesh.Vertices.row(mesh.Faces(f, k));
  }
  return triangle;
}

std::vector<PlacedTriangle> placedFaces(const TriangleMesh& mesh)
{
  std::vector<PlacedTriangle> triangles(mesh.faceCount());
  tbb::parallel_for(0, mesh.faceCount(), [&](int f) { triangles[f] = placedFace(mesh, f); });
  return triangles;
}

std::vector<Eigen::AlignedBox3d> boxesOf(const std::vector<PlacedTriangle>& triangles)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(triangles.size());
  for (const PlacedTriangle& triangle : triangles)
  {
    boxes.push_back(triangle.box());
  }
  return boxes;
}

// The triangles of a search and the pairs that it finds. A search that was abandoned goes on with its
// own.
struct PairSearch
{
  std::vector<PlacedTriangle> Triangles;
  std::size_t Most = std::numeric_limits<std::size_t>::max(); // so many pairs are kept
  std::atomic<std::size_t> Count{ 0 };
  PairsOfThreads Found;
  std::atomic<bool> IsAborted{ false };

  // Called by several threads, in any order. @throws Cancelled if the search is aborted.
  void compare(int i, int j)
  {
    if (this->IsAborted)
    {
      throw Cancelled();
    }
    if (intersect(this->Triangles[i], this->Triangles[j]) && this->Count++ < this->Most)
    {
      this->Found.local().push_back(std::minmax(i, j));
    }
  }
};

bool hasVertexTwice(const PlacedTriangle& triangle)
{
  const auto& [a, b, c] = triangle.Vertices;
  return a == b || b == c || c == a;
}

// Compares a triangle with those before it of some others, if their boxes meet.
void compareWith(PairSearch& search,
  int triangle,
  const Eigen::AlignedBox3d& box,
  const std::vector<std::pair<Eigen::AlignedBox3d, int>>& others)
{
  if (hasVertexTwice(search.Triangles[triangle]))
  {
    return;
  }
  for (const auto& [other, i] : others)
  {
    if (i < triangle && box.intersects(other) && !hasVertexTwice(search.Triangles[i]))
    {
      search.compare(i, triangle);
    }
  }
}

// Compares all triangles with each other. The tree is asked for a few that are near to each other at
// once: the search takes a quarter less time than if it is asked for each of them.
void compareAll(PairSearch& search)
{
  constexpr std::size_t atOnce = 8; // with 4 or 16 it takes a little longer
  const std::vector<Eigen::AlignedBox3d> boxes = boxesOf(search.Triangles);
  const BoxTree tree(boxes);
  const std::vector<int> order = tree.nearToEachOther();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, order.size(), atOnce),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      std::vector<std::pair<Eigen::AlignedBox3d, int>> near;
      for (std::size_t begin = range.begin(); begin < range.end(); begin += atOnce)
      {
        const std::size_t end = std::min(begin + atOnce, range.end());
        Eigen::AlignedBox3d box;
        for (std::size_t n = begin; n < end; ++n)
        {
          box.extend(boxes[order[n]]);
        }
        near.clear();
        tree.query(box, [&](int i) { near.emplace_back(boxes[i], i); });
        for (std::size_t n = begin; n < end; ++n)
        {
          compareWith(search, order[n], boxes[order[n]], near);
        }
      }
    });
}

// Compares some triangles (ascending) with all.
void compareWithAll(PairSearch& search, const std::vector<int>& some)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(some.size());
  std::vector<char> isChosen(search.Triangles.size(), 0);
  for (const int i : some)
  {
    boxes.push_back(search.Triangles[i].box());
    isChosen[i] = 1;
  }
  const BoxTree tree(boxes);
  tbb::parallel_for(0,
    static_cast<int>(search.Triangles.size()),
    [&](int j)
    {
      if (hasVertexTwice(search.Triangles[j]))
      {
        return;
      }
      tree.query(search.Triangles[j].box(),
        [&](int n)
        {
          const int i = some[n];
          if ((i < j || !isChosen[j]) && !hasVertexTwice(search.Triangles[i]))
          {
            search.compare(i, j);
          }
        });
    });
}

// The search by a function that compares triangles, when it is over. An abort returns at once, and all
// threads of the search see it.
std::shared_ptr<PairSearch> searched(std::vector<PlacedTriangle> triangles,
  std::function<void(PairSearch&)> compare,
  std::size_t most,
  const ProgressCallback& progress)
{
  const auto search = std::make_shared<PairSearch>();
  search->Triangles = std::move(triangles);
  search->Most = most;
  try
  {
    callInterruptibly([search, compare = std::move(compare)] { compare(*search); },
      progress,
      0.0,
      "looking for self-intersections");
  }
  catch (const Cancelled&)
  {
    search->IsAborted = true;
    throw;
  }
  return search;
}

} // namespace

bool intersect(const PlacedTriangle& a, const PlacedTriangle& b)
{
  int shared = 0;
  int sumOfA = 0; // of the positions of the shared corners, which determines them
  int sumOfB = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (a.Vertices[i] == b.Vertices[j])
      {
        ++shared;
        sumOfA += i;
        sumOfB += j;
      }
    }
  }
  switch (shared)
  {
    case 0:
      return CGAL::do_intersect(triangle(a), triangle(b));
    case 1:
      return intersectAtCorner(a, sumOfA, b, sumOfB);
    case 2:
      return overlapAcrossEdge(a, 3 - sumOfA, b, 3 - sumOfB);
    default:
      return true;
  }
}

std::optional<Pairs> fewOverlappingBoxes(const std::vector<Eigen::AlignedBox3d>& some,
  int count,
  const std::function<Eigen::AlignedBox3d(int)>& boxOf,
  std::size_t most)
{
  const BoxTree tree(some);
  PairsOfThreads found;
  std::atomic<std::size_t> pairCount(0);
  tbb::parallel_for(tbb::blocked_range<int>(0, count),
    [&](const tbb::blocked_range<int>& range)
    {
      Pairs& pairs = found.local();
      for (int j = range.begin(); j < range.end() && pairCount <= most; ++j)
      {
        pairCount += tree.query(boxOf(j), [&](int i) { pairs.emplace_back(i, j); });
      }
    });
  return pairCount <= most ? std::optional<Pairs>(sorted(found)) : std::nullopt;
}

std::size_t countOverlappingBoxes(const std::vector<PlacedTriangle>& some,
  const std::vector<PlacedTriangle>& all,
  const std::function<bool(int, int)>& counts)
{
  const BoxTree tree(boxesOf(some));
  std::atomic<std::size_t> count(0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, all.size()),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      std::size_t inRange = 0;
      for (std::size_t j = range.begin(); j < range.end(); ++j)
      {
        tree.query(all[j].box(), [&](int i) { inRange += counts(i, static_cast<int>(j)) ? 1 : 0; });
      }
      count += inRange;
    });
  return count;
}

Pairs intersectingPairs(const std::vector<PlacedTriangle>& triangles, const ProgressCallback& progress)
{
  const std::size_t most = std::numeric_limits<std::size_t>::max();
  return sorted(searched(triangles, compareAll, most, progress)->Found);
}

std::size_t countSelfIntersections(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  return fewSelfIntersections(mesh, 0, progress).Count;
}

FewPairs fewSelfIntersections(const TriangleMesh& mesh,
  std::size_t most,
  const ProgressCallback& progress)
{
  const auto search = searched(placedFaces(mesh), compareAll, most, progress);
  return { search->Count, sorted(search->Found) };
}

FewPairs fewIntersectionsOf(const TriangleMesh& mesh,
  const std::vector<int>& some,
  std::size_t most,
  const ProgressCallback& progress)
{
  const auto search = searched(
    placedFaces(mesh), [some](PairSearch& pairs) { compareWithAll(pairs, some); }, most, progress);
  return { search->Count, sorted(search->Found) };
}

std::vector<int> intersectionsPerGroup(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& groups)
{
  std::vector<Eigen::AlignedBox3d> some;
  std::vector<std::pair<int, int>> groupAndFace;
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    for (const int face : groups[group])
    {
      some.push_back(placedFace(mesh, face).box());
      groupAndFace.emplace_back(static_cast<int>(group), face);
    }
  }
  const auto pairs = fewOverlappingBoxes(
    some,
    mesh.faceCount(),
    [&mesh](int f) { return placedFace(mesh, f).box(); },
    std::numeric_limits<std::size_t>::max());
  std::vector<int> count(groups.size(), 0);
  for (const auto& [i, other] : *pairs)
  {
    const auto [group, face] = groupAndFace[i];
    count[group] += face != other && intersect(placedFace(mesh, face), placedFace(mesh, other));
  }
  return count;
}

} // namespace flattening
