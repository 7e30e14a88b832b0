// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkFlattenRegion
 * @brief   flattens one region of a surface with its areas preserved, and measures it
 *
 * The input is a triangle surface, or a flat map with the array `SurfacePoints`, which stands for its
 * surface in space. The region is given by a label in an array of labels, such as `SaliencyRegion` of
 * vtkMeshSaliency, or by a selection (port 1). With labels or selected points, a triangle belongs to
 * the region if two of its corners do. The largest connected piece is cut out as a disk with a margin
 * around it, mapped conformally, and then transported and refined so that it keeps its areas. A warning
 * says which area was left out with the other pieces.
 *
 * Output port 0 is the flat region with its margin, in the plane z = 0, with the area of the surface
 * and all arrays of the input, except the arrays and field data that describe it as a flat map. Output
 * port 1 is a vtkTable with the rows `Area`, `GreatestDiameter`, `ExtentAcross` and `Perimeter`. Output
 * port 2 has the two diameters and the outline as polylines on the flat map.
 *
 * Output arrays of port 0:
 * - point `SurfacePoints` (double x 3, input units): where the flat point lies on the surface.
 * - point `vtkOriginalPointIds` (vtkIdType): id of the same point in the input; -1 for a new point.
 * - point `TCoords` (float x 2, [0, 1]): active texture coordinates, the flat position in the smallest
 *   square around the map with the same centre.
 * - point `SurfaceTCoords` (as in the input): texture coordinates that the surface had under the name
 *   `TCoords` before it was flattened; absent if it had none.
 * - cell `InRegion` (unsigned char): 1 in the region, 0 in the margin.
 * - cell `vtkOriginalCellIds` (vtkIdType): id of the cell of the input that the cell is a part of.
 *
 * Output arrays of port 1:
 * - row `Measure` (string): name of the measure.
 * - row `OnSurface` (double, unit of the row): value on the surface.
 * - row `StandardDeviation` (double, unit of the row): standard deviation of OnSurface, as the boundary
 * lies somewhere between points: for the area and the two lengths, it is taken as uniformly distributed
 *   within half an edge, independently at each edge; for the perimeter, it is the change if the
 *   boundary is smoothed twice as far.
 * - row `OnMap` (double, unit of the row): value of the same faces or the same curve on the flat map.
 * - row `Unit` (string): unit of the row.
 *
 * Output arrays of port 2:
 * - point `SurfacePoints` (double x 3, input units): where the point of the curve lies on the surface.
 * - cell `Measure` (string): `GreatestDiameter`, `ExtentAcross` or `Perimeter`.
 * - cell `Length` (double, input units): length of the curve on the surface; up to the smoothed boundary
 *   for the two that end there, of the smoothed boundary for the perimeter.
 *
 * Field data of all ports (one tuple each):
 * - `Margin` (double, input units): width of the margin.
 * - `Area` (double, input units squared): area of the region on the surface.
 * - `FlatArea` (double, input units squared): area of the region on the map.
 * - `GreatestDiameter` (double, input units): greatest geodesic distance between two points of the
 *   region.
 * - `ExtentAcross` (double, input units): greatest length from one side of that diameter to the other,
 *   at a right angle to it.
 * - `Perimeter` (double, input units): length of the smoothed boundary.
 * - `RegionPieces` (vtkIdType): number of connected pieces of the region, of which the largest was
 *   kept.
 * - `DroppedArea` (double, input units squared): area of the other pieces.
 * - `FilledHoles` (vtkIdType): number of holes in the region that became a part of it.
 * - `FilledArea` (double, input units squared): area of these holes.
 * - `MaxCellAreaError` (double, dimensionless): greatest relative error of the area of a power cell.
 * - `FlippedFaces` (vtkIdType): number of triangles that are not positively oriented.
 * - `Bijective` (vtkIdType): 1 if the map is one-to-one, else 0.
 *
 * An empty input gives empty outputs. The following are errors, each with empty outputs: labels that
 * are not whole numbers; a label that no triangle has; an empty selection; a region or margin that is
 * not a disk (the message names the remedy); a surface that is not an oriented manifold of triangles;
 * negative settings; all errors of vtkConformalDiskFilter and vtkOMTAreaPreservingFilter.
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
   * Source of the region. LABEL (0): the triangles with Label in the input array to process 0
   * (SetInputArrayToProcess; a point or cell array of one component). SELECTION (1): the selection on
   * input port 1. Default: LABEL.
   */
  vtkSetClampMacro(RegionFrom, int, LABEL, SELECTION);
  vtkGetMacro(RegionFrom, int);
  void SetRegionFromLabel() { this->SetRegionFrom(LABEL); }
  void SetRegionFromSelection() { this->SetRegionFrom(SELECTION); }
  ///@}

  ///@{
  /**
   * Label of the region, for LABEL. Any whole number; an error if no triangle has it. Default: 1.
   */
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /**
   * Whether the width of the margin is four times the mean edge length of the region or, if that leaves
   * no disk, three times, twice, once or 0. Without a margin the jagged boundary of the region becomes
   * the circle, and the triangles there lose their areas. Default: on.
   */
  vtkSetMacro(AutomaticMargin, bool);
  vtkGetMacro(AutomaticMargin, bool);
  vtkBooleanMacro(AutomaticMargin, bool);
  ///@}

  ///@{
  /**
   * Width of the margin around the region, measured along edges, if AutomaticMargin is off (input
   * units). Range [0, inf), otherwise an error. Default: 0.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Greatest area of all holes in the region, as a share of the area of the region. The holes are filled
   * with the parts of the surface that lie in them; larger holes are an error. Range [0, inf). Default:
   * 0.1.
   */
  vtkSetMacro(LargestHoles, double);
  vtkGetMacro(LargestHoles, double);
  ///@}

  ///@{
  /**
   * Name of the unit of length of the input, for the table, where nothing else tells it. Default: empty.
   */
  vtkSetMacro(LengthUnit, std::string);
  vtkGetMacro(LengthUnit, std::string);
  ///@}

  /**
   * Selection of SELECTION, input port 1: a vtkSelection of points or cells of the input. Default: none,
   * an error for SELECTION.
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
  std::string LengthUnit;

private:
  vtkFlattenRegion(const vtkFlattenRegion&) = delete;
  void operator=(const vtkFlattenRegion&) = delete;

  std::vector<char> LabelledFaces(vtkPolyData* input, const flattening::TriangleMesh& mesh);
};

#endif
