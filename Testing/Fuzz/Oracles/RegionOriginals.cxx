// SPDX-License-Identifier: GPL-3.0-or-later
#include "RegionOriginals.h"

#include "FlatPlaces.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuzz
{

std::optional<Region> readRegion(vtkPolyData* output, vtkPolyData* input, Findings& findings)
{
  Region region{ trianglesOf(input, "SurfacePoints"),
    trianglesOf(output, "SurfacePoints"),
    trianglesOf(output),
    {},
    {},
    {} };
  vtkDataArray* pointIds = output->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* cellIds = output->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkDataArray* flags = output->GetCellData()->GetArray("InRegion");
  if (!pointIds || !cellIds || !flags ||
      cellIds->GetNumberOfTuples() != static_cast<vtkIdType>(region.Flat.Faces.size()) ||
      !output->GetPointData()->HasArray("SurfacePoints"))
  {
    findings.fail("region-ids", "an array is missing, or there are cells that are no triangles");
    return std::nullopt;
  }
  for (vtkIdType p = 0; p < pointIds->GetNumberOfTuples(); ++p)
  {
    region.PointIds.push_back(static_cast<vtkIdType>(pointIds->GetTuple1(p)));
  }
  for (vtkIdType c = 0; c < cellIds->GetNumberOfTuples(); ++c)
  {
    region.CellIds.push_back(static_cast<vtkIdType>(cellIds->GetTuple1(c)));
    region.InRegion.push_back(flags->GetTuple1(c) != 0.0);
    if (region.CellIds.back() < 0 || region.CellIds.back() >= input->GetNumberOfCells())
    {
      findings.fail("region-ids", "a cell id out of range");
      return std::nullopt;
    }
  }
  return region;
}

void checkIds(const Region& region, Findings& findings)
{
  std::vector<std::vector<std::size_t>> partsOf(region.Surface.Faces.size());
  for (std::size_t p = 0; p < region.PointIds.size(); ++p)
  {
    const vtkIdType id = region.PointIds[p];
    findings.require(id >= -1 && id < static_cast<vtkIdType>(region.Surface.Points.size()),
      "region-ids",
      "a point id out of range");
    findings.require(id < 0 || region.Surface.Points[id] == region.Space.Points[p],
      "region-ids",
      "a point that is not where its original is");
  }
  for (std::size_t c = 0; c < region.CellIds.size(); ++c)
  {
    partsOf[region.CellIds[c]].push_back(c);
  }
  for (std::size_t f = 0; f < partsOf.size(); ++f)
  {
    const Triangle& whole = region.Surface.Faces[f];
    Measure area{ areaOf(region.Surface, whole), 0.0L };
    const long double square = greatestSquaredSide(region.Surface, whole);
    area.Rounding = SumRounding * area.Value;
    long double parts = 0.0L;
    std::set<vtkIdType> corners;
    for (const std::size_t c : partsOf[f])
    {
      parts += areaOf(region.Space, region.Space.Faces[c]);
      for (const vtkIdType p : region.Space.Faces[c])
      {
        corners.insert(region.PointIds[p]);
        // A point in the middle of a side is rounded with its coordinates.
        const Point& place = region.Space.Points[p];
        const long double coordinate =
          std::max({ std::abs(place[0]), std::abs(place[1]), std::abs(place[2]) });
        area.Rounding += 1e-15L * coordinate * std::sqrt(square) + NeedleRounding * square;
        findings.require(
          distanceTo(region.Surface, whole, place) <= 1e-14L * coordinate + 1e-12L * std::sqrt(square),
          "region-ids",
          "a corner that does not lie on the original cell");
      }
      findings.require(region.InRegion[c] == region.InRegion[partsOf[f].front()],
        "region-ids",
        "a cell that is a part in the region and a part outside");
    }
    findings.require(partsOf[f].empty() || std::abs(parts - area.Value) <= area.Rounding,
      "region-ids",
      "the parts of a cell do not have its area");
    const bool hasAll =
      std::all_of(whole.begin(), whole.end(), [&](vtkIdType p) { return corners.count(p) == 1; });
    findings.require(
      partsOf[f].empty() || hasAll, "region-ids", "a corner of the original cell is missing");
  }
}

void checkPointValues(const Region& region,
  vtkPolyData* output,
  vtkDataArray* labels,
  Findings& findings)
{
  vtkDataArray* kept = output->GetPointData()->GetArray(labels->GetName());
  vtkDataArray* texture = output->GetPointData()->GetArray("TCoords");
  const Square square = squareAround(region.Flat);
  findings.require(kept != nullptr, "region-arrays", "the array of labels is lost");
  for (std::size_t p = 0; p < region.PointIds.size(); ++p)
  {
    const auto id = static_cast<vtkIdType>(p);
    findings.require(
      !kept || region.PointIds[p] < 0 || kept->GetTuple1(id) == labels->GetTuple1(region.PointIds[p]),
      "region-arrays",
      "a point has another label than its original");
    for (int k = 0; k < 2; ++k)
    {
      const long double expected = (region.Flat.Points[p][k] - square.Low[k]) / square.Side;
      findings.require(texture && std::abs(texture->GetComponent(id, k) - expected) < 1e-6L,
        "region-arrays",
        "TCoords is not the place in the smallest square");
    }
  }
}

} // namespace fuzz
