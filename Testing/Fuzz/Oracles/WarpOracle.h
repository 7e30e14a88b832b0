// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the output of Planar Warp was carried by its map.
#pragma once

#include "../Findings.h"

class vtkDataObject;
class vtkPlanarWarp;
class vtkPolyData;

namespace fuzz
{

/// @param filter    a filter that has a result
/// @param flattened its first input, a flat map of a planar mesh
/// @param carried   its second input, polydata without lines or an image of one slice
void checkWarp(vtkPlanarWarp* filter,
  vtkPolyData* flattened,
  vtkDataObject* carried,
  Findings& findings);

} // namespace fuzz
