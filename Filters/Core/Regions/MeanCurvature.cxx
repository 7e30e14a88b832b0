// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/MeanCurvature.h"

#include "Base/Errors.h"
#include "Mesh/FaceSides.h"

#include <Eigen/Geometry>

#include <cmath>

namespace flattening
{

Eigen::VectorXd integratedMeanCurvature(const TriangleMesh& mesh)
{
  if (!mesh.Vertices.allFinite())
  {
    throw InvalidInput("the surface has coordinates that are not finite: clean the data first");
  }
  Points3 normals(mesh.faceCount(), 3); // of length zero on degenerate faces
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::RowVector3d a = mesh.Vertices.row(mesh.Faces(f, 0));
    const Eigen::RowVector3d u = mesh.Vertices.row(mesh.Faces(f, 1)) - a;
    const Eigen::RowVector3d v = mesh.Vertices.row(mesh.Faces(f, 2)) - a;
    normals.row(f) = u.cross(v).stableNormalized();
  }
  Eigen::VectorXd measure = Eigen::VectorXd::Zero(mesh.vertexCount());
  forEachEdge(sortedSides(mesh.Faces),
    [&](const FaceSide* sides, int count)
    {
      if (count != 2 || sides[0].From == sides[1].From)
      {
        return;
      }
      const bool firstAscends = sides[0].From < sides[0].To;
      const FaceSide& left = sides[firstAscends ? 0 : 1];
      const FaceSide& right = sides[firstAscends ? 1 : 0];
      const Eigen::RowVector3d edge = mesh.Vertices.row(left.To) - mesh.Vertices.row(left.From);
      const Eigen::RowVector3d n = normals.row(left.face());
      const Eigen::RowVector3d m = normals.row(right.face());
      const double length = edge.norm();
      if (!(length > 0.0) || n.isZero(0.0) || m.isZero(0.0))
      {
        return;
      }
      // The angle is positive at a convex edge.
      const double angle = std::atan2(n.cross(m).dot(edge) / length, n.dot(m));
      measure[left.From] += 0.25 * length * angle;
      measure[left.To] += 0.25 * length * angle;
    });
  return measure;
}

} // namespace flattening
