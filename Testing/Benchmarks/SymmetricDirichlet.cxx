// SPDX-License-Identifier: GPL-3.0-or-later
#include "SymmetricDirichlet.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/GraphLaplacian.h"
#include "Mesh/MeshTopology.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flattening::benchmarks
{
namespace
{

// The weight of staying where the vertices are, which makes the matrix regular (as libigl does).
constexpr double ProximalWeight = 1e-4;
// The share of the way to the first flip or collision that a step may go.
constexpr double ShareOfLargestStep = 0.8;
// An iteration that lowers the energy by a smaller share ends the descent.
constexpr double LeastProgress = 1e-6;

constexpr double Infinite = std::numeric_limits<double>::infinity();

using Gradients = Eigen::Matrix<double, 2, 3>; // of the three hat functions of a face, in its plane

double cross(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// The smallest positive t with c + b t + a t^2 = 0.
double firstRoot(double a, double b, double c)
{
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0)
  {
    return Infinite;
  }
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double first = Infinite;
  for (const double t : { q / a, c / q })
  {
    if (t > 0.0 && t < first)
    {
      first = t;
    }
  }
  return first;
}

// Singular value decomposition of a 2 x 2 matrix with rotations: U diag(s) V^T; s[1] has the sign of the
// determinant.
struct Rotations
{
  explicit Rotations(const Eigen::Matrix2d& j)
  {
    const double e = 0.5 * (j(0, 0) + j(1, 1));
    const double f = 0.5 * (j(0, 0) - j(1, 1));
    const double g = 0.5 * (j(1, 0) + j(0, 1));
    const double h = 0.5 * (j(1, 0) - j(0, 1));
    const double q = std::hypot(e, h);
    const double r = std::hypot(f, g);
    this->Values << q + r, q - r;
    const double sum = std::atan2(g, f);
    const double difference = std::atan2(h, e);
    this->U = Eigen::Rotation2Dd(0.5 * (sum + difference)).toRotationMatrix();
    this->V = Eigen::Rotation2Dd(0.5 * (sum - difference)).toRotationMatrix();
  }
  Eigen::Matrix2d U;
  Eigen::Matrix2d V;
  Eigen::Vector2d Values;
};

class Descent
{
public:
  Descent(const TriangleMesh& mesh, const std::vector<int>& loop)
    : Faces(mesh.Faces)
    , Loop(loop)
    , Areas(faceAreas(mesh.Vertices, mesh.Faces))
    , Hats(mesh.faceCount())
  {
    this->Areas /= this->Areas.sum();
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      const Eigen::Matrix3d corners = faceCorners(mesh, f);
      const Eigen::RowVector3d a = corners.row(1) - corners.row(0);
      const Eigen::RowVector3d b = corners.row(2) - corners.row(0);
      const double length = a.norm();
      Eigen::Matrix2d sides; // columns: the sides in the plane
      sides << length, a.dot(b) / length, 0.0, a.cross(b).norm() / length;
      Eigen::Matrix<double, 3, 2> differences;
      differences << -1, -1, 1, 0, 0, 1;
      this->Hats[f] = (differences * sides.inverse()).transpose();
    }
    this->Cholesky.expectConstantPattern();
  }

  double energy(const Points2& p) const
  {
    double sum = 0.0;
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      const Eigen::Matrix2d j = this->jacobian(p, f);
      const double determinant = j.determinant();
      if (!(determinant > 0.0))
      {
        return Infinite;
      }
      sum += this->Areas[f] * j.squaredNorm() * (1.0 + 1.0 / (determinant * determinant));
    }
    return sum;
  }

  // One step; returns false if the energy is hardly lowered any more.
  bool step(Points2& p)
  {
    const Points2 way = this->proxyMinimum(p) - p;
    double length = std::min(1.0, ShareOfLargestStep * this->largestStep(p, way));
    const double before = this->energy(p);
    while (this->energy(p + length * way) >= before)
    {
      length *= 0.5;
      if (length < 1e-12)
      {
        return false;
      }
    }
    p += length * way;
    return this->energy(p) < (1.0 - LeastProgress) * before;
  }

private:
  Eigen::Matrix2d jacobian(const Points2& p, Eigen::Index f) const
  {
    Eigen::Matrix<double, 3, 2> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.row(k) = p.row(this->Faces(f, k));
    }
    return (this->Hats[f] * corners).transpose();
  }

  // The positions at which the sum of area |W (J - R)|^2 is least: R is the rotation next to J, and W
  // makes the gradient that of the energy.
  Points2 proxyMinimum(const Points2& p)
  {
    const Eigen::Index n = p.rows();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(this->Faces.rows() * 21 + 2 * n);
    Eigen::VectorXd rightSide(2 * n);
    const double stay = ProximalWeight / static_cast<double>(n);
    for (Eigen::Index v = 0; v < n; ++v)
    {
      for (int d = 0; d < 2; ++d)
      {
        entries.emplace_back(2 * v + d, 2 * v + d, stay);
        rightSide[2 * v + d] = stay * p(v, d);
      }
    }
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      const Rotations parts(this->jacobian(p, f));
      Eigen::Vector2d squares;
      for (int d = 0; d < 2; ++d)
      {
        const double s = parts.Values[d];
        // (s - 1 / s^3) / (s - 1), without the pole at 1.
        squares[d] = (s + 1.0) * (s * s + 1.0) / (s * s * s);
      }
      const Eigen::Matrix2d weight =
        this->Areas[f] * parts.U * squares.asDiagonal() * parts.U.transpose();
      const Eigen::Matrix2d target = weight * parts.U * parts.V.transpose();
      for (int i = 0; i < 3; ++i)
      {
        const Eigen::Index vi = this->Faces(f, i);
        rightSide.segment<2>(2 * vi) += target * this->Hats[f].col(i);
        for (int j = 0; j < 3; ++j)
        {
          const Eigen::Index vj = this->Faces(f, j);
          const double product = this->Hats[f].col(i).dot(this->Hats[f].col(j));
          for (int r = 0; r < 2; ++r)
          {
            for (int c = 0; c < 2; ++c)
            {
              if (2 * vi + r >= 2 * vj + c)
              {
                entries.emplace_back(2 * vi + r, 2 * vj + c, product * weight(r, c));
              }
            }
          }
        }
      }
    }
    SparseMatrix matrix(2 * n, 2 * n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    this->Cholesky.compute(matrix);
    if (this->Cholesky.info() != Eigen::Success)
    {
      throw ConvergenceError("symmetric Dirichlet energy: a matrix could not be factored");
    }
    const Eigen::VectorXd solution = this->Cholesky.solve(rightSide);
    return Eigen::Map<const Points2>(solution.data(), n, 2);
  }

  // The smallest share of the way at which a face has no area or a vertex of the outline lies on one of
  // its edges.
  double largestStep(const Points2& p, const Points2& way) const
  {
    double largest = Infinite;
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      largest =
        std::min(largest, whenInLine(p, way, this->Faces(f, 0), this->Faces(f, 1), this->Faces(f, 2)));
    }
    const std::size_t size = this->Loop.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const int a = this->Loop[i];
      const int b = this->Loop[(i + 1) % size];
      for (const int v : this->Loop)
      {
        if (v != a && v != b)
        {
          const double t = whenInLine(p, way, a, b, v);
          if (t < largest && this->liesBetween(p + t * way, a, b, v))
          {
            largest = t;
          }
        }
      }
    }
    return largest;
  }

  static double whenInLine(const Points2& p, const Points2& way, int a, int b, int c)
  {
    const Eigen::RowVector2d u = p.row(b) - p.row(a);
    const Eigen::RowVector2d v = p.row(c) - p.row(a);
    const Eigen::RowVector2d du = way.row(b) - way.row(a);
    const Eigen::RowVector2d dv = way.row(c) - way.row(a);
    return firstRoot(cross(du, dv), cross(u, dv) + cross(du, v), cross(u, v));
  }

  template <typename Positions>
  static bool liesBetween(const Positions& p, int a, int b, int v)
  {
    const Eigen::RowVector2d side = p.row(b) - p.row(a);
    const Eigen::RowVector2d to = p.row(v) - p.row(a);
    const double place = to.dot(side);
    return place >= 0.0 && place <= side.squaredNorm();
  }

  const FaceMatrix& Faces;
  const std::vector<int>& Loop;
  Eigen::VectorXd Areas; // shares of the whole
  std::vector<Gradients> Hats;
  SparseCholesky Cholesky;
};

