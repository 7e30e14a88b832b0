// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuzz
{

void scale(Random& random, Soup& soup)
{
  const double factor = random.chance(0.5) ? std::ldexp(1.0, random.integer(-990, 990))
                                           : std::pow(10.0, random.integer(-300, 300));
  for (Point& point : soup.Points)
  {
    for (double& x : point)
    {
      x *= factor;
    }
  }
}

void offset(Random& random, Soup& soup)
{
  const double distance = sizeOf(soup) * random.logUniform(1.0, 1e15);
  const Point direction = {
    random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)
  };
  for (Point& point : soup.Points)
  {
    for (int k = 0; k < 3; ++k)
    {
      point[k] += distance * direction[k];
    }
  }
}

void spoilCoordinates(Random& random, Soup& soup)
{
  const std::vector<double> values = {
    std::nan(""), HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::max()
  };
  for (int n = random.integer(1, 3); n > 0 && !soup.Points.empty(); --n)
  {
    const int p = random.integer(0, static_cast<int>(soup.Points.size()) - 1);
    soup.Points[p][random.integer(0, 2)] = random.pick(values);
  }
}

void repeatFaces(Random& random, Soup& soup)
{
  const double share = random.logUniform(0.005, 0.5);
  const bool reverses = random.chance(0.5);
  const std::size_t count = soup.Polygons.size();
  for (std::size_t f = 0; f < count; ++f)
  {
    if (random.chance(share))
    {
      Cell face = soup.Polygons[f];
      if (random.chance(0.5))
      {
        std::reverse(face.begin(), face.end());
      }
      reverses ? void(soup.Polygons[f] = face) : soup.Polygons.push_back(face);
    }
  }
}

void repeatPoints(Random& random, Soup& soup)
{
  const double share = random.chance(0.3) ? 1.0 : random.logUniform(0.01, 1.0);
  const double distance = random.chance(0.6) ? 0.0 : sizeOf(soup) * random.logUniform(1e-17, 1e-3);
  for (Cell& face : soup.Polygons)
  {
    for (vtkIdType& corner : face)
    {
      if (random.chance(share))
      {
        Point copy = soup.Points[corner];
        for (double& x : copy)
        {
          x += distance * random.uniform(-1.0, 1.0);
        }
        corner = soup.add(copy);
      }
    }
  }
}

void removeFaces(Random& random, Soup& soup)
{
  const double share = random.logUniform(0.002, 0.5);
  soup.Polygons.erase(
    std::remove_if(
      soup.Polygons.begin(), soup.Polygons.end(), [&](const Cell&) { return random.chance(share); }),
    soup.Polygons.end());
}

void addOtherCells(Random& random, Soup& soup)
{
  const double size = sizeOf(soup);
  for (int n = random.integer(1, 20); n > 0; --n)
  {
    soup.add({ size * random.normal(), size * random.normal(), size * random.normal() });
  }
  const int last = static_cast<int>(soup.Points.size()) - 1;
  for (int n = random.integer(0, 10); n > 0; --n)
  {
    soup.Vertices.push_back({ random.integer(0, last) });
  }
  for (int n = random.integer(0, 5); n > 0; --n)
  {
    Cell line;
    for (int k = random.integer(2, 6); k > 0; --k)
    {
      line.push_back(random.integer(0, last));
    }
    soup.Lines.push_back(line);
  }
}

void shake(Random& random, Soup& soup)
{
  const double distance = sizeOf(soup) * random.logUniform(1e-17, 0.1);
  for (Point& point : soup.Points)
  {
    for (double& x : point)
    {
      x += distance * random.normal();
    }
  }
}

} // namespace fuzz
