// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/FoldoverEnergy.h"

#include "Untangling/SmoothPositivePart.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <limits>

namespace flattening
{

FoldoverEnergy::FoldoverEnergy(const TargetTriangle& target, double areaWeight)
  : AreaWeight(areaWeight)
{
  Eigen::Matrix2d edges;
  edges << target.Second, target.Third;
  this->Gradients.bottomRows<2>() = edges.inverse();
  this->Gradients.row(0) = -this->Gradients.bottomRows<2>().colwise().sum();
}

double FoldoverEnergy::areaRatio(const Corners& corners) const
{
  return this->jacobian(corners).determinant();
}

double FoldoverEnergy::value(const Corners& corners, double epsilon) const
{
  const Eigen::Matrix2d j = this->jacobian(corners);
  const double d = j.determinant();
  if (epsilon <= 0.0 && d <= 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  return (j.squaredNorm() + this->AreaWeight * (d * d + 1.0)) / smoothPositivePart(d, epsilon).Value;
}

FoldoverEnergy::Derivatives FoldoverEnergy::derivatives(const Corners& corners, double epsilon) const
{
  using Vector4 = Eigen::Vector4d;
  const Eigen::Matrix2d m = this->jacobian(corners);
  const Vector4 j(m(0, 0), m(0, 1), m(1, 0), m(1, 1));
  const Vector4 cofactors(m(1, 1), -m(1, 0), -m(0, 1), m(0, 0)); // gradient of D by J
  Eigen::Matrix4d curvature = Eigen::Matrix4d::Zero();           // second derivatives of D by J
  curvature(0, 3) = curvature(3, 0) = 1.0;
  curvature(1, 2) = curvature(2, 1) = -1.0;

  // The energy is N / chi, N = |J|^2 + w (D^2 + 1).
  const double d = m.determinant();
  const double w = this->AreaWeight;
  const auto [root, chi] = smoothPositivePart(d, epsilon);
  const double chiByD = chi / root;
  const double chiByDD = 0.5 * epsilon * epsilon / (root * root * root);
  const double n = j.squaredNorm() + w * (d * d + 1.0);
  const double byD = (2.0 * w * d - n * chiByD / chi) / chi;
  const double byDD =
    (2.0 * w - 4.0 * w * d * chiByD / chi + n * (2.0 * chiByD * chiByD / chi - chiByDD) / chi) / chi;
  const double mixed = -2.0 * chiByD / (chi * chi);

  const Vector4 gradient = 2.0 / chi * j + byD * cofactors;
  const Eigen::Matrix4d hessian = 2.0 / chi * Eigen::Matrix4d::Identity() +
                                  mixed * (j * cofactors.transpose() + cofactors * j.transpose()) +
                                  byDD * (cofactors * cofactors.transpose()) + byD * curvature;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(hessian);
  const Eigen::Matrix4d convex = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                 eigen.eigenvectors().transpose();

  Eigen::Matrix<double, 4, 6> jacobianByCorners = Eigen::Matrix<double, 4, 6>::Zero();
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int c = 0; c < 2; ++c)
    {
      jacobianByCorners.block<2, 1>(2 * c, 2 * corner + c) = this->Gradients.row(corner).transpose();
    }
  }
  return { jacobianByCorners.transpose() * gradient,
    jacobianByCorners.transpose() * convex * jacobianByCorners };
}

} // namespace flattening
