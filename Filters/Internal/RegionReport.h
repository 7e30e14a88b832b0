// SPDX-License-Identifier: GPL-3.0-or-later
/// The measures of a flattened region as numbers, as a table and as curves.
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
  double Area = 0.0;          ///< area in space (input units squared)
  double FlatArea = 0.0;      ///< area on the map (input units squared)
  double AreaError = 0.0;     ///< standard deviation of Area
  double LengthError = 0.0;   ///< standard deviation of the lengths of the two diameters (input units)
  double FlatDiameter = 0.0;  ///< length on the map of the curve of the diameter
  double FlatAcross = 0.0;    ///< length on the map of the curve across
  double FlatPerimeter = 0.0; ///< length of the outline on the map, smoothed as in space
  RegionExtent Extent;        ///< its curves refer to the vertices of the whole disk
};

/// Measures the region in space and on the map.
/// @param positions the flat positions of the vertices of the disk (n x 2).
/// @throws TopologyError, InvalidInput, ConvergenceError as regionExtent does.
RegionReport measureRegion(const RegionDisk& region,
  const Points2& positions,
  const ProgressCallback& progress);

/// A sentence about the pieces of the region that were left out; empty if there are none, or only noise.
std::string leftOutWarning(const RegionDisk& region, const RegionReport& measures);

/// Writes a row per measure to the table and an array of one tuple per measure to the field data.
void fillMeasures(vtkTable* table,
  const RegionReport& measures,
  const std::string& unit,
  vtkFieldData* data);

/// Writes the two diameters and the outline as polylines on the map.
void fillCurves(vtkPolyData* output,
  const RegionReport& measures,
  const TriangleMesh& disk,
  const Points2& positions);

} // namespace flattening
