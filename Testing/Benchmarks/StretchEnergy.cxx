// SPDX-License-Identifier: GPL-3.0-or-later
#include "StretchEnergy.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Conformal/BoundaryAngles.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening::benchmarks
{
namespace
{

// The weight of the edge opposite corner k of each face: half the cotangent at that corner times the
// weight of the face (m x 3). A face with corners p: cot = dot / (2 area).
template <typename Points>
Points3 edgeWeights(const Points& positions, const FaceMatrix& faces, const Eigen::VectorXd& perDot)
{
  Points3 weights(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto corner = positions.row(faces(f, k));
      const auto a = positions.row(faces(f, (k + 1) % 3)) - corner;
      const auto b = positions.row(faces(f, (k + 2) % 3)) - corner;
      weights(f, k) = a.dot(b) * perDot[f];
    }
  }
  return weights;
}

// Solves Laplace's equation for the free vertices with given values at all others. All matrices have the
// same pattern.
class DirichletProblem
{
public:
  DirichletProblem(const FaceMatrix& faces, const std::vector<int>& free, int vertexCount)
    : Faces(faces)
    , Row(vertexCount, -1)
    , Free(free)
    , Cholesky(SparseCholesky::Ordering::Thorough)
  {
    this->Cholesky.expectConstantPattern();
    for (std::size_t i = 0; i < free.size(); ++i)
    {
      this->Row[free[i]] = static_cast<int>(i);
    }
    this->findPattern();
  }

  // Replaces the positions of the free vertices.
  void solve(const Points3& weights, Points2& positions)
  {
    Eigen::MatrixXd rightSide = Eigen::MatrixXd::Zero(this->Free.size(), 2);
    double* values = this->Matrix.valuePtr();
    std::fill(values, values + this->Matrix.nonZeros(), 0.0);
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int i = this->Faces(f, (k + 1) % 3);
        const int j = this->Faces(f, (k + 2) % 3);
        this->addEdge(i, j, weights(f, k), 3 * f + k, positions, rightSide);
      }
    }
    this->Cholesky.compute(this->Matrix);
    if (this->Cholesky.info() != Eigen::Success)
    {
      throw ConvergenceError("stretch-energy minimisation: a matrix could not be factored");
    }
    const Eigen::MatrixXd solution = this->Cholesky.solve(rightSide);
    if (!solution.allFinite())
    {
      throw ConvergenceError("stretch-energy minimisation: a solution is not finite");
    }
    for (std::size_t i = 0; i < this->Free.size(); ++i)
    {
      positions.row(this->Free[i]) = solution.row(i);
    }
  }

private:
  void findPattern()
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < this->Free.size(); ++i)
    {
      entries.emplace_back(i, i, 1.0);
    }
    const auto forFreeEdges = [this](const auto& action)
    {
      for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
      {
        for (int k = 0; k < 3; ++k)
        {
          const int i = this->Row[this->Faces(f, (k + 1) % 3)];
          const int j = this->Row[this->Faces(f, (k + 2) % 3)];
          if (i >= 0 && j >= 0)
          {
            action(3 * f + k, std::max(i, j), std::min(i, j));
          }
        }
      }
    };
    forFreeEdges([&entries](Eigen::Index, int i, int j) { entries.emplace_back(i, j, 1.0); });
    this->Matrix.resize(this->Free.size(), this->Free.size());
    this->Matrix.setFromTriplets(entries.begin(), entries.end());
    this->Entry.assign(3 * this->Faces.rows(), -1);
    forFreeEdges(
      [this](Eigen::Index edge, int i, int j)
      {
        const int* rows = this->Matrix.innerIndexPtr();
        const int* columns = this->Matrix.outerIndexPtr();
        this->Entry[edge] =
          static_cast<int>(std::lower_bound(rows + columns[j], rows + columns[j + 1], i) - rows);
      });
  }

  // The diagonal comes first in its column of the lower triangle.
  void addEdge(int i,
    int j,
    double weight,
    Eigen::Index edge,
    const Points2& positions,
    Eigen::MatrixXd& rightSide)
  {
    double* values = this->Matrix.valuePtr();
    if (this->Entry[edge] >= 0)
    {
      values[this->Entry[edge]] -= weight;
    }
    for (const auto& [v, other] : { std::pair(i, j), std::pair(j, i) })
    {
      if (const int row = this->Row[v]; row >= 0)
      {
        values[this->Matrix.outerIndexPtr()[row]] += weight;
        if (this->Row[other] < 0)
        {
          rightSide.row(row) += weight * positions.row(other);
        }
      }
    }
  }

  const FaceMatrix& Faces;
  std::vector<int> Row; // of every vertex; -1 if it is not free
  std::vector<int> Free;
  SparseMatrix Matrix; // lower triangle
  std::vector<int>
    Entry; // of the edge opposite corner k of face f, at 3 f + k; -1 if an end is not free
  SparseCholesky Cholesky;
};

