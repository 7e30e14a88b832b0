// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the output of Flat Map Transfer lies on the map that it was made from.
#pragma once

#include "../Findings.h"

class vtkPolyData;

namespace fuzz
{

/// @param transferred the output of Flat Map Transfer
/// @param flattened   its first input, a flat map
/// @param original    its second input, the surface to which the map was transferred
void checkTransfer(vtkPolyData* transferred,
  vtkPolyData* flattened,
  vtkPolyData* original,
  Findings& findings);

} // namespace fuzz
