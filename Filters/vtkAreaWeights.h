// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkAreaWeights
 * @brief   computes weights that make chosen regions larger or smaller on the flat map
 *
 * The input is a triangle surface at any stage before vtkOMTAreaPreservingFilter: the surface of the
 * scan, the disk or its conformal map. The output is the input with one more point array, `AreaWeight`,
 * which vtkOMTAreaPreservingFilter reads. WeightsFrom says which points get which factor:
 * - LABEL: the region with one label in an array of labels gets Factor.
 * - LABEL_TABLE: each label of a table gets its own factor; all other labels keep the factor 1.
 * - SCALARS: the factor of each point is its value in an array, passed through a transfer curve.
 * - SELECTION: the selected points, or the corners of the selected cells (port 1), get Factor.
 * - IMPLICIT_FUNCTION: the points inside a sphere or box or on one side of a plane get Factor.
 *
 * If the input already has an array `AreaWeight`, the new weights are multiplied by it, so that several
 * filters in a chain combine.
 *
 * A region is a set of points. If the labels are given per cell, each point takes the label that covers
 * most of the area around it. The power cells of the points of a region then grow by exactly the
 * factor; so do, to the tolerance of the flattening, the triangles with all three corners in the
 * region. The triangles across the border of a region grow by something between.
 *
 * Output arrays:
 * - point `AreaWeight` (double, dimensionless): factor by which the area around the point is to grow
 *   relative to the other points, > 0; the active scalars.
 *
 * Field data (one tuple each):
 * - `RegionPoints` (vtkIdType): number of points in all regions together; absent for SCALARS.
 * - `RegionArea` (double, input units squared): area of all regions on the surface, a third of the area
 *   of the triangles around each point; absent for SCALARS.
 * - `RegionFlatArea` (double, input units squared): area that the regions get on a map with the area of
 *   the surface; absent for SCALARS.
 * - `SmallestMagnification` (double, dimensionless): smallest ratio of flat area to surface area of any
 *   point.
 * - `GreatestMagnification` (double, dimensionless): greatest ratio of flat area to surface area of any
 *   point.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: cells
 * other than triangles; an array that is missing, has several components or holds values that are not
 * finite or, as labels, not whole numbers; a label that no point has; an empty selection; a function
 * that encloses no point; factors that are not positive, or that make weights
 * outside of 1e-100 to 1e100; regions that cover the whole surface;
 * magnifications for which the map has no room; soft edges on a surface that is not a connected
 * manifold; an earlier `AreaWeight` that is not positive.
 *
 * @sa vtkOMTAreaPreservingFilter vtkMeshSaliency
 */
#ifndef vtkAreaWeights_h
#define vtkAreaWeights_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include "vtkBlockwisePolyDataAlgorithm.h"

#include <vtkSmartPointer.h>

#include <utility>
#include <vector>

class vtkImplicitFunction;
class vtkPiecewiseFunction;
class vtkSelection;

namespace flattening
{
struct ChosenArray;
struct TriangleMesh;
struct WeightedRegion;
}

