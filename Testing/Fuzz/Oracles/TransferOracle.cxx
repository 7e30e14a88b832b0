// SPDX-License-Identifier: GPL-3.0-or-later
#include "TransferOracle.h"

#include "ExactOrientation.h"
#include "Triangles.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace fuzz
{
namespace
{

// The rounding of a flat position that was interpolated, as a share of the size of the map.
constexpr long double FlatRounding = 1e-12L;
// The rounding of a distance in space, as a share of the tolerance and of the coordinates.
constexpr long double SpaceRounding = 1e-6L;
// Points whose way back is searched among all faces.
constexpr vtkIdType MostPoints = 100;

/// The surface, the map and the output of a transfer.
struct Transfer
{
  Triangles Surface;  // in space, of the flattened surface
  Triangles Map;      // the same faces in the plane
  Triangles Original; // all triangles
  Triangles Flat;     // the output in the plane
  std::vector<vtkIdType> PointIds;
  std::vector<vtkIdType> CellIds;
};

std::vector<vtkIdType> idsOf(vtkDataArray* array, vtkIdType count, Findings& findings)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(static_cast<vtkIdType>(array->GetTuple1(i)));
    findings.require(ids.back() >= 0 && ids.back() < count, "transfer-ids", "an id out of range");
  }
  return ids;
}

// Whether each cell is the original one, and no cell is there twice.
void checkCells(const Transfer& transfer, Findings& findings)
{
  std::set<vtkIdType> seen;
  for (std::size_t c = 0; c < transfer.Flat.Faces.size(); ++c)
  {
    const vtkIdType cell = transfer.CellIds[c];
    findings.require(seen.insert(cell).second, "transfer-ids", "a cell that is there twice");
    for (int k = 0; k < 3; ++k)
    {
      findings.require(transfer.PointIds[transfer.Flat.Faces[c][k]] == transfer.Original.Faces[cell][k],
        "transfer-ids",
        "a corner of cell " + std::to_string(cell) + " is another point of the original surface");
    }
  }
}

void checkFigures(const Transfer& transfer, vtkPolyData* transferred, Findings& findings)
{
  std::map<vtkIdType, int> copies;
  for (const vtkIdType id : transfer.PointIds)
  {
    ++copies[id];
  }
  const auto repeated = std::count_if(copies.begin(),
    copies.end(),
    [](const std::pair<const vtkIdType, int>& one) { return one.second > 1; });
  const auto flipped = std::count_if(transfer.Flat.Faces.begin(),
    transfer.Flat.Faces.end(),
    [&](const Triangle& face)
    {
      const std::vector<Point>& points = transfer.Flat.Points;
      return orientation(points[face[0]], points[face[1]], points[face[2]]) <= 0;
    });
  const auto expect = [&](const char* name, double value)
  {
    const double reported = figure(transferred, name);
    findings.require(reported == value,
      "transfer-figures",
      std::string(name) + " is " + std::to_string(reported) + " instead of " + std::to_string(value));
  };
  expect("TransferredPoints", static_cast<double>(transfer.PointIds.size()));
  expect("LostPoints", static_cast<double>(transfer.Original.Points.size() - copies.size()));
  expect("RepeatedPoints", static_cast<double>(repeated));
  expect("LostCells", static_cast<double>(transfer.Original.Faces.size() - transfer.Flat.Faces.size()));
  expect("FlippedFaces", static_cast<double>(flipped));
  long double area = 0.0L;
  for (const vtkIdType cell : transfer.CellIds)
  {
    area += areaOf(transfer.Original, transfer.Original.Faces[cell]);
  }
  const long double reported = figure(transferred, "SurfaceArea");
  const long double coordinate = greatestCoordinate(transfer.Original);
  findings.require(std::abs(reported - area) <= 1e-6L * area + 1e-14L * coordinate * coordinate,
    "transfer-figures",
    "SurfaceArea is not the area of the cells");
}

