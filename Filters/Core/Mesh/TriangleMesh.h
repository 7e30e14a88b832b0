// SPDX-License-Identifier: GPL-3.0-or-later
/// The indexed triangle mesh on which all of Core works.
#pragma once

#include <Eigen/Core>

namespace flattening
{

/// n x 3, input units (mm for scanner data). One row per vertex.
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// n x 2, positions in the flat domain. One row per vertex.
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// m x 3, vertex indices, counter-clockwise seen from outside. One row per face.
using FaceMatrix = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

struct TriangleMesh
{
  Points3 Vertices;
  FaceMatrix Faces;

  int vertexCount() const { return static_cast<int>(this->Vertices.rows()); }
  int faceCount() const { return static_cast<int>(this->Faces.rows()); }
};

/// The corners of face @p face, one row each.
Eigen::Matrix3d faceCorners(const TriangleMesh& mesh, int face);

/// Area of every face (m), input units squared.
Eigen::VectorXd faceAreas(const Points3& vertices, const FaceMatrix& faces);

/// Signed area of every face of a flat mesh (m); negative where a face is flipped.
Eigen::VectorXd signedFaceAreas(const Points2& positions, const FaceMatrix& faces);

/// A third of the sum of the areas of the faces around every vertex (n): the measure mu of the paper,
/// section 4.1. @p faceMeasure (m) may be the areas or any other measure of the faces.
Eigen::VectorXd vertexAreas(const FaceMatrix& faces,
  const Eigen::VectorXd& faceMeasure,
  int vertexCount);
/// The same of the areas of the faces of @p mesh, input units squared.
Eigen::VectorXd vertexAreas(const TriangleMesh& mesh);

} // namespace flattening
