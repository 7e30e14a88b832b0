// SPDX-License-Identifier: GPL-3.0-or-later
#include "Generators.h"

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

// A sphere of meridians and parallels with both poles, whose radius depends on the direction.
template <typename Radius>
Soup roundSurface(Random& random, int faces, const Radius& radius)
{
  const int columns = std::max(3, static_cast<int>(std::sqrt(faces * random.uniform(0.5, 2.0))));
  const int rows = std::max(2, faces / 2 / columns + 1);
  const auto place = [&](double longitude, double latitude) -> Point
  {
    const Point direction = { std::sin(latitude) * std::cos(longitude),
      std::sin(latitude) * std::sin(longitude),
      std::cos(latitude) };
    const double r = radius(direction);
    return { r * direction[0], r * direction[1], r * direction[2] };
  };
  Soup soup;
  const vtkIdType top = soup.add(place(0.0, 0.0));
  const vtkIdType bottom = soup.add(place(0.0, Pi));
  for (int j = 1; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      soup.add(place(2.0 * Pi * i / columns, Pi * j / rows));
    }
  }
  const auto at = [&](int i, int j) -> vtkIdType { return 2 + (j - 1) * columns + i % columns; };
  for (int i = 0; i < columns; ++i)
  {
    soup.addTriangle(top, at(i, 1), at(i + 1, 1));
    soup.addTriangle(bottom, at(i + 1, rows - 1), at(i, rows - 1));
    for (int j = 1; j + 1 < rows; ++j)
    {
      soup.addTriangle(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      soup.addTriangle(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  return soup;
}

// Removes the faces above a random height, so that a closed surface becomes an open one.
void openTop(Random& random, Soup& soup)
{
  const double height = random.uniform(-0.7, 0.95) * sizeOf(soup) / 2.0;
  const auto isAbove = [&](const Cell& face) { return soup.Points[face.front()][2] > height; };
  soup.Polygons.erase(
    std::remove_if(soup.Polygons.begin(), soup.Polygons.end(), isAbove), soup.Polygons.end());
}

Point randomDirection(Random& random)
{
  const Point v = { random.normal(), random.normal(), random.normal() };
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return { v[0] / length, v[1] / length, v[2] / length };
}

} // namespace

Soup closedSphere(Random& random, int faces)
{
  const double noise = random.chance(0.5) ? 0.0 : random.logUniform(1e-6, 0.3);
  Soup soup =
    roundSurface(random, faces, [&](const Point&) { return 1.0 + noise * random.uniform(-1.0, 1.0); });
  const double flatness = random.chance(0.5) ? 1.0 : random.logUniform(1e-9, 1e2);
  for (Point& point : soup.Points)
  {
    point[1] *= flatness;
  }
  return soup;
}

Soup horns(Random& random, int faces)
{
  struct Horn
  {
    Point Direction;
    double Length, Width;
  };
  std::vector<Horn> all(random.integer(1, 5));
  for (Horn& horn : all)
  {
    horn = { randomDirection(random), random.logUniform(0.5, 100.0), random.logUniform(0.03, 0.5) };
  }
  Soup soup = roundSurface(random,
    faces,
    [&](const Point& x)
    {
      double radius = 1.0;
      for (const Horn& horn : all)
      {
        const Point& d = horn.Direction;
        const double cosine = std::clamp(x[0] * d[0] + x[1] * d[1] + x[2] * d[2], -1.0, 1.0);
        const double angle = std::acos(cosine) / horn.Width;
        radius += horn.Length * std::exp(-angle * angle);
      }
      return radius;
    });
  if (random.chance(0.5))
  {
    openTop(random, soup);
  }
  return soup;
}

Soup pressedTube(Random& random, int faces)
{
  const int around =
    std::clamp(static_cast<int>(random.logUniform(3.0, 60.0)), 3, std::max(3, faces / 2));
  const int along = std::max(1, faces / 2 / around);
  const double press = random.chance(0.15) ? 0.0 : random.logUniform(1e-17, 1.0);
  const double length = random.logUniform(0.5, 200.0);
  const double bend = random.chance(0.4) ? random.uniform(0.0, 6.0) : 0.0;
  const double jitter = random.chance(0.5) ? random.logUniform(1e-12, 0.2) : 0.0;
  const Seam ends = random.chance(0.15) ? Seam::Closed : Seam::Open;
  return gridSoup(
    { around, along, Seam::Closed, ends },
    [&](double u, double v) -> Point
    {
      const double x = std::cos(2.0 * Pi * u) + jitter * random.normal();
      const double y = press * (std::sin(2.0 * Pi * u) + jitter * random.normal());
      if (bend > 0.0)
      {
        const double radius = length / bend + x;
        return { radius * std::cos(bend * v), y, radius * std::sin(bend * v) };
      }
      return { x, y, length * v };
    },
    [&] { return random.chance(0.5); });
}

Soup torus(Random& random, int faces)
{
  const int columns =
    std::max(3, static_cast<int>(std::sqrt(faces / 2.0 * random.logUniform(0.2, 5.0))));
  const int rows = std::max(3, faces / 2 / columns);
  const double minor = random.logUniform(1e-4, 2.0); // above 1 the surface intersects itself
  const double noise = random.chance(0.5) ? 0.0 : random.logUniform(1e-6, 0.1);
  Soup soup = gridSoup(
    { columns, rows, Seam::Closed, Seam::Closed },
    [&](double u, double v) -> Point
    {
      const double tube = minor * (1.0 + noise * random.normal());
      const double radius = 1.0 + tube * std::cos(2.0 * Pi * u);
      return {
        radius * std::cos(2.0 * Pi * v), radius * std::sin(2.0 * Pi * v), tube * std::sin(2.0 * Pi * u)
      };
    },
    [&] { return random.chance(0.5); });
  if (random.chance(0.4))
  {
    openTop(random, soup);
  }
  return soup;
}

} // namespace fuzz
