// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineTriangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace flattening
{
namespace
{

using OutlineKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using OutlineVertex = CGAL::Triangulation_vertex_base_with_info_2<int, OutlineKernel>;
using OutlineFace = CGAL::Constrained_triangulation_face_base_2<OutlineKernel,
  CGAL::Triangulation_face_base_with_info_2<int, OutlineKernel>>;
using OutlineDelaunay = CGAL::Constrained_Delaunay_triangulation_2<OutlineKernel,
  CGAL::Triangulation_data_structure_2<OutlineVertex, OutlineFace>>;
using FaceHandle = OutlineDelaunay::Face_handle;
using Corners = std::array<int, 3>;

// The info of a face inside is its row; the info of the others is one of these.
constexpr int NotReached = -2;
constexpr int IsOutside = -1;
// Points that are inserted between two reports of progress.
constexpr int PointsPerReport = 1000;

// The corners of a triangle, the smallest first.
Corners cornersOf(FaceHandle face)
{
  Corners corners{ face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info() };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Whether the point lies in the face, but not on its border.
bool isWithin(const OutlineKernel::Point_2& point, FaceHandle face)
{
  for (int k = 0; k < 3; ++k)
  {
    const auto& from = face->vertex(OutlineDelaunay::ccw(k))->point();
    const auto& to = face->vertex(OutlineDelaunay::cw(k))->point();
    if (CGAL::orientation(from, to, point) != CGAL::LEFT_TURN)
    {
      return false;
    }
  }
  return true;
}

// Some rows in an order in which each point is near the one before, so that it is found fast: along a
// curve of Hilbert.
std::vector<int> alongCurve(const Points2& positions, const std::vector<int>& rows)
{
  std::vector<OutlineKernel::Point_2> points;
  points.reserve(rows.size());
  for (const int v : rows)
  {
    points.emplace_back(positions(v, 0), positions(v, 1));
  }
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Traits = CGAL::Spatial_sort_traits_adapter_2<OutlineKernel,
    CGAL::Pointer_property_map<OutlineKernel::Point_2>::type>;
  CGAL::hilbert_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(points)));
  std::vector<int> sortedRows(rows.size());
  std::transform(
    order.begin(), order.end(), sortedRows.begin(), [&rows](std::size_t k) { return rows[k]; });
  return sortedRows;
}

FaceMatrix sorted(std::vector<std::pair<Corners, FaceHandle>>& triangles)
{
  std::sort(
    triangles.begin(), triangles.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  FaceMatrix faces(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    const Corners& corners = triangles[k].first;
    faces.row(static_cast<Eigen::Index>(k)) << corners[0], corners[1], corners[2];
  }
  return faces;
}

} // namespace

struct OutlineTriangulation::Triangulation : OutlineDelaunay
{
  FaceHandle Near;                     // where the next point is inserted
  std::vector<FaceHandle> FacesInside; // by their rows

  Vertex_handle insertPoint(const Points2& positions, int row)
  {
    const Vertex_handle handle = this->insert({ positions(row, 0), positions(row, 1) }, this->Near);
    handle->info() = row;
    this->Near = handle->face();
    return handle;
  }

  // Marks the faces that are reached from infinity through edges that are not the polygon's.
  void markOutside()
  {
    for (const FaceHandle face : this->all_face_handles())
    {
      face->info() = NotReached;
    }
    std::vector<FaceHandle> next{ this->infinite_face() };
    this->infinite_face()->info() = IsOutside;
    while (!next.empty())
    {
      const FaceHandle face = next.back();
      next.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const FaceHandle other = face->neighbor(k);
        if (!face->is_constrained(k) && other->info() == NotReached)
        {
          other->info() = IsOutside;
          next.push_back(other);
        }
      }
    }
  }
};

OutlineTriangulation::OutlineTriangulation(const Points2& positions,
  const std::vector<FlatEdge>& outline,
  const std::vector<int>& inner,
  const ProgressCallback& progress)
  : Delaunay(std::make_unique<Triangulation>())
{
  std::unordered_map<int, OutlineDelaunay::Vertex_handle> handles; // of the polygon
  for (const FlatEdge& edge : outline)
  {
    for (const int v : edge)
    {
      if (handles.find(v) == handles.end())
      {
        handles.emplace(v, this->Delaunay->insertPoint(positions, v));
      }
    }
  }
  const std::vector<int> order = alongCurve(positions, inner);
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    if (k % PointsPerReport == 0)
    {
      report(progress, static_cast<double>(k) / static_cast<double>(order.size()), "Triangulation");
    }
    this->Delaunay->insertPoint(positions, order[k]);
  }
  for (const FlatEdge& edge : outline)
  {
    this->Delaunay->insert_constraint(handles[edge[0]], handles[edge[1]]);
  }
  this->Delaunay->markOutside();
  std::vector<std::pair<Corners, FaceHandle>> inside;
  std::vector<std::pair<Corners, FaceHandle>> outside;
  for (const FaceHandle face : this->Delaunay->finite_face_handles())
  {
    (face->info() == IsOutside ? outside : inside).emplace_back(cornersOf(face), face);
  }
  this->Inside = sorted(inside);
  this->Outside = sorted(outside);
  for (std::size_t k = 0; k < inside.size(); ++k)
  {
    inside[k].second->info() = static_cast<int>(k);
    this->Delaunay->FacesInside.push_back(inside[k].second);
  }
}

OutlineTriangulation::~OutlineTriangulation() = default;

int OutlineTriangulation::insideAt(const Eigen::Vector2d& point, int near) const
{
  const OutlineKernel::Point_2 sought(point.x(), point.y());
  const FaceHandle begin = this->Delaunay->FacesInside[near];
  if (isWithin(sought, begin)) // much faster than a walk that does not leave the face
  {
    return near;
  }
  OutlineDelaunay::Locate_type type;
  int index = 0;
  const FaceHandle face = this->Delaunay->locate(sought, type, index, begin);
  if (face == FaceHandle() || this->Delaunay->is_infinite(face))
  {
    return -1;
  }
  if (face->info() >= 0)
  {
    return face->info();
  }
  // A point of the polygon is also one of faces inside.
  if (type == OutlineDelaunay::EDGE)
  {
    return std::max(face->neighbor(index)->info(), -1);
  }
  if (type == OutlineDelaunay::VERTEX)
  {
    auto around = this->Delaunay->incident_faces(face->vertex(index));
    const auto first = around;
    do
    {
      if (around->info() >= 0)
      {
        return around->info();
      }
    } while (++around != first);
  }
  return -1;
}

} // namespace flattening
