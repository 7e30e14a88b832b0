// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactOrientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

namespace fuzz
{

int orientation(const Point& a, const Point& b, const Point& c)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  // A power of two is exact and keeps products of the coordinates from overflow.
  double greatest = 0.0;
  for (const Point* point : { &a, &b, &c })
  {
    greatest = std::max({ greatest, std::abs((*point)[0]), std::abs((*point)[1]) });
  }
  const int exponent = greatest > 0.0 && std::isfinite(greatest) ? -std::ilogb(greatest) : 0;
  const auto scaled = [exponent](const Point& point)
  { return Kernel::Point_2(std::ldexp(point[0], exponent), std::ldexp(point[1], exponent)); };
  return static_cast<int>(CGAL::orientation(scaled(a), scaled(b), scaled(c)));
}

} // namespace fuzz
