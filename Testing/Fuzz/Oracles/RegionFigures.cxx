// SPDX-License-Identifier: GPL-3.0-or-later
#include "RegionFigures.h"

#include <vtkFlattenRegion.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <cmath>

namespace fuzz
{
namespace
{

// The area of the region in the plane, in which flipped faces count as negative.
Measure signedFlatArea(const Region& region)
{
  Measure area = areaWhere(region.Flat, region.InRegion);
  area.Value = 0.0L;
  for (std::size_t c = 0; c < region.Flat.Faces.size(); ++c)
  {
    const Triangle& face = region.Flat.Faces[c];
    const Point& a = region.Flat.Points[face[0]];
    const Point& b = region.Flat.Points[face[1]];
    const Point& d = region.Flat.Points[face[2]];
    if (region.InRegion[c])
    {
      area.Value +=
        0.5L * ((static_cast<long double>(b[0]) - a[0]) * (static_cast<long double>(d[1]) - a[1]) -
                 (static_cast<long double>(b[1]) - a[1]) * (static_cast<long double>(d[0]) - a[0]));
    }
  }
  return area;
}

} // namespace

void checkMeasure(const std::string& name,
  long double reported,
  const Measure& measure,
  Findings& findings)
{
  findings.require(std::abs(reported - measure.Value) <= measure.Rounding,
    "region-figures",
    name + " is " + std::to_string(static_cast<double>(reported / measure.Value)) +
      " of what it should be");
}

void checkAreas(const Region& region, vtkPolyData* output, Findings& findings)
{
  checkMeasure("Area", figure(output, "Area"), areaWhere(region.Space, region.InRegion), findings);
  checkMeasure("FlatArea", figure(output, "FlatArea"), signedFlatArea(region), findings);
  findings.require(
    figure(output, "MaxCellAreaError") >= 0.0, "region-figures", "MaxCellAreaError is negative");
}

bool checkTable(vtkFlattenRegion* filter, Findings& findings)
{
  vtkTable* table = filter->GetMeasures();
  if (table->GetNumberOfRows() != 4)
  {
    findings.fail("region-table", "the table has not four rows");
    return false;
  }
  const char* rows[] = { "Area", "GreatestDiameter", "ExtentAcross", "Perimeter" };
  for (vtkIdType row = 0; row < 4; ++row)
  {
    const double error = table->GetValueByName(row, "StandardDeviation").ToDouble();
    const double onMap = table->GetValueByName(row, "OnMap").ToDouble();
    findings.require(table->GetValueByName(row, "Measure").ToString() == rows[row],
      "region-table",
      "a row has another name");
    findings.require(
      table->GetValueByName(row, "OnSurface").ToDouble() == figure(filter->GetOutput(), rows[row]),
      "region-table",
      std::string("the table has another ") + rows[row] + " than the field data");
    findings.require(std::isfinite(error) && error >= 0.0,
      "region-table",
      std::string("StandardDeviation of ") + rows[row] + " is " + std::to_string(error));
    findings.require(std::isfinite(onMap) && onMap >= 0.0,
      "region-table",
      std::string("OnMap of ") + rows[row] + " is " + std::to_string(onMap));
  }
  findings.require(
    table->GetValueByName(0, "OnMap").ToDouble() == figure(filter->GetOutput(), "FlatArea"),
    "region-table",
    "the table has another FlatArea than the field data");
  return true;
}

} // namespace fuzz
