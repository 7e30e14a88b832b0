// SPDX-License-Identifier: GPL-3.0-or-later
#include "FaceIntersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

namespace bg = boost::geometry;
using BoxCorner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<BoxCorner>;

struct Triangle
{
  std::array<int, 3> Vertices;
  std::array<Point, 3> Points;
};

Box boxOf(const Triangle& t)
{
  const auto [xMin, xMax] = std::minmax({ t.Points[0].x(), t.Points[1].x(), t.Points[2].x() });
  const auto [yMin, yMax] = std::minmax({ t.Points[0].y(), t.Points[1].y(), t.Points[2].y() });
  const auto [zMin, zMax] = std::minmax({ t.Points[0].z(), t.Points[1].z(), t.Points[2].z() });
  return { { xMin, yMin, zMin }, { xMax, yMax, zMax } };
}

bool sidesOppositeMeet(const Triangle& a, int corner, const Triangle& b)
{
  return CGAL::do_intersect(Kernel::Segment_3(a.Points[(corner + 1) % 3], a.Points[(corner + 2) % 3]),
    Kernel::Triangle_3(b.Points[0], b.Points[1], b.Points[2]));
}

bool doIntersect(const Triangle& a, const Triangle& b)
{
  std::array<std::pair<int, int>, 3> shared; // corners of a and of b
  int count = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (a.Vertices[i] == b.Vertices[j])
      {
        shared[count++] = { i, j };
      }
    }
  }
  switch (count)
  {
    case 0:
      return CGAL::do_intersect(Kernel::Triangle_3(a.Points[0], a.Points[1], a.Points[2]),
        Kernel::Triangle_3(b.Points[0], b.Points[1], b.Points[2]));
    case 1:
      return sidesOppositeMeet(a, shared[0].first, b) || sidesOppositeMeet(b, shared[0].second, a);
    case 2: {
      const Point& p = a.Points[shared[0].first];
      const Point& q = a.Points[shared[1].first];
      const Point& r = a.Points[3 - shared[0].first - shared[1].first];
      const Point& s = b.Points[3 - shared[0].second - shared[1].second];
      return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }
    default:
      return true;
  }
}

} // namespace

struct FaceIntersections::Tree
{
  using Value = std::pair<Box, int>;
  using Boxes = bg::index::rtree<Value, bg::index::linear<16>>;

  explicit Tree(const HalfedgeSurface& surface)
    : Surface(surface)
  {
    std::vector<Value> values;
    values.reserve(surface.faceCount());
    for (int f = 0; f < surface.faceCount(); ++f)
    {
      values.emplace_back(boxOf(this->triangle(f)), f);
    }
    this->Faces = Boxes(values.begin(), values.end());
  }

  Triangle triangle(int f) const
  {
    Triangle t;
    for (int k = 0; k < 3; ++k)
    {
      t.Vertices[k] = this->Surface.origin(3 * f + k);
      const Eigen::Vector3d& p = this->Surface.point(t.Vertices[k]);
      t.Points[k] = { p.x(), p.y(), p.z() };
    }
    return t;
  }

  // Pairs among the triangles, and pairs of one of them and a face of the surface that is not left out.
  int count(const std::vector<Triangle>& triangles,
    const std::vector<int>& leftOut,
    int enough = std::numeric_limits<int>::max()) const
  {
    int pairs = 0;
    using SweptBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, const Triangle*>;
    std::vector<SweptBox> boxes;
    boxes.reserve(triangles.size());
    std::vector<Value> near;
    for (const Triangle& t : triangles)
    {
      const Box box = boxOf(t);
      boxes.emplace_back(CGAL::Bbox_3(box.min_corner().get<0>(),
                           box.min_corner().get<1>(),
                           box.min_corner().get<2>(),
                           box.max_corner().get<0>(),
                           box.max_corner().get<1>(),
                           box.max_corner().get<2>()),
        &t);
      near.clear();
      this->Faces.query(bg::index::intersects(box), std::back_inserter(near));
      for (const Value& value : near)
      {
        if (!std::binary_search(leftOut.begin(), leftOut.end(), value.second))
        {
          pairs += doIntersect(t, this->triangle(value.second));
        }
      }
      if (pairs > enough)
      {
        return pairs;
      }
    }
    CGAL::box_self_intersection_d(boxes.begin(),
      boxes.end(),
      [&pairs](const SweptBox& a, const SweptBox& b) { pairs += doIntersect(*a.info(), *b.info()); });
    return pairs;
  }

  const HalfedgeSurface& Surface;
  Boxes Faces;
};

FaceIntersections::FaceIntersections(const HalfedgeSurface& surface)
  : Surface(surface)
  , Boxes(std::make_unique<Tree>(surface))
{
}

FaceIntersections::~FaceIntersections() = default;

int FaceIntersections::countNew(const FaceReplacement& replacement, int enough) const
{
  std::vector<Triangle> triangles;
  triangles.reserve(replacement.Faces.size());
  for (const std::array<int, 3>& face : replacement.Faces)
  {
    Triangle t;
    t.Vertices = face;
    for (int k = 0; k < 3; ++k)
    {
      const auto place = replacement.Places.find(face[k]);
      const Eigen::Vector3d& p =
        place == replacement.Places.end() ? this->Surface.point(face[k]) : place->second;
      t.Points[k] = { p.x(), p.y(), p.z() };
    }
    triangles.push_back(t);
  }
  return this->Boxes->count(triangles, replacement.Replaced, enough);
}

int FaceIntersections::count(const std::vector<int>& faces) const
{
  std::vector<Triangle> triangles;
  for (const int f : faces)
  {
    triangles.push_back(this->Boxes->triangle(f));
  }
  return this->Boxes->count(triangles, faces);
}

void FaceIntersections::remove(const std::vector<int>& faces)
{
  for (const int f : faces)
  {
    this->Boxes->Faces.remove({ boxOf(this->Boxes->triangle(f)), f });
  }
}

void FaceIntersections::insert(const std::vector<int>& faces)
{
  for (const int f : faces)
  {
    this->Boxes->Faces.insert({ boxOf(this->Boxes->triangle(f)), f });
  }
}

} // namespace flattening
