// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkDistortionMetrics
 * @brief   measures how much a flattening distorts each face, each region and the whole surface
 *
 * The input is a flattened surface from vtkConformalDiskFilter or vtkOMTAreaPreservingFilter: triangles
 * whose points are flat (constant z), with the point array `SurfacePoints` (3 components, input units)
 * that says where each point lies on the surface. Both surfaces are scaled to the same total area. Then
 * Gamma >= gamma are the singular values of the affine map from the flat triangle to the surface
 * triangle.
 *
 * Output port 0 is the input with the measures of each face. Output port 1 is a vtkTable with a row per
 * region, in ascending order of the label, and a last row `Total`.
 *
 * A degenerate face has no shape. Its measures hold the value of an undistorted face, so that colour
 * maps and histograms stay finite, and the statistics leave it out. If it has area on the surface but
 * none in the plane, its AreaRatio is 0 and counts as an area error of 100 percent.
 *
 * Output arrays of port 0:
 * - cell `AreaDistortion` (double, dimensionless): log(Gamma gamma); 0 is ideal, and it is positive
 *   where the flat face is too small.
 * - cell `AngleDistortion` (double, dimensionless): log(Gamma / gamma); 0 is ideal.
 * - cell `AreaRatio` (double, dimensionless): share of the flat area over share of the target area; 1
 *   is ideal.
 * - cell `BeltramiMagnitude` (double, dimensionless): (K - 1) / (K + 1) with K = Gamma / gamma; 0 is
 *   ideal.
 * - cell `StretchL2` (double, dimensionless): sqrt((Gamma^2 + gamma^2) / 2); 1 is ideal.
 * - cell `SymmetricDirichlet` (double, dimensionless): Gamma^2 + gamma^2 + Gamma^-2 + gamma^-2; 4 is
 *   ideal.
 * - cell `AngleError` (double, degrees): mean change of the three corner angles; 0 is ideal.
 * - cell `Flipped` (unsigned char): 1 where the flat triangle is clockwise or has no area (exact
 *   predicate), 0 elsewhere.
 * - cell `Degenerate` (unsigned char): 1 where the surface triangle or the flat triangle has no area, 0
 *   elsewhere.
 * - point `LengthError` (double, percent; only with MeasureLengths): mean error of the lengths between
 *   the point and the source points no farther than LengthRadius from it; -1 where there are none.
 * - point `TCoords` (float x 2, [0, 1]): active texture coordinates, the flat position in the smallest
 *   square around the map with the same centre.
 *
 * X below stands for one of `AreaError` (percent), `AreaDistortion` (its magnitude),
 * `AngleDistortion`, `BeltramiMagnitude`, `StretchL2`, `SymmetricDirichlet` and `AngleError` (degrees).
 *
 * Field data of both ports (one tuple each):
 * - `SurfaceArea` (double, input units squared): area of the surface.
 * - `FlatArea` (double, units of the map squared): area that the boundary of the map encloses; flipped
 *   faces, which lie on top of others, count negative.
 * - `FlippedFaces` (vtkIdType): number of faces with `Flipped` 1.
 * - `DegenerateFaces` (vtkIdType): number of faces with `Degenerate` 1.
 * - `FacesWithin2Percent` (double, percent): share of the faces, except those without area on the
 *   surface, that are not flipped and whose AreaRatio is within 0.02 of 1.
 * - `RootMeanSquareStretch` (double, dimensionless): root of the area-weighted mean of StretchL2
 *   squared.
 * - `MeanX` (double, unit of X): mean over the faces, each counted once.
 * - `AreaWeightedMeanX` (double, unit of X): mean over the faces, weighted by their surface areas.
 * - `P95X` (double, unit of X): value that 5 percent of the faces exceed.
 * - `P99X` (double, unit of X): value that 1 percent of the faces exceed.
 * - `MaxX` (double, unit of X): greatest value of a face.
 * - `SDAreaRatio` (double, dimensionless): standard deviation of AreaRatio over the faces that have
 *   area on the surface, each counted once; 0 is ideal.
 * - `SDLogAreaRatio` (double, dimensionless): standard deviation of the natural logarithm of AreaRatio
 *   over the faces that are not degenerate; 0 is ideal.
 *
 * L below stands for `Local` (lengths up to LengthRadius; straight lines on the map), `WithinMap` (the
 * same, on the surface as it was cut open; shortest paths within the map) and `Global` (all lengths;
 * straight lines on the map). An error is relative to the length on the surface, after all lengths on
 * the map were multiplied by the scale that makes the mean error least.
 *
 * Field data of port 0 with MeasureLengths (one tuple each):
 * - `MeanLLengthError` (double, percent): mean error, every source point counted the same.
 * - `StandardErrorLLengthError` (double, percent): standard error of that mean.
 * - `P95LLengthError` (double, percent): error that 5 percent of the lengths exceed.
 * - `RingDistanceError` (double, percent): mean error of the lengths between points that are joined by
 *   seven edges or fewer, on the surface as it was cut open; straight lines on the map.
 * - `LengthScale` (double, input units per unit of the map): scale of the local lengths.
 *
 * Output arrays of port 1:
 * - row `RegionId` (vtkIdType): label of the region; -1 in the row `Total`.
 * - row `Region` (string): name of the region.
 * - row `Faces` (int): number of faces.
 * - row `FlippedFaces` (int): number of flipped faces.
 * - row `DegenerateFaces` (int): number of degenerate faces.
 * - row `AreaErrorPercent` (double, percent): error of the region's share of the flat area against its
 *   share of the target area.
 * - row `SurfaceArea` (double, input units squared): as in the field data, as are all further columns
 *   (`FlatArea`, `FacesWithin2Percent`, `RootMeanSquareStretch`, `SDAreaRatio`, `SDLogAreaRatio`,
 *   `MeanX` to `MaxX`).
 *
 * An empty input gives empty outputs. The following are errors, each with empty outputs: cells that are
 * not triangles; no array `SurfacePoints`; points that are not finite or not flat; zero total area; a
 * `TargetArea` that is not positive; a region array that is missing or does not hold one whole number
 * per point or cell; with MeasureLengths, a LengthRadius or LengthSamples out of its range, and a
 * LengthRadius within which no two points lie.
 *
 * Sources: Zhao et al., "Area-Preservation Mapping using Optimal Mass Transport", TVCG 2013, section 5
 * (area and angle distortion); Sander, Snyder, Gortler, Hoppe, "Texture Mapping Progressive Meshes",
 * SIGGRAPH 2001 (stretch); Smith and Schaefer, "Bijective Parameterization with Free Boundaries",
 * SIGGRAPH 2015 (symmetric Dirichlet energy); Ju et al., "Quantitative evaluation of three cortical
 * surface flattening methods", NeuroImage 28, 2005 (errors of geodesic lengths); Fischl, Sereno, Dale,
 * "Cortical surface-based analysis II", NeuroImage 9, 1999 (lengths within rings).
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
   * Whether areas are compared with the areas that the flattening was asked for. If on, and if the input
   * has the point array `TargetArea` of vtkOMTAreaPreservingFilter, the target of a face is its surface
   * area times the mean of TargetArea / (one third of the incident surface areas) over its corners. For
   * a flattening without weights that is the surface area itself; for one with weights, all measures
   * then tell how far the result is from the request. If off, areas are compared with those of the
   * surface. Default: on.
   */
  vtkSetMacro(UseTargetArea, bool);
  vtkGetMacro(UseTargetArea, bool);
  vtkBooleanMacro(UseTargetArea, bool);
  ///@}

  ///@{
  /**
   * Whether the table has a row for each region of the input array to process 0. Without a chosen array
   * there is only the row `Total`. Default: on.
   */
  vtkSetMacro(UseRegionArray, bool);
  vtkGetMacro(UseRegionArray, bool);
  vtkBooleanMacro(UseRegionArray, bool);
  ///@}

  ///@{
  /**
   * Name of a string array in the field data of the input whose tuple i is the name of the region with
   * label i, for the table. Regions without a name are called by their label; a missing array is not an
   * error. Default: "RegionNames".
   */
  vtkSetStringMacro(RegionNamesArray);
  vtkGetStringMacro(RegionNamesArray);
  ///@}

  ///@{
  /**
   * Whether the errors of lengths are measured. Lengths on the surface are those of the exact shortest
   * paths over its triangles, between source points and others. Lengths are always compared with those
   * of the surface, whatever UseTargetArea says. Local and global lengths are those of the surface
   * before a seam cut it: edges of the boundary that lie on each other in opposite directions are joined
   * again. So local errors tell how wrong a straight line on the map can be, and those within the map
   * leave out what a seam separates. Half a brain with 66,000 points takes about ten seconds on two
   * cores. Default: off.
   */
  vtkSetMacro(MeasureLengths, bool);
  vtkGetMacro(MeasureLengths, bool);
  vtkBooleanMacro(MeasureLengths, bool);
  ///@}

  ///@{
  /**
   * Greatest length on the surface that is local, if MeasureLengths is on (input units). Finite and
   * greater than 0, otherwise an error. Default: 30, for surfaces in mm.
   */
  vtkSetMacro(LengthRadius, double);
  vtkGetMacro(LengthRadius, double);
  ///@}

  ///@{
  /**
   * Number of source points, if MeasureLengths is on. They are points of the surface, drawn by area from
   * a fixed seed; the same input gives the same points. Local lengths take all of them where
   * LengthRadius reaches over less than a sixteenth of the surface, fewer where it reaches farther, and
   * a sixteenth of them where it reaches over all of it. Global lengths take a twentieth of them. Four
   * times as many halve the standard errors and take four times as long. More than there are points
   * count as many as those. Range [2, inf), otherwise an error; one, too, if the lengths between them
   * and the points within LengthRadius need more memory than there is. Default: 300.
   */
  vtkSetMacro(LengthSamples, int);
  vtkGetMacro(LengthSamples, int);
  ///@}

  /**
   * The table of output port 1. The input array to process 0, set by SetInputArrayToProcess(0, 0, 0,
   * association, name), is an optional array of labels (one component, whole numbers) per cell or per
   * point. If it is not set, empty or "None", the table has only the row `Total`. With labels per point,
   * a face belongs to the label of most of its corners, or of its first corner if all three differ.
   */
  vtkTable* GetSummary();

protected:
  vtkDistortionMetrics();
  ~vtkDistortionMetrics() override;

  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  bool UseTargetArea = true;
  bool UseRegionArray = true;
  bool MeasureLengths = false;
  double LengthRadius = 30.0;
  int LengthSamples = 300;
  char* RegionNamesArray = nullptr;

private:
  vtkDistortionMetrics(const vtkDistortionMetrics&) = delete;
  void operator=(const vtkDistortionMetrics&) = delete;
};

#endif
