// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/FaceIntersections.h"

#include <algorithm>
#include <limits>

namespace flattening
{
namespace
{

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

Eigen::AlignedBox3d boxOf(const HalfedgeSurface& surface, int face)
{
  return triangleOf(surface, face).box();
}

std::vector<Eigen::AlignedBox3d> boxesOf(const HalfedgeSurface& surface)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(surface.faceCount());
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    boxes.push_back(boxOf(surface, f));
  }
  return boxes;
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

FaceIntersections::FaceIntersections(const HalfedgeSurface& surface)
  : Surface(surface)
  , Boxes(boxesOf(surface))
{
}

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
  for (const PlacedTriangle& t : triangles)
  {
    this->Boxes.query(t.box(),
      [&](int face)
      {
        if (!std::binary_search(leftOut.begin(), leftOut.end(), face))
        {
          pairs += intersect(t, triangleOf(this->Surface, face));
        }
      });
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
    this->Boxes.remove(boxOf(this->Surface, f), f);
  }
}

void FaceIntersections::insert(const std::vector<int>& faces)
{
  for (const int f : faces)
  {
    this->Boxes.insert(boxOf(this->Surface, f), f);
  }
}

} // namespace flattening
