// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/ShapeDistortion.h"

#include "Mesh/PlaneVectors.h"

#include <cmath>

namespace flattening
{

double shapeDistortion(const RefinementTerms& terms,
  const Points2& positions,
  const Eigen::VectorXd& targets)
{
  double sum = 0.0;
  for (Eigen::Index f = 0; f < terms.Faces.rows(); ++f)
  {
    Eigen::Vector2d sides[3];
    double dirichlet = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      sides[k] = positions.row(terms.Faces(f, (k + 2) % 3)) - positions.row(terms.Faces(f, (k + 1) % 3));
      dirichlet += 0.25 * terms.Cotangents(f, k) * sides[k].squaredNorm();
    }
    const double area = 0.5 * cross(sides[0], sides[1]);
    sum += area > 0.0 && dirichlet > area ? targets[f] * std::log(dirichlet / area) : 0.0;
  }
  return sum / targets.sum();
}

} // namespace flattening
