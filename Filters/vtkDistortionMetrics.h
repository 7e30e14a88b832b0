// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkDistortionMetrics
 * @brief   measures how much a flattening distorts each face, each region and the whole surface
 *
 * The input is a flattened surface, as vtkConformalDiskFilter or vtkOMTAreaPreservingFilter make it:
 * triangles whose points are flat (z constant) with the point array `SurfacePoints` (3 components, input
 * units) of where each point came from. Both surfaces are scaled to the same total area; then Gamma >=
 * gamma are the singular values of the affine map from the flat triangle to the surface triangle.
 *
 * Output port 0 is the input with these cell arrays (double unless said otherwise), each with the value
 * of a perfect face:
 * - `AreaDistortion`, log(Gamma gamma), 0; positive where the flat face is too small
 * - `AngleDistortion`, log(Gamma / gamma), 0
 * - `AreaRatio`, share of the flat area over share of the target area, 1
 * - `BeltramiMagnitude`, (K - 1) / (K + 1) with K = Gamma / gamma, 0
 * - `StretchL2`, sqrt((Gamma^2 + gamma^2) / 2), 1
 * - `SymmetricDirichlet`, Gamma^2 + gamma^2 + Gamma^-2 + gamma^-2, 4
 * - `AngleError`, mean over the corners of the change of angle in degrees, 0
 * - `Flipped` (unsigned char), 1 where the flat triangle is clockwise or has no area (exact predicate),
 * 0
 * - `Degenerate` (unsigned char), 1 where the surface or the flat triangle has no area, 0
 *
 * A degenerate face has no shape: its measures hold the value of a perfect face, so that colour maps and
 * histograms stay finite, and statistics leave it out. Its AreaRatio is 0, and counts as an area error
 * of 100 percent, where the face has area on the surface but none in the flat.
 *
 * The point array `TCoords`, made active, holds the flat positions mapped to [0,1]^2: the smallest
 * square around the flat surface, with the same centre. Field data receives the figures of the whole
 * surface, as arrays of one tuple: `SurfaceArea` and `FlatArea` (units of the input squared; the area
 * that the boundary encloses, so that flipped faces, which lie on top of others, count negative),
 * `FlippedFaces`, `DegenerateFaces`, `FacesWithin2Percent` (percent of the faces with surface area),
 * `RootMeanSquareStretch`, and `MeanX`, `AreaWeightedMeanX`, `P95X`, `P99X` and `MaxX` for X
 * one of `AreaError` (percent), `AreaDistortion` (its magnitude), `AngleDistortion`,
 * `BeltramiMagnitude`, `StretchL2`, `SymmetricDirichlet` and `AngleError` (degrees). A mean counts every
 * face the same unless it says area-weighted; percentiles are over the faces.
 *
 * Output port 1 is a vtkTable of the same figures: one row per region, in ascending order of `RegionId`,
 * and a last row `Total` with the id -1. `AreaErrorPercent` compares the region's share of the flat area
 * with its share of the target area. See SetInputArrayToProcess below for regions.
 *
 * An empty input gives empty outputs. Errors, each with empty outputs: cells that are not triangles, no
 * array `SurfacePoints`, points that are not finite or not flat, zero total area, a `TargetArea` that is
 * not positive, a region array that is missing or not a label, a whole number, per point or cell.
 *
 * Sources: Zhao et al., "Area-Preservation Mapping using Optimal Mass Transport", TVCG 2013, section 5
 * (area and angle distortion); Sander, Snyder, Gortler, Hoppe, "Texture Mapping Progressive Meshes",
 * SIGGRAPH 2001 (stretch); Smith and Schaefer, "Bijective Parameterization with Free Boundaries",
 * SIGGRAPH 2015 (symmetric Dirichlet energy).
 *
 * @sa vtkConformalDiskFilter vtkOMTAreaPreservingFilter
 */
#ifndef vtkDistortionMetrics_h
#define vtkDistortionMetrics_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class vtkTable;

class SURFACEFLATTENINGFILTERS_EXPORT vtkDistortionMetrics : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkDistortionMetrics* New();
  vtkTypeMacro(vtkDistortionMetrics, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether areas are compared with what the flattening was asked for. If on, and if the input has the
   * point array `TargetArea` that vtkOMTAreaPreservingFilter writes, the target of a face is its surface
   * area times the mean of TargetArea / (one third of the incident surface areas) over its corners. For
   * a flattening without weights that is the surface area itself; for one with weights, all measures
   * then say how far the result is from the request, not from the surface. If off, areas are compared
   * with the surface's. Default: on.
   */
  vtkSetMacro(UseTargetArea, bool);
  vtkGetMacro(UseTargetArea, bool);
  vtkBooleanMacro(UseTargetArea, bool);
  ///@}

  ///@{
  /**
   * Whether the table has a row per region, from the array chosen as input array to process 0. Default:
   * on; without a chosen array there is only the row `Total` all the same.
   */
  vtkSetMacro(UseRegionArray, bool);
  vtkGetMacro(UseRegionArray, bool);
  vtkBooleanMacro(UseRegionArray, bool);
  ///@}

  ///@{
  /**
   * Name of a string array in the input's field data whose tuple i is the name of the region with label
   * i, for the table. Regions without a name are called by their label. Default: "RegionNames"; an array
   * that does not exist is no error.
   */
  vtkSetStringMacro(RegionNamesArray);
  vtkGetStringMacro(RegionNamesArray);
  ///@}

  /**
   * The table of output port 1. The input array to process 0, set by SetInputArrayToProcess(0, 0, 0,
   * association, name), is an optional array of labels (one component, whole numbers) per cell or
   * per point. Not set, an empty name or "None": the table has only the row `Total`. With labels per
   * point a face belongs to the label of most of its corners, or of its first corner if all three
   * differ.
   */
  vtkTable* GetSummary();

protected:
  vtkDistortionMetrics();
  ~vtkDistortionMetrics() override;

  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  bool UseTargetArea = true;
  bool UseRegionArray = true;
  char* RegionNamesArray = nullptr;

private:
  vtkDistortionMetrics(const vtkDistortionMetrics&) = delete;
  void operator=(const vtkDistortionMetrics&) = delete;
};

#endif
