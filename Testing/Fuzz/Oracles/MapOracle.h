// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether a flat map is what its filter says: flipped faces, one-to-one, domain, distortion.
#pragma once

#include "../Findings.h"

class vtkPolyData;

namespace fuzz
{

/// The output of Conformal Disk or OMT Area Preserving.
/// @param hasSurfaceArea whether the domain is to have the area of the surface
/// @param polygon what the map is to fill, scaled to that area; null for a disk or a rectangle
void checkMap(vtkPolyData* map, bool hasSurfaceArea, Findings& findings, vtkPolyData* polygon = nullptr);

/// Output port 0 of Distortion Metrics.
/// @param hasTargets whether areas were compared with the array TargetArea
void checkDistortion(vtkPolyData* measured, bool hasTargets, Findings& findings);

} // namespace fuzz
