// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkContextResolution
 * @brief   coarsens a surface outside regions of interest
 *
 * The input is a triangle surface, usually the disk of vtkSurfaceToDiskFilter, with an array that is
 * not 0 in the regions of interest, such as `SaliencyRegion` of vtkMeshSaliency. Edges outside the
 * regions are collapsed until about ContextFaces triangles are left there (CGAL's edge collapse with
 * the cost and placement of Lindstrom and Turk 1998). The points of the regions and all triangles
 * around them stay as they are, and so do triangles at a point where parts of the surface touch.
 * Flattening then takes the time of a small surface while the regions keep their detail (Zhao et al.
 * 2013, section 5). vtkFlatMapTransfer brings all original points to the flat map afterwards.
 *
 * If the array is a cell array, the corners of the cells that are not 0 form the regions.
 *
 * The output has all arrays of the input; the values at new points are interpolated at the nearest
 * position on the input surface.
 *
 * Output arrays:
 * - point `vtkOriginalPointIds` (vtkIdType): id of the same point in the input; -1 for a new point.
 * - cell `vtkOriginalCellIds` (vtkIdType): id of the same cell in the input, or of the nearest one for
 *   a new cell.
 *
 * Field data (one tuple each):
 * - `RegionPoints` (vtkIdType): number of points in the regions.
 * - `KeptCells` (vtkIdType): number of cells with a corner in the regions.
 * - `ContextCells` (vtkIdType): number of the other cells of the output.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: cells
 * other than triangles; a surface that is not an oriented manifold; no chosen array; an array that is
 * missing, has several components, is 0 everywhere or holds a value that is not a number; ContextFaces
 * below 1.
 *
 * @sa vtkMeshSaliency vtkSurfaceToDiskFilter vtkFlatMapTransfer
 */
#ifndef vtkContextResolution_h
#define vtkContextResolution_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class SURFACEFLATTENINGFILTERS_EXPORT vtkContextResolution : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkContextResolution* New();
  vtkTypeMacro(vtkContextResolution, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Approximate number of triangles outside the regions; a context with fewer stays as it is. The array
   * of the regions is the input array to process 0 (SetInputArrayToProcess; a point or cell array of one
   * component). Range [1, inf), otherwise an error. Default: 10000.
   */
  vtkSetMacro(ContextFaces, int);
  vtkGetMacro(ContextFaces, int);
  ///@}

protected:
  vtkContextResolution() = default;
  ~vtkContextResolution() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int ContextFaces = 10000;

private:
  vtkContextResolution(const vtkContextResolution&) = delete;
  void operator=(const vtkContextResolution&) = delete;
};

#endif
