// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/DeformationEnergy.h"

#include "Mesh/PlaneVectors.h"

#include <Eigen/Jacobi>

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
// The weight of a small square's own shape, against that of faces that fill it. Choices: small, so that
// the map and the plane around it give way. Around a free outline it is so large that parts of the
// outline do not come too near to each other for the next deformation: of ten generated surfaces that
// kept more than 1 % of their faces wrong with 1e-3, five did not with 1e-2.
constexpr double BackgroundWeight = 1e-3;
constexpr double FreeBackgroundWeight = 1e-2;
// Up to this ratio of Dirichlet energy to area, a stretch of 12 to 1, shapes count by its logarithm, and
// beyond in proportion. A choice: with the logarithm alone the boundary beside the ends of a seam is
// stretched ever more, while areas are lost there; with the ratio alone a few faces in protrusions count
// for more than all others.
constexpr double LogarithmEnd = 6.0;
// The weight of squared distances from the boundary of a domain of area pi. A choice: so large that they
// are far smaller than the faces beside the boundary, and small enough to solve for in doubles.
constexpr double KeepingWeight = 1e6;
// Squares of the lattice of one task of a thread. It fixes the order of summation, and with it the last
// bits.
constexpr int SquaresPerTask = 128;
// A guard: Jacobi's method needs about five sweeps.
constexpr int MostSweeps = 20;

// The derivative of det F by F.
Eigen::Matrix2d cofactors(const Eigen::Matrix2d& f)
{
  Eigen::Matrix2d result;
  result << f(1, 1), -f(1, 0), -f(0, 1), f(0, 0);
  return result;
}

// Makes an entry of a symmetric matrix 0 by a rotation, with which it also multiplies @p vectors.
// Returns false if the entry was 0 already, as far as doubles can tell.
bool eliminate(int row, int column, Eigen::Matrix4d& matrix, Eigen::Matrix4d& vectors)
{
  const double largest = matrix.diagonal().cwiseAbs().maxCoeff();
  Eigen::JacobiRotation<double> rotation;
  if (!(std::abs(matrix(row, column)) > std::numeric_limits<double>::epsilon() * largest) ||
      !rotation.makeJacobi(matrix, row, column))
  {
    return false;
  }
  matrix.applyOnTheLeft(row, column, rotation.adjoint());
  matrix.applyOnTheRight(row, column, rotation);
  vectors.applyOnTheRight(row, column, rotation);
  return true;
}

// The matrix with no negative eigenvalues that is nearest to a symmetric one, by Jacobi's method (Golub
// and Van Loan 2013, section 8.5). Eigen's class for eigenvalues would do as well, but GCC compiles it
// for nine seconds, which is a tenth of the time of all sources that are compiled together with this
// one.
Eigen::Matrix4d positivePart(Eigen::Matrix4d matrix)
{
  Eigen::Matrix4d vectors = Eigen::Matrix4d::Identity();
  bool isDiagonal = false;
  for (int sweep = 0; sweep < MostSweeps && !isDiagonal; ++sweep)
  {
    isDiagonal = true;
    for (int row = 1; row < 4; ++row)
    {
      for (int column = 0; column < row; ++column)
      {
        isDiagonal = !eliminate(row, column, matrix, vectors) && isDiagonal;
      }
    }
  }
  return vectors * matrix.diagonal().cwiseMax(0.0).asDiagonal() * vectors.transpose();
}

} // namespace

DeformationEnergy::DeformationEnergy(const DeformationLattice& lattice,
  const RefinementTerms& terms,
  const Points2& positions,
  const Eigen::VectorXd& targets,
  Shapes shapes)
  : Lattice(lattice)
{
  this->addSquares(terms.Outline.empty() ? BackgroundWeight : FreeBackgroundWeight);
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
    if (shapes == Shapes::OfMap)
    {
      square.Shape += 0.5 * weight * Eigen::Matrix2d::Identity();
    }
    else if (shape.trace() > 0.0 && twiceArea > 0.0)
    {
      square.Shape += weight / std::min(shape.trace(), LogarithmEnd * twiceArea) * shape;
    }
    square.Target += targets[face];
    square.Ratio += 0.5 * twiceArea;
  }
  for (Square& square : this->Squares)
  {
    square.Target = square.Ratio > 0.0 ? square.Target : 0.0; // no faces, or flipped ones
    square.Ratio = square.Target > 0.0 ? square.Ratio / square.Target : 1.0;
  }
}

