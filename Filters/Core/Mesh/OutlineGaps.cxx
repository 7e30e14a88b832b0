// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineGaps.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace flattening
{
namespace
{

using GapKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using GapTriangulation = CGAL::Constrained_Delaunay_triangulation_2<GapKernel,
  CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, GapKernel>,
    CGAL::Constrained_triangulation_face_base_2<GapKernel>>>;
using GapFace = GapTriangulation::Face_handle;

GapTriangulation triangulationOf(const Points2& positions, const std::vector<FlatEdge>& edges)
{
  GapTriangulation triangulation;
  std::map<int, GapTriangulation::Vertex_handle> handles;
  for (const FlatEdge& edge : edges)
  {
    for (const int v : edge)
    {
      if (handles.find(v) == handles.end())
      {
        const auto handle = triangulation.insert({ positions(v, 0), positions(v, 1) });
        handle->info() = v;
        handles.emplace(v, handle);
      }
    }
  }
  for (const FlatEdge& edge : edges)
  {
    triangulation.insert_constraint(handles[edge[0]], handles[edge[1]]);
  }
  return triangulation;
}

} // namespace

FaceMatrix outlineGaps(const Points2& positions, const std::vector<FlatEdge>& edges)
{
  const GapTriangulation triangulation = triangulationOf(positions, edges);
  std::vector<std::array<int, 3>> gaps;
  // From outside the convex hull through all edges that are not the polygon's.
  std::set<GapFace> reached{ triangulation.infinite_face() };
  std::vector<GapFace> next(reached.begin(), reached.end());
  while (!next.empty())
  {
    const GapFace face = next.back();
    next.pop_back();
    if (!triangulation.is_infinite(face))
    {
      gaps.push_back({ face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info() });
    }
    for (int k = 0; k < 3; ++k)
    {
      if (!face->is_constrained(k) && reached.insert(face->neighbor(k)).second)
      {
        next.push_back(face->neighbor(k));
      }
    }
  }
  // The order in which they are reached must not matter.
  for (std::array<int, 3>& gap : gaps)
  {
    std::rotate(gap.begin(), std::min_element(gap.begin(), gap.end()), gap.end());
  }
  std::sort(gaps.begin(), gaps.end());
  FaceMatrix faces(static_cast<Eigen::Index>(gaps.size()), 3);
  for (std::size_t k = 0; k < gaps.size(); ++k)
  {
    faces.row(static_cast<Eigen::Index>(k)) << gaps[k][0], gaps[k][1], gaps[k][2];
  }
  return faces;
}

} // namespace flattening
