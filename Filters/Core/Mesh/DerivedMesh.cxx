// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/DerivedMesh.h"

#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{

DerivedMesh derivedFromItself(TriangleMesh mesh)
{
  DerivedMesh derived;
  derived.Vertices.resize(mesh.vertexCount(), mesh.vertexCount());
  derived.Vertices.setIdentity();
  derived.Faces.resize(mesh.faceCount());
  std::iota(derived.Faces.begin(), derived.Faces.end(), 0);
  derived.Mesh = std::move(mesh);
  return derived;
}

Origin originOf(const FaceMatrix& faces, int face, const std::array<double, 3>& weights)
{
  Origin origin;
  for (int k = 0; k < 3; ++k)
  {
    if (weights[k] > 0.0)
    {
      origin.emplace_back(faces(face, k), weights[k]);
    }
  }
  return origin;
}

Origin combined(const std::vector<std::pair<Origin, double>>& parts)
{
  std::map<int, double> weights;
  for (const auto& [origin, share] : parts)
  {
    for (const auto& [vertex, weight] : origin)
    {
      weights[vertex] += share * weight;
    }
  }
  return { weights.begin(), weights.end() };
}

VertexOrigins keptVertices(const std::vector<int>& original, int originalCount)
{
  return originMatrix(original, originalCount, [](int v) { return Origin{ { v, 1.0 } }; });
}

void follow(DerivedMesh& derived, DerivedMesh&& next)
{
  derived.Vertices = VertexOrigins(next.Vertices * derived.Vertices);
  for (int& face : next.Faces)
  {
    face = face < 0 ? -1 : derived.Faces[face];
  }
  derived.Faces = std::move(next.Faces);
  derived.Mesh = std::move(next.Mesh);
}

DerivedMesh extractFaces(const TriangleMesh& mesh, const std::vector<int>& faces)
{
  std::vector<int> index(mesh.vertexCount(), -1);
  for (const int f : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      index[mesh.Faces(f, k)] = 0;
    }
  }
  std::vector<int> original;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (index[v] == 0)
    {
      index[v] = static_cast<int>(original.size());
      original.push_back(v);
    }
  }

  DerivedMesh part;
  part.Mesh.Vertices.resize(static_cast<Eigen::Index>(original.size()), 3);
  for (std::size_t v = 0; v < original.size(); ++v)
  {
    part.Mesh.Vertices.row(v) = mesh.Vertices.row(original[v]);
  }
  part.Mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      part.Mesh.Faces(f, k) = index[mesh.Faces(faces[f], k)];
    }
  }
  part.Vertices = keptVertices(original, mesh.vertexCount());
  part.Faces = faces;
  return part;
}

} // namespace flattening
