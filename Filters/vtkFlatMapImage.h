// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlatMapImage
 * @brief   a flat map as an image, with the way back from every pixel to the surface
 *
 * The input is a flat map: triangles in the plane with the point array `SurfacePoints`, from
 * vtkConformalDiskFilter, vtkOMTAreaPreservingFilter or a filter after them. The output is a square
 * image (vtkImageData, one point per pixel, at its centre) of the smallest square around the map, the
 * one that its texture coordinates `TCoords` cover: saved as a picture it is a texture that fits map and
 * surface.
 *
 * Every point array of the input is interpolated at the pixels' centres, if it is of floating point
 * numbers; all others (labels, ids, strings) take the value of the nearest corner of the triangle, for
 * the mean of two labels is a wrong label. Cell arrays take the value of the triangle under the pixel,
 * and have `Cell` after their name where a point array has it. Stock filters choose arrays (Pass
 * Arrays) or parts of the image (Extract Subset). These are the way back:
 * - `SurfacePoints` (3 components, input units): the point of the surface under the pixel
 * - `CellId` (vtkIdType): the triangle under the pixel; -1 outside of the map
 * - `InMap` (unsigned char): 1 in the map, 0 outside
 *
 * Outside of the map, pixels within Margin have the values of the nearest place of the map, so that what
 * interpolates between pixels has something at the map's boundary; those farther away are NaN in arrays
 * of floating point numbers and 0 in others. Where a map folds over (`FlippedFaces` of the filters
 * before), one of the triangles is shown.
 *
 * Field data (one tuple each): `PixelLength` (units of the map), `PixelsInMap`.
 *
 * vtkProbeFilter would do most of it, but averages labels, does not tell the triangle, and loses centres
 * that lie on edges between triangles by rounding.
 *
 * An empty input gives an empty image. Errors, each with an empty output: cells that are not triangles,
 * no array `SurfacePoints`, a map that is not flat, has no area or a coordinate that is not finite, a
 * PixelLength for which more than 16384 pixels a side would be needed.
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

  static constexpr int GreatestSize = 16384;

  ///@{
  /**
   * Number of pixels a side, if PixelLength is 0. Range [2, 16384]. Default: 512.
   */
  vtkSetClampMacro(Size, int, 2, GreatestSize);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /**
   * Greatest side of a pixel, in units of the map: as many pixels as are needed for that, and the field
   * array `PixelLength` says what it is. Range [0, inf). Default: 0, as Size says.
   */
  vtkSetClampMacro(PixelLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PixelLength, double);
  ///@}

  ///@{
  /**
   * How many pixels beyond the map are filled from its nearest place. Range [0, 16384]. Default: 2.
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

  // Pixels a side of a map that is @p side long and wide. Without a limit.
  double PixelsFor(double side) const;
};

#endif
