// SPDX-License-Identifier: GPL-3.0-or-later
#include "AuthalicEnergy.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Mesh/MeshTopology.h"
#include "StretchEnergy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening::benchmarks
{
namespace
{

constexpr int StretchIterations = 5;
// A step must lower the energy by this share of what the slope promises (Armijo's rule).
constexpr double SufficientDecrease = 1e-4;
constexpr double SmallestStep = 1e-10;
// The search for the balance makes so many iterations with each multiplier, and ends after so many
// multipliers at the latest, or when the energies differ by this share of their sum.
constexpr int IterationsByMultiplier = 50;
constexpr int MostMultipliers = 20;
constexpr double SmallestImbalance = 1e-4;
// The penalty on the difference, times the sum of both energies. A choice: the balance was found within
// MostMultipliers on a hemisphere, a lion and a bunny.
constexpr double RelativePenalty = 10.0;

// The augmented Lagrangian of "the least conformal energy C at which the authalic energy A is as large",
//   C + m (A - C) + p / 2 (A - C)^2
// with a multiplier m and a penalty p, as a function of the inner positions and of the boundary's angles
// on the circle. The authalic energy alone has m = 1 and p = 0. The unknowns are all x, all y, and the
// angles.
class DiskEnergy
{
public:
  struct Energies
  {
    double Authalic = 0.0;
    double Conformal = 0.0;

    double difference() const { return this->Authalic - this->Conformal; }
    double sum() const { return this->Authalic + this->Conformal; }
  };

  DiskEnergy(const TriangleMesh& mesh, const std::vector<int>& loop, double multiplier)
    : Faces(mesh.Faces)
    , Loop(loop)
    , Areas(faceAreas(mesh.Vertices, mesh.Faces))
    , Cotangents(mesh.faceCount(), 3)
    , Multiplier(multiplier)
    , Row(mesh.vertexCount(), 0)
  {
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      const Eigen::Matrix3d corners = faceCorners(mesh, f);
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::RowVector3d a = corners.row((k + 1) % 3) - corners.row(k);
        const Eigen::RowVector3d b = corners.row((k + 2) % 3) - corners.row(k);
        this->Cotangents(f, k) = a.dot(b) / (2.0 * this->Areas[f]);
      }
    }
    this->Areas *= EIGEN_PI / this->Areas.sum();
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      this->Row[loop[k]] = -1 - static_cast<int>(k);
    }
    for (int& row : this->Row)
    {
      row = row < 0 ? row : this->InnerCount++;
    }
  }

  int innerCount() const { return this->InnerCount; }
  const std::vector<int>& rows() const { return this->Row; }

  Eigen::VectorXd unknownsOf(const Points2& positions) const
  {
    Eigen::VectorXd unknowns(2 * this->InnerCount + static_cast<Eigen::Index>(this->Loop.size()));
    for (std::size_t v = 0; v < this->Row.size(); ++v)
    {
      if (const int row = this->Row[v]; row >= 0)
      {
        unknowns[row] = positions(v, 0);
        unknowns[this->InnerCount + row] = positions(v, 1);
      }
      else
      {
        unknowns[2 * this->InnerCount - 1 - row] = std::atan2(positions(v, 1), positions(v, 0));
      }
    }
    return unknowns;
  }

  Points2 positionsOf(const Eigen::VectorXd& unknowns) const
  {
    Points2 positions(this->Row.size(), 2);
    for (std::size_t v = 0; v < this->Row.size(); ++v)
    {
      if (const int row = this->Row[v]; row >= 0)
      {
        positions.row(v) << unknowns[row], unknowns[this->InnerCount + row];
      }
      else
      {
        const double angle = unknowns[2 * this->InnerCount - 1 - row];
        positions.row(v) << std::cos(angle), std::sin(angle);
      }
    }
    return positions;
  }

  Energies energiesAt(const Eigen::VectorXd& unknowns) const
  {
    return this->energiesOf(this->positionsOf(unknowns));
  }

  // Adds what the penalty makes of the difference at @p energies to the multiplier, and sets the penalty
  // of the next minimisation. The first one is made without a penalty and leaves the multiplier.
  void updateMultiplier(const Energies& energies)
  {
    this->Multiplier += this->Penalty * energies.difference();
    this->Penalty = RelativePenalty / energies.sum();
  }

  // The augmented Lagrangian and, if asked for, its gradient.
  double at(const Eigen::VectorXd& unknowns, Eigen::VectorXd* gradient = nullptr) const
  {
    const Points2 p = this->positionsOf(unknowns);
    const Energies energies = this->energiesOf(p);
    const double difference = energies.difference();
    if (gradient)
    {
      this->passOn(
        p, this->gradientByPosition(p, this->Multiplier + this->Penalty * difference), *gradient);
    }
    return energies.Conformal + this->Multiplier * difference +
           0.5 * this->Penalty * difference * difference;
  }

  // The Laplacian of the energies at @p p, by the multiplier's shares of both, a block for the inner
  // vertices and one for the boundary: lower triangles.
  std::pair<SparseMatrix, SparseMatrix> laplacians(const Points2& p) const
  {
    std::vector<Eigen::Triplet<double>> inner;
    std::vector<Eigen::Triplet<double>> boundary;
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int i = this->Faces(f, (k + 1) % 3);
        const int j = this->Faces(f, (k + 2) % 3);
        const Eigen::RowVector2d a = p.row(i) - p.row(this->Faces(f, k));
        const Eigen::RowVector2d b = p.row(j) - p.row(this->Faces(f, k));
        const double weight = this->Multiplier * 0.5 * a.dot(b) / this->Areas[f] +
                              (1.0 - this->Multiplier) * 0.5 * this->Cotangents(f, k);
        const int rowI = this->Row[i];
        const int rowJ = this->Row[j];
        for (const int row : { rowI, rowJ })
        {
          auto& entries = row >= 0 ? inner : boundary;
          const int index = row >= 0 ? row : -1 - row;
          entries.emplace_back(index, index, weight);
        }
        if ((rowI >= 0) == (rowJ >= 0))
        {
          auto& entries = rowI >= 0 ? inner : boundary;
          const int indexI = rowI >= 0 ? rowI : -1 - rowI;
          const int indexJ = rowJ >= 0 ? rowJ : -1 - rowJ;
          entries.emplace_back(std::max(indexI, indexJ), std::min(indexI, indexJ), -weight);
        }
      }
    }
    const auto size = static_cast<Eigen::Index>(this->Loop.size());
    std::pair<SparseMatrix, SparseMatrix> result{ SparseMatrix(this->InnerCount, this->InnerCount),
      SparseMatrix(size, size) };
    result.first.setFromTriplets(inner.begin(), inner.end());
    result.second.setFromTriplets(boundary.begin(), boundary.end());
    return result;
  }

