// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ClosestPointWalk.h"

#include <Eigen/Geometry>

namespace flattening
{
namespace
{

// The share of the way at which a linear function that is `towards` at the start and -`beyond` at the
// end is 0.
double shareAlong(double towards, double beyond)
{
  return towards + beyond > 0.0 ? towards / (towards + beyond) : 0.0;
}

// The barycentric coordinates of the point of a triangle (one corner per row) closest to `point`
// (Ericson 2005, "Real-time collision detection", section 5.1.5). The triangle may be without area.
std::array<double, 3> closestWeights(const Eigen::Matrix3d& corners, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d a = corners.row(0);
  const Eigen::Vector3d b = corners.row(1);
  const Eigen::Vector3d c = corners.row(2);
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double abToA = ab.dot(point - a);
  const double acToA = ac.dot(point - a);
  if (abToA <= 0.0 && acToA <= 0.0)
  {
    return { 1.0, 0.0, 0.0 };
  }
  const double abToB = ab.dot(point - b);
  const double acToB = ac.dot(point - b);
  if (abToB >= 0.0 && acToB <= abToB)
  {
    return { 0.0, 1.0, 0.0 };
  }
  const double abToC = ab.dot(point - c);
  const double acToC = ac.dot(point - c);
  if (acToC >= 0.0 && abToC <= acToC)
  {
    return { 0.0, 0.0, 1.0 };
  }
  const double outsideAb = abToA * acToB - abToB * acToA;
  if (outsideAb <= 0.0 && abToA >= 0.0 && abToB <= 0.0)
  {
    const double t = shareAlong(abToA, -abToB);
    return { 1.0 - t, t, 0.0 };
  }
  const double outsideAc = abToC * acToA - abToA * acToC;
  if (outsideAc <= 0.0 && acToA >= 0.0 && acToC <= 0.0)
  {
    const double t = shareAlong(acToA, -acToC);
    return { 1.0 - t, 0.0, t };
  }
  const double outsideBc = abToB * acToC - abToC * acToB;
  if (outsideBc <= 0.0 && acToB >= abToB && abToC >= acToC)
  {
    const double t = shareAlong(acToB - abToB, abToC - acToC);
    return { 0.0, 1.0 - t, t };
  }
  const double sum = outsideAb + outsideAc + outsideBc;
  return { outsideBc / sum, outsideAc / sum, outsideAb / sum };
}

SurfacePoint closestOnFace(const TriangleMesh& mesh, int face, const Eigen::Vector3d& point)
{
  const Eigen::Matrix3d corners = faceCorners(mesh, face);
  SurfacePoint result;
  result.Face = face;
  result.Weights = closestWeights(corners, point);
  result.Position = corners.transpose() * Eigen::Map<const Eigen::Vector3d>(result.Weights.data());
  return result;
}

} // namespace

Points3 vertexNormals(const TriangleMesh& mesh)
{
  Points3 normals = Points3::Zero(mesh.vertexCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::Matrix3d corners = faceCorners(mesh, f);
    const Eigen::Vector3d u = corners.row(1) - corners.row(0);
    const Eigen::Vector3d v = corners.row(2) - corners.row(0);
    const Eigen::RowVector3d areaVector = u.cross(v).transpose();
    for (int k = 0; k < 3; ++k)
    {
      normals.row(mesh.Faces(f, k)) += areaVector;
    }
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double length = normals.row(v).norm(); // normalize() would leave tiny surfaces as they are
    if (length > 0.0)
    {
      normals.row(v) /= length;
    }
  }
  return normals;
}

ClosestPointWalk::ClosestPointWalk(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Around(mesh.Faces, mesh.vertexCount())
  , Normals(vertexNormals(mesh))
{
}

SurfacePoint ClosestPointWalk::closest(const Eigen::Vector3d& point, int startFace) const
{
  SurfacePoint best = closestOnFace(this->Mesh, startFace, point);
  double bestDistance = (best.Position - point).squaredNorm();
  for (int centre = -1; centre != best.Face;)
  {
    centre = best.Face;
    const std::array<double, 3> weights = best.Weights;
    if (weights[0] > 0.0 && weights[1] > 0.0 && weights[2] > 0.0)
    {
      return best; // inside the face, from where the distance grows in every direction
    }
    // Only faces that share the point with this one can be nearer: the faces around a corner, or the
    // face across a side.
    const int k = weights[0] > 0.0 ? 0 : weights[1] > 0.0 ? 1 : 2;
    const int other = weights[(k + 1) % 3] > 0.0   ? (k + 1) % 3
                      : weights[(k + 2) % 3] > 0.0 ? (k + 2) % 3
                                                   : k;
    const int vertex = this->Mesh.Faces(centre, k);
    const int second = this->Mesh.Faces(centre, other);
    const auto hasCorner = [this](int face, int corner)
    { return (this->Mesh.Faces.row(face).array() == corner).any(); };
    for (const int face : this->Around.aroundEither(vertex, second))
    {
      if (face == centre || !hasCorner(face, vertex) || !hasCorner(face, second))
      {
        continue;
      }
      const SurfacePoint at = closestOnFace(this->Mesh, face, point);
      const double distance = (at.Position - point).squaredNorm();
      if (distance < bestDistance)
      {
        bestDistance = distance;
        best = at;
      }
    }
  }
  return best;
}

Eigen::Vector3d ClosestPointWalk::normal(const SurfacePoint& at) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += at.Weights[k] * this->Normals.row(this->Mesh.Faces(at.Face, k)).transpose();
  }
  const double length = sum.norm();
  return length > 0.0 ? Eigen::Vector3d(sum / length) : sum;
}

} // namespace flattening
