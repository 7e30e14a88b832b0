// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkMeshSaliency
 * @brief   computes how much each point of a surface stands out, and the regions that do
 *
 * The input is a triangle surface, or a flat map with the array `SurfacePoints`, which stands for its
 * surface in space. On each of several scales, the saliency of a point is the difference between the
 * mean curvature averaged over a small neighbourhood and over one twice as large. The scales are summed
 * so that those with a few high peaks count most.
 *
 * The curvature is integrated over the edges (Cohen-Steiner, Morvan 2003), so that slivers do no harm.
 * Points are weighted by the area around them, so that the result does not depend on how fine the
 * triangles are; AreaWeighted off gives the weights of the paper. Points in the same cubic cell, whose
 * side is a third of a standard deviation, are taken together: on a half brain of 68,000 points the
 * saliency then differs from that of all pairs of points by 0.2 % of its greatest value on average and
 * by 2 % at most. The result does not depend on the number of threads.
 *
 * Output arrays:
 * - point `Saliency` (double, dimensionless): how much the point stands out, >= 0; the active scalars.
 * - point `SaliencyRegion` (int): number of the region of interest that the point is in, 1 for the one
 *   of the largest area; 0 for none. Only if FindRegions is on.
 * - point `SaliencyScaleN` (double, one over input units): difference on the scale of N = 2, 3, ...
 *   units. Only if PerScaleArrays is on.
 * - point `MeanCurvature` (double, one over input units): mean curvature, positive where a surface with
 *   outward normals is convex. Only if PerScaleArrays is on.
 *
 * Field data (one tuple each unless stated otherwise):
 * - `SaliencyUnit` (double, input units): unit of the scales.
 * - `SaliencyThreshold` (double, dimensionless): lowest saliency of a region; only if FindRegions is
 *   on.
 * - `SaliencyRegions` (vtkIdType): number of regions; only if FindRegions is on.
 * - `SaliencyRegionAreas` (double, input units squared, one tuple per region): areas of the regions;
 *   absent if there is none.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: cells
 * other than triangles; coordinates that are not finite; a surface without area; scales larger than the
 * surface; a negative unit, area or threshold.
 *
 * Source: Lee, Varshney, Jacobs, "Mesh saliency", SIGGRAPH 2005.
 *
 * @sa vtkAreaWeights vtkFlattenRegion vtkContextResolution
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
   * Unit of the scales (input units); features of about 5 to 15 units across stand out. 0 takes 0.3 % of
   * the diagonal of the bounding box, as the paper does. Range [0, inf); an error if negative, or if the
   * largest scale, 4 (NumberOfScales + 1) units, exceeds the diagonal. Default: 0.
   */
  vtkSetMacro(Unit, double);
  vtkGetMacro(Unit, double);
  ///@}

  ///@{
  /**
   * Number of scales. They compare Gaussians of standard deviation 2, 3, ... units with Gaussians twice
   * as wide. Range [1, 20]. Default: 5.
   */
  vtkSetClampMacro(NumberOfScales, int, 1, 20);
  vtkGetMacro(NumberOfScales, int);
  ///@}

  ///@{
  /**
   * Whether points are weighted by the area around them. If off, all have the same weight, as in the
   * paper. Default: on.
   */
  vtkSetMacro(AreaWeighted, bool);
  vtkGetMacro(AreaWeighted, bool);
  vtkBooleanMacro(AreaWeighted, bool);
  ///@}

  ///@{
  /**
   * Whether the output has an array for each scale and the array MeanCurvature. Default: off.
   */
  vtkSetMacro(PerScaleArrays, bool);
  vtkGetMacro(PerScaleArrays, bool);
  vtkBooleanMacro(PerScaleArrays, bool);
  ///@}

  ///@{
  /**
   * Whether regions of interest are found: sets of points of at least the threshold that are connected
   * by edges. Default: on.
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
   * Threshold of the regions: the saliency below which Percentile percent of the area lie (PERCENTILE,
   * 0), or Threshold (VALUE, 1). Default: PERCENTILE.
   */
  vtkSetClampMacro(ThresholdType, int, PERCENTILE, VALUE);
  vtkGetMacro(ThresholdType, int);
  void SetThresholdTypeToPercentile() { this->SetThresholdType(PERCENTILE); }
  void SetThresholdTypeToValue() { this->SetThresholdType(VALUE); }
  ///@}

  ///@{
  /**
   * Share of the area with a saliency below the threshold, for PERCENTILE (percent). Range [0, 100].
   * Default: 90.
   */
  vtkSetClampMacro(Percentile, double, 0.0, 100.0);
  vtkGetMacro(Percentile, double);
  ///@}

  ///@{
  /**
   * Lowest saliency of a region, for VALUE (dimensionless). Range [0, inf), otherwise an error. Default:
   * 0.5.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /**
   * Smallest area of a region (input units squared); smaller regions are left out. Range [0, inf),
   * otherwise an error. Default: 0.
   */
  vtkSetMacro(MinimumRegionArea, double);
  vtkGetMacro(MinimumRegionArea, double);
  ///@}

  ///@{
  /**
   * Greatest area of a region (input units squared); larger regions are left out. 0 keeps all. Range [0,
   * inf), otherwise an error. Default: 0.
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
