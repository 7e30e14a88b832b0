// SPDX-License-Identifier: GPL-3.0-or-later
/// A mesh made from another one that remembers where its vertices and faces came from, so that any
/// attribute of the original can be carried over.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/SparseCore>

#include <vector>

namespace flattening
{

/// For a mesh of n vertices made from m original vertices, an n x m matrix. Row v says what vertex v is
/// made of: element (v, o) is the weight (>= 0) of original vertex o, and the sum of the row is 1. A
/// kept vertex has one weight 1; the midpoint of an edge has two weights 1/2.
using VertexOrigins = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

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
