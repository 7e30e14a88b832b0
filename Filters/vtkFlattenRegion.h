// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlattenRegion
 * @brief   flattens one region of a surface, with its areas kept, and measures it
 *
 * The input is a triangle surface, or a flat one with the array `SurfacePoints`, whose surface in space
 * is meant. The region is that of a label in an array of labels (Mesh Saliency's `SaliencyRegion` is
 * one) or a selection (port 1). With labels or selected points a triangle belongs to the region of two
 * of its corners. The largest connected piece is cut out as a disk, with a margin, mapped conformally,
 * and transported and refined so that it keeps its areas.
 *
 * Output port 0 is the flat region with its margin, in the plane z = 0 and of the surface's area, with
 * all of the input's arrays and
 * - point `SurfacePoints` (double x 3): where each point came from; `vtkOriginalPointIds`; the active
 * `TCoords` (see vtkConformalDiskFilter)
 * - cell `InRegion` (unsigned char): 1 in the region, 0 in the margin; `vtkOriginalCellIds`
 *
 * Output port 1 is a table with a row for each of
 * - `Area`
 * - `GreatestDiameter`, the greatest distance of two points of the region, over its surface
 * - `ExtentAcross`, the greatest from one side of that diameter to the other, square to it
 * - `Perimeter`, the length of the boundary, smoothed
 *
 * and the columns `Measure`, `OnSurface` and `OnMap` (the same face by face and curve by curve on the
 * flat map), `Error` (of OnSurface) and `Unit`. The error is the standard deviation that comes from the
 * boundary running somewhere between the points: of the area and the two lengths, if it is anywhere
 * within half an edge of where it seems, independently along it; of the perimeter, what it changes by
 * when the boundary is smoothed twice as far.
 *
 * Output port 2 has the two diameters and the outline as polylines on the flat map, with the point array
 * `SurfacePoints`, so that they can be shown in space, and the cell arrays `Measure` (a string) and
 * `Length`.
 *
 * Field data of port 0 (one tuple each): `Margin` (input units); `Area`, `FlatArea`, `GreatestDiameter`,
 * `ExtentAcross`, `Perimeter`; `RegionPieces`, of which the largest was kept, and `DroppedArea`;
 * `FilledHoles` and `FilledArea`, of other labels within the region, which became a part of it;
 * `MaxCellAreaError`, `FlippedFaces` and `Bijective`, as from vtkOMTAreaPreservingFilter.
 *
 * An empty input gives empty outputs. Errors, each with empty outputs: labels that are no whole numbers,
 * a label that no triangle has, an empty selection, a region or margin that is not a disk (with the
 * remedy), a surface that is not an oriented manifold of triangles, negative settings, what
 * vtkConformalDiskFilter and vtkOMTAreaPreservingFilter refuse.
 *
 * @sa vtkMeshSaliency vtkAreaWeights vtkConformalDiskFilter vtkOMTAreaPreservingFilter
 */
#ifndef vtkFlattenRegion_h
#define vtkFlattenRegion_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include "vtkBlockwisePolyDataAlgorithm.h"

#include <string>
#include <vector>

class vtkTable;

namespace flattening
{
struct TriangleMesh;
}

class SURFACEFLATTENINGFILTERS_EXPORT vtkFlattenRegion : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkFlattenRegion* New();
  vtkTypeMacro(vtkFlattenRegion, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RegionSources
  {
    LABEL = 0,
    SELECTION = 1
  };

  ///@{
  /**
   * What the region is: the triangles with Label in the input array to process 0
   * (SetInputArrayToProcess; a point or cell array of one component), or the selection on port 1.
   * Default: LABEL.
   */
  vtkSetClampMacro(RegionFrom, int, LABEL, SELECTION);
  vtkGetMacro(RegionFrom, int);
  void SetRegionFromLabel() { this->SetRegionFrom(LABEL); }
  void SetRegionFromSelection() { this->SetRegionFrom(SELECTION); }
  ///@}

  ///@{
  /**
   * The label of the region. Default: 1.
   */
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /**
   * Whether the margin is four mean edges of the region's triangles wide, or the most of three, two, one
   * and none that leaves a disk. Without a margin the teeth of the region's boundary become a part of
   * the circle, and the areas of their triangles suffer. Default: on.
   */
  vtkSetMacro(AutomaticMargin, bool);
  vtkGetMacro(AutomaticMargin, bool);
  vtkBooleanMacro(AutomaticMargin, bool);
  ///@}

  ///@{
  /**
   * Width of what is taken along around the region if AutomaticMargin is off, along edges (input units).
   * Range [0, inf). Default: 0.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Area of the holes in the region that are filled with the surface that is there, as share of the
   * region's area. Range [0, inf). Default: 0.1. Error if they are larger.
   */
  vtkSetMacro(LargestHoles, double);
  vtkGetMacro(LargestHoles, double);
  ///@}

  ///@{
  /**
   * The name of the unit of length of the input, for the table. Default: mm.
   */
  vtkSetMacro(LengthUnit, std::string);
  vtkGetMacro(LengthUnit, std::string);
  ///@}

  /**
   * The selection, port 1: a vtkSelection of the input's points or cells.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /**
   * The table of output port 1 and the curves of output port 2.
   */
  vtkTable* GetMeasures();
  vtkPolyData* GetCurves();
  ///@}

protected:
  vtkFlattenRegion();
  ~vtkFlattenRegion() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int RegionFrom = LABEL;
  int Label = 1;
  bool AutomaticMargin = true;
  double Margin = 0.0;
  double LargestHoles = 0.1;
  std::string LengthUnit = "mm";

private:
  vtkFlattenRegion(const vtkFlattenRegion&) = delete;
  void operator=(const vtkFlattenRegion&) = delete;

  std::vector<char> LabelledFaces(vtkPolyData* input, const flattening::TriangleMesh& mesh);
};

#endif
