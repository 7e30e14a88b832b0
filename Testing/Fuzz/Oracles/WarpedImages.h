// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether Planar Warp carries an image of one slice to the flat map, resampled or as a texture.
#pragma once

#include "../Findings.h"
#include "WarpedPlaces.h"

class vtkImageData;
class vtkPlanarWarp;
class vtkPolyData;

namespace fuzz
{

/// Whether the resampled image, the output of the filter, covers the flat map and shows in its pixels
/// what the carried image has at the places that were taken there.
void checkWarpedImage(const Warp& warp,
  vtkPlanarWarp* filter,
  vtkImageData* carried,
  vtkPolyData* flattened,
  Findings& findings);

/// Whether the texture coordinates of each point of the map are the place that it had in the carried
/// image.
void checkWarpedTexture(const Warp& warp,
  vtkImageData* carried,
  vtkPolyData* output,
  Findings& findings);

} // namespace fuzz
