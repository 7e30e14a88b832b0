// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SelfIntersections.h"

#include "Mesh/EditableSurface.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace flattening
{
namespace
{

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
using BoxPointers = std::vector<const Box*>; // sorted instead of the boxes themselves: half the time
using Pairs = std::vector<std::pair<int, int>>;

// Below as many boxes, scanning them all is faster than dividing them.
constexpr std::ptrdiff_t Cutoff = 1000;

std::vector<Box> boxesOf(const std::vector<PlacedTriangle>& triangles)
{
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto& [a, b, c] = triangles[i].Points;
    Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c);
    Eigen::Vector3d high = a.cwiseMax(b).cwiseMax(c);
    boxes.emplace_back(low.data(), high.data(), static_cast<int>(i));
  }
  return boxes;
}

BoxPointers pointersTo(const std::vector<Box>& boxes)
{
  BoxPointers pointers;
  pointers.reserve(boxes.size());
  for (const Box& box : boxes)
  {
    pointers.push_back(&box);
  }
  return pointers;
}

// Slices of space across its longest axis, to be searched side by side.
class Slabs
{
public:
  explicit Slabs(const std::vector<Box>& boxes)
    : Boxes(boxes)
  {
    CGAL::Bbox_3 all;
    for (const Box& box : boxes)
    {
      all += box.bbox();
    }
    for (int axis = 1; axis < 3 && !boxes.empty(); ++axis)
    {
      if (all.max(axis) - all.min(axis) > all.max(this->Axis) - all.min(this->Axis))
      {
        this->Axis = axis;
      }
    }
    this->Low = boxes.empty() ? 0.0 : all.min(this->Axis);
    this->Width = boxes.empty() ? 0.0 : (all.max(this->Axis) - this->Low) / Count;
  }

  int count() const { return static_cast<int>(this->Boxes.size()) < Cutoff ? 1 : Count; }

  /// Those that reach into the slab.
  BoxPointers boxes(int slab) const
  {
    BoxPointers result;
    for (const Box& box : this->Boxes)
    {
      if (this->at(box.min_coord(this->Axis)) <= slab && slab <= this->at(box.max_coord(this->Axis)))
      {
        result.push_back(&box);
      }
    }
    return result;
  }

  /// Of all slabs that a pair of overlapping boxes is found in, it belongs to the first.
  bool isPairOf(int slab, const Box& a, const Box& b) const
  {
    return this->at(std::max(a.min_coord(this->Axis), b.min_coord(this->Axis))) == slab;
  }

private:
  static constexpr int Count = 16;

  int at(double coordinate) const
  {
    return this->count() == 1 || !(this->Width > 0.0)
             ? 0
             : std::min(Count - 1, static_cast<int>((coordinate - this->Low) / this->Width));
  }

  const std::vector<Box>& Boxes;
  int Axis = 0;
  double Low;
  double Width;
};

Kernel::Point_3 point(const PlacedTriangle& t, int k)
{
  const Eigen::Vector3d& p = t.Points[k % 3];
  return { p.x(), p.y(), p.z() };
}

Kernel::Triangle_3 triangle(const PlacedTriangle& t)
{
  return { point(t, 0), point(t, 1), point(t, 2) };
}

// Of triangles with a common corner: whether the edge of one opposite to it meets the other.
bool intersectAtCorner(const PlacedTriangle& a, int cornerOfA, const PlacedTriangle& b, int cornerOfB)
{
  return CGAL::do_intersect(
           triangle(a), Kernel::Segment_3(point(b, cornerOfB + 1), point(b, cornerOfB + 2))) ||
         CGAL::do_intersect(
           triangle(b), Kernel::Segment_3(point(a, cornerOfA + 1), point(a, cornerOfA + 2)));
}

// Of triangles with a common edge: whether they are folded onto each other. The corners are the ones
// that they do not share.
bool overlapAcrossEdge(const PlacedTriangle& a, int cornerOfA, const PlacedTriangle& b, int cornerOfB)
{
  const Kernel::Point_3 from = point(a, cornerOfA + 1);
  const Kernel::Point_3 to = point(a, cornerOfA + 2);
  const Kernel::Point_3 apexOfA = point(a, cornerOfA);
  const Kernel::Point_3 apexOfB = point(b, cornerOfB);
  return CGAL::coplanar(from, to, apexOfA, apexOfB) &&
         CGAL::coplanar_orientation(from, to, apexOfA, apexOfB) == CGAL::POSITIVE;
}

} // namespace

bool intersect(const PlacedTriangle& a, const PlacedTriangle& b)
{
  int shared = 0;
  int sumOfA = 0; // of the positions of shared corners: tells one from the other two
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

Pairs overlappingBoxes(const std::vector<PlacedTriangle>& some, const std::vector<PlacedTriangle>& all)
{
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Value = std::pair<boost::geometry::model::box<Corner>, int>;
  const auto boxOf = [](const PlacedTriangle& triangle)
  {
    const auto& [a, b, c] = triangle.Points;
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector3d high = a.cwiseMax(b).cwiseMax(c);
    return boost::geometry::model::box<Corner>(
      { low.x(), low.y(), low.z() }, { high.x(), high.y(), high.z() });
  };
  std::vector<Value> values;
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    values.emplace_back(boxOf(some[i]), static_cast<int>(i));
  }
  const boost::geometry::index::rtree<Value, boost::geometry::index::linear<16>> tree(values);
  tbb::enumerable_thread_specific<Pairs> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, all.size()),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      Pairs& pairs = found.local();
      for (std::size_t j = range.begin(); j < range.end(); ++j)
      {
        tree.query(boost::geometry::index::intersects(boxOf(all[j])),
          boost::make_function_output_iterator(
            [&](const Value& value) { pairs.emplace_back(value.second, static_cast<int>(j)); }));
      }
    });
  Pairs pairs;
  for (const Pairs& part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs intersectingPairs(const std::vector<PlacedTriangle>& triangles, const ProgressCallback& progress)
{
  const std::vector<Box> boxes = boxesOf(triangles);
  const Slabs slabs(boxes);
  std::vector<Pairs> found(slabs.count());
  std::atomic<int> done = 0;
  const std::thread::id caller = std::this_thread::get_id();
  tbb::parallel_for(0,
    slabs.count(),
    [&](int slab)
    {
      if (std::this_thread::get_id() == caller)
      {
        report(progress, static_cast<double>(done) / slabs.count(), "looking for self-intersections");
      }
      BoxPointers pointers = slabs.boxes(slab);
      CGAL::box_self_intersection_d(
        pointers.begin(),
        pointers.end(),
        [&, slab](const Box* a, const Box* b)
        {
          if (slabs.isPairOf(slab, *a, *b) && intersect(triangles[a->info()], triangles[b->info()]))
          {
            found[slab].push_back(std::minmax(a->info(), b->info()));
          }
        },
        Cutoff);
      ++done;
    });
  Pairs pairs;
  for (const Pairs& some : found)
  {
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs selfIntersections(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  std::vector<PlacedTriangle> triangles(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      triangles[f].Vertices[k] = mesh.Faces(f, k);
      triangles[f].Points[k] = mesh.Vertices.row(mesh.Faces(f, k));
    }
  }
  return intersectingPairs(triangles, progress);
}

} // namespace flattening
