// SPDX-License-Identifier: GPL-3.0-or-later
/// Random shapes as a user draws them beside a surface: the lines of a seam, regions, the outline of a
/// map. Most of them are sensible, some are hostile.
#pragma once

#include "../Random.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace fuzz
{

/// Lines through points of the surface and points near it: apart, meeting, closed, with points twice.
vtkSmartPointer<vtkPolyData> drawnLines(Random& random, vtkPolyData* surface);

/// A polygon or a closed line in a plane of constant z, of any size and place; most are convex.
vtkSmartPointer<vtkPolyData> drawnPolygon(Random& random);

/// The surface with regions around some of its points, as the array @p name with values 0 to 3.
vtkSmartPointer<vtkPolyData> withRegions(Random& random, vtkPolyData* surface, const char* name);

} // namespace fuzz