// Tutte's map to a disk of the surface's area, the boundary in equal steps.
Points2 tutteMap(const TriangleMesh& mesh, const std::vector<int>& loop)
{
  std::vector<NeighbourWeight> weights;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      weights.push_back({ mesh.Faces(f, k), mesh.Faces(f, (k + 1) % 3), 1.0 });
      weights.push_back({ mesh.Faces(f, (k + 1) % 3), mesh.Faces(f, k), 1.0 });
    }
  }
  const double radius = std::sqrt(faceAreas(mesh.Vertices, mesh.Faces).sum() / EIGEN_PI);
  std::vector<char> fixed(mesh.vertexCount(), 0);
  ComplexVector positions(mesh.vertexCount(), 0.0);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    fixed[loop[k]] = 1;
    const double share = static_cast<double>(k) / static_cast<double>(loop.size());
    positions[loop[k]] = std::polar(radius, static_cast<double>(2.0 * EIGEN_PI) * share);
  }
  WeightedMeans(weights, WeightSymmetry::Symmetric, fixed).extend(positions);
  return pointsOf(positions);
}

} // namespace

Points2 symmetricDirichletMap(const TriangleMesh& mesh, int iterations)
{
  const std::vector<int> loop = requireDisk(mesh);
  Points2 positions = tutteMap(mesh, loop);
  Descent descent(mesh, loop);
  for (int n = 0; n < iterations && descent.step(positions); ++n)
  {
  }
  return positions;
}

int outlineCrossings(const Points2& positions, const std::vector<int>& loop)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const std::size_t size = loop.size();
  std::vector<Kernel::Segment_2> edges;
  const auto point = [&](std::size_t k)
  { return Kernel::Point_2(positions(loop[k % size], 0), positions(loop[k % size], 1)); };
  for (std::size_t k = 0; k < size; ++k)
  {
    edges.emplace_back(point(k), point(k + 1));
  }
  int crossings = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t j = i + 2; j < size; ++j)
    {
      const bool neighbours = i == 0 && j + 1 == size;
      crossings += !neighbours && CGAL::do_overlap(edges[i].bbox(), edges[j].bbox()) &&
                   CGAL::do_intersect(edges[i], edges[j]);
    }
  }
  return crossings;
}

} // namespace flattening::benchmarks
