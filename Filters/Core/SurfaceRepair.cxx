// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceRepair.h"

#include "CoincidentPoints.h"
#include "CollinearFaces.h"
#include "EditableSurface.h"
#include "Errors.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace flattening
{
namespace
{

using Triangle = std::array<int, 3>;

void requireFinite(const TriangleMesh& soup)
{
  for (int f = 0; f < soup.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = soup.Faces(f, k);
      if (v < 0 || v >= soup.vertexCount())
      {
        throw InvalidInput("face " + std::to_string(f) + " names vertex " + std::to_string(v) +
                           ", but there are " + std::to_string(soup.vertexCount()) +
                           " vertices: the data set is damaged");
      }
      if (!soup.Vertices.row(v).allFinite())
      {
        throw InvalidInput("point " + std::to_string(v) + " of face " + std::to_string(f) +
                           " has a coordinate that is not finite: remove such points first, e.g. with "
                           "Threshold or Extract Selection");
      }
    }
  }
}

bool repeatsVertex(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// The faces left after merging, with the input face of each.
struct FaceList
{
  std::vector<Triangle> Faces;
  std::vector<int> Origins;

  template <typename Drop>
  int dropIf(Drop&& drop)
  {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      if (!drop(f))
      {
        this->Faces[kept] = this->Faces[f];
        this->Origins[kept++] = this->Origins[f];
      }
    }
    const int dropped = static_cast<int>(this->Faces.size() - kept);
    this->Faces.resize(kept);
    this->Origins.resize(kept);
    return dropped;
  }
};

int dropDuplicates(FaceList& list)
{
  struct Key
  {
    Triangle Vertices;
    int Face;
  };
  std::vector<Key> keys(list.Faces.size());
  for (std::size_t f = 0; f < keys.size(); ++f)
  {
    keys[f] = { list.Faces[f], static_cast<int>(f) };
    std::sort(keys[f].Vertices.begin(), keys[f].Vertices.end());
  }
  std::sort(keys.begin(),
    keys.end(),
    [](const Key& a, const Key& b)
    { return a.Vertices != b.Vertices ? a.Vertices < b.Vertices : a.Face < b.Face; });
  std::vector<char> duplicate(keys.size(), 0);
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    duplicate[keys[i].Face] = keys[i].Vertices == keys[i - 1].Vertices;
  }
  return list.dropIf([&duplicate](std::size_t f) { return duplicate[f] != 0; });
}

using Polygons = std::vector<std::array<std::size_t, 3>>;

struct OrientationRecord : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  std::vector<char>* Reversed = nullptr;
  std::vector<int>* CopyOf = nullptr; // vertex that each vertex is a copy of, or itself

  void polygon_orientation_reversed(std::size_t face) { (*this->Reversed)[face] ^= 1; }
  void duplicated_vertex(std::size_t original, std::size_t copy)
  {
    this->CopyOf->resize(std::max(this->CopyOf->size(), copy + 1));
    (*this->CopyOf)[copy] = (*this->CopyOf)[original];
  }
};

// Sides of faces by undirected edge; neighbours across an edge of exactly two faces.
template <typename FaceVector>
std::map<std::pair<std::size_t, std::size_t>, std::vector<int>> facesOfEdges(const FaceVector& faces,
  const std::vector<char>& concerned)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<int>> edges;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int k = 0; concerned[f] && k < 3; ++k)
    {
      const std::size_t a = faces[f][k];
      const std::size_t b = faces[f][(k + 1) % 3];
      edges[std::minmax(a, b)].push_back(static_cast<int>(f));
    }
  }
  return edges;
}

// A cut at an edge of just two faces has one reason only: no orientation suits both.
std::vector<char> facesAtOneSidedEdges(const std::vector<Triangle>& before,
  const Polygons& after,
  const std::vector<int>& copyOf,
  std::size_t verticesBefore)
{
  std::vector<char> oneSided(before.size(), 0);
  if (copyOf.size() == verticesBefore)
  {
    return oneSided;
  }
  std::vector<char> copied(verticesBefore, 0);
  for (std::size_t v = verticesBefore; v < copyOf.size(); ++v)
  {
    copied[copyOf[v]] = 1;
  }
  std::vector<char> concerned(before.size(), 0);
  for (std::size_t f = 0; f < before.size(); ++f)
  {
    concerned[f] = copied[before[f][0]] || copied[before[f][1]] || copied[before[f][2]];
  }
  const auto edgesAfter = facesOfEdges(after, concerned);
  std::map<std::pair<int, int>, int> joined;
  for (const auto& [edge, faces] : edgesAfter)
  {
    if (faces.size() == 2)
    {
      joined[std::minmax(faces[0], faces[1])] = 1;
    }
  }
  for (const auto& [edge, faces] : facesOfEdges(before, concerned))
  {
    if (faces.size() == 2 && !joined.count(std::minmax(faces[0], faces[1])))
    {
      oneSided[faces[0]] = oneSided[faces[1]] = 1;
    }
  }
  return oneSided;
}

} // namespace