std::vector<int> verticesWithout(const std::vector<int>& loop, int vertexCount)
{
  std::vector<char> left(vertexCount, 1);
  for (const int v : loop)
  {
    left[v] = 0;
  }
  std::vector<int> vertices;
  for (int v = 0; v < vertexCount; ++v)
  {
    if (left[v])
    {
      vertices.push_back(v);
    }
  }
  return vertices;
}

// Half the sum of the squared lengths of edges times their weights.
double energyOf(const Points2& positions, const FaceMatrix& faces, const Points3& weights)
{
  double energy = 0.0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto edge = positions.row(faces(f, (k + 1) % 3)) - positions.row(faces(f, (k + 2) % 3));
      energy += 0.5 * weights(f, k) * edge.squaredNorm();
    }
  }
  return energy;
}

// Solves Laplace's equation for the boundary, with the inner vertices reflected at the circle, centres
// the solution and puts it back on the circle. Of the inner vertices only those beside the boundary
// count.
void moveBoundary(DirichletProblem& outside,
  const Points3& weights,
  const std::vector<int>& loop,
  Points2& positions)
{
  Points2 reflected = positions.array().colwise() / positions.rowwise().squaredNorm().array();
  outside.solve(weights, reflected);
  Eigen::RowVector2d centre = Eigen::RowVector2d::Zero();
  for (const int v : loop)
  {
    centre += reflected.row(v) / static_cast<double>(loop.size());
  }
  for (const int v : loop)
  {
    positions.row(v) = (reflected.row(v) - centre).normalized();
  }
}

} // namespace

StretchEnergyMap stretchEnergyDiskMap(const TriangleMesh& mesh, int iterations)
{
  const std::vector<int> loop = requireDisk(mesh);
  const Eigen::VectorXd areas = faceAreas(mesh.Vertices, mesh.Faces);
  if (areas.minCoeff() <= 0.0)
  {
    throw InvalidInput("stretch-energy minimisation divides by the areas of faces: one has none");
  }
  const Eigen::VectorXd angles = anglesInProportion(loopLengths(mesh, loop, 0.0));
  StretchEnergyMap map{ Points2::Zero(mesh.vertexCount(), 2), {} };
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    map.Positions.row(loop[k]) << std::cos(angles[k]), std::sin(angles[k]);
  }
  DirichletProblem outside(mesh.Faces, loop, mesh.vertexCount());
  DirichletProblem inside(mesh.Faces, verticesWithout(loop, mesh.vertexCount()), mesh.vertexCount());
  const Eigen::VectorXd perSurfaceDot = 0.25 * areas.cwiseInverse();
  inside.solve(edgeWeights(mesh.Vertices, mesh.Faces, perSurfaceDot), map.Positions);
  // Half a cotangent is dot / (4 flat area): times flat over surface area, dot / (4 surface area). It
  // does not matter which way round a flat face is.
  for (int n = 0; n < iterations; ++n)
  {
    Points2 positions = map.Positions;
    const Points3 weights = edgeWeights(positions, mesh.Faces, perSurfaceDot);
    moveBoundary(outside, weights, loop, positions);
    inside.solve(weights, positions);
    const double energy = energyOf(positions, mesh.Faces, weights);
    if (!map.Energies.empty() && energy > map.Energies.back())
    {
      break;
    }
    map.Positions = std::move(positions);
    map.Energies.push_back(energy);
  }
  return map;
}

} // namespace flattening::benchmarks
