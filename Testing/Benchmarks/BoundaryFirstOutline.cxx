// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryFirstOutline.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening::benchmarks
{
namespace
{

// The cotangent Laplacian, split into inner and boundary vertices, and the angle sums.
class CotangentSystem
{
public:
  CotangentSystem(const TriangleMesh& mesh, const std::vector<int>& loop)
    : AngleSums(Eigen::VectorXd::Zero(mesh.vertexCount()))
    , Index(mesh.vertexCount(), 0)
  {
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      this->Index[loop[k]] = -1 - static_cast<int>(k);
    }
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (this->Index[v] >= 0)
      {
        this->Index[v] = static_cast<int>(this->Inner.size());
        this->Inner.push_back(v);
      }
    }
    std::vector<Eigen::Triplet<double>> inner;
    std::vector<Eigen::Triplet<double>> mixed;
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      const Eigen::Matrix3d corners = faceCorners(mesh, f);
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::RowVector3d a = corners.row((k + 1) % 3) - corners.row(k);
        const Eigen::RowVector3d b = corners.row((k + 2) % 3) - corners.row(k);
        const double area = a.cross(b).norm();
        this->AngleSums[mesh.Faces(f, k)] += std::atan2(area, a.dot(b));
        this->addEdge(
          mesh.Faces(f, (k + 1) % 3), mesh.Faces(f, (k + 2) % 3), 0.5 * a.dot(b) / area, inner, mixed);
      }
    }
    SparseMatrix matrix(this->Inner.size(), this->Inner.size());
    matrix.setFromTriplets(inner.begin(), inner.end());
    this->Coupling.resize(this->Inner.size(), loop.size());
    this->Coupling.setFromTriplets(mixed.begin(), mixed.end());
    this->Cholesky.compute(matrix);
    if (this->Cholesky.info() != Eigen::Success)
    {
      throw ConvergenceError("Boundary First Flattening: the Laplacian could not be factored");
    }
  }

  Eigen::VectorXd AngleSums;
  std::vector<int> Inner;
  SparseMatrix Coupling; // of inner with boundary vertices
  SparseCholesky Cholesky;

private:
  void addEdge(int i,
    int j,
    double weight,
    std::vector<Eigen::Triplet<double>>& inner,
    std::vector<Eigen::Triplet<double>>& mixed) const
  {
    const int rowI = this->Index[i];
    const int rowJ = this->Index[j];
    for (const int row : { rowI, rowJ })
    {
      if (row >= 0)
      {
        inner.emplace_back(row, row, weight);
      }
    }
    if (rowI >= 0 && rowJ >= 0)
    {
      inner.emplace_back(std::max(rowI, rowJ), std::min(rowI, rowJ), -weight);
    }
    else if (rowI >= 0 || rowJ >= 0)
    {
      mixed.emplace_back(std::max(rowI, rowJ), -1 - std::min(rowI, rowJ), -weight);
    }
  }

  std::vector<int> Index; // of an inner vertex; -1 - k of vertex k of the loop
};

// The exterior angles of the outline if the factors are 0 on the boundary.
Eigen::VectorXd outlineAngles(const CotangentSystem& system, const std::vector<int>& loop)
{
  Eigen::VectorXd curvature(system.Inner.size());
  for (std::size_t i = 0; i < system.Inner.size(); ++i)
  {
    curvature[i] = 2.0 * EIGEN_PI - system.AngleSums[system.Inner[i]];
  }
  const Eigen::VectorXd factors = -system.Cholesky.solve(curvature);
  Eigen::VectorXd angles = system.Coupling.transpose() * factors;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    angles[k] += EIGEN_PI - system.AngleSums[loop[k]];
  }
  return angles;
}

// The closed polygon with these exterior angles and nearly these lengths of sides.
Points2 closedOutline(const Eigen::VectorXd& angles, const Eigen::VectorXd& lengths)
{
  const Eigen::Index n = lengths.size();
  Eigen::MatrixXd tangents(2, n);
  double direction = 0.0;
  for (Eigen::Index k = 0; k < n; ++k)
  {
    direction += angles[k];
    tangents.col(k) << std::cos(direction), std::sin(direction);
  }
  const Eigen::Matrix2d system = tangents * lengths.asDiagonal() * tangents.transpose();
  const Eigen::VectorXd closed =
    lengths - lengths.asDiagonal() * tangents.transpose() * system.inverse() * (tangents * lengths);
  Points2 outline = Points2::Zero(n, 2);
  for (Eigen::Index k = 0; k + 1 < n; ++k)
  {
    outline.row(k + 1) = outline.row(k) + closed[k] * tangents.col(k).transpose();
  }
  return outline;
}

} // namespace

Points2 naturalBoundaryMap(const TriangleMesh& mesh)
{
  const std::vector<int> loop = requireDisk(mesh);
  const CotangentSystem system(mesh, loop);
  Eigen::VectorXd lengths(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    lengths[k] = (mesh.Vertices.row(loop[(k + 1) % loop.size()]) - mesh.Vertices.row(loop[k])).norm();
  }
  const Points2 outline = closedOutline(outlineAngles(system, loop), lengths);
  const Eigen::MatrixXd inner = system.Cholesky.solve(Eigen::MatrixXd(-system.Coupling * outline));
  Points2 positions(mesh.vertexCount(), 2);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    positions.row(loop[k]) = outline.row(k);
  }
  for (std::size_t i = 0; i < system.Inner.size(); ++i)
  {
    positions.row(system.Inner[i]) = inner.row(i);
  }
  return positions;
}

} // namespace flattening::benchmarks
