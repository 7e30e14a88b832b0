// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlatMapTransfer
 * @brief   transfers the flat map of a repaired or remeshed surface to the original surface
 *
 * Port 0 takes a flattened surface (flat triangles with the point array `SurfacePoints`, from
 * vtkConformalDiskFilter or vtkOMTAreaPreservingFilter). Port 1 takes the original triangle surface in
 * the coordinates of `SurfacePoints`, usually the input of vtkSurfaceToDiskFilter. Every original point
 * goes to the flat position of the nearest point on the flattened surface, interpolated in its
 * triangle. A triangle that both surfaces have, with the same coordinates, lies where the map has it.
 *
 * An original point is lost if it has no such position: if it lies on a removed hole, component, handle
 * or patch, farther away than the tolerance, or nearest to the wrong side of a fold (normals that
 * differ by more than 90 degrees). The output consists of the original cells whose points all survived.
 * Their points lie in the plane z = 0 and keep all arrays of the original surface but those that
 * describe an earlier map of it.
 *
 * A disk that vtkSurfaceToDiskFilter has opened along a seam has two banks there, at the same place on
 * the surface and apart on the map. Each cell lies on the bank of its centroid, and none reaches from
 * one bank to the other. A point on the seam is in the output once for each bank, as in the disk. A cell
 * through which the seam runs has no place in one piece: it is left out, on a surface that was not
 * remeshed, too, as seams run through triangles.
 *
 * Output arrays:
 * - point `SurfacePoints` (double x 3, input units): the original point.
 * - point `vtkOriginalPointIds` (vtkIdType): id of the original point; points on a seam share one.
 * - cell `vtkOriginalCellIds` (vtkIdType): id of the original cell.
 * - point `TCoords` (float x 2, [0, 1]): active texture coordinates, the flat position in the smallest
 *   square around the map with the same centre.
 * - point `SurfaceTCoords` (as in the input): texture coordinates that the original surface had under
 *   the name `TCoords`; absent if it had none.
 *
 * Field data (one tuple each), in place of the measures and reports of the flattened surface's map:
 * - `TransferredPoints` (vtkIdType): number of points of the output.
 * - `LostPoints` (vtkIdType): number of original points that are not in the output.
 * - `RepeatedPoints` (vtkIdType): number of original points that are in the output more than once.
 * - `LostCells` (vtkIdType): number of original cells that are not in the output.
 * - `CellsAcrossSeams` (vtkIdType): number of those through which a seam runs.
 * - `FlippedFaces` (vtkIdType): number of triangles of the output that are not positively oriented; a
 *   warning if there are any. There are a few where the original surface has slivers that the flattened
 *   surface does not have, and beside seams, where the map bends their sides.
 * - `SurfaceArea` (double, input units squared): area of the output's cells on the original surface.
 * - `LargestDistance` (double, input units): greatest distance of a transferred point from the
 *   flattened surface.
 * - `Tolerance` (double, input units): the tolerance that was used.
 *
 * An empty input on either port gives an empty output. The following are errors, each with an empty
 * output: cells that are not triangles; no array `SurfacePoints`; a flattened surface that is not flat
 * or not an oriented manifold; coordinates that are not finite; a tolerance that is negative or not
 * finite; no original point, or no complete original triangle, within the tolerance.
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
   * Original surface, input port 1: triangles in the coordinates of `SurfacePoints`.
   */
  void SetOriginalConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetOriginalData(vtkPolyData* original) { this->SetInputData(1, original); }
  ///@}

  ///@{
  /**
   * Greatest distance of an original point from the flattened surface (input units); 0 takes half of the
   * mean edge length of the flattened surface in space. Range [0, inf), otherwise an error. Default: 0.
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
