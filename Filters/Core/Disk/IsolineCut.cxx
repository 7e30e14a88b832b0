// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/IsolineCut.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace flattening
{

namespace
{

using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;

// A vertex moves onto the isoline if that crosses one of its edges within this share of the edge. A
// convention: with a smaller share there are more slivers to remove afterwards, a larger one moves more
// of the surface.
constexpr double SnapShare = 0.2;
// Cosine of the largest tilt of a face, 60 degrees. A guard against folds: any angle below 90 works.
constexpr double LeastCosine = 0.5;

// Edges per boundary vertex that an isoline crosses where refining ends. Measured: 3.1 to 3.8 are crossed
// in the end on ordinary surfaces, and up to 5.4 on the random ones of the tests. With less, their cuts
// would be coarser; with more, slivers cost more time.
constexpr int MoreThanEnough = 8;

class IsolineSnapping
{
public:
  IsolineSnapping(EditableSurface& surface, std::vector<double>& values, double level)
    : Surface(surface)
    , Mesh(surface.mesh())
    , Values(values)
    , Level(level)
  {
  }

  void run()
  {
    for (const Vertex v : this->Mesh.vertices())
    {
      const auto [edge, share] = this->nearestCrossing(v);
      if (share < SnapShare && !this->Mesh.is_border(v) && this->keepsSides(v, edge, share))
      {
        this->snap(v, edge, share);
      }
    }
  }

private:
  int side(Vertex v) const
  {
    const double value = this->Values[v];
    return value < this->Level ? -1 : value > this->Level ? 1 : 0;
  }

  // The half-edge from the vertex that the isoline crosses nearest to it, and the share of the edge up
  // to there.
  std::pair<Halfedge, double> nearestCrossing(Vertex v) const
  {
    std::pair<Halfedge, double> nearest{ SurfaceMesh::null_halfedge(), 1.0 };
    for (const Halfedge h : CGAL::halfedges_around_source(v, this->Mesh))
    {
      const Vertex w = this->Mesh.target(h);
      if (this->side(v) * this->side(w) < 0)
      {
        const double share = (this->Level - this->Values[v]) / (this->Values[w] - this->Values[v]);
        nearest = share < nearest.second ? std::make_pair(h, share) : nearest;
      }
    }
    return nearest;
  }

  Kernel::Point_3 pointOn(Halfedge edge, double share) const
  {
    const Kernel::Point_3& p = this->Mesh.point(this->Mesh.source(edge));
    return p + share * (this->Mesh.point(this->Mesh.target(edge)) - p);
  }

  bool keepsSides(Vertex v, Halfedge edge, double share)
  {
    const Kernel::Point_3 position = this->pointOn(edge, share);
    for (const Halfedge h : CGAL::halfedges_around_source(v, this->Mesh))
    {
      const Vertex a = this->Mesh.target(h);
      const Vertex b = this->Mesh.target(this->Mesh.next(h));
      const Kernel::Point_3& p = this->Mesh.point(a);
      const Kernel::Point_3& q = this->Mesh.point(b);
      const auto old = CGAL::cross_product(p - this->Mesh.point(v), q - this->Mesh.point(v));
      const auto now = CGAL::cross_product(p - position, q - position);
      if ((this->side(a) == 0 && this->side(b) == 0) ||
          !(old * now > LeastCosine * std::sqrt(old.squared_length() * now.squared_length())))
      {
        return false;
      }
    }
    const double value = this->Values[v];
    this->Values[v] = this->Level;
    bool manifold = this->partsAbove(v) == 1;
    for (const Vertex w : this->Mesh.vertices_around_target(this->Mesh.halfedge(v)))
    {
      manifold = manifold && (this->side(w) != 0 || this->partsAbove(w) == 1);
    }
    this->Values[v] = value;
    return manifold;
  }

  // The number of fans of faces above the level around an inner vertex at the level.
  int partsAbove(Vertex v) const
  {
    int above = 0;
    int joints = 0;
    for (const Halfedge h : CGAL::halfedges_around_source(v, this->Mesh))
    {
      const int here = this->side(this->Mesh.target(h));
      const int next = this->side(this->Mesh.target(this->Mesh.next(h)));
      const int before = this->side(this->Mesh.target(this->Mesh.next(this->Mesh.opposite(h))));
      const bool leftIsAbove = here > 0 || next > 0;
      const bool rightIsAbove = here > 0 || before > 0;
      above += leftIsAbove ? 1 : 0;
      joints += leftIsAbove && rightIsAbove && here >= 0 ? 1 : 0;
    }
    return above - joints;
  }

  void snap(Vertex v, Halfedge edge, double share)
  {
    const Kernel::Point_3 position = this->pointOn(edge, share);
    std::map<int, double> weights;
    for (const auto& [original, weight] : this->Surface.origin(v))
    {
      weights[original] += (1.0 - share) * weight;
    }
    for (const auto& [original, weight] : this->Surface.origin(this->Mesh.target(edge)))
    {
      weights[original] += share * weight;
    }
    this->Surface.origin(v).assign(weights.begin(), weights.end());
    this->Mesh.point(v) = position;
    this->Values[v] = this->Level;
  }

  EditableSurface& Surface;
  SurfaceMesh& Mesh;
  std::vector<double>& Values;
  double Level;
};

} // namespace

void snapToIsoline(EditableSurface& surface, std::vector<double>& values, double level)
{
  IsolineSnapping(surface, values, level).run();
}

void raiseValuesAt(std::vector<double>& values, double level)
{
  for (double& value : values)
  {
    value = value == level ? std::nextafter(level, HUGE_VAL) : value;
  }
}

std::vector<Halfedge> edgesAcrossIsoline(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level)
{
  std::vector<Halfedge> crossed;
  for (const auto edge : mesh.edges())
  {
    const Halfedge h = mesh.halfedge(edge);
    const auto [low, high] = std::minmax(values[mesh.source(h)], values[mesh.target(h)]);
    if (low < level && level < high)
    {
      crossed.push_back(h);
    }
  }
  return crossed;
}

bool crossesMoreThanEnough(const SurfaceMesh& mesh,
  const std::vector<double>& values,
  double level,
  int boundaryVertices)
{
  const auto crossed = static_cast<double>(edgesAcrossIsoline(mesh, values, level).size());
  return crossed > static_cast<double>(MoreThanEnough) * boundaryVertices;
}

std::vector<EditableSurface::Face> longFacesAtIsoline(const EditableSurface& surface,
  const std::vector<double>& values,
  double level,
  double distance,
  double longestEdge)
{
  const SurfaceMesh& mesh = surface.mesh();
  std::vector<EditableSurface::Face> faces;
  for (const auto face : mesh.faces())
  {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
    {
      low = std::min(low, values[v]);
      high = std::max(high, values[v]);
    }
    if (low <= level + distance && high >= level - distance && surface.longestEdge(face) > longestEdge)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

void splitAtIsoline(EditableSurface& surface, std::vector<double>& values, double level)
{
  constexpr double closest = 1e-6; // share of an edge; a guard against edges of length zero by rounding
  const SurfaceMesh& mesh = surface.mesh();
  for (const Halfedge h : edgesAcrossIsoline(mesh, values, level))
  {
    const double from = values[mesh.source(h)];
    const double to = values[mesh.target(h)];
    const double t = std::clamp((level - from) / (to - from), closest, 1.0 - closest);
    const auto middle = surface.splitEdge(h, t).Middle;
    values.resize(mesh.num_vertices());
    values[middle] = level;
  }
}

} // namespace flattening