void DeformationEnergy::keepOnBoundary(const ConvexDomain& domain,
  const std::vector<BoundaryPoint>& points)
{
  this->Domain = &domain;
  this->Kept.resize(this->Squares.size() / (Divisions * Divisions));
  for (const BoundaryPoint& point : points)
  {
    this->Kept[this->squareOf(point.Place) / (Divisions * Divisions)].push_back(
      { point, this->Lattice.influenceOn(point.Place) });
  }
}

void DeformationEnergy::addSquares(double weight)
{
  const double side = this->Lattice.side() / Divisions;
  const Eigen::Matrix2d shape = 0.5 * weight * side * side * Eigen::Matrix2d::Identity();
  for (int square = 0; square < this->Lattice.rows() * this->Lattice.columns(); ++square)
  {
    for (int part = 0; part < Divisions * Divisions; ++part)
    {
      const int column = Divisions * (square % this->Lattice.columns()) + part % Divisions;
      const int row = Divisions * (square / this->Lattice.columns()) + part / Divisions;
      const Eigen::Vector2d centre =
        this->Lattice.origin() + side * Eigen::Vector2d(column + 0.5, row + 0.5);
      this->Squares.push_back({ this->Lattice.influenceOn(centre), shape, 0.0, 0.0 });
    }
  }
}

