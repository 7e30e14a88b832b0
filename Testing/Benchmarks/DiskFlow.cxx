// SPDX-License-Identifier: GPL-3.0-or-later
#include "DiskFlow.h"

#include <algorithm>

namespace flattening::benchmarks
{
namespace
{

constexpr double LeastShare = 0.2; // of a face's area, after a step

Eigen::RowVector2d turned(const Eigen::RowVector2d& v)
{
  return { -v.y(), v.x() };
}

// The vector from corner k + 1 to corner k + 2.
Eigen::RowVector2d side(const Points2& positions, const FaceMatrix& faces, Eigen::Index f, int k)
{
  return positions.row(faces(f, (k + 2) % 3)) - positions.row(faces(f, (k + 1) % 3));
}

} // namespace

SparseMatrix stiffness(const Points2& positions, const FaceMatrix& faces)
{
  const Eigen::VectorXd areas = signedFaceAreas(positions, faces);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector2d own = side(positions, faces, f, k);
      for (int l = 0; l < 3; ++l)
      {
        if (faces(f, k) >= faces(f, l))
        {
          entries.emplace_back(
            faces(f, k), faces(f, l), own.dot(side(positions, faces, f, l)) / (4.0 * areas[f]));
        }
      }
    }
  }
  SparseMatrix matrix(positions.rows(), positions.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

FaceVectors faceGradients(const Points2& positions,
  const FaceMatrix& faces,
  const Eigen::VectorXd& values)
{
  const Eigen::VectorXd areas = signedFaceAreas(positions, faces);
  FaceVectors gradients = FaceVectors::Zero(faces.rows(), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      gradients.row(f) += values[faces(f, k)] / (2.0 * areas[f]) * turned(side(positions, faces, f, k));
    }
  }
  return gradients;
}

FaceVectors vertexMeans(const FaceMatrix& faces,
  const FaceVectors& values,
  const Eigen::VectorXd& areas,
  int vertexCount)
{
  FaceVectors sums = FaceVectors::Zero(vertexCount, 2);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(vertexCount);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sums.row(faces(f, k)) += areas[f] * values.row(f);
      shares[faces(f, k)] += areas[f];
    }
  }
  return shares.cwiseInverse().asDiagonal() * sums;
}

double advance(Points2& positions,
  const FaceVectors& velocity,
  double time,
  double shortest,
  const FaceMatrix& faces,
  const std::vector<int>& boundary)
{
  const Eigen::VectorXd before = signedFaceAreas(positions, faces);
  for (double part = time; part >= shortest; part *= 0.5)
  {
    Points2 moved = positions + part * velocity;
    for (const int v : boundary)
    {
      moved.row(v).normalize();
    }
    const Eigen::VectorXd after = signedFaceAreas(moved, faces);
    if ((after.array() > LeastShare * before.array()).all())
    {
      positions = moved;
      return part;
    }
  }
  return 0.0;
}

} // namespace flattening::benchmarks
