// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/ConsistentOrientation.h"

#include "Base/Errors.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/FaceSides.h"
#include "Mesh/MeshTopology.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

// Most isosurfaces are oriented manifolds: finding out takes a tenth of the time of making them so.
bool isOrientedManifold(const TriangleMesh& mesh)
{
  try
  {
    analyseTopology(mesh.Faces, mesh.vertexCount());
    return true;
  }
  catch (const TopologyError&)
  {
    return false;
  }
}

// Records in `Result` what CGAL reverses and copies.
struct OrientationRecord : PMP::Default_orientation_visitor
{
  OrientedMesh* Result = nullptr;

  void polygon_orientation_reversed(std::size_t face) { this->Result->Reversed[face] ^= 1; }
  void duplicated_vertex(std::size_t original, std::size_t copy)
  {
    std::vector<int>& copyOf = this->Result->CopyOf;
    copyOf.resize(std::max(copyOf.size(), copy + 1));
    copyOf[copy] = copyOf[original];
  }
};

// The pairs of faces that share an edge with no third one, sorted.
std::vector<std::pair<int, int>> neighbours(const FaceMatrix& faces)
{
  std::vector<std::pair<int, int>> pairs;
  forEachEdge(sortedSides(faces),
    [&pairs](const FaceSide* side, int count)
    {
      if (count == 2)
      {
        pairs.emplace_back(side[0].face(), side[1].face());
      }
    });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Marks the faces beside a one-sided edge: an edge of just two faces is cut only if no orientation suits
// both.
void markOneSidedEdges(OrientedMesh& oriented, const FaceMatrix& before)
{
  const std::vector<std::pair<int, int>> joined = neighbours(oriented.Mesh.Faces);
  for (const auto& pair : neighbours(before))
  {
    if (!std::binary_search(joined.begin(), joined.end(), pair))
    {
      oriented.OneSided[pair.first] = oriented.OneSided[pair.second] = 1;
    }
  }
}

} // namespace

OrientedMesh orientConsistently(const TriangleMesh& mesh)
{
  OrientedMesh oriented;
  oriented.CopyOf.resize(mesh.vertexCount());
  std::iota(oriented.CopyOf.begin(), oriented.CopyOf.end(), 0);
  oriented.Reversed.assign(mesh.faceCount(), 0);
  oriented.OneSided.assign(mesh.faceCount(), 0);
  oriented.Mesh = mesh;
  if (isOrientedManifold(mesh))
  {
    return oriented;
  }

  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    points.push_back(pointOf(mesh.Vertices, v));
  }
  std::vector<std::array<std::size_t, 3>> polygons(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      polygons[f][k] = mesh.Faces(f, k);
    }
  }
  OrientationRecord record;
  record.Result = &oriented;
  PMP::orient_polygon_soup(points, polygons, CGAL::parameters::visitor(record));

  oriented.Mesh.Vertices.conservativeResize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = mesh.vertexCount(); v < points.size(); ++v)
  {
    oriented.Mesh.Vertices.row(static_cast<Eigen::Index>(v)) = mesh.Vertices.row(oriented.CopyOf[v]);
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      oriented.Mesh.Faces(f, k) = static_cast<int>(polygons[f][k]);
    }
  }
  if (points.size() > static_cast<std::size_t>(mesh.vertexCount()))
  {
    markOneSidedEdges(oriented, mesh.Faces);
  }
  return oriented;
}

int orientOutward(TriangleMesh& component, const std::vector<char>& reversed, bool closed)
{
  const int faces = component.faceCount();
  double volume = 0.0;       // six times the volume; about the centroid, to lose fewer digits
  double reversedArea = 0.0; // area of the reversed faces minus area of the others
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

DerivedMesh stitchCoincidentBorders(const TriangleMesh& mesh)
{
  EditableSurface surface(mesh);
  PMP::stitch_borders(surface.mesh());
  return surface.derived();
}

} // namespace flattening
