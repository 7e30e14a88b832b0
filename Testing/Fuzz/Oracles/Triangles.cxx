// SPDX-License-Identifier: GPL-3.0-or-later
#include "Triangles.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fuzz
{
namespace
{

using LongPoint = std::array<long double, 3>;

LongPoint difference(const Point& a, const Point& b)
{
  return { static_cast<long double>(a[0]) - b[0],
    static_cast<long double>(a[1]) - b[1],
    static_cast<long double>(a[2]) - b[2] };
}

long double dot(const LongPoint& u, const LongPoint& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

LongPoint cross(const LongPoint& u, const LongPoint& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

long double squaredLength(const LongPoint& v)
{
  return dot(v, v);
}

// Distance of the point a + w from the side from a to a + side.
long double distanceToSide(const LongPoint& side, const LongPoint& w)
{
  const long double length = squaredLength(side);
  const long double share = length > 0.0L ? std::clamp(dot(side, w) / length, 0.0L, 1.0L) : 0.0L;
  return std::sqrt(
    squaredLength({ w[0] - share * side[0], w[1] - share * side[1], w[2] - share * side[2] }));
}

} // namespace

Triangles trianglesOf(vtkPolyData* data, const char* positions)
{
  Triangles mesh;
  vtkDataArray* array = positions ? data->GetPointData()->GetArray(positions) : nullptr;
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    Point point;
    array ? array->GetTuple(p, point.data()) : data->GetPoint(p, point.data());
    mesh.Points.push_back(point);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetPolys()->GetNumberOfCells(); ++c)
  {
    data->GetPolys()->GetCellAtId(c, ids);
    if (ids->GetNumberOfIds() == 3)
    {
      mesh.Faces.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
    }
  }
  return mesh;
}

long double areaOf(const Triangles& mesh, const Triangle& face)
{
  const LongPoint u = difference(mesh.Points[face[1]], mesh.Points[face[0]]);
  const LongPoint v = difference(mesh.Points[face[2]], mesh.Points[face[0]]);
  return 0.5L * std::sqrt(squaredLength(cross(u, v)));
}

long double totalArea(const Triangles& mesh)
{
  long double total = 0.0L;
  for (const Triangle& face : mesh.Faces)
  {
    total += areaOf(mesh, face);
  }
  return total;
}

long double greatestSquaredSide(const Triangles& mesh, const Triangle& face)
{
  long double greatest = 0.0L;
  for (int k = 0; k < 3; ++k)
  {
    greatest = std::max(
      greatest, squaredLength(difference(mesh.Points[face[k]], mesh.Points[face[(k + 1) % 3]])));
  }
  return greatest;
}

long double greatestCoordinate(const Triangles& mesh)
{
  long double size = 0.0L;
  for (const Point& p : mesh.Points)
  {
    for (const double x : p)
    {
      size = std::max(size, std::abs(static_cast<long double>(x)));
    }
  }
  return size;
}

long double distanceTo(const Triangles& mesh, const Triangle& face, const Point& point)
{
  const Point& a = mesh.Points[face[0]];
  const LongPoint normal =
    cross(difference(mesh.Points[face[1]], a), difference(mesh.Points[face[2]], a));
  const long double length = std::sqrt(squaredLength(normal));
  bool isAbove = length > 0.0L;
  long double nearest = HUGE_VALL;
  for (int k = 0; k < 3; ++k)
  {
    const Point& from = mesh.Points[face[k]];
    const LongPoint side = difference(mesh.Points[face[(k + 1) % 3]], from);
    const LongPoint w = difference(point, from);
    isAbove = isAbove && dot(cross(side, w), normal) >= 0.0L;
    nearest = std::min(nearest, distanceToSide(side, w));
  }
  return isAbove ? std::min(nearest, std::abs(dot(normal, difference(point, a))) / length) : nearest;
}

std::vector<std::vector<vtkIdType>> boundaryLoops(const Triangles& mesh)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const Triangle& face : mesh.Faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert({ face[k], face[(k + 1) % 3] });
    }
  }
  std::map<vtkIdType, vtkIdType> next;
  for (const auto& [a, b] : edges)
  {
    if (edges.count({ b, a }) == 0)
    {
      next[a] = b;
    }
  }
  std::vector<std::vector<vtkIdType>> loops;
  while (!next.empty())
  {
    loops.emplace_back();
    vtkIdType vertex = next.begin()->first;
    for (auto edge = next.find(vertex); edge != next.end(); edge = next.find(vertex))
    {
      loops.back().push_back(vertex);
      vertex = edge->second;
      next.erase(edge);
    }
  }
  return loops;
}

double figure(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetTuple1(0) : std::nan("");
}

} // namespace fuzz
