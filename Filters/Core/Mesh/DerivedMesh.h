// SPDX-License-Identifier: GPL-3.0-or-later
/// A mesh made from another one that remembers where its vertices and faces came from, so that any
/// attribute of the original can be carried over.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace flattening
{

/// For a mesh of n vertices made from m original vertices, an n x m matrix. Row v says what vertex v is
/// made of: element (v, o) is the weight (>= 0) of original vertex o, and the sum of the row is 1. A
/// kept vertex has one weight 1; the midpoint of an edge has two weights 1/2. A vertex that was moved
/// and takes the attributes of an original one has further weights, which are 0.
using VertexOrigins = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// A row of that matrix: original vertices, each once, and their weights.
using Origin = std::vector<std::pair<int, double>>;

/// A point of the face in row @p face of @p faces is made of the corners whose barycentric weight is not
/// 0.
Origin originOf(const FaceMatrix& faces, int face, const std::array<double, 3>& weights);

/// The origin of a vertex that is made of others, each given by its origin and its weight.
Origin combined(const std::vector<std::pair<Origin, double>>& parts);

/// The matrix with a row for each of @p vertices, a range: the Origin that @p originAt returns for it.
template <typename Vertices, typename OriginAt>
VertexOrigins originMatrix(const Vertices& vertices, int originalCount, const OriginAt& originAt)
{
  VertexOrigins origins(static_cast<Eigen::Index>(vertices.size()), originalCount);
  origins.reserve(3 * origins.rows()); // mostly the corners of a face
  int row = 0;
  for (const auto& vertex : vertices)
  {
    Origin origin = originAt(vertex);
    std::sort(origin.begin(), origin.end());
    origins.startVec(row);
    for (const auto& [original, weight] : origin)
    {
      origins.insertBackByOuterInner(row, original) = weight;
    }
    ++row;
  }
  origins.finalize();
  return origins;
}

/// A mesh and its origins.
struct DerivedMesh
{
  TriangleMesh Mesh;
  VertexOrigins Vertices;
  /// The original face that each face is a part of or, on a remeshed surface, lies nearest to; -1 for
  /// a face that fills a hole.
  std::vector<int> Faces;
};

/// The mesh with its own vertices and faces as origins.
DerivedMesh derivedFromItself(TriangleMesh mesh);

/// Origins with a single weight 1 per row: vertex v is the original vertex @p original[v].
VertexOrigins keptVertices(const std::vector<int>& original, int originalCount);

/// Replaces @p derived by @p next, a mesh that was derived from derived.Mesh. The origins of the result
/// refer to the mesh from which @p derived was derived, not to derived.Mesh.
void follow(DerivedMesh& derived, DerivedMesh&& next);

/// The part of @p mesh that consists of the given faces, in their order. Vertices keep their order in
/// the mesh.
DerivedMesh extractFaces(const TriangleMesh& mesh, const std::vector<int>& faces);

} // namespace flattening
