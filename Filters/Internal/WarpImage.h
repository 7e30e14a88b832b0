// SPDX-License-Identifier: GPL-3.0-or-later
/// Planar Warp of images.
#pragma once

#include "Internal/ImageGrid.h"
#include "Internal/WarpRules.h"

class vtkImageData;
class vtkPolyData;

namespace flattening
{

struct ResamplingRules
{
  const PlanarWarp& Warp;
  bool LeaveUnmoved; ///< whether pixels outside both shapes of the mesh keep their values
  bool Nearest;      ///< whether a pixel takes the value of the nearest pixel, without interpolation
  int Size[2];       ///< number of columns and rows of the output
  ProgressCallback Progress;
};

/// The grid of square pixels over the flat map, and over the image, too, if it stays unmoved.
/// @param size number of columns and rows
/// @param planeHeight z of the undeformed mesh
ImageGrid resampledGrid(vtkImageData* input,
  vtkPolyData* flat,
  bool leaveUnmoved,
  const int size[2],
  double planeHeight);

/// Fills @p output, an image over @p flat, with all arrays of @p input and InMap.
/// @return the number of pixels of the flat map that lie outside the image.
/// @throws InvalidInput if the image has several slices, one row or no arrays, or does not touch the
/// mesh.
long long warpImage(vtkImageData* input,
  vtkPolyData* flat,
  const ResamplingRules& rules,
  vtkImageData* output);

/// Adds to @p flat texture coordinates for an image on the undeformed mesh, whose points are @p before
/// (n x 3), and the array InMap, 1 where such a point lies on the image.
/// @return the number of points that do not lie on the image.
/// @throws InvalidInput as warpImage does.
long long addTextureCoordinates(vtkImageData* image, const Points3& before, vtkPolyData* flat);

} // namespace flattening
