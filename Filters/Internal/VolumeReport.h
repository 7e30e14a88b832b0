// SPDX-License-Identifier: GPL-3.0-or-later
/// What Volume To Surface tells of its steps: tables, field data, warnings.
#pragma once

#include "Internal/LargestComponent.h"
#include "Internal/OtsuThreshold.h"

#include <string>

class vtkFieldData;
class vtkTable;

namespace flattening
{

struct VolumeReport
{
  OtsuThreshold Classes; ///< of the isovalue that was taken
  bool Suggested = false;
  double Air = 0.0;
  int Margin = 0;
  double Smoothing = 0.0;
  long long NotFinite = 0;
  ComponentAreas Components;
  double LeftOutArea = 0.0;
};

/// Fills the table with a row for each step, in their order.
void setReportTable(vtkTable* table, const VolumeReport& report);

/// Fills the table with a row for each bin.
void setHistogramTable(vtkTable* table, const Histogram& histogram, double isovalue);

void setFieldData(vtkFieldData* data, const VolumeReport& report);

/// A sentence about components that were left out and are no noise; empty if there are none.
std::string leftOutWarning(const VolumeReport& report);

} // namespace flattening
