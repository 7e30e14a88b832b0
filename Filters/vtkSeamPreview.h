// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSeamPreview
 * @brief   shows where a seam will run while its points are picked
 *
 * The input is a surface. The output has a polyline for each pair of consecutive points of a path: the
 * geodesic between the points of the surface nearest to them, where vtkSurfaceToDiskFilter cuts with
 * these SeamPoints. Where no geodesic can be found, because the surface is no manifold before its repair
 * or has several components, it is a straight line. ParaView's window draws the output; it is no step of
 * a pipeline.
 *
 * Output arrays:
 * - cell `Leg` (int): number, from 0, of the point with which the leg begins.
 *
 * An empty input gives an empty output, and points that are nearest to the same point of the surface have
 * no leg between them. The following are errors, each with an empty output: a cell with a point that does
 * not exist or is not finite; a surface too large, too small or too far from the origin for double
 * precision.
 *
 * @sa vtkSurfaceToDiskFilter
 */
#ifndef vtkSeamPreview_h
#define vtkSeamPreview_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

#include <array>
#include <vector>

class SURFACEFLATTENINGFILTERS_EXPORT vtkSeamPreview : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkSeamPreview* New();
  vtkTypeMacro(vtkSeamPreview, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Number of points that the seam goes through, as of vtkSurfaceToDiskFilter.
   */
  void SetNumberOfSeamPoints(int number);

  /**
   * A point that the seam goes through, by its number from 0. Other numbers change nothing.
   */
  void SetSeamPoint(int index, double x, double y, double z);

  /**
   * Number of further paths of the seam, as of vtkSurfaceToDiskFilter.
   */
  void SetNumberOfSeamPathStarts(int number);

  /**
   * The number of the point with which a further path begins. Other indices change nothing.
   */
  void SetSeamPathStart(int index, int point);

protected:
  vtkSeamPreview() = default;
  ~vtkSeamPreview() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  std::vector<std::array<double, 3>> SeamPoints;
  std::vector<int> SeamPathStarts;

  vtkSeamPreview(const vtkSeamPreview&) = delete;
  void operator=(const vtkSeamPreview&) = delete;
};

#endif
