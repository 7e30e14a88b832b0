// SPDX-License-Identifier: GPL-3.0-or-later
#include "Soup.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

vtkSmartPointer<vtkCellArray> cellArray(const std::vector<Cell>& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const Cell& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return array;
}

void appendCells(std::vector<Cell>& cells, const std::vector<Cell>& others, vtkIdType offset)
{
  for (Cell cell : others)
  {
    for (vtkIdType& corner : cell)
    {
      corner += offset;
    }
    cells.push_back(std::move(cell));
  }
}

} // namespace

vtkIdType Soup::add(const Point& point)
{
  this->Points.push_back(point);
  return static_cast<vtkIdType>(this->Points.size()) - 1;
}

vtkSmartPointer<vtkPolyData> toPolyData(const Soup& soup)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(soup.SinglePrecision ? VTK_FLOAT : VTK_DOUBLE);
  for (const Point& point : soup.Points)
  {
    points->InsertNextPoint(point.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cellArray(soup.Vertices));
  data->SetLines(cellArray(soup.Lines));
  data->SetPolys(cellArray(soup.Polygons));
  data->SetStrips(cellArray(soup.Strips));
  return data;
}

Soup soupOf(vtkPolyData* data)
{
  Soup soup;
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    Point point;
    data->GetPoint(p, point.data());
    soup.Points.push_back(point);
  }
  vtkNew<vtkIdList> ids;
  vtkCellArray* polygons = data->GetPolys();
  for (vtkIdType c = 0; c < polygons->GetNumberOfCells(); ++c)
  {
    polygons->GetCellAtId(c, ids);
    soup.Polygons.emplace_back(ids->begin(), ids->end());
  }
  return soup;
}

void append(Soup& soup, const Soup& other)
{
  const auto offset = static_cast<vtkIdType>(soup.Points.size());
  soup.Points.insert(soup.Points.end(), other.Points.begin(), other.Points.end());
  appendCells(soup.Vertices, other.Vertices, offset);
  appendCells(soup.Lines, other.Lines, offset);
  appendCells(soup.Polygons, other.Polygons, offset);
  appendCells(soup.Strips, other.Strips, offset);
}

double sizeOf(const Soup& soup)
{
  double size = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Point& point : soup.Points)
    {
      if (std::isfinite(point[k]))
      {
        low = std::min(low, point[k]);
        high = std::max(high, point[k]);
      }
    }
    size = std::max(size, high - low);
  }
  return size > 0.0 && std::isfinite(size) ? size : 1.0;
}

Soup gridSoup(const Grid& grid,
  const std::function<Point(double, double)>& position,
  const std::function<bool()>& diagonal)
{
  const int columns = grid.Around == Seam::Open ? grid.Columns + 1 : grid.Columns;
  const int rows = grid.Along == Seam::Open ? grid.Rows + 1 : grid.Rows;
  Soup soup;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      soup.add(position(static_cast<double>(i) / grid.Columns, static_cast<double>(j) / grid.Rows));
    }
  }
  const auto pointAt = [&](int i, int j) -> vtkIdType
  {
    if (j == rows)
    {
      j = 0;
      i = grid.Along == Seam::Reversed ? grid.Columns - i : i;
    }
    if (i >= columns)
    {
      i -= columns;
      j = grid.Around == Seam::Reversed ? rows - 1 - j : j;
    }
    return static_cast<vtkIdType>(j) * columns + i;
  };
  for (int j = 0; j < grid.Rows; ++j)
  {
    for (int i = 0; i < grid.Columns; ++i)
    {
      const vtkIdType a = pointAt(i, j);
      const vtkIdType b = pointAt(i + 1, j);
      const vtkIdType c = pointAt(i + 1, j + 1);
      const vtkIdType d = pointAt(i, j + 1);
      const bool rising = diagonal();
      soup.addTriangle(a, b, rising ? c : d);
      rising ? soup.addTriangle(a, c, d) : soup.addTriangle(b, c, d);
    }
  }
  return soup;
}

} // namespace fuzz
