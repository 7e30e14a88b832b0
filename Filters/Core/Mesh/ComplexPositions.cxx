// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ComplexPositions.h"

namespace flattening
{

Points2 pointsOf(const ComplexVector& positions)
{
  Points2 points(positions.size(), 2);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points.row(i) << positions[i].real(), positions[i].imag();
  }
  return points;
}

ComplexVector complexOf(const Points2& positions)
{
  ComplexVector numbers(positions.rows());
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    numbers[i] = std::complex<double>(positions(i, 0), positions(i, 1));
  }
  return numbers;
}

} // namespace flattening
