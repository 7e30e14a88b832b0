// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/EditableSurface.h"

#include "Base/Errors.h"
#include "Mesh/FaceSides.h"
#include "Mesh/Halfedges.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace flattening
{

namespace
{

[[noreturn]] void throwNoManifold(int face)
{
  throw TopologyError(
    "face " + std::to_string(face) + " does not fit an oriented manifold: run Surface To Disk first");
}

template <typename Point>
CGAL::Surface_mesh<Point> withFacesAdded(const TriangleMesh& mesh)
{
  using Vertex = typename CGAL::Surface_mesh<Point>::Vertex_index;
  CGAL::Surface_mesh<Point> surface;
  surface.reserve(mesh.vertexCount(), 3 * (mesh.faceCount() / 2), mesh.faceCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    surface.add_vertex(Point(mesh.Vertices(v, 0), mesh.Vertices(v, 1), mesh.Vertices(v, 2)));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto corners = mesh.Faces.row(f);
    if (surface.add_face(Vertex(corners[0]), Vertex(corners[1]), Vertex(corners[2])) ==
        surface.null_face())
    {
      throwNoManifold(f);
    }
  }
  return surface;
}

// The numbers that CGAL's half-edges have if faces are added one after the other: those of edge e are
// 2 e, which is met first, and 2 e + 1.
std::vector<unsigned> halfedgeNumbers(const std::vector<int>& opposite)
{
  std::vector<unsigned> numbers(opposite.size());
  unsigned edges = 0;
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h)
  {
    const bool isMet = opposite[h] >= 0 && opposite[h] < h;
    numbers[h] = isMet ? numbers[opposite[h]] + 1 : 2 * edges++;
  }
  return numbers;
}

// Joins the half-edges of the border, which belong to no face.
template <typename Point>
void joinBorder(CGAL::Surface_mesh<Point>& surface,
  const FaceMatrix& faces,
  const std::vector<int>& opposite,
  const std::vector<unsigned>& numbers)
{
  using Vertex = typename CGAL::Surface_mesh<Point>::Vertex_index;
  using Halfedge = typename CGAL::Surface_mesh<Point>::Halfedge_index;
  std::vector<Halfedge> borderFrom(surface.num_vertices());
  std::vector<Halfedge> border;
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h)
  {
    if (opposite[h] >= 0)
    {
      continue;
    }
    const int from = faces.data()[nextHalfedge(h)];
    const Vertex to(faces.data()[h]);
    if (faces.data()[h] == from)
    {
      throwNoManifold(h / 3);
    }
    borderFrom[from] = surface.opposite(Halfedge(numbers[h]));
    surface.set_target(borderFrom[from], to);
    surface.set_halfedge(to, borderFrom[from]);
    border.push_back(borderFrom[from]);
  }
  for (const Halfedge h : border)
  {
    surface.set_next(h, borderFrom[surface.target(h)]);
  }
}

} // namespace

// The same mesh as if its faces were added one after the other, in half the time.
template <typename Point>
CGAL::Surface_mesh<Point> toSurfaceMesh(const TriangleMesh& mesh)
{
  using Vertex = typename CGAL::Surface_mesh<Point>::Vertex_index;
  using Halfedge = typename CGAL::Surface_mesh<Point>::Halfedge_index;
  using Face = typename CGAL::Surface_mesh<Point>::Face_index;
  const std::vector<int> opposite = oppositeHalfedges(mesh.Faces);
  // An edge of more than two faces, or of two that are oriented against each other, divides the fans of
  // its ends, too.
  if (!verticesOfSeveralFans(mesh.Faces, opposite, mesh.vertexCount()).empty())
  {
    return withFacesAdded<Point>(mesh);
  }
  const std::vector<unsigned> numbers = halfedgeNumbers(opposite);
  const auto borderEdges = std::count(opposite.begin(), opposite.end(), -1);
  const auto edges = static_cast<unsigned>((opposite.size() + borderEdges) / 2);
  CGAL::Surface_mesh<Point> surface;
  surface.resize(mesh.vertexCount(), edges, mesh.faceCount());
  tbb::parallel_for(0,
    mesh.vertexCount(),
    [&](int v)
    {
      const auto p = mesh.Vertices.row(v);
      surface.point(Vertex(v)) = Point(p[0], p[1], p[2]);
    });
  tbb::parallel_for(0,
    mesh.faceCount(),
    [&](int f)
    {
      const auto numbered = [&numbers, f](int k) { return Halfedge(numbers[3 * f + k % 3]); };
      surface.set_halfedge(Face(f), numbered(2));
      for (int k = 0; k < 3; ++k)
      {
        surface.set_face(numbered(k), Face(f));
        surface.set_target(numbered(k), Vertex(mesh.Faces(f, (k + 1) % 3)));
        surface.set_next(numbered(k), numbered(k + 1));
      }
    });
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h)
  {
    surface.set_halfedge(Vertex(mesh.Faces.data()[nextHalfedge(h)]), Halfedge(numbers[h]));
  }
  joinBorder(surface, mesh.Faces, opposite, numbers);
  return surface;
}

template CGAL::Surface_mesh<Kernel::Point_3> toSurfaceMesh(const TriangleMesh& mesh);
template CGAL::Surface_mesh<Eigen::Vector3d> toSurfaceMesh(const TriangleMesh& mesh);

