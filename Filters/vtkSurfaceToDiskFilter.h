// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceToDiskFilter
 * @brief   makes one clean oriented disk of triangles out of any surface
 *
 * The input is any polydata with polygons or triangle strips; vertices and lines are dropped. In this
 * order, the filter
 * - triangulates,
 * - merges coincident points, drops degenerate and duplicate faces without leaving cracks, and where
 *   more than two faces share an edge, or fans of faces only a vertex, cuts the surface into its sheets,
 * - keeps one component (ComponentMode), turns its faces to the same side, a closed one outward,
 * - flattens spikes, pits and fins of one voxel (FlattenFolds),
 * - keeps one side of a plane, if CutMode is PLANE,
 * - keeps one boundary (BoundaryMode) and fills all others with patches of the density around them; a
 *   boundary shorter than that of the hole below is filled too, and the surface opened there,
 * - removes handles and tunnels, or cuts them open without changing the surface (HandleMode),
 * - on request replaces the triangles by nearly equilateral ones (Remesh),
 * - opens the surface, if it is closed, by a small geodesic hole or along a seam (CutMode), with a
 *   boundary of at least MinimumBoundaryVertices vertices: the mesh is refined there, as a boundary of
 *   six edges cannot be that of a disk. A tube with two open ends is cut from end to end (CutMode SEAM).
 *
 * The output is a single component of genus 0 with one boundary loop, points in double precision, no
 * unused point. It keeps all point and cell arrays. Where new points are needed, arrays of floating
 * point numbers are interpolated linearly, all others (labels, strings) take the value of the nearest
 * point; cell arrays follow the input cell that a face is part of or, after remeshing, lies nearest to,
 * and hold 0 on filled holes and caps. Active normals are turned over where they point to the back of
 * the oriented surface. Global ids are not kept. Added arrays:
 * - point `vtkOriginalPointIds` (vtkIdType): the input point that this one is, of merged points the one
 *   with the smallest id; -1 for new points, which after remeshing are nearly all. On a seam two points
 *   or more have the same id
 * - point `Seam` (unsigned char): 1 where the surface was cut open along a seam, else 0
 * - cell `vtkOriginalCellIds` (vtkIdType): the input cell; -1 on filled holes and caps
 * - cell `Filled` (unsigned char): 1 on filled holes and on the caps of removed handles, else 0
 *
 * Field data says what was changed, one array each (one tuple unless said otherwise; lengths and areas
 * in units of the input, angles in degrees):
 * - `DroppedCells` (vertices and lines), `MergedPoints`, `UnusedPoints` (of no face), `DroppedFaces` =
 *   `DroppedDegenerateFaces` + `DroppedDuplicateFaces`, `ClosedCracks` (open edges split at points that
 *   lie on them), `SplitPoints` (copies made where the surface was not manifold),
 * - `Components`, `DroppedComponents`, `DroppedComponentArea`, `ReorientedFaces`,
 * - `RemovedSpikes` (and pits: single points), `RemovedFins` (several points), `FoldAreaChange` (what
 *   flattening them changed the area by), `LeftFolded` (places that it would not have helped),
 * - `FilledHoles`, `FilledArea`,
 * - `Genus` (of the component), `RemovedHandles`, `HandleLoopLengths` (as many tuples),
 * `HandleAreaRemoved`, `HandleAreaAdded`, `HandleDisplacement` (how far a kept point was moved at most),
 * - `RemeshEdgeLength` (0: not remeshed),
 * - `HoleCentre` (3 components), `HoleRadius` (geodesic; 0: no hole was cut), `SeamLength` (0: no seam),
 *   `RemovedArea` (of the hole, or beyond the plane), `RemovedRegionPoints` (of the region of interest,
 *   where the surface has no other place for the hole), `SeamRegionPoints` (of the region of interest,
 *   where the cut of handles or of a tube runs through it),
 * - what came of it: `BoundaryVertices`, `BoundaryLength`, `SurfaceArea`, `SmallestAngle`,
 *   `SelfIntersectionsBefore` and `SelfIntersections` (pairs of faces of the repaired component and of
 * the disk that intersect).
 *
 * Empty input gives empty output. Errors, each with an empty output: no polygons or strips, coordinates
 * that are not finite, zero area, a one-sided surface, parameters that make no sense or name what is
 * not there (a point off the surface, a component that does not exist, a plane that misses), a boundary
 * too long to be filled unasked, handles if HandleMode is ERROR.
 *
 * Sources: Gueziec, Taubin, Lazarus, Horn, "Cutting and Stitching: Converting Sets of Polygons to
 * Manifold Surfaces", TVCG 2001; Liepa, "Filling Holes in Meshes", SGP 2003; Botsch and Kobbelt, "A
 * Remeshing Approach to Multiresolution Modeling", SGP 2004; Crane, Weischedel, Wardetzky, "Geodesics in
 * Heat", TOG 2013; Rivara, "Algorithms for Refining Triangular Grids", IJNME 1984; Eppstein, "Dynamic
 * Generators of Topologically Embedded Graphs", SODA 2003 (tree-cotree); Xin and Wang, "Improving Chen
 * and Han's Algorithm on the Discrete Geodesic Problem", TOG 2009. All but the last but one as
 * implemented in CGAL.
 *
 * @sa vtkConformalDiskFilter vtkOMTAreaPreservingFilter
 */
