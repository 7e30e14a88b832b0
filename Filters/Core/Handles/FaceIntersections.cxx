// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/FaceIntersections.h"

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
using Box = bg::model::box<bg::model::point<double, 3, bg::cs::cartesian>>;
using BoxedFace = std::pair<Box, int>;
using BoxTree = bg::index::rtree<BoxedFace, bg::index::linear<16>>; // the branching is a convention

Box boxOf(const PlacedTriangle& t)
{
  const Eigen::AlignedBox3d box = t.box();
  const Eigen::Vector3d& low = box.min();
  const Eigen::Vector3d& high = box.max();
  return { { low.x(), low.y(), low.z() }, { high.x(), high.y(), high.z() } };
}

PlacedTriangle triangleOf(const HalfedgeSurface& surface, int face)
{
  PlacedTriangle t;
  for (int k = 0; k < 3; ++k)
  {
    t.Vertices[k] = surface.source(3 * face + k);
    t.Points[k] = surface.point(t.Vertices[k]);
  }
  return t;
}

BoxedFace boxedFace(const HalfedgeSurface& surface, int face)
{
  return { boxOf(triangleOf(surface, face)), face };
}

} // namespace

std::vector<PlacedTriangle> trianglesOf(const HalfedgeSurface& surface, const std::vector<int>& faces)
{
  std::vector<PlacedTriangle> triangles;
  for (const int f : faces)
  {
    triangles.push_back(triangleOf(surface, f));
  }
  return triangles;
}

std::vector<PlacedTriangle> trianglesOf(const HalfedgeSurface& surface,
  const FaceReplacement& replacement)
{
  std::vector<PlacedTriangle> triangles;
  for (const std::array<int, 3>& face : replacement.Faces)
  {
    PlacedTriangle t;
    t.Vertices = face;
    for (int k = 0; k < 3; ++k)
    {
      const auto position = replacement.Positions.find(face[k]);
      t.Points[k] = position == replacement.Positions.end() ? surface.point(face[k]) : position->second;
    }
    triangles.push_back(t);
  }
  return triangles;
}

struct FaceIntersections::Tree
{
  BoxTree Faces;
};

FaceIntersections::FaceIntersections(const HalfedgeSurface& surface)
  : Surface(surface)
  , Boxes(std::make_unique<Tree>())
{
  std::vector<BoxedFace> faces;
  faces.reserve(surface.faceCount());
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    faces.push_back(boxedFace(surface, f));
  }
  this->Boxes->Faces = BoxTree(faces.begin(), faces.end());
}

FaceIntersections::~FaceIntersections() = default;

int FaceIntersections::countNew(const FaceReplacement& replacement, int enough) const
{
  return this->count(trianglesOf(this->Surface, replacement), replacement.Replaced, enough);
}

int FaceIntersections::count(const std::vector<int>& faces) const
{
  return this->count(trianglesOf(this->Surface, faces), faces, std::numeric_limits<int>::max());
}

// Counts pairs of one of the triangles and a face of the surface that is not left out, then pairs among
// the triangles.
int FaceIntersections::count(const std::vector<PlacedTriangle>& triangles,
  const std::vector<int>& leftOut,
  int enough) const
{
  int pairs = 0;
  std::vector<BoxedFace> near;
  for (const PlacedTriangle& t : triangles)
  {
    near.clear();
    this->Boxes->Faces.query(bg::index::intersects(boxOf(t)), std::back_inserter(near));
    for (const auto& [box, face] : near)
    {
      if (!std::binary_search(leftOut.begin(), leftOut.end(), face))
      {
        pairs += intersect(t, triangleOf(this->Surface, face));
      }
    }
    if (pairs > enough)
    {
      return pairs;
    }
  }
  return pairs + static_cast<int>(intersectingPairs(triangles).size());
}

void FaceIntersections::remove(const std::vector<int>& faces)
{
  for (const int f : faces)
  {
    this->Boxes->Faces.remove(boxedFace(this->Surface, f));
  }
}

void FaceIntersections::insert(const std::vector<int>& faces)
{
  for (const int f : faces)
  {
    this->Boxes->Faces.insert(boxedFace(this->Surface, f));
  }
}

} // namespace flattening
