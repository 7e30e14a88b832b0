// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkContextResolution
 * @brief   leaves regions of a surface as fine as they are and makes the rest coarse
 *
 * The input is a triangle surface, usually the disk of vtkSurfaceToDiskFilter, with an array that is
 * not 0 in the regions of interest: vtkMeshSaliency's `SaliencyRegion` is one. Edges outside of the
 * regions are collapsed until about ContextFaces triangles are left there (CGAL, cost and placement of
 * Lindstrom and Turk 1998). The points of the regions and all triangles around them stay as they are,
 * so that flattening takes the time of a small surface and the regions keep their detail (paper,
 * section 5). vtkFlatMapTransfer brings all original points to the flat map afterwards.
 *
 * With an array of cells the corners of the cells that are not 0 are the region.
 *
 * The output has all arrays of the input, those of new points interpolated at the place of the input
 * nearest to them, and
 * - point `vtkOriginalPointIds`: the input's point, -1 for a new one
 * - cell `vtkOriginalCellIds`: the input's cell, or the one nearest to a new cell
 *
 * Field data (one tuple each): `RegionPoints`, points in the regions; `KeptCells`, cells around them;
 * `ContextCells`, the others of the output.
 *
 * An empty input gives an empty output. Errors, each with an empty output: cells other than triangles, a
 * surface that is not an oriented manifold, no array chosen, one that is missing, has several components
 * or is 0 everywhere or no number somewhere, ContextFaces below 1.
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
   * About how many triangles are left outside of the regions; a context that has fewer stays as it is.
   * The array of the regions is the input array to process 0 (SetInputArrayToProcess; a point or cell
   * array of one component). Range [1, inf). Default: 10000.
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
