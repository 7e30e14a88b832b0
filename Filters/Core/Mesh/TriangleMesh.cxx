// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleMesh.h"

#include "Mesh/PlaneVectors.h"

#include <Eigen/Geometry>

namespace flattening
{

Eigen::Matrix3d faceCorners(const TriangleMesh& mesh, int face)
{
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k)
  {
    corners.row(k) = mesh.Vertices.row(mesh.Faces(face, k));
  }
  return corners;
}

Eigen::VectorXd faceAreas(const Points3& vertices, const FaceMatrix& faces)
{
  Eigen::VectorXd areas(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    const Eigen::Vector3d a = vertices.row(faces(f, 0));
    const Eigen::Vector3d b = vertices.row(faces(f, 1));
    const Eigen::Vector3d c = vertices.row(faces(f, 2));
    areas[f] = 0.5 * (b - a).cross(c - a).norm();
  }
  return areas;
}

Eigen::VectorXd signedFaceAreas(const Points2& positions, const FaceMatrix& faces)
{
  Eigen::VectorXd areas(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    const Eigen::RowVector2d a = positions.row(faces(f, 0));
    const Eigen::RowVector2d u = positions.row(faces(f, 1)) - a;
    const Eigen::RowVector2d v = positions.row(faces(f, 2)) - a;
    areas[f] = 0.5 * cross(u, v);
  }
  return areas;
}

Eigen::VectorXd vertexAreas(const FaceMatrix& faces, const Eigen::VectorXd& faceMeasure, int vertexCount)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(vertexCount);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      areas[faces(f, k)] += faceMeasure[f] / 3.0;
    }
  }
  return areas;
}

Eigen::VectorXd vertexAreas(const TriangleMesh& mesh)
{
  return vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), mesh.vertexCount());
}

} // namespace flattening