RepairedSurface repairTriangleSoup(const TriangleMesh& soup, double tolerance)
{
  if (soup.faceCount() == 0)
  {
    throw InvalidInput("the surface has no triangles: pass a surface, e.g. from Contour");
  }
  requireFinite(soup);

  RepairedSurface repaired;
  RepairReport& report = repaired.Report;
  const std::vector<int> representative = coincidentPoints(soup.Vertices, tolerance);
  std::vector<char> used(soup.vertexCount(), 0);
  FaceList list;
  list.Faces.resize(soup.faceCount());
  list.Origins.resize(soup.faceCount());
  for (int f = 0; f < soup.faceCount(); ++f)
  {
    list.Origins[f] = f;
    for (int k = 0; k < 3; ++k)
    {
      used[soup.Faces(f, k)] = 1;
      list.Faces[f][k] = representative[soup.Faces(f, k)];
    }
  }
  for (int v = 0; v < soup.vertexCount(); ++v)
  {
    report.UnusedPoints += !used[v];
    report.MergedPoints += used[v] && representative[v] != v;
  }

  report.DegenerateFaces = list.dropIf([&list](std::size_t f) { return repeatsVertex(list.Faces[f]); });
  report.DegenerateFaces += dissolveCollinearFaces(soup.Vertices, list.Faces, list.Origins);
  report.DuplicateFaces = dropDuplicates(list);
  if (list.Faces.empty())
  {
    throw InvalidInput("the surface has zero area: all of its " + std::to_string(soup.faceCount()) +
                       " triangles are degenerate; check the coordinates and the merge tolerance");
  }

  // Number the vertices in use.
  std::vector<int> original;
  std::vector<int> index(soup.vertexCount(), -1);
  for (const Triangle& triangle : list.Faces)
  {
    for (const int v : triangle)
    {
      index[v] = 0;
    }
  }
  std::vector<Kernel::Point_3> points;
  for (int v = 0; v < soup.vertexCount(); ++v)
  {
    if (index[v] == 0)
    {
      index[v] = static_cast<int>(original.size());
      original.push_back(v);
      points.push_back(pointOf(soup.Vertices, v));
    }
  }
  Polygons polygons(list.Faces.size());
  for (std::size_t f = 0; f < polygons.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      list.Faces[f][k] = index[list.Faces[f][k]];
      polygons[f][k] = list.Faces[f][k];
    }
  }

  repaired.Reversed.assign(polygons.size(), 0);
  std::vector<int> copyOf(points.size());
  for (std::size_t v = 0; v < copyOf.size(); ++v)
  {
    copyOf[v] = static_cast<int>(v);
  }
  OrientationRecord record;
  record.Reversed = &repaired.Reversed;
  record.CopyOf = &copyOf;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(
    points, polygons, CGAL::parameters::visitor(record));
  report.SplitPoints = static_cast<int>(points.size() - original.size());
  repaired.OneSided = facesAtOneSidedEdges(list.Faces, polygons, copyOf, original.size());

  DerivedMesh& surface = repaired.Surface;
  surface.Mesh.Vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  std::vector<int> origins(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    surface.Mesh.Vertices.row(v) << points[v].x(), points[v].y(), points[v].z();
    origins[v] = original[copyOf[v]];
  }
  surface.Vertices = keptVertices(origins, soup.vertexCount());
  surface.Mesh.Faces.resize(static_cast<Eigen::Index>(polygons.size()), 3);
  for (std::size_t f = 0; f < polygons.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      surface.Mesh.Faces(f, k) = static_cast<int>(polygons[f][k]);
    }
  }
  surface.Faces = std::move(list.Origins);
  return repaired;
}

int orientOutward(TriangleMesh& component, const std::vector<char>& reversed, bool closed)
{
  const int faces = component.faceCount();
  double volume = 0.0;       // six times; about the centroid, to lose fewer digits
  double reversedArea = 0.0; // minus the area of the faces that were kept
  const Eigen::RowVector3d centre = component.Vertices.colwise().mean();
  const Eigen::VectorXd areas = faceAreas(component.Vertices, component.Faces);
  int reversedFaces = 0;
  for (int f = 0; f < faces; ++f)
  {
    const Eigen::Vector3d a = component.Vertices.row(component.Faces(f, 0)) - centre;
    const Eigen::Vector3d b = component.Vertices.row(component.Faces(f, 1)) - centre;
    const Eigen::Vector3d c = component.Vertices.row(component.Faces(f, 2)) - centre;
    volume += a.dot(b.cross(c));
    reversedArea += reversed[f] ? areas[f] : -areas[f];
    reversedFaces += reversed[f] != 0;
  }
  if (closed ? volume < 0.0 : reversedArea > 0.0)
  {
    component.Faces.col(1).swap(component.Faces.col(2));
    reversedFaces = faces - reversedFaces;
  }
  return reversedFaces;
}

} // namespace flattening