std::size_t DeformationEnergy::squareOf(const Eigen::Vector2d& point) const
{
  const Eigen::Vector2d offset = Divisions * (point - this->Lattice.origin()) / this->Lattice.side();
  const int column =
    std::clamp(static_cast<int>(offset.x()), 0, Divisions * this->Lattice.columns() - 1);
  const int row = std::clamp(static_cast<int>(offset.y()), 0, Divisions * this->Lattice.rows() - 1);
  const int square = row / Divisions * this->Lattice.columns() + column / Divisions;
  const int part = row % Divisions * Divisions + column % Divisions;
  return static_cast<std::size_t>(square) * (Divisions * Divisions) + part;
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

// The part of the way of a point that leaves the boundary, and the projection of the way on it.
struct DeformationEnergy::WayOff
{
  Eigen::Vector2d Way;
  Eigen::Matrix2d Projection;
};

DeformationEnergy::WayOff DeformationEnergy::wayOff(const KeptPoint& kept,
  const Points2& displacements) const
{
  Eigen::Vector2d way = Eigen::Vector2d::Zero();
  for (int k = 0; k < 9; ++k)
  {
    way += kept.Influence.Weights[k] * displacements.row(kept.Influence.Nodes[k]).transpose();
  }
  if (kept.Point.Stays)
  {
    return { way, Eigen::Matrix2d::Identity() };
  }
  const Eigen::Vector2d place = kept.Point.Place + way;
  const double parameter = this->Domain->parameterOf(place);
  const Eigen::Vector2d tangent = this->Domain->tangentAt(parameter);
  const Eigen::Matrix2d projection = Eigen::Matrix2d::Identity() - tangent * tangent.transpose();
  return { projection * (place - this->Domain->at(parameter)), projection };
}

double DeformationEnergy::energyOf(const KeptPoint& kept, const Points2& displacements) const
{
  return KeepingWeight * kept.Point.Length * this->wayOff(kept, displacements).Way.squaredNorm();
}

double DeformationEnergy::value(const Points2& displacements) const
{
  constexpr int parts = Divisions * Divisions;
  const int count = static_cast<int>(this->Squares.size()) / parts;
  const int tasks = (count + SquaresPerTask - 1) / SquaresPerTask;
  std::vector<double> sums(tasks, 0.0);
  tbb::parallel_for(0,
    tasks,
    [&](int task)
    {
      for (int s = task * SquaresPerTask; s < std::min(count, (task + 1) * SquaresPerTask); ++s)
      {
        for (int part = s * parts; part < (s + 1) * parts; ++part)
        {
          const Square& square = this->Squares[part];
          sums[task] += this->energyOf(square, derivativeOf(square, displacements));
        }
        for (std::size_t k = 0; !this->Kept.empty() && k < this->Kept[s].size(); ++k)
        {
          sums[task] += this->energyOf(this->Kept[s][k], displacements);
        }
      }
    });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
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

struct DeformationEnergy::NodeTerm
{
  double Energy = 0.0;
  Eigen::Matrix<double, 18, 1> Slope = Eigen::Matrix<double, 18, 1>::Zero(); // x and y of each node
  LatticeMatrix::SquareBlock Curvature = LatticeMatrix::SquareBlock::Zero(); // the lower triangle
};

void DeformationEnergy::addTo(NodeTerm& sum, const Square& square, const Points2& displacements) const
{
  const SquareTerm term = this->term(square, displacements);
  const std::array<Eigen::Vector2d, 9>& gradients = square.Influence.Gradients;
  sum.Energy += term.Energy;
  for (int b = 0; b < 9; ++b)
  {
    sum.Slope.segment<2>(2 * b) += term.Slope * gradients[b];
    const Eigen::Matrix<double, 4, 2> byNode =
      term.Curvature.leftCols<2>() * gradients[b].x() + term.Curvature.rightCols<2>() * gradients[b].y();
    for (int a = b; a < 9; ++a)
    {
      sum.Curvature.block<2, 2>(2 * a, 2 * b) +=
        gradients[a].x() * byNode.topRows<2>() + gradients[a].y() * byNode.bottomRows<2>();
    }
  }
}

void DeformationEnergy::addTo(NodeTerm& sum, const KeptPoint& kept, const Points2& displacements) const
{
  const WayOff off = this->wayOff(kept, displacements);
  const double weight = 2.0 * KeepingWeight * kept.Point.Length;
  sum.Energy += this->energyOf(kept, displacements);
  for (int a = 0; a < 9; ++a)
  {
    const double share = weight * kept.Influence.Weights[a];
    sum.Slope.segment<2>(2 * a) += share * off.Way;
    for (int b = 0; b <= a; ++b)
    {
      sum.Curvature.block<2, 2>(2 * a, 2 * b) += share * kept.Influence.Weights[b] * off.Projection;
    }
  }
}

std::vector<DeformationEnergy::NodeTerm> DeformationEnergy::nodeTerms(const Points2& displacements) const
{
  constexpr int parts = Divisions * Divisions;
  const int count = static_cast<int>(this->Squares.size()) / parts;
  std::vector<NodeTerm> terms(count);
  tbb::parallel_for(tbb::blocked_range<int>(0, count, SquaresPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int s = range.begin(); s < range.end(); ++s)
      {
        for (int part = s * parts; part < (s + 1) * parts; ++part)
        {
          this->addTo(terms[s], this->Squares[part], displacements);
        }
        for (std::size_t k = 0; !this->Kept.empty() && k < this->Kept[s].size(); ++k)
        {
          this->addTo(terms[s], this->Kept[s][k], displacements);
        }
      }
    });
  return terms;
}

double DeformationEnergy::derivatives(const Points2& displacements,
  Eigen::VectorXd& gradient,
  LatticeMatrix& hessian) const
{
  const std::vector<NodeTerm> terms = this->nodeTerms(displacements);
  double sum = 0.0;
  gradient.setZero(2 * this->Lattice.nodeCount());
  hessian.setZero();
  for (std::size_t s = 0; s < terms.size(); ++s)
  {
    const std::array<int, 9>& nodes = this->Squares[s * Divisions * Divisions].Influence.Nodes;
    sum += terms[s].Energy;
    for (int k = 0; k < 9; ++k)
    {
      gradient.segment<2>(2 * nodes[k]) += terms[s].Slope.segment<2>(2 * k);
    }
    hessian.add(nodes, terms[s].Curvature);
  }
  return sum;
}

} // namespace flattening
