// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Conformal/DiskNormalisation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace
{

using namespace flattening;
using Complex = std::complex<double>;

// Its vertices have equal masses.
DiskCentring centringOfATriangle()
{
  TriangleMesh triangle;
  triangle.Vertices.resize(3, 3);
  triangle.Vertices << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.5, std::sqrt(0.75), 0.0;
  triangle.Faces.resize(1, 3);
  triangle.Faces << 0, 1, 2;
  return DiskCentring(triangle);
}

// Three equal masses almost on the real axis: the centre is that of the ideal triangle between them, far
// above the medians of their coordinates.
TEST(DiskCentring, IsFarFromTheBoundaryWhereMassesLieBesideIt)
{
  const DiskCentring centring = centringOfATriangle();
  const ComplexVector positions{ { -1.0, 1e-9 }, { 0.0, 1e-9 }, { 1.0, 1e-9 } };
  const Complex centre(0.0, 1.0 / std::sqrt(3.0));
  EXPECT_LT(std::abs(centring.centre(positions) - centre), 1e-8);
  EXPECT_EQ(centring.roughCentre(positions), centring.centre(positions));
}

// Two thirds of the mass are one point of the boundary, which has no centre.
TEST(DiskCentring, IsRoughlyWhereMostOfTheMassIs)
{
  const DiskCentring centring = centringOfATriangle();
  const ComplexVector positions{ { -1.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 0.0 } };
  EXPECT_THROW(centring.centre(positions), ConvergenceError);
  EXPECT_EQ(centring.roughCentre(positions), Complex(2.0, 0.0));
}

} // namespace
