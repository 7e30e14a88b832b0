// SPDX-License-Identifier: GPL-3.0-or-later
/// Boundaries with corners, where the map's scale goes to zero or to infinity.
#include "ConformalDisk.h"
#include "SampleSurfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace
{

using namespace flattening;
using samples::Pi;

// The triangle (0,0), (1,0), apex with n edges on each side.
TriangleMesh flatTriangle(int n, double apexX, double apexY)
{
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  const auto vertex = [](int i, int j) { return i * (i + 1) / 2 + j; };
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      vertices.push_back({ (i - j + j * apexX) / n, j * apexY / n, 0.0 });
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      faces.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      if (j < i)
      {
        faces.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
      }
    }
  }
  return samples::meshOf(vertices, faces);
}

std::complex<double> at(const ConformalDiskMap& map, int v)
{
  return { map.Positions(v, 0), map.Positions(v, 1) };
}

TEST(ConformalCorners, SharpCornersBecomePartOfTheCircle)
{
  for (const int n : { 1, 4, 16 })
  {
    for (const auto& apex : { std::array<double, 2>{ 0.5, 0.87 }, { 0.0, 1.0 }, { 1.0, 0.36 } })
    {
      SCOPED_TRACE(n);
      SCOPED_TRACE(apex[1]);
      const TriangleMesh mesh = flatTriangle(n, apex[0], apex[1]);
      const ConformalDiskMap map = conformalDiskMap(mesh);
      EXPECT_LE(map.MaxCurvatureError, 1e-10);
      EXPECT_LE(map.LayoutError, 1e-6);
      for (int i = 0; i <= n; ++i)
      {
        EXPECT_NEAR(std::abs(at(map, i * (i + 1) / 2)), 1.0, 1e-15);
      }
    }
  }
}

// The equilateral triangle's centroid goes to the centre, its corners a third of a turn apart, and the
// middles of its sides halfway between them.
TEST(ConformalCorners, EquilateralTriangleKeepsItsSymmetry)
{
  constexpr int n = 24;
  const TriangleMesh mesh = flatTriangle(n, 0.5, std::sqrt(0.75));
  const ConformalDiskMap map = conformalDiskMap(mesh);
  EXPECT_EQ(map.FlippedFaces, 0);
  const auto vertex = [](int i, int j) { return i * (i + 1) / 2 + j; };
  const std::complex<double> corners[] = { at(map, 0), at(map, vertex(n, 0)), at(map, vertex(n, n)) };
  const std::complex<double> middles[] = {
    at(map, vertex(n / 2, 0)), at(map, vertex(n, n / 2)), at(map, vertex(n / 2, n / 2))
  };
  const std::complex<double> third = std::polar(1.0, 2.0 * Pi / 3.0);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_LT(std::abs(corners[(k + 1) % 3] - third * corners[k]), 1e-3) << k;
    EXPECT_LT(std::abs(middles[k] - std::polar(1.0, Pi / 3.0) * corners[k]), 1e-3) << k;
  }
  EXPECT_LT(std::abs(at(map, vertex(2 * n / 3, n / 3))), 1e-3);
}

} // namespace