template <typename Point>
TriangleMesh toTriangleMesh(const CGAL::Surface_mesh<Point>& mesh)
{
  TriangleMesh result;
  result.Vertices.resize(mesh.number_of_vertices(), 3);
  result.Faces.resize(mesh.number_of_faces(), 3);
  std::vector<int> index(mesh.num_vertices(), -1);
  int v = 0;
  for (const auto vertex : mesh.vertices())
  {
    const Point& p = mesh.point(vertex);
    result.Vertices.row(v) << p.x(), p.y(), p.z();
    index[vertex] = v++;
  }
  int f = 0;
  for (const auto face : mesh.faces())
  {
    int k = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
    {
      result.Faces(f, k++) = index[vertex];
    }
    ++f;
  }
  return result;
}

template TriangleMesh toTriangleMesh(const CGAL::Surface_mesh<Kernel::Point_3>& mesh);
template TriangleMesh toTriangleMesh(const CGAL::Surface_mesh<Eigen::Vector3d>& mesh);

EditableSurface::EditableSurface(const TriangleMesh& mesh)
  : Mesh(toSurfaceMesh(mesh))
  , VertexOrigin(this->Mesh.add_property_map<Vertex, Origin>("v:origin").first)
  , FaceOrigin(this->Mesh.add_property_map<Face, int>("f:origin", -1).first)
  , OriginalVertices(mesh.vertexCount())
{
  for (const Vertex vertex : this->Mesh.vertices())
  {
    this->VertexOrigin[vertex] = { { static_cast<int>(vertex.idx()), 1.0 } };
  }
  for (const Face face : this->Mesh.faces())
  {
    this->FaceOrigin[face] = static_cast<int>(face.idx());
  }
}

namespace
{

// The greatest number of new vertices beside as many as the surface has: a guard of memory. Cuts add
// some thousands; a boundary of 40,000 long needles asks for more.
constexpr std::size_t MostNewVertices = 1000000;

} // namespace

EditableSurface::Split EditableSurface::splitEdge(Halfedge edge, double t)
{
  if (this->Mesh.number_of_vertices() >
      2 * static_cast<std::size_t>(this->OriginalVertices) + MostNewVertices)
  {
    throw InvalidInput(
      "the cut would take more than a million new points: lower Minimum Boundary Vertices or, if the "
      "triangles beside it differ very much in size, remove points that lie far off or set Remesh");
  }
  const Vertex source = this->Mesh.source(edge);
  const Vertex target = this->Mesh.target(edge);
  const Kernel::Point_3 p = this->Mesh.point(source);
  const Kernel::Point_3 q = this->Mesh.point(target);

  const Halfedge first = CGAL::Euler::split_edge(edge, this->Mesh); // source -> new vertex
  const Vertex middle = this->Mesh.target(first);
  this->Mesh.point(middle) = p + t * (q - p);

  this->VertexOrigin[middle] =
    combined({ { this->VertexOrigin[source], 1.0 - t }, { this->VertexOrigin[target], t } });

  Split split{ middle, {} };
  // Splits the face on one side of the edge from the new vertex to the opposite corner.
  const auto splitFace = [this, &split](Halfedge toMiddle, Halfedge toCorner)
  {
    if (this->Mesh.is_border(toMiddle))
    {
      return;
    }
    const Face whole = this->Mesh.face(toMiddle);
    const Halfedge diagonal = CGAL::Euler::split_face(toMiddle, toCorner, this->Mesh);
    const Face rest = this->Mesh.face(this->Mesh.opposite(diagonal));
    this->FaceOrigin[rest] = this->FaceOrigin[whole];
    split.Halves.emplace_back(whole, rest);
  };
  const Halfedge back = this->Mesh.opposite(edge); // target -> new vertex
  splitFace(first, this->Mesh.next(edge));
  splitFace(back, this->Mesh.next(this->Mesh.opposite(first)));
  return split;
}

double EditableSurface::squaredLength(Halfedge edge) const
{
  return CGAL::squared_distance(
    this->Mesh.point(this->Mesh.source(edge)), this->Mesh.point(this->Mesh.target(edge)));
}

double EditableSurface::longestEdge(Face face) const
{
  double longest = 0.0;
  for (const Halfedge h : this->Mesh.halfedges_around_face(this->Mesh.halfedge(face)))
  {
    longest = std::max(longest, this->squaredLength(h));
  }
  return std::sqrt(longest);
}

double EditableSurface::area(Face face) const
{
  const Halfedge h = this->Mesh.halfedge(face);
  const Kernel::Point_3& p = this->Mesh.point(this->Mesh.source(h));
  const Kernel::Vector_3 u = this->Mesh.point(this->Mesh.target(h)) - p;
  const Kernel::Vector_3 v = this->Mesh.point(this->Mesh.target(this->Mesh.next(h))) - p;
  return 0.5 * std::sqrt(CGAL::cross_product(u, v).squared_length());
}

DerivedMesh EditableSurface::derived() const
{
  DerivedMesh result;
  result.Mesh = toTriangleMesh(this->Mesh);
  result.Vertices = originMatrix(this->Mesh.vertices(),
    this->OriginalVertices,
    [this](Vertex v) -> const Origin& { return this->VertexOrigin[v]; });
  result.Faces.reserve(this->Mesh.number_of_faces());
  for (const Face face : this->Mesh.faces())
  {
    result.Faces.push_back(this->FaceOrigin[face]);
  }
  return result;
}

} // namespace flattening
