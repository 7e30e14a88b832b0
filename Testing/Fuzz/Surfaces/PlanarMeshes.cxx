// SPDX-License-Identifier: GPL-3.0-or-later
#include "Generators.h"

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

// A grid in the unit square whose points are moved at random by a share of a cell.
Soup unevenSquare(Random& random, int faces, double jitter)
{
  const double aspect = random.chance(0.6) ? 1.0 : random.logUniform(0.05, 20.0);
  const int columns = std::clamp(static_cast<int>(std::sqrt(faces / 2.0 * aspect)), 1, faces);
  const int rows = std::clamp(faces / 2 / columns, 1, faces);
  return gridSoup(
    { columns, rows },
    [&](double u, double v) -> Point
    {
      return { u + jitter * random.uniform(-0.5, 0.5) / columns,
        v + jitter * random.uniform(-0.5, 0.5) / rows,
        0.0 };
    },
    [&] { return random.chance(0.5); });
}

void removeFacesAround(Soup& soup, const Point& centre, double radius)
{
  const auto isInside = [&](const Cell& face)
  {
    const Point& point = soup.Points[face.front()];
    return std::hypot(point[0] - centre[0], point[1] - centre[1]) < radius;
  };
  soup.Polygons.erase(
    std::remove_if(soup.Polygons.begin(), soup.Polygons.end(), isInside), soup.Polygons.end());
}

} // namespace

Soup stretchedPlane(Random& random, int faces)
{
  Soup soup = unevenSquare(random, faces, random.uniform(0.0, 1.9));
  for (int hole = random.chance(0.3) ? random.integer(1, 3) : 0; hole > 0; --hole)
  {
    removeFacesAround(soup, { random.uniform(), random.uniform(), 0.0 }, random.uniform(0.02, 0.2));
  }
  const double stretch = random.logUniform(1.0, 1e6);
  const double wave = random.chance(0.3) ? random.logUniform(1e-12, 0.3) : 0.0;
  for (Point& point : soup.Points)
  {
    point[2] = wave * std::sin(9.0 * point[0]) * std::cos(7.0 * point[1]);
    point[0] *= stretch;
  }
  return soup;
}

Soup needlesAndCaps(Random& random, int faces)
{
  Soup soup = unevenSquare(random, faces, random.uniform(0.0, 1.5));
  const double bump = random.chance(0.5) ? random.uniform(0.0, 1.0) : 0.0;
  for (Point& point : soup.Points)
  {
    point[2] = bump * std::sin(4.0 * point[0]) * std::sin(3.0 * point[1]);
  }
  const double smallest = random.logUniform(1e-18, 1e-2);
  const int count = static_cast<int>(soup.Polygons.size());
  for (int n = random.integer(1, std::max(1, count / 4)); n > 0; --n)
  {
    // A corner moves next to the opposite side (a cap) or to the next corner (a needle).
    const Cell& face = random.pick(soup.Polygons);
    const double share = random.chance(0.5) ? random.uniform() : 0.0;
    const double distance = random.logUniform(smallest, 0.1);
    const Point a = soup.Points[face[1]];
    const Point b = soup.Points[face[2]];
    Point& moved = soup.Points[face[0]];
    for (int k = 0; k < 3; ++k)
    {
      moved[k] = a[k] + share * (b[k] - a[k]) + distance * (moved[k] - a[k]);
    }
  }
  return soup;
}

} // namespace fuzz