#ifndef vtkSurfaceToDiskFilter_h
#define vtkSurfaceToDiskFilter_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include "vtkBlockwisePolyDataAlgorithm.h"

#include <array>
#include <vector>

namespace flattening
{
struct SurfaceToDiskOptions;
}

class SURFACEFLATTENINGFILTERS_EXPORT vtkSurfaceToDiskFilter : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkSurfaceToDiskFilter* New();
  vtkTypeMacro(vtkSurfaceToDiskFilter, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Points closer to each other than this become one. In units of the input; 0 merges points that
   * coincide exactly. A little more, such as a tenth of the edge length, removes the thinnest slivers of
   * an isosurface. Default: 0. Error if negative or not finite.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  enum ComponentModes
  {
    LARGEST = 0,
    CLOSEST_TO_POINT = 1,
    BY_INDEX = 2
  };

  ///@{
  /**
   * Which connected component is kept: the one with the largest area, the one closest to ComponentPoint,
   * or the one with the number ComponentIndex. Default: LARGEST.
   */
  vtkSetClampMacro(ComponentMode, int, LARGEST, BY_INDEX);
  vtkGetMacro(ComponentMode, int);
  void SetComponentModeToLargest() { this->SetComponentMode(LARGEST); }
  void SetComponentModeToClosestToPoint() { this->SetComponentMode(CLOSEST_TO_POINT); }
  void SetComponentModeToByIndex() { this->SetComponentMode(BY_INDEX); }
  ///@}

  ///@{
  /**
   * The point that chooses the component if ComponentMode is CLOSEST_TO_POINT. In units of the input.
   * Default: (0, 0, 0).
   */
  vtkSetVector3Macro(ComponentPoint, double);
  vtkGetVector3Macro(ComponentPoint, double);
  ///@}

  ///@{
  /**
   * The number of the component if ComponentMode is BY_INDEX; components are numbered from 0 in order of
   * decreasing area. Default: 0. Error if there are not as many.
   */
  vtkSetMacro(ComponentIndex, int);
  vtkGetMacro(ComponentIndex, int);
  ///@}

  enum BoundaryModes
  {
    LONGEST_BOUNDARY = 0,
    BOUNDARY_CLOSEST_TO_POINT = 1,
    FILL_ALL_BOUNDARIES = 2
  };

  ///@{
  /**
   * Which boundary loop becomes that of the disk, while all others are filled: the longest, the one
   * closest to BoundaryPoint, or none, so that the surface is closed and then opened as CutMode says.
   * Default: LONGEST_BOUNDARY.
   */
  vtkSetClampMacro(BoundaryMode, int, LONGEST_BOUNDARY, FILL_ALL_BOUNDARIES);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToLongest() { this->SetBoundaryMode(LONGEST_BOUNDARY); }
  void SetBoundaryModeToClosestToPoint() { this->SetBoundaryMode(BOUNDARY_CLOSEST_TO_POINT); }
  void SetBoundaryModeToFillAll() { this->SetBoundaryMode(FILL_ALL_BOUNDARIES); }
  ///@}

  ///@{
  /**
   * The point that chooses the boundary if BoundaryMode is BOUNDARY_CLOSEST_TO_POINT. In units of the
   * input. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(BoundaryPoint, double);
  vtkGetVector3Macro(BoundaryPoint, double);
  ///@}

  ///@{
  /**
   * A boundary loop longer than this is not filled but an error: the patch would be an invention. In
   * units of the input; 0 takes the circumference of a circle of 5 % of the surface's area. Default: 0.
   * Error if negative or not finite.
   */
  vtkSetMacro(FillLengthLimit, double);
  vtkGetMacro(FillLengthLimit, double);
  ///@}

  ///@{
  /**
   * Whether spikes, pits and fins as thin as one voxel, which noise leaves on an isosurface, are
   * flattened into the surface around them: such a fold has nearly no base to put its area on in a flat
   * map. At most 20 neighbouring points are moved together; larger sheets stay. See the figures
   * RemovedSpikes, RemovedFins, FoldAreaChange and LeftFolded. Default: on. Nothing is changed if
   * HandleMode is CUT_HANDLES.
   */
  vtkSetMacro(FlattenFolds, bool);
  vtkGetMacro(FlattenFolds, bool);
  vtkBooleanMacro(FlattenFolds, bool);
  ///@}

  enum HandleModes
  {
    REMOVE_HANDLES = 0,
    CUT_HANDLES = 1,
    HANDLES_ARE_ERRORS = 2
  };

  ///@{
  /**
   * What is done about handles and tunnels (genus > 0).
   * - REMOVE_HANDLES: each is cut along the shortest loop, around the handle or around the tunnel, and
   *   the two openings are capped. For topological noise, whose loops are short. Where a cap would pass
   *   through another part of the surface, a longer loop is taken, or the surface is smoothed there.
   * - CUT_HANDLES: the surface is cut open along a short graph of its edges and stays as it is; all of
   *   its area is kept. A closed surface is open then, and is not opened at a hole or seam besides,
   *   unless points are chosen for it: the hole of HolePoint (UseHolePoint) or the seam of SeamPoints
   *   (UseSeamPoints) is cut first. The graph does not keep off a region of interest: a warning if it
   * meets it.
   * - HANDLES_ARE_ERRORS: an error that names their number.
   * Default: REMOVE_HANDLES.
   */
  vtkSetClampMacro(HandleMode, int, REMOVE_HANDLES, HANDLES_ARE_ERRORS);
  vtkGetMacro(HandleMode, int);
  void SetHandleModeToRemove() { this->SetHandleMode(REMOVE_HANDLES); }
  void SetHandleModeToCut() { this->SetHandleMode(CUT_HANDLES); }
  void SetHandleModeToError() { this->SetHandleMode(HANDLES_ARE_ERRORS); }
  ///@}

  enum CutModes
  {
    HOLE = 0,
    SEAM = 1,
    PLANE = 2
  };

  ///@{
  /**
   * How the surface is cut.
   * - HOLE: a surface without boundary loses a geodesic disk around a point (HolePoint,
   *   HoleAreaFraction).
   * - SEAM: the surface is cut along a geodesic path (UseSeamPoints, SeamPoints) and loses nothing. If
   *   it has a boundary the path must start there. Without SeamPoints, a tube with two open ends is cut
   *   from end to end along a shortest path, ready for the rectangle of vtkConformalDiskFilter: its ends
   *   are the longest boundary and the next one, if that is at least a quarter as long. Not if
   *   BoundaryMode is FILL_ALL_BOUNDARIES, or HandleMode CUT_HANDLES and there are handles. The seam of
   * a tube does not keep off a region of interest: a warning if it meets it.
   * - PLANE: what lies on the side of PlaneOrigin to which PlaneNormal points is kept, of several parts
   *   one as ComponentMode says (BY_INDEX: the largest).
   * Default: HOLE.
   */
  vtkSetClampMacro(CutMode, int, HOLE, PLANE);
  vtkGetMacro(CutMode, int);
  void SetCutModeToHole() { this->SetCutMode(HOLE); }
  void SetCutModeToSeam() { this->SetCutMode(SEAM); }
  void SetCutModeToPlane() { this->SetCutMode(PLANE); }
  ///@}

  ///@{
  /**
   * Whether HolePoint says where a closed surface is opened. If off, the hole is placed where the rest
   * of the surface is nearest on average, along the surface: neither on a tip nor deep in a fold, which
   * keeps the distortion of the flattening low. Default: off.
   */
  vtkSetMacro(UseHolePoint, bool);
  vtkGetMacro(UseHolePoint, bool);
  vtkBooleanMacro(UseHolePoint, bool);
  ///@}

  ///@{
  /**
   * The point of the surface closest to this one becomes the centre of the hole, if UseHolePoint is on.
   * In units of the input. Default: (0, 0, 0). Error if it is farther from the surface than 5 % of the
   * diagonal of its bounding box.
   */
  vtkSetVector3Macro(HolePoint, double);
  vtkGetVector3Macro(HolePoint, double);
  ///@}

  ///@{
  /**
   * Area of the hole that is cut into a closed surface, as share of the surface's area. A smaller hole
   * loses less of the surface, but stretches the conformal map more. Default: 0.001; range: 1e-6 to 0.5.
   */
  vtkSetClampMacro(HoleAreaFraction, double, 1e-6, 0.5);
  vtkGetMacro(HoleAreaFraction, double);
  ///@}

  ///@{
  /**
   * Whether the hole or seam is kept away from a region of interest: points where the array set by
   * SetInputArrayToProcess(0, ...) is not 0, or corners of cells where it is not 0. Default: off. It
   * concerns automatic placement only. Error if the array is missing, of another length or leaves no
   * room for a seam; a warning if the hole takes some of it.
   */
  vtkSetMacro(UseRegionOfInterest, bool);
  vtkGetMacro(UseRegionOfInterest, bool);
  vtkBooleanMacro(UseRegionOfInterest, bool);
  ///@}

  ///@{
  /**
   * Whether SeamPoints say where the seam runs, if CutMode is SEAM. If off, the seam of a closed surface
   * runs between two ends of it that are far from each other, which flattens best, that of a tube from
   * end to end, and any other open surface stays as it is. Default: off.
   */
  vtkSetMacro(UseSeamPoints, bool);
  vtkGetMacro(UseSeamPoints, bool);
  vtkBooleanMacro(UseSeamPoints, bool);
  ///@}

  ///@{
  /**
   * How many points the seam goes through, if UseSeamPoints is on. Default: 0. Error if there are fewer
   * than two.
   */
  void SetNumberOfSeamPoints(int number);
  int GetNumberOfSeamPoints();
  ///@}

  ///@{
  /**
   * A point that the seam goes through, in their order: the point of the surface closest to this one. In
   * units of the input. Error if it is off the surface as for HolePoint.
   */
  void SetSeamPoint(int index, double x, double y, double z);
  void SetSeamPoint(int index, const double point[3]);
  void GetSeamPoint(int index, double point[3]);
  void AddSeamPoint(double x, double y, double z);
  void RemoveAllSeamPoints();
  ///@}

  ///@{
  /**
   * A point of the plane. In units of the input. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(PlaneOrigin, double);
  vtkGetVector3Macro(PlaneOrigin, double);
  ///@}

  ///@{
  /**
   * Points to the side of the plane that is kept; any length but 0. Default: (1, 0, 0).
   */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /**
   * A boundary that the filter cuts gets at least this many vertices: edges there are split where
   * needed. One that the input has gets 8, or this many if these are fewer, as a polygon of three covers
   * less than half of the disk. Default: 128; range: 3 and above.
   */
  vtkSetClampMacro(MinimumBoundaryVertices, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumBoundaryVertices, int);
  ///@}

  ///@{
  /**
   * Without Remesh, faces with a smaller angle are changed by moving, joining and flipping what is
   * around them, as slivers cannot be flattened well. In degrees; 0 leaves all faces as they are.
   * Default: 1; range: 0 to 15. Nothing is changed if HandleMode is CUT_HANDLES.
   */
  vtkSetClampMacro(SmallestAngle, double, 0.0, 15.0);
  vtkGetMacro(SmallestAngle, double);
  ///@}

  ///@{
  /**
   * Whether the triangles are replaced by nearly equilateral ones. The boundary is resampled alike.
   * vtkFlatMapTransfer carries the flattening back to the points of the input. Default: off.
   */
  vtkSetMacro(Remesh, bool);
  vtkGetMacro(Remesh, bool);
  vtkBooleanMacro(Remesh, bool);
  ///@}

  ///@{
  /**
   * Edge length for Remesh, in units of the input; 0 takes RelativeEdgeLength instead. Default: 0. Error
   * if negative, not finite, or so large that fewer than 20 faces would be left.
   */
  vtkSetMacro(TargetEdgeLength, double);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Edge length for Remesh in units of the mean edge length of the surface, if TargetEdgeLength is 0.
   * Default: 0.9, which leaves an isosurface about as many points as it had. Error if not positive and
   * finite.
   */
  vtkSetMacro(RelativeEdgeLength, double);
  vtkGetMacro(RelativeEdgeLength, double);
  ///@}

  ///@{
  /**
   * Whether the pairs of faces that intersect each other are counted, before and after; takes about as
   * long as all the rest without remeshing. Default: on.
   */
  vtkSetMacro(CountSelfIntersections, bool);
  vtkGetMacro(CountSelfIntersections, bool);
  vtkBooleanMacro(CountSelfIntersections, bool);
  ///@}

protected:
  vtkSurfaceToDiskFilter() = default;
  ~vtkSurfaceToDiskFilter() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double MergeTolerance = 0.0;
  int ComponentMode = LARGEST;
  double ComponentPoint[3] = { 0.0, 0.0, 0.0 };
  int ComponentIndex = 0;
  int BoundaryMode = LONGEST_BOUNDARY;
  double BoundaryPoint[3] = { 0.0, 0.0, 0.0 };
  double FillLengthLimit = 0.0;
  bool FlattenFolds = true;
  int HandleMode = REMOVE_HANDLES;
  int CutMode = HOLE;
  bool UseHolePoint = false;
  double HolePoint[3] = { 0.0, 0.0, 0.0 };
  double HoleAreaFraction = 1e-3;
  bool UseRegionOfInterest = false;
  bool UseSeamPoints = false;
  std::vector<std::array<double, 3>> SeamPoints;
  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 1.0, 0.0, 0.0 };
  int MinimumBoundaryVertices = 128;
  double SmallestAngle = 1.0;
  bool Remesh = false;
  double TargetEdgeLength = 0.0;
  double RelativeEdgeLength = 0.9;
  bool CountSelfIntersections = true;

private:
  flattening::SurfaceToDiskOptions GetOptions(vtkPolyData* input);

  vtkSurfaceToDiskFilter(const vtkSurfaceToDiskFilter&) = delete;
  void operator=(const vtkSurfaceToDiskFilter&) = delete;
};

#endif