private:
  Energies energiesOf(const Points2& p) const
  {
    const Eigen::VectorXd flat = signedFaceAreas(p, this->Faces);
    const double whole = flat.sum();
    const double stretch = flat.dot(flat.cwiseQuotient(this->Areas));
    return { EIGEN_PI / whole * stretch - whole, this->dirichletEnergy(p) - whole };
  }

  double dirichletEnergy(const Points2& p) const
  {
    double energy = 0.0;
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        energy += 0.25 * this->Cotangents(f, k) * this->side(p, f, k).squaredNorm();
      }
    }
    return energy;
  }

  Eigen::RowVector2d side(const Points2& p, Eigen::Index f, int k) const
  {
    return p.row(this->Faces(f, (k + 2) % 3)) - p.row(this->Faces(f, (k + 1) % 3));
  }

  // The gradient of @p share of the authalic energy and the rest of the conformal energy.
  Points2 gradientByPosition(const Points2& p, double share) const
  {
    const Eigen::VectorXd flat = signedFaceAreas(p, this->Faces);
    const Eigen::VectorXd ratios = flat.cwiseQuotient(this->Areas);
    const double whole = flat.sum();
    const double scale = EIGEN_PI / whole;
    const Eigen::VectorXd byArea =
      (share * scale * (2.0 * ratios.array() - flat.dot(ratios) / whole) - 1.0).matrix();
    Points2 gradient = Points2::Zero(p.rows(), 2);
    for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::RowVector2d side = this->side(p, f, k);
        gradient.row(this->Faces(f, k)) += 0.5 * byArea[f] * Eigen::RowVector2d(-side.y(), side.x());
        const Eigen::RowVector2d pull = 0.5 * (1.0 - share) * this->Cotangents(f, k) * side;
        gradient.row(this->Faces(f, (k + 2) % 3)) += pull;
        gradient.row(this->Faces(f, (k + 1) % 3)) -= pull;
      }
    }
    return gradient;
  }

  void passOn(const Points2& p, const Points2& byPosition, Eigen::VectorXd& gradient) const
  {
    gradient.resize(2 * this->InnerCount + static_cast<Eigen::Index>(this->Loop.size()));
    for (std::size_t v = 0; v < this->Row.size(); ++v)
    {
      if (const int row = this->Row[v]; row >= 0)
      {
        gradient[row] = byPosition(v, 0);
        gradient[this->InnerCount + row] = byPosition(v, 1);
      }
      else
      {
        gradient[2 * this->InnerCount - 1 - row] =
          p(v, 0) * byPosition(v, 1) - p(v, 1) * byPosition(v, 0);
      }
    }
  }

  const FaceMatrix& Faces;
  const std::vector<int>& Loop;
  Eigen::VectorXd Areas; // of the surface's faces, pi in all
  Points3 Cotangents;    // of the surface
  double Multiplier;
  double Penalty = 0.0;
  std::vector<int> Row; // of an inner vertex; -1 - k of vertex k of the loop
  int InnerCount = 0;
};

