// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the figures of Flatten Region are true: those of its field data and its table of measures.
#pragma once

#include "../Findings.h"
#include "RegionOriginals.h"

#include <string>

class vtkFlattenRegion;
class vtkPolyData;

namespace fuzz
{

/// Whether a figure that the filter reports is the measure, up to rounding.
void checkMeasure(const std::string& name,
  long double reported,
  const Measure& measure,
  Findings& findings);

/// Whether the areas of the region in its field data are right.
void checkAreas(const Region& region, vtkPolyData* output, Findings& findings);

/// Whether the table has its four rows, in which OnSurface is what the field data say. Nothing else can
/// be read from a table for which this is false.
bool checkTable(vtkFlattenRegion* filter, Findings& findings);

} // namespace fuzz
