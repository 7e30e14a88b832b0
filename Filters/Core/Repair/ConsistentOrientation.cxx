// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/ConsistentOrientation.h"

#include "Mesh/EditableSurface.h"
#include "Mesh/FaceSides.h"

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

// Records what CGAL reverses and copies.
struct OrientationRecord : PMP::Default_orientation_visitor
{
  std::vector<char>* Reversed = nullptr; // per face
  std::vector<int>* CopyOf = nullptr;    // per vertex

  void polygon_orientation_reversed(std::size_t face) { (*this->Reversed)[face] ^= 1; }
  void duplicated_vertex(std::size_t original, std::size_t copy)
  {
    this->CopyOf->resize(std::max(this->CopyOf->size(), copy + 1));
    (*this->CopyOf)[copy] = (*this->CopyOf)[original];
  }
};

// The part of a mesh that orienting it may change.
struct PartToOrient
{
  std::vector<int> Faces;
  std::vector<char> MayBeCut; // per vertex of the mesh
};

// That is nothing of an oriented manifold. Where faces agree in orientation with their neighbours, it is
// only the faces around the vertices at which the surface must be cut; else it is everything.
PartToOrient partToOrient(const TriangleMesh& mesh)
{
  const std::vector<FaceSide> sides = sortedSides(mesh.Faces);
  bool disagree = false;
  forEachEdge(sides,
    [&disagree](const FaceSide* side, int count)
    { disagree = disagree || (count == 2 && side[0].From == side[1].From); });
  PartToOrient part;
  part.MayBeCut.assign(mesh.vertexCount(), static_cast<char>(disagree));
  for (const int v : verticesOfSeveralFans(mesh.Faces, oppositeHalfedges(sides), mesh.vertexCount()))
  {
    part.MayBeCut[v] = 1;
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto corners = mesh.Faces.row(f);
    if (part.MayBeCut[corners[0]] || part.MayBeCut[corners[1]] || part.MayBeCut[corners[2]])
    {
      part.Faces.push_back(f);
    }
  }
  return part;
}

// A mesh after its faces were oriented and its vertices copied.
struct CutMesh
{
  std::vector<std::array<std::size_t, 3>> Faces;
  std::vector<int> CopyOf;    // per vertex, those of the mesh first
  std::vector<char> Reversed; // per face
};

CutMesh orientAndCut(const TriangleMesh& mesh)
{
  CutMesh result;
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    points.push_back(pointOf(mesh.Vertices, v));
  }
  result.Faces.resize(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.Faces[f][k] = mesh.Faces(f, k);
    }
  }
  result.CopyOf.resize(mesh.vertexCount());
  std::iota(result.CopyOf.begin(), result.CopyOf.end(), 0);
  result.Reversed.assign(mesh.faceCount(), 0);
  OrientationRecord record;
  record.CopyOf = &result.CopyOf;
  record.Reversed = &result.Reversed;
  PMP::orient_polygon_soup(points, result.Faces, CGAL::parameters::visitor(record));
  return result;
}

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

// The faces beside one-sided edges: an edge of just two faces is cut only if no orientation suits both.
std::vector<char> facesBesideOneSidedEdges(const FaceMatrix& before, const FaceMatrix& after)
{
  std::vector<char> oneSided(before.rows(), 0);
  const std::vector<std::pair<int, int>> joined = neighbours(after);
  for (const auto& pair : neighbours(before))
  {
    if (!std::binary_search(joined.begin(), joined.end(), pair))
    {
      oneSided[pair.first] = oneSided[pair.second] = 1;
    }
  }
  return oneSided;
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
  const PartToOrient part = partToOrient(mesh);
  if (part.Faces.empty())
  {
    return oriented;
  }

  const DerivedMesh before = extractFaces(mesh, part.Faces);
  const CutMesh cut = orientAndCut(before.Mesh);
  std::vector<int> number(cut.CopyOf.size()); // that each vertex gets in the result
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    const int original = before.Vertices.innerIndexPtr()[cut.CopyOf[v]];
    number[v] = original;
    // A vertex that has further faces outside of the part stays one.
    if (static_cast<int>(v) >= before.Mesh.vertexCount() && part.MayBeCut[original])
    {
      number[v] = static_cast<int>(oriented.CopyOf.size());
      oriented.CopyOf.push_back(original);
    }
  }
  const Eigen::Index count = static_cast<Eigen::Index>(oriented.CopyOf.size());
  oriented.Mesh.Vertices.conservativeResize(count, 3);
  for (Eigen::Index v = mesh.vertexCount(); v < count; ++v)
  {
    oriented.Mesh.Vertices.row(v) = mesh.Vertices.row(oriented.CopyOf[v]);
  }
  FaceMatrix after(before.Mesh.faceCount(), 3);
  for (int f = 0; f < before.Mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      after(f, k) = number[cut.Faces[f][k]];
    }
  }
  const std::vector<char> oneSided = facesBesideOneSidedEdges(before.Mesh.Faces, after);
  for (int f = 0; f < before.Mesh.faceCount(); ++f)
  {
    oriented.Mesh.Faces.row(part.Faces[f]) = after.row(f);
    oriented.Reversed[part.Faces[f]] = cut.Reversed[f];
    oriented.OneSided[part.Faces[f]] = oneSided[f];
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
