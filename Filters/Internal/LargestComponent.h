// SPDX-License-Identifier: GPL-3.0-or-later
/// The largest component of a surface.
#pragma once

#include "Core/Base/Progress.h"

class vtkPolyData;

namespace flattening
{

/// The number of components of a surface, and their areas in its units squared.
struct ComponentAreas
{
  long long Count = 0;
  double Whole = 0.0;   ///< area of all
  double Largest = 0.0; ///< area of the largest one
};

/// Finds the components of a surface of triangles and their areas. @p keepLargest leaves only the one of
/// the largest area.
ComponentAreas takeLargestComponent(vtkPolyData* surface,
  bool keepLargest,
  const ProgressCallback& progress);

} // namespace flattening
