// SPDX-License-Identifier: GPL-3.0-or-later
/// What is measured of a flattened region: as numbers, as a table and as curves.
#pragma once

#include "Core/Base/Progress.h"
#include "Core/Regions/RegionDisk.h"
#include "Core/Regions/RegionExtent.h"

#include <string>

class vtkFieldData;
class vtkPolyData;
class vtkTable;

namespace flattening
{

struct RegionReport
{
  double Area = 0.0;     ///< in space (input units squared)
  double FlatArea = 0.0; ///< on the map
  double AreaError = 0.0;
  double LengthError = 0.0;  ///< of the two diameters
  double FlatDiameter = 0.0; ///< on the map, of the curve of the diameter
  double FlatAcross = 0.0;
  double FlatPerimeter = 0.0; ///< of the outline, smoothed as in space
  RegionExtent Extent;        ///< its curves by the vertices of the whole disk
};

/// @param positions n x 2, the flat positions of the disk's vertices.
/// @throws as regionExtent.
RegionReport measureRegion(const RegionDisk& region,
  const Points2& positions,
  const ProgressCallback& progress);

/// A row per measure, and one-tuple arrays in @p figures.
void fillMeasures(vtkTable* table,
  const RegionReport& measures,
  const std::string& unit,
  vtkFieldData* figures);

/// The two diameters and the outline as polylines on the map.
void fillCurves(vtkPolyData* output,
  const RegionReport& measures,
  const TriangleMesh& disk,
  const Points2& positions);

} // namespace flattening
