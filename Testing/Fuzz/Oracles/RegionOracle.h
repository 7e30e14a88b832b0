// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the output of Flatten Region is the chosen region, a disk, and measured as it says.
#pragma once

#include "../Findings.h"

class vtkDataArray;
class vtkFlattenRegion;
class vtkPolyData;

namespace fuzz
{

/// @param filter a filter that has a result
/// @param input  its first input
/// @param labels the point array of labels that it reads, of one component
void checkRegion(vtkFlattenRegion* filter, vtkPolyData* input, vtkDataArray* labels, Findings& findings);

} // namespace fuzz
