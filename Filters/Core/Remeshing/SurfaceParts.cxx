// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/SurfaceParts.h"

#include "Repair/ConsistentOrientation.h"

#include <tbb/parallel_for.h>

#include <cstddef>
#include <utility>

namespace flattening
{
namespace
{

// Per vertex: the part that has all of its faces, or -1 if several have some.
std::vector<int> partOfVertex(const FaceMatrix& faces,
  const std::vector<int>& partOfFace,
  int vertexCount)
{
  constexpr int None = -2;
  std::vector<int> part(vertexCount, None);
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      int& ofVertex = part[faces(f, k)];
      ofVertex = ofVertex == None || ofVertex == partOfFace[f] ? partOfFace[f] : -1;
    }
  }
  return part;
}

// Marks the vertices of faces with a vertex that has copies.
void keepAroundCopies(const OrientedMesh& mesh, std::vector<char>& kept)
{
  std::vector<char> hasCopies(mesh.CopyOf.size(), 0);
  for (std::size_t v = 0; v < mesh.CopyOf.size(); ++v)
  {
    if (mesh.CopyOf[v] != static_cast<int>(v))
    {
      hasCopies[v] = hasCopies[mesh.CopyOf[v]] = 1;
    }
  }
  const FaceMatrix& faces = mesh.Mesh.Faces;
  for (int f = 0; f < faces.rows(); ++f)
  {
    if (hasCopies[faces(f, 0)] || hasCopies[faces(f, 1)] || hasCopies[faces(f, 2)])
    {
      kept[faces(f, 0)] = kept[faces(f, 1)] = kept[faces(f, 2)] = 1;
    }
  }
}

SurfacePart cutPart(const PlacedMesh& whole,
  const std::vector<int>& faces,
  const std::vector<int>& partOfVertex)
{
  const DerivedMesh extracted = extractFaces(whole.Mesh, faces);
  OrientedMesh separated = orientConsistently(extracted.Mesh);
  SurfacePart part;
  for (const int v : separated.CopyOf)
  {
    const int inWhole = extracted.Vertices.innerIndexPtr()[v];
    const bool shared = partOfVertex[inWhole] < 0;
    part.Shared.push_back(shared ? inWhole : -1);
    part.Kept.push_back(static_cast<char>(shared));
    part.Surface.Places.push_back(whole.Places[inWhole]);
  }
  keepAroundCopies(separated, part.Kept);
  part.Surface.Mesh = std::move(separated.Mesh);
  return part;
}

} // namespace

std::vector<SurfacePart> cutIntoParts(const PlacedMesh& whole,
  const std::vector<int>& partOfFace,
  int count)
{
  std::vector<std::vector<int>> faces(count);
  for (std::size_t f = 0; f < partOfFace.size(); ++f)
  {
    faces[partOfFace[f]].push_back(static_cast<int>(f));
  }
  const std::vector<int> ofVertex = partOfVertex(whole.Mesh.Faces, partOfFace, whole.Mesh.vertexCount());
  std::vector<SurfacePart> parts(count);
  tbb::parallel_for(0, count, [&](int p) { parts[p] = cutPart(whole, faces[p], ofVertex); });
  return parts;
}

SurfacePart remeshedPart(const SurfacePart& part, const MeshOnSurface& surface)
{
  SurfacePart remeshed;
  remeshed.Surface = surface.placed();
  for (const MeshOnSurface::Vertex v : surface.mesh().vertices())
  {
    // A kept vertex keeps its number; others may have taken those of vertices that were removed.
    remeshed.Shared.push_back(v.idx() < part.Shared.size() ? part.Shared[v.idx()] : -1);
  }
  return remeshed;
}

PlacedMesh joinedParts(const std::vector<SurfacePart>& parts, int vertexCount)
{
  Eigen::Index faces = 0;
  std::vector<int> numberOfShared(vertexCount, -1);
  std::vector<std::vector<int>> numbers;
  std::vector<std::pair<int, int>> vertices; // part and vertex, in the order of the result
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    faces += parts[p].Surface.Mesh.Faces.rows();
    std::vector<int>& number = numbers.emplace_back();
    for (std::size_t v = 0; v < parts[p].Shared.size(); ++v)
    {
      const int shared = parts[p].Shared[v];
      if (shared < 0 || numberOfShared[shared] < 0)
      {
        number.push_back(static_cast<int>(vertices.size()));
        vertices.emplace_back(static_cast<int>(p), static_cast<int>(v));
      }
      else
      {
        number.push_back(numberOfShared[shared]);
      }
      if (shared >= 0)
      {
        numberOfShared[shared] = number.back();
      }
    }
  }

  PlacedMesh whole;
  whole.Mesh.Vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  whole.Places.reserve(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
  {
    const PlacedMesh& surface = parts[vertices[v].first].Surface;
    whole.Mesh.Vertices.row(static_cast<Eigen::Index>(v)) =
      surface.Mesh.Vertices.row(vertices[v].second);
    whole.Places.push_back(surface.Places[vertices[v].second]);
  }
  whole.Mesh.Faces.resize(faces, 3);
  Eigen::Index row = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const FaceMatrix& ofPart = parts[p].Surface.Mesh.Faces;
    for (int f = 0; f < ofPart.rows(); ++f, ++row)
    {
      for (int k = 0; k < 3; ++k)
      {
        whole.Mesh.Faces(row, k) = numbers[p][ofPart(f, k)];
      }
    }
  }
  return whole;
}

} // namespace flattening
