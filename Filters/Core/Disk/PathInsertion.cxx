// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/PathInsertion.h"

#include "Geodesics/FaceNeighbourhoods.h"
#include "Remeshing/LongestEdgeBisection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// A path goes through a vertex or along an edge that is closer than this share of an edge, or of a
// barycentric coordinate. A convention: with a smaller share the path cuts thinner slivers off, with a
// larger one it is less straight.
constexpr double ShareAtVertex = 0.2;
constexpr int StraighteningSweeps = 20; // a convention; the path changes little after the first sweeps

double keptOffEnds(double fraction)
{
  return std::clamp(fraction, ShareAtVertex, 1.0 - ShareAtVertex);
}

// Barycentric coordinates of a position, in the order of the targets of the face's half-edges from
// mesh.halfedge(face) on.
std::array<double, 3> weightsOf(const SurfaceMesh& mesh, Face face, const Eigen::Vector3d& position)
{
  TriangleMesh triangle;
  triangle.Vertices.resize(3, 3);
  triangle.Faces.resize(1, 3);
  triangle.Faces << 0, 1, 2;
  int k = 0;
  for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face)))
  {
    const Kernel::Point_3& p = mesh.point(mesh.target(h));
    triangle.Vertices.row(k++) << p.x(), p.y(), p.z();
  }
  return ClosestPointTree(triangle).closest(position).Weights;
}

bool ends(const SurfaceMesh& mesh, Halfedge edge, Vertex v)
{
  return mesh.source(edge) == v || mesh.target(edge) == v;
}

// Whether one face joins the points before and after this one, so that the path does not need it.
bool isDetour(const SurfaceMesh& mesh,
  const PathPoint& before,
  const PathPoint& point,
  const PathPoint& after)
{
  if (!point.isVertex())
  {
    return (before.isVertex() && ends(mesh, point.Edge, before.Vertex)) ||
           (after.isVertex() && ends(mesh, point.Edge, after.Vertex));
  }
  if (point.Vertex == before.Vertex || point.Vertex == after.Vertex)
  {
    return true;
  }
  if (!before.isVertex() || !after.isVertex())
  {
    return false;
  }
  const Halfedge direct = mesh.halfedge(before.Vertex, after.Vertex);
  if (!direct.is_valid())
  {
    return false;
  }
  const auto isCorner = [&mesh, &point](Halfedge h)
  { return !mesh.is_border(h) && mesh.target(mesh.next(h)) == point.Vertex; };
  return isCorner(direct) || isCorner(mesh.opposite(direct));
}

Kernel::Point_3 pointAt(const SurfaceMesh& mesh, const PathPoint& point)
{
  if (point.isVertex())
  {
    return mesh.point(point.Vertex);
  }
  const Kernel::Point_3& source = mesh.point(mesh.source(point.Edge));
  return source + point.Fraction * (mesh.point(mesh.target(point.Edge)) - source);
}

// The fraction of an edge at which the straight line between two points crosses it if the faces on both
// sides are laid out flat.
double straightFraction(const SurfaceMesh& mesh,
  Halfedge edge,
  const Kernel::Point_3& before,
  const Kernel::Point_3& after)
{
  const Kernel::Point_3& source = mesh.point(mesh.source(edge));
  const Kernel::Vector_3 along = mesh.point(mesh.target(edge)) - source;
  const double squared = along.squared_length();
  const double left = ((before - source) * along) / squared;
  const double right = ((after - source) * along) / squared;
  const double leftHeight = std::sqrt((before - source - left * along).squared_length());
  const double rightHeight = std::sqrt((after - source - right * along).squared_length());
  return (left * rightHeight + right * leftHeight) / (leftHeight + rightHeight);
}

// Shortens the path: its points slide along their edges.
void straighten(const SurfaceMesh& mesh, std::vector<PathPoint>& path)
{
  for (int sweep = 0; sweep < StraighteningSweeps; ++sweep)
  {
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      if (!path[i].isVertex())
      {
        const double fraction =
          straightFraction(mesh, path[i].Edge, pointAt(mesh, path[i - 1]), pointAt(mesh, path[i + 1]));
        path[i].Fraction = std::isfinite(fraction) ? keptOffEnds(fraction) : path[i].Fraction;
      }
    }
  }
}

} // namespace

Vertex insertPoint(EditableSurface& surface, const SurfacePoint& point, double longestEdge)
{
  const SurfaceMesh& mesh = surface.mesh();
  const Kernel::Point_3 position{ point.Position.x(), point.Position.y(), point.Position.z() };
  Face face = partAt(surface, point.Face, position);
  // Until nothing changes: an edge that is longer than the limit by rounding alone is not split.
  for (SurfaceMesh::size_type before = 0; before < mesh.number_of_faces();)
  {
    before = mesh.number_of_faces();
    halveLongEdges(surface, { face }, longestEdge);
    face = partAt(surface, point.Face, position);
  }

  const std::array<double, 3> weights = weightsOf(mesh, face, point.Position);
  std::array<Halfedge, 3> toCorner;
  Halfedge h = mesh.halfedge(face);
  for (int k = 0; k < 3; ++k, h = mesh.next(h))
  {
    toCorner[k] = h;
  }
  const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  const auto farthest = std::min_element(weights.begin(), weights.end()) - weights.begin();
  const Vertex corner = mesh.target(toCorner[nearest]);
  if (weights[nearest] > 1.0 - ShareAtVertex)
  {
    return corner;
  }
  // Splits the side opposite to a corner where the line from the corner through the point meets it.
  const auto splitOpposite = [&](std::ptrdiff_t k)
  {
    const double toSource = weights[(k + 1) % 3];
    const double toTarget = weights[(k + 2) % 3];
    return surface.splitEdge(mesh.prev(toCorner[k]), keptOffEnds(toTarget / (toSource + toTarget)))
      .Middle;
  };
  if (weights[farthest] < ShareAtVertex)
  {
    return splitOpposite(farthest);
  }
  const Vertex middle = splitOpposite(nearest);
  return surface.splitEdge(mesh.halfedge(corner, middle), 1.0 - weights[nearest]).Middle;
}

void snapToVertices(const SurfaceMesh& mesh,
  std::vector<PathPoint>& path,
  const std::function<bool(Vertex)>& avoided)
{
  for (PathPoint& point : path)
  {
    if (point.isVertex())
    {
      continue;
    }
    const Vertex near = point.Fraction < 0.5 ? mesh.source(point.Edge) : mesh.target(point.Edge);
    if (keptOffEnds(point.Fraction) != point.Fraction && !avoided(near))
    {
      point = { near, SurfaceMesh::null_halfedge(), 0.0 };
    }
    else
    {
      point.Fraction = keptOffEnds(point.Fraction);
    }
  }
  for (std::size_t i = 1; i + 1 < path.size();)
  {
    if (isDetour(mesh, path[i - 1], path[i], path[i + 1]))
    {
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(i));
      i = std::max<std::size_t>(i - 1, 1);
    }
    else
    {
      ++i;
    }
  }
  straighten(mesh, path);
}

std::vector<Vertex> insertPath(EditableSurface& surface, const std::vector<PathPoint>& path)
{
  std::vector<Vertex> vertices;
  for (const PathPoint& point : path)
  {
    vertices.push_back(
      point.isVertex() ? point.Vertex : surface.splitEdge(point.Edge, point.Fraction).Middle);
  }
  return vertices;
}

} // namespace flattening
