// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/MeanCurvature.h"

#include "Base/Errors.h"

#include <Eigen/Geometry>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace flattening
{
namespace
{

// A side of a face, between the vertices Low < High.
struct Side
{
  int Low;
  int High;
  int Face;
  bool Ascending; // the face runs from Low to High

  bool operator<(const Side& other) const
  {
    return std::tie(this->Low, this->High, this->Face, this->Ascending) <
           std::tie(other.Low, other.High, other.Face, other.Ascending);
  }
  bool sameEdge(const Side& other) const { return this->Low == other.Low && this->High == other.High; }
};

std::vector<Side> sortedSides(const FaceMatrix& faces)
{
  std::vector<Side> sides;
  sides.reserve(3 * static_cast<std::size_t>(faces.rows()));
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = faces(f, k);
      const int b = faces(f, (k + 1) % 3);
      sides.push_back({ std::min(a, b), std::max(a, b), f, a < b });
    }
  }
  tbb::parallel_sort(sides.begin(), sides.end());
  return sides;
}

} // namespace

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
  const std::vector<Side> sides = sortedSides(mesh.Faces);
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end)
  {
    end = first + 1;
    while (end < sides.size() && sides[end].sameEdge(sides[first]))
    {
      ++end;
    }
    if (end != first + 2 || sides[first].Ascending == sides[first + 1].Ascending)
    {
      continue;
    }
    const Side& left = sides[sides[first].Ascending ? first : first + 1];
    const Side& right = sides[sides[first].Ascending ? first + 1 : first];
    const Eigen::RowVector3d edge = mesh.Vertices.row(left.High) - mesh.Vertices.row(left.Low);
    const Eigen::RowVector3d n = normals.row(left.Face);
    const Eigen::RowVector3d m = normals.row(right.Face);
    const double length = edge.norm();
    if (!(length > 0.0) || n.isZero(0.0) || m.isZero(0.0))
    {
      continue;
    }
    // The angle is positive at a convex edge.
    const double angle = std::atan2(n.cross(m).dot(edge) / length, n.dot(m));
    measure[left.Low] += 0.25 * length * angle;
    measure[left.High] += 0.25 * length * angle;
  }
  return measure;
}

} // namespace flattening
