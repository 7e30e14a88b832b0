// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/TJunctions.h"

#include "Mesh/FaceSides.h"
#include "Mesh/Halfedges.h"
#include "Mesh/SliverThresholds.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>
#include <utility>

namespace flattening
{
namespace
{

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

// How many times as high as the distance of a vertex from the edge the face must be over the edge: a
// guard against splitting a face that is itself as thin as the gap, which would fold it.
constexpr double LeastHeightRatio = 10.0;

struct OpenEdge
{
  int From;
  int To;
  int Apex;
  int Face;
};

struct PointOnEdge
{
  int Edge;
  double Along; // share of the edge before the vertex
  int Vertex;

  bool operator<(const PointOnEdge& other) const
  {
    return std::tie(this->Edge, this->Along, this->Vertex) <
           std::tie(other.Edge, other.Along, other.Vertex);
  }
};

// The edges of one face only, sorted by face.
std::vector<OpenEdge> openEdges(const std::vector<Triangle>& faces)
{
  const FaceMatrix corners =
    Eigen::Map<const FaceMatrix>(faces.front().data(), static_cast<Eigen::Index>(faces.size()), 3);
  std::vector<OpenEdge> edges;
  forEachEdge(sortedSides(corners),
    [&](const FaceSide* side, int count)
    {
      if (count == 1)
      {
        const int apex = faces[side->face()][previousHalfedge(side->Halfedge) % 3];
        edges.push_back({ side->From, side->To, apex, side->face() });
      }
    });
  std::sort(edges.begin(),
    edges.end(),
    [](const OpenEdge& a, const OpenEdge& b)
    { return std::tie(a.Face, a.From) < std::tie(b.Face, b.From); });
  return edges;
}

class TJunctionSearch
{
public:
  TJunctionSearch(const Points3& vertices, double tolerance)
    : Vertices(vertices)
    , Tolerance(tolerance)
  {
  }

  // The vertices on the edges, sorted by edge and along it.
  std::vector<PointOnEdge> pointsOn(const std::vector<OpenEdge>& edges) const
  {
    std::vector<Box> boxesOfEdges;
    std::vector<int> ends;
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      Eigen::AlignedBox3d box = this->boxAround(edges[e]);
      boxesOfEdges.emplace_back(box.min().data(), box.max().data(), static_cast<int>(e));
      ends.push_back(edges[e].From);
      ends.push_back(edges[e].To);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Box> boxesOfPoints;
    for (const int v : ends)
    {
      Eigen::Vector3d point = this->Vertices.row(v);
      boxesOfPoints.emplace_back(point.data(), point.data(), v);
    }

    std::vector<PointOnEdge> found;
    CGAL::box_intersection_d(boxesOfEdges.begin(),
      boxesOfEdges.end(),
      boxesOfPoints.begin(),
      boxesOfPoints.end(),
      [&](const Box& edge, const Box& point)
      {
        const double along = this->shareOn(edges[edge.info()], point.info());
        if (along > 0.0)
        {
          found.push_back({ edge.info(), along, point.info() });
        }
      });
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  double reach(double length) const { return std::max(this->Tolerance, slivers::CapAltitude * length); }

  Eigen::AlignedBox3d boxAround(const OpenEdge& edge) const
  {
    const Eigen::Vector3d from = this->Vertices.row(edge.From);
    const Eigen::Vector3d to = this->Vertices.row(edge.To);
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(this->reach((to - from).norm()));
    return { from.cwiseMin(to) - margin, from.cwiseMax(to) + margin };
  }

  // The share of the edge before the vertex; 0 if the vertex is not on it.
  double shareOn(const OpenEdge& edge, int v) const
  {
    if (v == edge.From || v == edge.To || v == edge.Apex)
    {
      return 0.0;
    }
    const Eigen::Vector3d from = this->Vertices.row(edge.From);
    const Eigen::Vector3d along = this->Vertices.row(edge.To).transpose() - from;
    const Eigen::Vector3d point = this->Vertices.row(v).transpose() - from;
    const Eigen::Vector3d apex = this->Vertices.row(edge.Apex).transpose() - from;
    const double length = along.norm();
    const double share = point.dot(along) / (length * length);
    const double offEnds = std::max(this->Tolerance / length, 2.0 * slivers::NeedleEdge);
    if (!(share > offEnds && share < 1.0 - offEnds))
    {
      return 0.0;
    }
    const double distance = (point - share * along).norm();
    const double height = along.cross(apex).norm() / length;
    return distance <= this->reach(length) && height > LeastHeightRatio * distance ? share : 0.0;
  }

  const Points3& Vertices;
  double Tolerance;
};

// Splits the part of a face that has the edge from `before` to `end` at `middle`.
void splitPart(std::vector<Triangle>& parts, int before, int end, int middle)
{
  const auto has = [](const Triangle& part, int v)
  { return std::find(part.begin(), part.end(), v) != part.end(); };
  const auto whole = std::find_if(parts.begin(),
    parts.end(),
    [&](const Triangle& part) { return has(part, before) && has(part, end); });
  Triangle rest = *whole;
  std::replace(whole->begin(), whole->end(), end, middle);
  std::replace(rest.begin(), rest.end(), before, middle);
  parts.push_back(rest);
}

} // namespace

int closeTJunctions(const Points3& vertices, FaceList& list, double tolerance)
{
  std::vector<Triangle>& faces = list.Faces;
  const std::vector<OpenEdge> edges = openEdges(faces);
  const std::vector<PointOnEdge> points = TJunctionSearch(vertices, tolerance).pointsOn(edges);
  std::vector<Triangle> parts;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const OpenEdge& edge = edges[points[i].Edge];
    const bool firstOfFace = i == 0 || edges[points[i - 1].Edge].Face != edge.Face;
    const bool firstOfEdge = i == 0 || points[i - 1].Edge != points[i].Edge;
    const bool lastOfFace = i + 1 == points.size() || edges[points[i + 1].Edge].Face != edge.Face;
    if (firstOfFace)
    {
      parts = { faces[edge.Face] };
    }
    splitPart(parts, firstOfEdge ? edge.From : points[i - 1].Vertex, edge.To, points[i].Vertex);
    if (lastOfFace)
    {
      faces[edge.Face] = parts.front();
      faces.insert(faces.end(), parts.begin() + 1, parts.end());
      list.Origins.insert(list.Origins.end(), parts.size() - 1, list.Origins[edge.Face]);
    }
  }
  list.dropIf([&faces](std::size_t f) { return repeatsVertex(faces[f]); });
  return static_cast<int>(points.size());
}

} // namespace flattening
