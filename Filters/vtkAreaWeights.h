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
 * that encloses no point; factors that are not positive; regions that cover the whole surface;
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
   * Where the weights come from. LABEL, LABEL_TABLE and SCALARS read the input array to process 0
   * (SetInputArrayToProcess), a point or cell array of one component. Default: LABEL.
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
   * The label of the region, for LABEL. Default: 1. Error if no point has it.
   */
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /**
   * The factor of the region's areas, for LABEL, SELECTION and IMPLICIT_FUNCTION; see FactorMeaning.
   * Dimensionless, > 0. Default: 2. Error otherwise.
   */
  vtkSetMacro(Factor, double);
  vtkGetMacro(Factor, double);
  ///@}

  ///@{
  /**
   * The table of LABEL_TABLE: a factor (> 0) per label. Error if it is empty, a label is in it twice or
   * is no whole number, or no point has it. Labels that are not in it have no factor.
   */
  void AddLabelFactor(double label, double factor);
  void ClearLabelFactors();
  ///@}

  ///@{
  /**
   * The transfer curve of SCALARS: factors (> 0) at values of the array, linear between them and
   * constant beyond the first and last. Without points the value itself is the factor. A cell array is
   * averaged to the points, by area, first.
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
   * What a factor compares. RELATIVE_TO_REST: the region grows to Factor times what it was, as compared
   * with the rest; any factor fits. MAGNIFICATION: the region gets Factor times its area on the map, and
   * the rest shrinks (or grows) to make room; error if there is none. Default: RELATIVE_TO_REST. Factors
   * of SCALARS are always relative to each other.
   */
  vtkSetClampMacro(FactorMeaning, int, RELATIVE_TO_REST, MAGNIFICATION);
  vtkGetMacro(FactorMeaning, int);
  void SetFactorMeaningToRelativeToRest() { this->SetFactorMeaning(RELATIVE_TO_REST); }
  void SetFactorMeaningToMagnification() { this->SetFactorMeaning(MAGNIFICATION); }
  ///@}

  ///@{
  /**
   * Over what width outside a region its weight fades to that of the rest: geodesic distance from the
   * region (heat method), input units (mm). The region itself keeps its factor. Range [0, inf). Default:
   * 0, a sharp edge, where the weights change over one triangle.
   */
  vtkSetMacro(EdgeWidth, double);
  vtkGetMacro(EdgeWidth, double);
  ///@}

  ///@{
  /**
   * The function of IMPLICIT_FUNCTION: its region is where the function is <= 0, the inside of a sphere
   * or box. It is evaluated at the points of the input, or at the positions in the input array to
   * process 1, a point array of 3 components: `SurfacePoints` for the place in space of the points of a
   * flat surface. Default: none.
   */
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  ///@}

  ///@{
  /**
   * If on, the region of IMPLICIT_FUNCTION is where the function is >= 0. Default: off.
   */
  vtkSetMacro(InsideOut, bool);
  vtkGetMacro(InsideOut, bool);
  vtkBooleanMacro(InsideOut, bool);
  ///@}

  /**
   * The selection of SELECTION, port 1: a vtkSelection of the input's points or cells.
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
