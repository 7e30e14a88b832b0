// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the outputs of Area Weights and Context Resolution are what they promise.
#pragma once

#include "../Findings.h"

class vtkAreaWeights;
class vtkContextResolution;
class vtkDataArray;
class vtkPolyData;

namespace fuzz
{

/// Positive weights, their totals and, with sharp edges, the factor of the region.
/// @param filter a filter that has a result
/// @param input  its first input
/// @param labels the point array that it reads, of one component
void checkWeights(vtkAreaWeights* filter, vtkPolyData* input, vtkDataArray* labels, Findings& findings);

/// Regions that stayed as they were, and a context of the input's shape.
/// @param filter a filter that has a result
/// @param input  its input
/// @param labels the point array of regions, of one component
void checkContext(vtkContextResolution* filter,
  vtkPolyData* input,
  vtkDataArray* labels,
  Findings& findings);

} // namespace fuzz
