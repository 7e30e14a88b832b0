// SPDX-License-Identifier: GPL-3.0-or-later
#include "Generators.h"

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

} // namespace

Soup book(Random& random, int faces)
{
  const int pages = random.integer(3, 8);
  const int rows = random.integer(1, 10);
  const int columns = std::max(1, faces / 2 / pages / rows);
  const double length = random.logUniform(0.1, 20.0);
  Soup soup;
  for (int j = 0; j <= rows; ++j)
  {
    soup.add({ 0.0, 0.0, length * j / rows });
  }
  for (int page = 0; page < pages; ++page)
  {
    const double angle = random.chance(0.1) ? 0.0 : random.uniform(0.0, 2.0 * Pi);
    const double width = random.logUniform(0.1, 5.0);
    const auto first = static_cast<vtkIdType>(soup.Points.size());
    for (int i = 1; i <= columns; ++i)
    {
      for (int j = 0; j <= rows; ++j)
      {
        const double r = width * i / columns;
        soup.add({ r * std::cos(angle), r * std::sin(angle), length * j / rows });
      }
    }
    const auto at = [&](int i, int j) -> vtkIdType
    { return i == 0 ? j : first + static_cast<vtkIdType>(i - 1) * (rows + 1) + j; };
    const bool reversed = random.chance(0.5);
    for (int i = 0; i < columns; ++i)
    {
      for (int j = 0; j < rows; ++j)
      {
        Cell square = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
        reversed ? std::reverse(square.begin(), square.end()) : void();
        soup.addTriangle(square[0], square[1], square[2]);
        soup.addTriangle(square[0], square[2], square[3]);
      }
    }
  }
  return soup;
}

Soup cracks(Random& random, int faces)
{
  // Strips of squares side by side. Each strip divides its sides in its own way.
  const int strips = random.integer(2, 8);
  const double gap = random.chance(0.6) ? 0.0 : random.logUniform(1e-16, 1e-3);
  Soup soup;
  for (int s = 0; s < strips; ++s)
  {
    const int rows = random.integer(1, std::max(1, faces / strips));
    const Soup strip = gridSoup(
      { 1, rows },
      [&](double u, double v) -> Point {
        return { s + u + gap * random.normal(), v * strips, 0.0 };
      },
      [&] { return random.chance(0.5); });
    append(soup, strip);
  }
  const double bend = random.chance(0.5) ? random.uniform(0.0, 0.3) : 0.0;
  for (Point& point : soup.Points)
  {
    point[2] = bend * point[0] * point[0];
  }
  return soup;
}

Soup oneSided(Random& random, int faces)
{
  const int columns = std::max(5, static_cast<int>(std::sqrt(faces)));
  const int rows = std::max(2, faces / 2 / columns);
  const bool closed = random.chance(0.5);
  const double width = random.logUniform(0.05, 1.0);
  return gridSoup(
    { columns, rows, Seam::Reversed, closed ? Seam::Closed : Seam::Open },
    [&](double u, double v) -> Point
    {
      const double turn = 2.0 * Pi * u;
      if (!closed)
      {
        const double across = width * (2.0 * v - 1.0);
        const double radius = 1.0 + across * std::cos(0.5 * turn);
        return { radius * std::cos(turn), radius * std::sin(turn), across * std::sin(0.5 * turn) };
      }
      const double t = 2.0 * Pi * v;
      const double radius =
        2.0 + std::cos(0.5 * turn) * std::sin(t) - std::sin(0.5 * turn) * std::sin(2.0 * t);
      return { radius * std::cos(turn),
        radius * std::sin(turn),
        std::sin(0.5 * turn) * std::sin(t) + std::cos(0.5 * turn) * std::sin(2.0 * t) };
    },
    [&] { return random.chance(0.5); });
}

Soup randomTriangles(Random& random, int faces)
{
  Soup soup;
  const int points = std::max(3, static_cast<int>(faces * random.logUniform(0.05, 3.0)));
  const bool onGrid = random.chance(0.3);
  for (int p = 0; p < points; ++p)
  {
    Point point = { random.uniform(), random.uniform(), random.uniform() };
    for (double& x : point)
    {
      x = onGrid ? std::floor(5.0 * x) : x;
    }
    soup.add(point);
  }
  for (int f = 0; f < faces; ++f)
  {
    soup.addTriangle(
      random.integer(0, points - 1), random.integer(0, points - 1), random.integer(0, points - 1));
  }
  return soup;
}

Soup tiny(Random& random, int)
{
  Soup soup;
  const int points = random.integer(0, 6);
  const bool degenerate = random.chance(0.3);
  for (int p = 0; p < points; ++p)
  {
    const double line = random.uniform();
    soup.add(degenerate ? Point{ line, 2.0 * line, -line }
                        : Point{ random.uniform(), random.uniform(), random.uniform() });
  }
  for (int f = points > 0 ? random.integer(0, 4) : 0; f > 0; --f)
  {
    soup.addTriangle(
      random.integer(0, points - 1), random.integer(0, points - 1), random.integer(0, points - 1));
  }
  return soup;
}

Soup polygonsAndStrips(Random& random, int faces)
{
  const int rows = std::max(1, static_cast<int>(std::sqrt(faces / 2.0)));
  const int columns = std::max(1, faces / 2 / rows);
  const double bump = random.chance(0.3) ? 0.0 : random.uniform(0.0, 2.0);
  Soup grid = gridSoup(
    { columns, rows },
    [&](double u, double v) -> Point {
      return { u, v, bump * std::sin(3.0 * u) * std::cos(2.0 * v) };
    },
    [] { return true; });
  grid.Polygons.clear();
  const auto at = [&](int i, int j) -> vtkIdType
  { return static_cast<vtkIdType>(j) * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j)
  {
    if (random.chance(0.4)) // a row as a triangle strip
    {
      Cell strip;
      for (int i = 0; i <= columns; ++i)
      {
        strip.push_back(at(i, j));
        strip.push_back(at(i, j + 1));
      }
      grid.Strips.push_back(strip);
      continue;
    }
    // The row in polygons of random width, whose long sides have points in their middle.
    for (int i = 0; i < columns;)
    {
      const int end = std::min(columns, i + random.integer(1, 5));
      Cell polygon;
      for (int k = i; k <= end; ++k)
      {
        polygon.push_back(at(k, j));
      }
      for (int k = end; k >= i; --k)
      {
        polygon.push_back(at(k, j + 1));
      }
      if (random.chance(0.05))
      {
        polygon.push_back(polygon[random.integer(0, static_cast<int>(polygon.size()) - 1)]);
      }
      if (random.chance(0.02))
      {
        polygon.resize(random.integer(0, 2)); // not a polygon at all
      }
      grid.Polygons.push_back(polygon);
      i = end;
    }
  }
  return grid;
}

} // namespace fuzz