class SURFACEFLATTENINGFILTERS_EXPORT vtkAreaWeights : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkAreaWeights* New();
  vtkTypeMacro(vtkAreaWeights, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override;

  enum WeightSources
  {
    LABEL = 0,
    LABEL_TABLE = 1,
    SCALARS = 2,
    SELECTION = 3,
    IMPLICIT_FUNCTION = 4
  };

  ///@{
  /**
   * Source of the weights: LABEL (0), LABEL_TABLE (1), SCALARS (2), SELECTION (3) or IMPLICIT_FUNCTION
   * (4). LABEL, LABEL_TABLE and SCALARS read the input array to process 0 (SetInputArrayToProcess), a
   * point or cell array of one component. Default: LABEL.
   */
  vtkSetClampMacro(WeightsFrom, int, LABEL, IMPLICIT_FUNCTION);
  vtkGetMacro(WeightsFrom, int);
  void SetWeightsFromLabel() { this->SetWeightsFrom(LABEL); }
  void SetWeightsFromLabelTable() { this->SetWeightsFrom(LABEL_TABLE); }
  void SetWeightsFromScalars() { this->SetWeightsFrom(SCALARS); }
  void SetWeightsFromSelection() { this->SetWeightsFrom(SELECTION); }
  void SetWeightsFromImplicitFunction() { this->SetWeightsFrom(IMPLICIT_FUNCTION); }
  ///@}

  ///@{
  /**
   * Label of the region, for LABEL. Any whole number; an error if no point has it. Default: 1.
   */
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /**
   * Factor of the areas of the region, for LABEL, SELECTION and IMPLICIT_FUNCTION (dimensionless); see
   * FactorMeaning. Range (0, inf), otherwise an error. Default: 2.
   */
  vtkSetMacro(Factor, double);
  vtkGetMacro(Factor, double);
  ///@}

  ///@{
  /**
   * Table of labels and their factors (dimensionless, > 0), for LABEL_TABLE. Labels outside the table
   * keep the factor 1. An error if the table is empty, or if a label is in it twice, is not a whole
   * number or is the label of no point. Default: empty.
   */
  void AddLabelFactor(double label, double factor);
  void ClearLabelFactors();
  ///@}

  ///@{
  /**
   * Transfer curve from values of the array (in its units) to factors (dimensionless, > 0), for SCALARS.
   * It is linear between its points and constant before the first and after the last. Without points the
   * value itself is the factor. A cell array is first averaged to the points by area. Default: no
   * points.
   */
  void AddCurvePoint(double value, double factor);
  void ClearCurve();
  vtkPiecewiseFunction* GetTransferCurve();
  ///@}

  enum FactorMeanings
  {
    RELATIVE_TO_REST = 0,
    MAGNIFICATION = 1
  };

  ///@{
  /**
   * Meaning of a factor. RELATIVE_TO_REST (0): the region grows by the factor relative to the rest of
   * the surface; any factor is possible. MAGNIFICATION (1): the region grows by the factor on the map,
   * and the rest shrinks or grows to fill the map; an error if no room is left for it. The factors of
   * SCALARS are always relative to each other. Default: RELATIVE_TO_REST.
   */
  vtkSetClampMacro(FactorMeaning, int, RELATIVE_TO_REST, MAGNIFICATION);
  vtkGetMacro(FactorMeaning, int);
  void SetFactorMeaningToRelativeToRest() { this->SetFactorMeaning(RELATIVE_TO_REST); }
  void SetFactorMeaningToMagnification() { this->SetFactorMeaning(MAGNIFICATION); }
  ///@}

  ///@{
  /**
   * Width outside a region over which its weight fades to that of the rest (geodesic distance by the
   * heat method, input units). The region itself keeps its factor. Range [0, inf), otherwise an error.
   * Default: 0, a sharp edge, where the weights change over one triangle.
   */
  vtkSetMacro(EdgeWidth, double);
  vtkGetMacro(EdgeWidth, double);
  ///@}

  ///@{
  /**
   * Function of IMPLICIT_FUNCTION: the region is where the function is <= 0, such as the inside of a
   * sphere or box. It is evaluated at the points of the input, or at the positions in the input array to
   * process 1, a point array of 3 components (input units): with `SurfacePoints`, at the positions in
   * space of a flat map. Default: none, an error for IMPLICIT_FUNCTION.
   */
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  ///@}

  ///@{
  /**
   * Whether the region of IMPLICIT_FUNCTION is where the function is >= 0. Default: off.
   */
  vtkSetMacro(InsideOut, bool);
  vtkGetMacro(InsideOut, bool);
  vtkBooleanMacro(InsideOut, bool);
  ///@}

  /**
   * Selection of SELECTION, input port 1: a vtkSelection of points or cells of the input. Default: none,
   * an error for SELECTION.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

protected:
  vtkAreaWeights();
  ~vtkAreaWeights() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int WeightsFrom = LABEL;
  int Label = 1;
  double Factor = 2.0;
  int FactorMeaning = RELATIVE_TO_REST;
  double EdgeWidth = 0.0;
  bool InsideOut = false;

private:
  vtkAreaWeights(const vtkAreaWeights&) = delete;
  void operator=(const vtkAreaWeights&) = delete;

  flattening::ChosenArray RequireArray(vtkPolyData* input);
  std::vector<flattening::WeightedRegion> LabelRegions(vtkPolyData* input,
    const flattening::TriangleMesh& mesh);
  std::vector<flattening::WeightedRegion> ChosenRegions(vtkPolyData* input,
    vtkSelection* selection,
    const flattening::TriangleMesh& mesh);
  std::vector<char> EnclosedPoints(vtkPolyData* input);
  std::vector<double> ScalarFactors(vtkPolyData* input, const flattening::TriangleMesh& mesh);

  std::vector<std::pair<double, double>> LabelFactors;
  vtkSmartPointer<vtkPiecewiseFunction> TransferCurve;
  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;
};

#endif