// Each point comes from a face of the map that is within the tolerance of the point in space.
void checkWayBack(const Transfer& transfer, double tolerance, Findings& findings)
{
  const long double mapSize = greatestCoordinate(transfer.Map);
  const long double greatest =
    (1.0L + SpaceRounding) * tolerance + 1e-12L * greatestCoordinate(transfer.Original);
  const auto count = static_cast<vtkIdType>(transfer.Flat.Points.size());
  const vtkIdType step = std::max<vtkIdType>(1, count / MostPoints);
  for (vtkIdType p = 0; p < count; p += step)
  {
    const Point& place = transfer.Original.Points[transfer.PointIds[p]];
    bool found = false;
    for (std::size_t f = 0; f < transfer.Map.Faces.size() && !found; ++f)
    {
      found = distanceTo(transfer.Map, transfer.Map.Faces[f], transfer.Flat.Points[p]) <=
                FlatRounding * mapSize &&
              distanceTo(transfer.Surface, transfer.Surface.Faces[f], place) <= greatest;
    }
    findings.require(found,
      "transfer-place",
      "point " + std::to_string(p) + " lies on no face of the map that is near it in space");
  }
}

using Corners = std::array<Point, 3>;

// The corners of a face in space, in order, and where they lie on a map.
std::pair<Corners, Corners> placedCorners(const Triangles& surface,
  const Triangle& face,
  const Triangles& map,
  const Triangle& flatFace)
{
  std::array<std::pair<Point, Point>, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = { surface.Points[face[k]], map.Points[flatFace[k]] };
  }
  std::sort(corners.begin(), corners.end());
  return { { corners[0].first, corners[1].first, corners[2].first },
    { corners[0].second, corners[1].second, corners[2].second } };
}

long double distance(const Corners& a, const Corners& b)
{
  long double greatest = 0.0L;
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 2; ++c)
    {
      greatest = std::max(greatest, std::abs(static_cast<long double>(a[k][c]) - b[k][c]));
    }
  }
  return greatest;
}

// A face that the flattened surface has, too, lies where it lies there. If the original surface has it
// more than once, as the sides of a sheet, one of them does.
void checkSameFaces(const Transfer& transfer, Findings& findings)
{
  std::multimap<Corners, Corners> known;
  for (std::size_t f = 0; f < transfer.Surface.Faces.size(); ++f)
  {
    known.insert(
      placedCorners(transfer.Surface, transfer.Surface.Faces[f], transfer.Map, transfer.Map.Faces[f]));
  }
  const long double rounding = FlatRounding * greatestCoordinate(transfer.Map);
  std::map<Corners, bool> isInPlace;
  for (std::size_t c = 0; c < transfer.Flat.Faces.size(); ++c)
  {
    const auto [surface, flat] = placedCorners(transfer.Original,
      transfer.Original.Faces[transfer.CellIds[c]],
      transfer.Flat,
      transfer.Flat.Faces[c]);
    for (auto [one, last] = known.equal_range(surface); one != last; ++one)
    {
      bool& found = isInPlace[surface];
      found = found || distance(one->second, flat) <= rounding;
    }
  }
  for (const auto& [corners, found] : isInPlace)
  {
    findings.require(found,
      "transfer-same-face",
      "the face from " + std::to_string(corners[0][0]) + ", " + std::to_string(corners[0][1]) + ", " +
        std::to_string(corners[0][2]) + " does not lie where the map has it");
  }
}

} // namespace

void checkTransfer(vtkPolyData* transferred,
  vtkPolyData* flattened,
  vtkPolyData* original,
  Findings& findings)
{
  Transfer transfer{ trianglesOf(flattened, "SurfacePoints"),
    trianglesOf(flattened),
    trianglesOf(original),
    trianglesOf(transferred),
    {},
    {} };
  transfer.PointIds = idsOf(transferred->GetPointData()->GetArray("vtkOriginalPointIds"),
    original->GetNumberOfPoints(),
    findings);
  transfer.CellIds = idsOf(
    transferred->GetCellData()->GetArray("vtkOriginalCellIds"), original->GetNumberOfCells(), findings);
  if (transfer.PointIds.size() != transfer.Flat.Points.size() ||
      transfer.CellIds.size() != transfer.Flat.Faces.size() ||
      static_cast<vtkIdType>(transfer.Original.Faces.size()) != original->GetNumberOfCells())
  {
    findings.fail("transfer-ids", "the output has cells that are no triangles, or no ids");
    return;
  }
  checkCells(transfer, findings);
  checkFigures(transfer, transferred, findings);
  checkWayBack(transfer, figure(transferred, "Tolerance"), findings);
  checkSameFaces(transfer, findings);
}

} // namespace fuzz
