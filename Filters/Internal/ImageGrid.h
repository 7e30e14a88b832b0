// SPDX-License-Identifier: GPL-3.0-or-later
/// The grid of an image, which tells where its pixels lie. Image filters ask for the grid before the
/// image is made.
#pragma once

#include "Internal/TextureCoordinates.h"

#include <functional>

class vtkAlgorithm;
class vtkImageData;
class vtkInformation;
class vtkPolyData;

namespace flattening
{

struct ImageGrid
{
  int Size[3];       ///< number of pixels along each axis; 0 everywhere for no image
  double Origin[3];  ///< centre of the first pixel
  double Spacing[3]; ///< distance of neighbouring pixels along each axis
};

constexpr ImageGrid NoImage{ { 0, 0, 0 }, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };

/// The grid of @p size x @p size pixels that cover the square around a map; the length of a pixel is the
/// spacing along z, too.
ImageGrid gridOver(const TextureSquare& square, int size);

ImageGrid gridOf(vtkImageData* image);

/// Gives the image its grid.
void setGrid(vtkImageData* image, const ImageGrid& grid);

/// Brings the input on @p port up to date, for a grid that depends on the input's data.
void updateInput(vtkAlgorithm* filter, int port);

/// Tells the filters after @p output what grid its image will have. Image filters read it from there
/// alone: without it, they would take 1 for the spacing, silently.
/// @param grid makes the grid. Where it throws, an empty image is announced, as the execution will
/// report the same error.
void announceGrid(vtkInformation* output, const std::function<ImageGrid()>& grid);

/// The same for an image over the square around a flat map; no image if the map is empty.
void announceGridOver(vtkPolyData* map,
  vtkInformation* output,
  const std::function<ImageGrid(const TextureSquare&)>& grid);

} // namespace flattening
