// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/FoldoverEnergy.h"

#include "Untangling/SmoothPositivePart.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

using Eigen::Vector2d;
using Eigen::Vector4d;

// The unit vector along a vector of a length, and any unit vector if that is 0.
Vector2d directionOf(const Vector2d& vector, double length)
{
  return length > 0.0 ? Vector2d(vector / length) : Vector2d(1.0, 0.0);
}

// The second derivatives, by the entries of J in rows, of a function of |J|^2 and D = det J,
//   a I + m (j c^T + c j^T) + q c c^T + p K,
// where j are the entries, c = K j the derivatives of D by them, and K its second derivatives.
struct IsotropicHessian
{
  double OfIdentity; // a
  double OfMixed;    // m
  double OfSquare;   // q
  double OfDet;      // p

  // The nearest matrix that has no negative eigenvalues (Smith, de Goes and Kim 2019, "Analytic
  // eigensystems for isotropic distortion energies"). The eigenvalues of K are 1, for multiples of
  // rotations, and -1, for multiples of reflections. J is the sum of one of each. In the plane of these
  // two the matrix has 2 x 2 entries; at right angles to it, its eigenvalues are a + p and a - p.
  Eigen::Matrix4d positivePart(const Eigen::Matrix2d& j) const
  {
    const double unit = std::sqrt(0.5); // a rotation has the norm 1 / unit
    const Vector2d rotation = unit * Vector2d(j(0, 0) + j(1, 1), j(0, 1) - j(1, 0));
    const Vector2d reflection = unit * Vector2d(j(0, 0) - j(1, 1), j(0, 1) + j(1, 0));
    const double r = rotation.norm();
    const double s = reflection.norm();
    const Vector2d alongR = unit * directionOf(rotation, r);
    const Vector2d alongS = unit * directionOf(reflection, s);
    const Vector4d first(alongR.x(), alongR.y(), -alongR.y(), alongR.x());
    const Vector4d second(alongS.x(), alongS.y(), alongS.y(), -alongS.x());
    const Vector4d otherFirst(-alongR.y(), alongR.x(), -alongR.x(), -alongR.y());
    const Vector4d otherSecond(-alongS.y(), alongS.x(), alongS.x(), alongS.y());

    // j = r first + s second, and c = r first - s second.
    const double ofFirst =
      this->OfIdentity + this->OfDet + (2.0 * this->OfMixed + this->OfSquare) * r * r;
    const double ofSecond =
      this->OfIdentity - this->OfDet + (this->OfSquare - 2.0 * this->OfMixed) * s * s;
    const double ofBoth = -this->OfSquare * r * s;
    const double mean = 0.5 * (ofFirst + ofSecond);
    const double half = 0.5 * (ofFirst - ofSecond);
    const double spread =
      std::hypot(half, ofBoth); // the eigenvalues are mean + spread and mean - spread
    const double greater = std::max(0.0, mean + spread);
    const double smaller = std::max(0.0, mean - spread);
    const double middle = 0.5 * (greater + smaller);
    const double share = spread > 0.0 ? 0.5 * (greater - smaller) / spread : 0.0;
    return (middle + share * half) * (first * first.transpose()) +
           (middle - share * half) * (second * second.transpose()) +
           share * ofBoth * (first * second.transpose() + second * first.transpose()) +
           std::max(0.0, this->OfIdentity + this->OfDet) * (otherFirst * otherFirst.transpose()) +
           std::max(0.0, this->OfIdentity - this->OfDet) * (otherSecond * otherSecond.transpose());
  }
};

} // namespace

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
  const Eigen::Matrix2d m = this->jacobian(corners);
  const Vector4d j(m(0, 0), m(0, 1), m(1, 0), m(1, 1));
  const Vector4d cofactors(m(1, 1), -m(1, 0), -m(0, 1), m(0, 0)); // gradient of D by J

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

  const Vector4d gradient = 2.0 / chi * j + byD * cofactors;
  const Eigen::Matrix4d convex = IsotropicHessian{ 2.0 / chi, mixed, byDD, byD }.positivePart(m);

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
