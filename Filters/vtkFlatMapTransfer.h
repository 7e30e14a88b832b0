// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlatMapTransfer
 * @brief   gives the original points of a surface the flattening of its repaired or remeshed one
 *
 * Port 0 takes a flattened surface (flat triangles with the point array `SurfacePoints`, from
 * vtkConformalDiskFilter or vtkOMTAreaPreservingFilter), port 1 the original triangle surface, in the
 * coordinates of `SurfacePoints`: usually the input of vtkSurfaceToDiskFilter. Every original point goes
 * to the flat position of the point nearest to it on the flattened surface, interpolated in its
 * triangle.
 *
 * A point is lost where there is no such place: over a hole that was cut, on a component, a handle or a
 * patch that is not there any more, farther away than the tolerance, or where only the other side of a
 * fold is near (normals that differ by more than 90 degrees). The output has the original cells whose
 * points all survived, and their points, in the plane z = 0, with all of the original's arrays and:
 * - point `SurfacePoints` (double x 3), the original points; the active `TCoords` (see
 *   vtkConformalDiskFilter)
 * - point `vtkOriginalPointIds`, cell `vtkOriginalCellIds`: which they were
 *
 * Field data (one tuple each): `TransferredPoints`, the points of the output; `LostPoints` and
 * `LostCells`, the original ones that are not there; `LargestDistance` (input units) between an original
 * point and its place on the flattened surface; `Tolerance` (input units) that was used; `FlippedFaces`,
 * cells of the output that are turned over: where the original has slivers that the flattened surface
 * has not, a few are.
 *
 * An empty input on either port gives an empty output. Errors, each with an empty output: cells that are
 * not triangles, a missing `SurfacePoints` array, a flattened surface that is not flat or not an
 * oriented manifold, coordinates that are not finite, a tolerance that is negative or not finite, no
 * original point or no whole original triangle within the tolerance.
 *
 * @sa vtkSurfaceToDiskFilter vtkConformalDiskFilter vtkOMTAreaPreservingFilter
 */
#ifndef vtkFlatMapTransfer_h
#define vtkFlatMapTransfer_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class SURFACEFLATTENINGFILTERS_EXPORT vtkFlatMapTransfer : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkFlatMapTransfer* New();
  vtkTypeMacro(vtkFlatMapTransfer, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The original surface, port 1.
   */
  void SetOriginalConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetOriginalData(vtkPolyData* original) { this->SetInputData(1, original); }
  ///@}

  ///@{
  /**
   * Greatest distance of an original point from the flattened surface (input units). Range [0, inf),
   * else an error. Default: 0, half of the flattened surface's mean edge length in space.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkFlatMapTransfer();
  ~vtkFlatMapTransfer() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double Tolerance = 0.0;

private:
  vtkFlatMapTransfer(const vtkFlatMapTransfer&) = delete;
  void operator=(const vtkFlatMapTransfer&) = delete;
};

#endif
