// SPDX-License-Identifier: GPL-3.0-or-later
/// Images that Planar Warp carries.
#pragma once

#include "Internal/WarpRules.h"

class vtkImageData;
class vtkPolyData;

namespace flattening
{

struct ResamplingRules
{
  const PlanarWarp& Warp;
  bool LeaveUnmoved; ///< what is outside both shapes of the mesh
  bool Nearest;      ///< no interpolation
  int Size[2];       ///< of the output in pixels
  ProgressCallback Progress;
};

/// Fills @p output, an image over @p flat, with all arrays of @p input and InMap.
/// @return how many pixels of the flat map lie outside the image.
/// @throws InvalidInput if the image has several slices, one row, or no arrays, or lies nowhere on the
/// mesh.
long long warpImage(vtkImageData* input,
  vtkPolyData* flat,
  const ResamplingRules& rules,
  vtkImageData* output);

/// Adds to @p flat texture coordinates for an image on the undeformed mesh, whose points are @p before,
/// and InMap, 1 where these lie on the image.
/// @return how many do not.
/// @throws InvalidInput as warpImage.
long long addTextureCoordinates(vtkImageData* image, const Points3& before, vtkPolyData* flat);

} // namespace flattening
