// SPDX-License-Identifier: GPL-3.0-or-later
#include "DrawnShapes.h"

#include "../Soup.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

Point pointNear(Random& random, vtkPolyData* surface)
{
  Point point = { 0.0, 0.0, 0.0 };
  const auto points = static_cast<int>(surface->GetNumberOfPoints());
  if (points > 0)
  {
    surface->GetPoint(random.integer(0, points - 1), point.data());
  }
  if (random.chance(0.2)) // beside the surface
  {
    const double distance =
      surface->GetLength() * random.logUniform(1e-6, random.chance(0.9) ? 0.05 : 10);
    for (double& x : point)
    {
      x += distance * random.normal();
    }
  }
  return point;
}

// Points on the straight line from the last point of a line to the next one.
void addStraight(Soup& soup, Cell& line, const Point& end, int steps)
{
  const Point start = soup.Points.at(line.back());
  for (int n = 1; n <= steps; ++n)
  {
    const double t = static_cast<double>(n) / steps;
    Point point;
    for (int k = 0; k < 3; ++k)
    {
      point[k] = (1.0 - t) * start[k] + t * end[k];
    }
    line.push_back(soup.add(point));
  }
}

Cell drawnLine(Random& random, vtkPolyData* surface, Soup& soup)
{
  const bool meetsEarlier = !soup.Points.empty() && random.chance(0.5);
  Cell line = { meetsEarlier
                  ? static_cast<vtkIdType>(random.integer(0, static_cast<int>(soup.Points.size()) - 1))
                  : soup.add(pointNear(random, surface)) };
  for (int n = random.integer(random.chance(0.05) ? 0 : 1, 4); n > 0; --n)
  {
    addStraight(soup, line, pointNear(random, surface), random.chance(0.5) ? 1 : random.integer(2, 30));
  }
  if (random.chance(0.05))
  {
    line.push_back(line.front());
  }
  if (random.chance(0.05))
  {
    line.push_back(line.back());
  }
  return line;
}

// The corners of a convex polygon: points of an ellipse, and points on its sides.
std::vector<Point> convexCorners(Random& random)
{
  const double width = random.chance(0.8) ? random.logUniform(0.1, 1.0) : random.logUniform(1e-9, 0.1);
  const double rotation = random.uniform(0.0, 7.0);
  std::vector<double> angles;
  for (int n = random.integer(3, random.chance(0.8) ? 8 : 200); n > 0; --n)
  {
    angles.push_back(random.uniform(0.0, 2.0 * vtkMath::Pi()));
  }
  std::sort(angles.begin(), angles.end());
  std::vector<Point> corners;
  for (const double angle : angles)
  {
    const double x = std::cos(angle);
    const double y = width * std::sin(angle);
    const Point corner = { x * std::cos(rotation) - y * std::sin(rotation),
      x * std::sin(rotation) + y * std::cos(rotation),
      0.0 };
    if (!corners.empty() && random.chance(0.1))
    {
      const Point& last = corners.back();
      corners.push_back({ 0.5 * (last[0] + corner[0]), 0.5 * (last[1] + corner[1]), 0.0 });
    }
    corners.push_back(corner);
  }
  return corners;
}

void spoil(Random& random, std::vector<Point>& corners)
{
  Point& corner = corners.at(random.integer(0, static_cast<int>(corners.size()) - 1));
  switch (random.integer(0, 5))
  {
    case 0:
      corner[random.integer(0, 2)] = std::nan("");
      break;
    case 1:
      corner[2] = random.logUniform(1e-18, 1.0);
      break;
    case 2:
      corner = corners.front();
      break;
    case 3:
      std::swap(corner, corners.back());
      break;
    case 4:
      corner = { 0.0, 0.0, 0.0 };
      break;
    default:
      corners.resize(random.integer(0, 2));
      break;
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> drawnLines(Random& random, vtkPolyData* surface)
{
  Soup soup;
  for (int n = random.integer(random.chance(0.05) ? 0 : 1, 4); n > 0; --n)
  {
    const Cell line = drawnLine(random, surface, soup);
    soup.Lines.push_back(line);
  }
  if (!soup.Points.empty() && random.chance(0.03))
  {
    soup.Points.back()[random.integer(0, 2)] = random.chance(0.5) ? std::nan("") : 1e300;
  }
  auto lines = toPolyData(soup);
  if (random.chance(0.2))
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName("SeamId");
    for (vtkIdType c = 0; c < lines->GetNumberOfCells(); ++c)
    {
      ids->InsertNextValue(random.integer(-1, 3));
    }
    lines->GetCellData()->AddArray(ids);
  }
  return lines;
}

vtkSmartPointer<vtkPolyData> drawnPolygon(Random& random)
{
  std::vector<Point> corners = convexCorners(random);
  if (random.chance(0.3))
  {
    std::reverse(corners.begin(), corners.end());
  }
  if (random.chance(0.15))
  {
    spoil(random, corners);
  }
  const double size = random.chance(0.8) ? 1.0 : random.logUniform(1e-250, 1e250);
  const double away = random.chance(0.7) ? 0.0 : size * random.logUniform(1.0, 1e10);
  Soup soup;
  Cell outline;
  for (const Point& corner : corners)
  {
    outline.push_back(soup.add({ size * corner[0] + away, size * corner[1] - away, size * corner[2] }));
  }
  if (random.chance(0.5))
  {
    soup.Polygons.push_back(outline);
  }
  else
  {
    if (!outline.empty() && random.chance(0.95))
    {
      outline.push_back(outline.front());
    }
    soup.Lines.push_back(outline);
  }
  return toPolyData(soup);
}

vtkSmartPointer<vtkPolyData> withRegions(Random& random, vtkPolyData* surface, const char* name)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  std::vector<int> values(count, 0);
  for (int region = 3; region > 0 && count > 0; --region)
  {
    const Point centre = pointNear(random, surface);
    const double radius = surface->GetLength() * random.logUniform(0.01, 0.6);
    for (vtkIdType p = 0; p < count; ++p)
    {
      Point point;
      surface->GetPoint(p, point.data());
      const double distance =
        std::hypot(point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]);
      values[p] = distance <= radius ? region : values[p];
    }
  }
  vtkNew<vtkIntArray> regions;
  regions->SetName(name);
  for (const int value : values)
  {
    regions->InsertNextValue(value);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  result->GetPointData()->AddArray(regions);
  return result;
}

} // namespace fuzz
