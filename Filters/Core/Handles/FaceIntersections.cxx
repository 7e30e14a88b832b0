// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/FaceIntersections.h"

#include "Mesh/SelfIntersections.h"

#include <CGAL/Bbox_3.h>
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

namespace bg = boost::geometry;
using BoxCorner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<BoxCorner>;

Box boxOf(const PlacedTriangle& t)
{
  const auto& [a, b, c] = t.Points;
  const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c);
  const Eigen::Vector3d high = a.cwiseMax(b).cwiseMax(c);
  return { { low.x(), low.y(), low.z() }, { high.x(), high.y(), high.z() } };
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

  PlacedTriangle triangle(int f) const
  {
    PlacedTriangle t;
    for (int k = 0; k < 3; ++k)
    {
      t.Vertices[k] = this->Surface.origin(3 * f + k);
      t.Points[k] = this->Surface.point(t.Vertices[k]);
    }
    return t;
  }

  // Pairs among the triangles, and pairs of one of them and a face of the surface that is not left out.
  int count(const std::vector<PlacedTriangle>& triangles,
    const std::vector<int>& leftOut,
    int enough = std::numeric_limits<int>::max()) const
  {
    int pairs = 0;
    using SweptBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, const PlacedTriangle*>;
    std::vector<SweptBox> boxes;
    boxes.reserve(triangles.size());
    std::vector<Value> near;
    for (const PlacedTriangle& t : triangles)
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
          pairs += intersect(t, this->triangle(value.second));
        }
      }
      if (pairs > enough)
      {
        return pairs;
      }
    }
    CGAL::box_self_intersection_d(boxes.begin(),
      boxes.end(),
      [&pairs](const SweptBox& a, const SweptBox& b) { pairs += intersect(*a.info(), *b.info()); });
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
  std::vector<PlacedTriangle> triangles;
  triangles.reserve(replacement.Faces.size());
  for (const std::array<int, 3>& face : replacement.Faces)
  {
    PlacedTriangle t;
    t.Vertices = face;
    for (int k = 0; k < 3; ++k)
    {
      const auto place = replacement.Places.find(face[k]);
      t.Points[k] = place == replacement.Places.end() ? this->Surface.point(face[k]) : place->second;
    }
    triangles.push_back(t);
  }
  return this->Boxes->count(triangles, replacement.Replaced, enough);
}

int FaceIntersections::count(const std::vector<int>& faces) const
{
  std::vector<PlacedTriangle> triangles;
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
