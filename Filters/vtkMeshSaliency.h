// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkMeshSaliency
 * @brief   how much each point of a surface stands out from its surroundings, and the regions that do
 *
 * The input is a triangle surface, or a flat one with the array `SurfacePoints`, which is then measured
 * in space. The output is the input with the arrays
 * - point `Saliency` (double, >= 0, dimensionless), its active scalars: on each of several scales the
 *   difference between the mean curvature averaged over a small and over a twice as large neighbourhood,
 *   summed so that scales with a few high peaks count most
 * - point `SaliencyRegion` (int), if FindRegions is on: the number of the region of interest that the
 *   point is in, 1 for that of the largest area; 0: none
 * - point `SaliencyScale2`, `SaliencyScale3`, ... (double, one over input units), if PerScaleArrays is
 * on: the difference on the scale of 2, 3, ... units; and `MeanCurvature` (double, one over input units,
 *   positive where a surface with outward normals is convex)
 *
 * Field data: `SaliencyUnit` (input units) and `SaliencyThreshold`, one tuple each; `SaliencyRegions`,
 * their number, and `SaliencyRegionAreas` (input units squared), one tuple per region, if there are any.
 *
 * The curvature is integrated over the edges (Cohen-Steiner, Morvan 2003), so that slivers do no harm.
 * Points count by the area around them, so that the result does not depend on how fine the triangles
 * are; AreaWeighted off gives the paper's. Points in the same cubic cell of a third of a standard
 * deviation count together: on a half brain of 68,000 points the saliency differs from that of all pairs
 * of points by 0.2 % of its greatest value on average and by 2 % at most. The result does not depend on
 * the number of threads.
 *
 * An empty input gives an empty output. Errors, each with an empty output: cells other than triangles,
 * coordinates that are not finite, a surface without area, scales larger than the surface, a negative
 * unit, area or threshold.
 *
 * Source: Lee, Varshney, Jacobs, "Mesh saliency", SIGGRAPH 2005.
 *
 * @sa vtkAreaWeights
 */
#ifndef vtkMeshSaliency_h
#define vtkMeshSaliency_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class SURFACEFLATTENINGFILTERS_EXPORT vtkMeshSaliency : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkMeshSaliency* New();
  vtkTypeMacro(vtkMeshSaliency, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The unit of the scales (input units). Things of about 5 to 15 units across stand out. Range [0,
   * inf). Default: 0, the paper's 0.3 % of the diagonal of the bounding box. Error if negative, or if
   * the largest scale, 4 (NumberOfScales + 1) units, reaches beyond the diagonal.
   */
  vtkSetMacro(Unit, double);
  vtkGetMacro(Unit, double);
  ///@}

  ///@{
  /**
   * Number of scales: of Gaussians of standard deviation 2, 3, ... units against twice that. Range
   * [1, 20]. Default: 5.
   */
  vtkSetClampMacro(NumberOfScales, int, 1, 20);
  vtkGetMacro(NumberOfScales, int);
  ///@}

  ///@{
  /**
   * Whether points count by the area around them. Default: on.
   */
  vtkSetMacro(AreaWeighted, bool);
  vtkGetMacro(AreaWeighted, bool);
  vtkBooleanMacro(AreaWeighted, bool);
  ///@}

  ///@{
  /**
   * Whether there is an array for each scale, and MeanCurvature. Default: off.
   */
  vtkSetMacro(PerScaleArrays, bool);
  vtkGetMacro(PerScaleArrays, bool);
  vtkBooleanMacro(PerScaleArrays, bool);
  ///@}

  ///@{
  /**
   * Whether regions of interest are made: points of at least the threshold that edges connect. Default:
   * on.
   */
  vtkSetMacro(FindRegions, bool);
  vtkGetMacro(FindRegions, bool);
  vtkBooleanMacro(FindRegions, bool);
  ///@}

  enum ThresholdTypes
  {
    PERCENTILE = 0,
    VALUE = 1
  };

  ///@{
  /**
   * What the threshold of the regions is: the saliency that is exceeded on the rest of the area beyond
   * Percentile (PERCENTILE), or Threshold (VALUE). Default: PERCENTILE.
   */
  vtkSetClampMacro(ThresholdType, int, PERCENTILE, VALUE);
  vtkGetMacro(ThresholdType, int);
  void SetThresholdTypeToPercentile() { this->SetThresholdType(PERCENTILE); }
  void SetThresholdTypeToValue() { this->SetThresholdType(VALUE); }
  ///@}

  ///@{
  /**
   * Percent of the area that has a lower saliency than a region's. Range [0, 100]. Default: 90.
   */
  vtkSetClampMacro(Percentile, double, 0.0, 100.0);
  vtkGetMacro(Percentile, double);
  ///@}

  ///@{
  /**
   * Lowest saliency of a region, dimensionless. Range [0, inf). Default: 0.5.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /**
   * Regions of a smaller area than this (input units squared) are left out. Range [0, inf). Default: 0.
   */
  vtkSetMacro(MinimumRegionArea, double);
  vtkGetMacro(MinimumRegionArea, double);
  ///@}

  ///@{
  /**
   * Regions of a larger area than this (input units squared) are left out. Range [0, inf); 0: none is.
   * Default: 0.
   */
  vtkSetMacro(MaximumRegionArea, double);
  vtkGetMacro(MaximumRegionArea, double);
  ///@}

protected:
  vtkMeshSaliency() = default;
  ~vtkMeshSaliency() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double Unit = 0.0;
  int NumberOfScales = 5;
  bool AreaWeighted = true;
  bool PerScaleArrays = false;
  bool FindRegions = true;
  int ThresholdType = PERCENTILE;
  double Percentile = 90.0;
  double Threshold = 0.5;
  double MinimumRegionArea = 0.0;
  double MaximumRegionArea = 0.0;

private:
  vtkMeshSaliency(const vtkMeshSaliency&) = delete;
  void operator=(const vtkMeshSaliency&) = delete;
};

#endif
