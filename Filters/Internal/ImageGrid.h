// SPDX-License-Identifier: GPL-3.0-or-later
/// The grid of an image, which tells where its pixels lie. Image filters ask for the grid before the
/// image is made.
#pragma once

#include "Internal/TextureCoordinates.h"

#include <functional>

class vtkAlgorithm;
class vtkDataArray;
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

/// Tells the filters after @p output which numbers the active scalars of its image will be. VTK's image
/// filters make their output of that type without a look at the image, and take double without it.
/// @param scalars an array with the components of those scalars; null if there will be none.
/// @param type the type of their values.
void announceScalars(vtkInformation* output, vtkDataArray* scalars, int type);
/// The same for scalars of the type of @p scalars.
void announceScalars(vtkInformation* output, vtkDataArray* scalars);

/// The same as announceGrid() for an image over the square around a flat map; no image if the map is
/// empty.
void announceGridOver(vtkPolyData* map,
  vtkInformation* output,
  const std::function<ImageGrid(const TextureSquare&)>& grid);

} // namespace flattening
