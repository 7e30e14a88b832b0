// SPDX-License-Identifier: GPL-3.0-or-later
#include "DiskOracle.h"

#include "Triangles.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace fuzz
{
namespace
{

using Edge = std::pair<vtkIdType, vtkIdType>;

// The edges without their direction. Fails if a directed edge occurs twice.
std::set<Edge> edgesOf(const Triangles& mesh, Findings& findings)
{
  std::set<Edge> directed;
  std::set<Edge> edges;
  for (const Triangle& face : mesh.Faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Edge edge = { face[k], face[(k + 1) % 3] };
      findings.require(edge.first != edge.second, "disk-topology", "a face has a corner twice");
      findings.require(directed.insert(edge).second,
        "disk-topology",
        "two faces have an edge in the same direction, or an edge has three faces");
      edges.insert({ std::min(edge.first, edge.second), std::max(edge.first, edge.second) });
    }
  }
  return edges;
}

class Sets
{
public:
  explicit Sets(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  std::size_t find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  void join(std::size_t i, std::size_t j) { this->Parent[this->find(i)] = this->find(j); }

private:
  std::vector<std::size_t> Parent;
};

// Whether the faces around each point form one fan, and all faces one component.
void checkFans(const Triangles& mesh, Findings& findings)
{
  // The corners of a point are joined across the edges that their faces share.
  Sets corners(3 * mesh.Faces.size());
  Sets points(mesh.Points.size());
  std::map<Edge, std::size_t> first;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = mesh.Faces[f][k];
      const vtkIdType b = mesh.Faces[f][(k + 1) % 3];
      points.join(a, b);
      const auto opposite = first.find({ b, a });
      if (opposite != first.end())
      {
        const std::size_t g = opposite->second / 3;
        const std::size_t m = opposite->second % 3;
        corners.join(3 * f + k, 3 * g + (m + 1) % 3);
        corners.join(3 * f + (k + 1) % 3, 3 * g + m);
      }
      first[{ a, b }] = 3 * f + k;
    }
  }
  std::map<vtkIdType, std::size_t> fan;
  for (std::size_t c = 0; c < 3 * mesh.Faces.size(); ++c)
  {
    const auto [place, isNew] = fan.emplace(mesh.Faces[c / 3][c % 3], corners.find(c));
    findings.require(
      isNew || place->second == corners.find(c), "disk-topology", "a point has several fans");
  }
  for (std::size_t p = 1; p < mesh.Points.size(); ++p)
  {
    findings.require(points.find(p) == points.find(0), "disk-topology", "several components");
  }
}

// Whether a step that moves points and keeps their ids reports that it did.
bool hasMovedPoints(vtkPolyData* disk)
{
  return figure(disk, "RemovedSpikes") != 0.0 || figure(disk, "RemovedFins") != 0.0 ||
         figure(disk, "HandleDisplacement") != 0.0;
}

void checkOrigins(const Triangles& mesh, vtkPolyData* disk, vtkPolyData* input, Findings& findings)
{
  const bool hasMoved = hasMovedPoints(disk);
  vtkDataArray* ids = disk->GetPointData()->GetArray("vtkOriginalPointIds");
  findings.require(ids != nullptr, "original-ids", "no array vtkOriginalPointIds");
  for (vtkIdType p = 0; ids && p < ids->GetNumberOfTuples(); ++p)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(p));
    if (id < -1 || id >= input->GetNumberOfPoints())
    {
      findings.fail("original-ids", "an id that the input does not have");
    }
    else if (id >= 0)
    {
      Point original;
      input->GetPoint(id, original.data());
      findings.require(hasMoved || original == mesh.Points[p],
        "original-ids",
        "point " + std::to_string(p) + " is not where its original " + std::to_string(id) + " is");
    }
  }
  vtkDataArray* cells = disk->GetCellData()->GetArray("vtkOriginalCellIds");
  findings.require(cells != nullptr, "original-ids", "no array vtkOriginalCellIds");
  for (vtkIdType c = 0; cells && c < cells->GetNumberOfTuples(); ++c)
  {
    const double id = cells->GetTuple1(c);
    findings.require(
      id >= -1 && id < input->GetNumberOfCells(), "original-ids", "a cell id out of range");
  }
}

// The rounding of the coordinates of a surface far from the origin, relative to its size.
double roundingOf(const Triangles& mesh)
{
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  double greatest = 0.0;
  for (const Point& point : mesh.Points)
  {
    low = std::min(low, point[0]);
    high = std::max(high, point[0]);
    greatest = std::max({ greatest, std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
  }
  return 1e-14 * greatest / (high - low);
}

void checkFigures(const Triangles& mesh,
  const std::vector<std::vector<vtkIdType>>& loops,
  vtkPolyData* disk,
  Findings& findings)
{
  const long double area = totalArea(mesh);
  const double reported = figure(disk, "SurfaceArea");
  if (std::isnormal(static_cast<double>(area)))
  {
    findings.require(std::abs(reported - area) <= (1e-6 + roundingOf(mesh)) * area,
      "figures",
      "SurfaceArea is " + std::to_string(static_cast<double>(reported / area)) + " of the area");
  }
  findings.require(
    loops.empty() || figure(disk, "BoundaryVertices") == static_cast<double>(loops[0].size()),
    "figures",
    "BoundaryVertices is wrong");
}

} // namespace

void checkDisk(vtkPolyData* disk, vtkPolyData* input, Findings& findings)
{
  const Triangles mesh = trianglesOf(disk);
  findings.require(static_cast<vtkIdType>(mesh.Faces.size()) == disk->GetNumberOfCells(),
    "disk-topology",
    "cells that are not triangles");
  for (const Point& point : mesh.Points)
  {
    findings.require(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]),
      "not-finite",
      "a point");
  }
  const std::set<Edge> edges = edgesOf(mesh, findings);
  const auto euler = static_cast<std::ptrdiff_t>(mesh.Points.size()) -
                     static_cast<std::ptrdiff_t>(edges.size()) +
                     static_cast<std::ptrdiff_t>(mesh.Faces.size());
  findings.require(euler == 1, "disk-topology", "Euler number " + std::to_string(euler));
  const auto loops = boundaryLoops(mesh);
  findings.require(loops.size() == 1, "disk-topology", std::to_string(loops.size()) + " boundary loops");
  checkFans(mesh, findings);
  checkOrigins(mesh, disk, input, findings);
  checkFigures(mesh, loops, disk, findings);
}

} // namespace fuzz