class Preconditioner
{
public:
  Preconditioner(const DiskEnergy& energy, const Points2& positions)
    : InnerCount(energy.innerCount())
  {
    const auto [inner, boundary] = energy.laplacians(positions);
    this->Inner.compute(inner);
    this->Boundary.compute(boundary);
    if (this->Inner.info() != Eigen::Success || this->Boundary.info() != Eigen::Success)
    {
      throw ConvergenceError("authalic energy: the preconditioner could not be factored");
    }
  }

  Eigen::VectorXd operator()(const Eigen::VectorXd& gradient) const
  {
    Eigen::VectorXd result(gradient.size());
    const int n = this->InnerCount;
    result.head(n) = this->Inner.solve(gradient.head(n));
    result.segment(n, n) = this->Inner.solve(gradient.segment(n, n));
    result.tail(gradient.size() - 2 * n) = this->Boundary.solve(gradient.tail(gradient.size() - 2 * n));
    return result;
  }

private:
  int InnerCount;
  SparseCholesky Inner;
  SparseCholesky Boundary;
};

// Lowers the function from @p x by preconditioned nonlinear conjugate gradients (Polak and Ribiere).
void lower(const DiskEnergy& function,
  const Preconditioner& precondition,
  int iterations,
  Eigen::VectorXd& x)
{
  Eigen::VectorXd gradient;
  double energy = function.at(x, &gradient);
  Eigen::VectorXd preconditioned = precondition(gradient);
  Eigen::VectorXd direction = -preconditioned;
  double step = 1.0;
  for (int n = 0; n < iterations; ++n)
  {
    double slope = gradient.dot(direction);
    if (slope >= 0.0)
    {
      direction = -preconditioned;
      slope = gradient.dot(direction);
    }
    // The least of the parabola through the energy here, its slope, and the energy after the last step.
    const double bend = function.at(x + step * direction) - energy - slope * step;
    step = bend > 0.0 ? -slope * step * step / (2.0 * bend) : 2.0 * step;
    while (function.at(x + step * direction) > energy + SufficientDecrease * step * slope &&
           step > SmallestStep)
    {
      step *= 0.5;
    }
    if (step <= SmallestStep)
    {
      break;
    }
    x += step * direction;
    const Eigen::VectorXd before = gradient;
    const double size = before.dot(preconditioned);
    energy = function.at(x, &gradient);
    preconditioned = precondition(gradient);
    const double share = std::max(0.0, preconditioned.dot(gradient - before) / size);
    direction = share * direction - preconditioned;
  }
}

} // namespace

Points2 authalicEnergyDiskMap(const TriangleMesh& mesh, int iterations)
{
  const std::vector<int> loop = requireDisk(mesh);
  const Points2 start = stretchEnergyDiskMap(mesh, StretchIterations).Positions;
  const DiskEnergy function(mesh, loop, 1.0);
  Eigen::VectorXd x = function.unknownsOf(start);
  lower(function, Preconditioner(function, start), iterations, x);
  return function.positionsOf(x);
}

BalancedMap balancedDiskMap(const TriangleMesh& mesh)
{
  const std::vector<int> loop = requireDisk(mesh);
  const Points2 start = stretchEnergyDiskMap(mesh, StretchIterations).Positions;
  DiskEnergy function(mesh, loop, 0.5);
  const Preconditioner precondition(function, start);
  Eigen::VectorXd x = function.unknownsOf(start);
  DiskEnergy::Energies energies;
  for (int n = 0; n < MostMultipliers; ++n)
  {
    lower(function, precondition, IterationsByMultiplier, x);
    energies = function.energiesAt(x);
    if (std::abs(energies.difference()) <= SmallestImbalance * energies.sum())
    {
      break;
    }
    function.updateMultiplier(energies);
  }
  return { function.positionsOf(x), energies.Authalic, energies.Conformal };
}

} // namespace flattening::benchmarks
