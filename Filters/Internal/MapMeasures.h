// SPDX-License-Identifier: GPL-3.0-or-later
/// The arrays with which Distortion Metrics describes a flat map.
#pragma once

#include "Core/FlatMap/DistortionMeasures.h"
#include "Core/FlatMap/DistortionSummary.h"
#include "Core/FlatMap/LengthDistortion.h"

#include <functional>
#include <string>

class vtkFieldData;
class vtkPolyData;

namespace flattening
{

/// Calls @p visit(name, value) for the values of a summary, in the order of the columns of the table.
void forEachValue(const DistortionSummary& summary,
  const std::function<void(const std::string&, double)>& visit);

/// Adds the cell arrays.
void addMeasures(vtkPolyData* map, const FaceDistortion& distortion);

/// Sets the values of the whole map.
void setMeasures(vtkFieldData* data, const DistortionSummary& total);

/// Adds the point array of the local errors of lengths, and sets the values of all lengths.
void addLengths(vtkPolyData* map, const LengthDistortion& lengths);

/// Removes what addLengths() added to an earlier map.
void removeLengths(vtkPolyData* map);

/// Removes what describes an earlier map of the same surface: its measures, and the areas that its
/// points were to have (TargetArea).
void removeEarlierMeasures(vtkPolyData* map);

/// Removes the reports of Conformal Disk, OMT Area Preserving and Flat Map Transfer on an earlier map.
void removeEarlierReports(vtkFieldData* data);

/// Removes all that describes an earlier map of the surface or of a larger one: its measures, the arrays
/// of the conformal and of the area-preserving map, and its reports. SurfacePoints and TCoords stay.
void removeEarlierMap(vtkPolyData* map);

} // namespace flattening
