// SPDX-License-Identifier: GPL-3.0-or-later
/// Points and cells of any kind, as the generators make them.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <functional>
#include <vector>

class vtkPolyData;

namespace fuzz
{

using Point = std::array<double, 3>;
using Cell = std::vector<vtkIdType>;

struct Soup
{
  std::vector<Point> Points;
  std::vector<Cell> Vertices;
  std::vector<Cell> Lines;
  std::vector<Cell> Polygons;
  std::vector<Cell> Strips;
  bool SinglePrecision = false;

  vtkIdType add(const Point& point);
  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c) { this->Polygons.push_back({ a, b, c }); }
};

vtkSmartPointer<vtkPolyData> toPolyData(const Soup& soup);

/// The points and polygons of polydata.
Soup soupOf(vtkPolyData* data);

/// Appends the points and cells of another soup.
void append(Soup& soup, const Soup& other);

/// Greatest side of the bounding box of the finite points; 1 if it is 0.
double sizeOf(const Soup& soup);

/// How two opposite sides of a grid are joined.
enum class Seam
{
  Open,     ///< two boundaries
  Closed,   ///< the last row meets the first
  Reversed, ///< the last row meets the first in reverse order
};

/// A grid of triangles with random diagonals. The position of a point is a function of u and v in [0,
/// 1].
struct Grid
{
  int Columns = 8;
  int Rows = 8;
  Seam Around = Seam::Open; ///< at the sides u = 0 and u = 1
  Seam Along = Seam::Open;  ///< at the sides v = 0 and v = 1
};

Soup gridSoup(const Grid& grid,
  const std::function<Point(double, double)>& position,
  const std::function<bool()>& diagonal);

} // namespace fuzz
