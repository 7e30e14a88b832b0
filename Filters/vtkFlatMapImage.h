// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlatMapImage
 * @brief   samples a flat map on an image whose pixels know their point of the surface
 *
 * The input is a flat map: triangles in the plane with the point array `SurfacePoints`, from
 * vtkConformalDiskFilter, vtkOMTAreaPreservingFilter or a filter after them. The output is a square
 * vtkImageData with one point at the centre of each pixel. It covers the smallest square around the map
 * with the same centre, as the texture coordinates `TCoords` do: saved as a picture, it is a texture
 * that fits the map and the surface.
 *
 * Point arrays of floating point numbers are interpolated at the centres of the pixels; all others
 * (labels, ids, strings) take the value of the nearest corner of the triangle, as the mean of two
 * labels is not a label. Cell arrays take the value of the triangle under the pixel; where a point
 * array has the same name, the suffix `Cell` is added, as often as it takes for a name of its own.
 *
 * Pixels outside the map but within Margin have the values of the nearest position on the map, so that
 * interpolation between pixels works at the boundary of the map. Pixels farther away are NaN in arrays
 * of floating point numbers and 0 in others. Where a map folds over (`FlippedFaces` of the filters
 * before), the pixel shows one of the triangles.
 *
 * vtkProbeFilter does something similar, but it averages labels, does not tell the triangle, and misses
 * pixels whose centre lies on an edge between two triangles up to rounding.
 *
 * Output arrays:
 * - point `SurfacePoints` (double x 3, input units): point of the surface under the pixel.
 * - point `CellId` (vtkIdType): triangle under the pixel; -1 outside the map.
 * - point `InMap` (unsigned char): 1 in the map, 0 outside.
 *
 * Image filters after this one ask for the extent, the spacing and the type of the active scalars before
 * there are data. Therefore this filter brings its input up to date when it is asked for information.
 * They ask once for all time steps (docs/composite_data.md).
 *
 * Field data (one tuple each):
 * - `PixelLength` (double, units of the map): side of a pixel.
 * - `PixelsInMap` (vtkIdType): number of pixels with `InMap` 1.
 *
 * An empty input gives an empty image. The following are errors, each with an empty output: cells that
 * are not triangles; no array `SurfacePoints`; a map that is not flat, has no area or has a coordinate
 * that is not finite; a PixelLength that needs more than 16384 pixels per side; an image for which there
 * is too little memory (about 200 bytes per pixel and those of the arrays).
 *
 * @sa vtkOMTAreaPreservingFilter vtkFlatMapSlab
 */
#ifndef vtkFlatMapImage_h
#define vtkFlatMapImage_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include "vtkBlockwisePolyDataAlgorithm.h"

class vtkImageData;

class SURFACEFLATTENINGFILTERS_EXPORT vtkFlatMapImage : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkFlatMapImage* New();
  vtkTypeMacro(vtkFlatMapImage, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Greatest number of pixels per side, a common limit of the size of textures.
  static constexpr int GreatestSize = 16384;

  ///@{
  /**
   * Number of pixels per side, if PixelLength is 0. Range [2, 16384]. Default: 512.
   */
  vtkSetClampMacro(Size, int, 2, GreatestSize);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /**
   * Greatest side of a pixel (units of the map): the image gets as many pixels as that needs, and the
   * field array `PixelLength` tells the actual side. 0 uses Size instead. Range [0, inf); an error if
   * more than 16384 pixels per side are needed. Default: 0.
   */
  vtkSetClampMacro(PixelLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PixelLength, double);
  ///@}

  ///@{
  /**
   * Width in pixels of the margin around the map that is filled from the nearest position on the map.
   * Range [0, 16384]. Default: 2.
   */
  vtkSetClampMacro(Margin, int, 0, GreatestSize);
  vtkGetMacro(Margin, int);
  ///@}

  /**
   * The image; nullptr if the input is composite.
   */
  vtkImageData* GetOutput();

protected:
  vtkFlatMapImage() = default;
  ~vtkFlatMapImage() override = default;

  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  int RequestInformation(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int Size = 512;
  double PixelLength = 0.0;
  int Margin = 2;

private:
  vtkFlatMapImage(const vtkFlatMapImage&) = delete;
  void operator=(const vtkFlatMapImage&) = delete;

  // The number of pixels per side of a map that is @p side long and wide. Throws InvalidInput if they
  // are too many.
  int PixelsFor(double side) const;
};

#endif
