// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/DeformationEnergy.h"

#include "Mesh/PlaneVectors.h"

#include <Eigen/Eigenvalues>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace flattening
{
namespace
{

// The small squares along a side of a square of the lattice. A choice: with one, a square can be
// sheared without an energy; more cost time and gain little.
constexpr int Divisions = 2;
// The weight of a small square's own shape, against that of faces that fill it. A choice: small, so that
// the plane around the map gives way, and not so small that parts of the outline come too near to each
// other for the next deformation.
constexpr double BackgroundWeight = 1e-3;
// Up to this ratio of Dirichlet energy to area, a stretch of 12 to 1, shapes count by its logarithm, and
// beyond in proportion. A choice: with the logarithm alone the boundary beside the ends of a seam is
// stretched ever more, while areas are lost there; with the ratio alone a few faces in protrusions count
// for more than all others.
constexpr double LogarithmEnd = 6.0;
// Small squares of one task of a thread. It fixes the order of summation, and with it the last bits.
constexpr int SquaresPerTask = 512;

// The derivative of det F by F.
Eigen::Matrix2d cofactors(const Eigen::Matrix2d& f)
{
  Eigen::Matrix2d result;
  result << f(1, 1), -f(1, 0), -f(0, 1), f(0, 0);
  return result;
}

// The matrix with no negative eigenvalues that is nearest to @p matrix.
Eigen::Matrix4d positivePart(const Eigen::Matrix4d& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(matrix);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

} // namespace

DeformationEnergy::DeformationEnergy(const DeformationLattice& lattice,
  const RefinementTerms& terms,
  const Points2& positions,
  const Eigen::VectorXd& targets)
  : Lattice(lattice)
{
  this->addSquares();
  const double largest = terms.ShapeWeights.maxCoeff();
  for (Eigen::Index face = 0; face < terms.Faces.rows(); ++face)
  {
    Eigen::Vector2d corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = positions.row(terms.Faces(face, k));
    }
    Square& square = this->Squares[this->squareOf((corners[0] + corners[1] + corners[2]) / 3.0)];
    Eigen::Matrix2d shape = Eigen::Matrix2d::Zero(); // its trace is twice the Dirichlet energy
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector2d side = corners[(k + 2) % 3] - corners[(k + 1) % 3];
      shape += 0.5 * terms.Cotangents(face, k) * side * side.transpose();
    }
    const double twiceArea = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double weight = largest > 0.0 ? terms.ShapeWeights[face] / largest * targets[face] : 0.0;
    if (shape.trace() > 0.0)
    {
      square.Shape += weight / std::min(shape.trace(), LogarithmEnd * twiceArea) * shape;
    }
    square.Target += targets[face];
    square.Ratio += 0.5 * twiceArea;
  }
  for (Square& square : this->Squares)
  {
    square.Ratio = square.Target > 0.0 ? square.Ratio / square.Target : 1.0;
  }
}

void DeformationEnergy::addSquares()
{
  const double side = this->Lattice.side() / Divisions;
  for (int row = 0; row < Divisions * this->Lattice.rows(); ++row)
  {
    for (int column = 0; column < Divisions * this->Lattice.columns(); ++column)
    {
      const Eigen::Vector2d centre =
        this->Lattice.origin() + side * Eigen::Vector2d(column + 0.5, row + 0.5);
      const Eigen::Matrix2d shape = 0.5 * BackgroundWeight * side * side * Eigen::Matrix2d::Identity();
      this->Squares.push_back({ this->Lattice.influenceOn(centre), shape, 0.0, 0.0 });
    }
  }
}

std::size_t DeformationEnergy::squareOf(const Eigen::Vector2d& point) const
{
  const Eigen::Vector2d offset = Divisions * (point - this->Lattice.origin()) / this->Lattice.side();
  const int columns = Divisions * this->Lattice.columns();
  const int rows = Divisions * this->Lattice.rows();
  const int column = std::clamp(static_cast<int>(offset.x()), 0, columns - 1);
  const int row = std::clamp(static_cast<int>(offset.y()), 0, rows - 1);
  return static_cast<std::size_t>(row) * columns + column;
}

Eigen::Matrix2d DeformationEnergy::derivativeOf(const Square& square, const Points2& displacements)
{
  Eigen::Matrix2d f = Eigen::Matrix2d::Identity();
  for (int k = 0; k < 9; ++k)
  {
    f += displacements.row(square.Influence.Nodes[k]).transpose() *
         square.Influence.Gradients[k].transpose();
  }
  return f;
}

double DeformationEnergy::energyOf(const Square& square, const Eigen::Matrix2d& f) const
{
  const double det = f.determinant();
  if (!(det > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double off = square.Ratio * det - 1.0;
  return (f * square.Shape * f.transpose()).trace() / det + this->AreaWeight * square.Target * off * off;
}

double DeformationEnergy::value(const Points2& displacements) const
{
  const int count = static_cast<int>(this->Squares.size());
  const int tasks = (count + SquaresPerTask - 1) / SquaresPerTask;
  std::vector<double> parts(tasks, 0.0);
  tbb::parallel_for(0,
    tasks,
    [&](int task)
    {
      for (int s = task * SquaresPerTask; s < std::min(count, (task + 1) * SquaresPerTask); ++s)
      {
        parts[task] += this->energyOf(this->Squares[s], derivativeOf(this->Squares[s], displacements));
      }
    });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

struct DeformationEnergy::SquareTerm
{
  double Energy;
  Eigen::Matrix2d Slope;     // by F
  Eigen::Matrix4d Curvature; // by the entries of F, column by column
};

DeformationEnergy::SquareTerm DeformationEnergy::term(const Square& square,
  const Points2& displacements) const
{
  // With x = tr(F G F^T) and d = det F, the energy is x / d + W T (rho d - 1)^2.
  const Eigen::Matrix2d f = derivativeOf(square, displacements);
  const double det = f.determinant();
  const double x = (f * square.Shape * f.transpose()).trace();
  const Eigen::Matrix2d byX = 2.0 * f * square.Shape;
  const Eigen::Matrix2d byDet = cofactors(f);
  const double area = 2.0 * this->AreaWeight * square.Target * square.Ratio;
  const double slope = -x / (det * det) + area * (square.Ratio * det - 1.0); // by d
  const double curvature = 2.0 * x / (det * det * det) + area * square.Ratio;
  const Eigen::Map<const Eigen::Vector4d> columnsOfX(byX.data());
  const Eigen::Map<const Eigen::Vector4d> columnsOfDet(byDet.data());
  Eigen::Matrix4d second = curvature * columnsOfDet * columnsOfDet.transpose();
  second -=
    (columnsOfX * columnsOfDet.transpose() + columnsOfDet * columnsOfX.transpose()) / (det * det);
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      second.block<2, 2>(2 * a, 2 * b).diagonal().array() += 2.0 * square.Shape(a, b) / det;
    }
  }
  second(0, 3) += slope;
  second(3, 0) += slope;
  second(1, 2) -= slope;
  second(2, 1) -= slope;
  return { this->energyOf(square, f), byX / det + slope * byDet, positivePart(second) };
}

double DeformationEnergy::derivatives(const Points2& displacements,
  Eigen::VectorXd& gradient,
  SparseMatrix& hessian) const
{
  const int count = static_cast<int>(this->Squares.size());
  std::vector<SquareTerm> terms(count);
  tbb::parallel_for(tbb::blocked_range<int>(0, count, SquaresPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int s = range.begin(); s < range.end(); ++s)
      {
        terms[s] = this->term(this->Squares[s], displacements);
      }
    });
  const int dofs = 2 * this->Lattice.nodeCount();
  double sum = 0.0;
  gradient.setZero(dofs);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(this->Squares.size() * 171);
  for (int s = 0; s < count; ++s)
  {
    const DeformationLattice::Influence& influence = this->Squares[s].Influence;
    sum += terms[s].Energy;
    Eigen::Matrix<double, 4, 18> ofNodes = Eigen::Matrix<double, 4, 18>::Zero();
    std::array<int, 18> rows;
    for (int k = 0; k < 18; ++k)
    {
      rows[k] = 2 * influence.Nodes[k / 2] + k % 2;
      ofNodes(k % 2, k) = influence.Gradients[k / 2].x();
      ofNodes(2 + k % 2, k) = influence.Gradients[k / 2].y();
      gradient[rows[k]] += terms[s].Slope.row(k % 2).dot(influence.Gradients[k / 2]);
    }
    const Eigen::Matrix<double, 18, 18> block = ofNodes.transpose() * terms[s].Curvature * ofNodes;
    for (int c = 0; c < 18; ++c)
    {
      for (int r = 0; r < 18; ++r)
      {
        if (rows[r] >= rows[c])
        {
          entries.emplace_back(rows[r], rows[c], block(r, c));
        }
      }
    }
  }
  hessian.resize(dofs, dofs);
  hessian.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

} // namespace flattening
