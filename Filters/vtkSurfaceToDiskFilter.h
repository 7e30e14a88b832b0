// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceToDiskFilter
 * @brief   turns any surface into one clean oriented disk of triangles
 *
 * The input is polydata with polygons or triangle strips; vertices and lines are dropped. The filter
 * takes these steps in order:
 * - It triangulates the polygons and strips.
 * - It merges coincident points and drops degenerate and duplicate faces without opening T-junctions.
 *   Where more than two faces share an edge, or fans of faces share only a vertex, it cuts the surface
 *   into its sheets.
 * - It keeps one component (ComponentMode) and orients its faces consistently, those of a closed
 *   surface outward.
 * - It flattens spikes, pits and fins of one voxel (FlattenFolds).
 * - It keeps one side of a plane, if CutMode is PLANE.
 * - It keeps one boundary (BoundaryMode) and fills all others with patches of the density around them.
 *   A boundary shorter than that of the hole below is filled, too, and the surface opened there.
 * - It removes handles and tunnels, or cuts them open without changing the surface (HandleMode).
 * - On request it replaces the triangles by nearly equilateral ones (Remesh).
 * - It opens a closed surface by a small geodesic hole or along a seam (CutMode). The new boundary gets
 *   at least MinimumBoundaryVertices vertices: the mesh is refined there, as a boundary of six edges
 *   cannot become that of a disk. A tube with two open ends is cut from end to end (CutMode SEAM).
 *
 * The output is a single component of genus 0 with one boundary loop, points in double precision and no
 * unused point. It keeps all point and cell arrays but the global ids. At new points, arrays of
 * floating point numbers are interpolated linearly, and all others (labels, strings) take the value of
 * the nearest point. Cell arrays take the value of the input cell that a face is part of or, after
 * remeshing, lies nearest to, and 0 on filled holes and caps. Active normals are reversed where they
 * point to the back of the oriented surface.
 *
 * Output arrays:
 * - point `vtkOriginalPointIds` (vtkIdType): id of the same point in the input, the smallest one of
 *   merged points; -1 for new points, which after remeshing are nearly all. The points on both sides of
 *   a seam have the same id.
 * - point `Seam` (unsigned char): 1 where the surface was cut open along a seam, 0 elsewhere.
 * - cell `vtkOriginalCellIds` (vtkIdType): id of the input cell; -1 on filled holes and caps.
 * - cell `Filled` (unsigned char): 1 on filled holes and on the caps of removed handles, 0 elsewhere.
 *
 * Field data (one tuple each unless stated otherwise):
 * - `DroppedCells` (vtkIdType): number of vertices and lines of the input.
 * - `MergedPoints` (vtkIdType): number of points that were merged into another.
 * - `UnusedPoints` (vtkIdType): number of points without a face.
 * - `DroppedFaces` (vtkIdType): sum of the next two.
 * - `DroppedDegenerateFaces` (vtkIdType): number of faces without area that were dropped.
 * - `DroppedDuplicateFaces` (vtkIdType): number of repeated faces that were dropped.
 * - `ClosedCracks` (vtkIdType): number of boundary edges that were split at points that lie on them
 *   (T-junctions).
 * - `SplitPoints` (vtkIdType): number of copies of points made where the surface was not a manifold.
 * - `Components` (vtkIdType): number of connected components.
 * - `DroppedComponents` (vtkIdType): number of components that were dropped.
 * - `DroppedComponentArea` (double, input units squared): area of the dropped components.
 * - `ReorientedFaces` (vtkIdType): number of faces whose orientation was reversed.
 * - `RemovedSpikes` (vtkIdType): number of spikes and pits, single points, that were flattened.
 * - `RemovedFins` (vtkIdType): number of fins, several points each, that were flattened.
 * - `LeftFolded` (vtkIdType): number of folds that flattening would not have improved.
 * - `FoldAreaChange` (double, input units squared): change of the area by flattening folds.
 * - `FilledHoles` (vtkIdType): number of filled boundary loops.
 * - `FilledArea` (double, input units squared): area of the patches that fill them.
 * - `Genus` (vtkIdType): genus of the component before handles are treated.
 * - `RemovedHandles` (vtkIdType): number of removed handles and tunnels.
 * - `HandleLoopLengths` (double, input units, one tuple per removed handle): length of the loop that
 *   was cut.
 * - `HandleAreaRemoved` (double, input units squared): area that removing handles took away.
 * - `HandleAreaAdded` (double, input units squared): area of the caps.
 * - `HandleDisplacement` (double, input units): greatest distance by which a kept point was moved.
 * - `RemeshEdgeLength` (double, input units): target edge length; 0 without remeshing.
 * - `HoleCentre` (double x 3, input units): centre of the hole that was cut.
 * - `HoleRadius` (double, input units): geodesic radius of that hole; 0 if none was cut.
 * - `SeamLength` (double, input units): length of the seam; 0 if there is none.
 * - `RemovedArea` (double, input units squared): area of the hole, or of the side of the plane that was
 *   cut off.
 * - `RemovedRegionPoints` (vtkIdType): number of points of the region of interest in the hole, where
 *   the surface has no other position for it.
 * - `SeamRegionPoints` (vtkIdType): number of points of the region of interest on the cut of handles or
 *   of a tube.
 * - `BoundaryVertices` (vtkIdType): number of boundary vertices of the disk.
 * - `BoundaryLength` (double, input units): length of the boundary of the disk.
 * - `SurfaceArea` (double, input units squared): area of the disk.
 * - `SmallestAngle` (double, degrees): smallest angle of a face of the disk.
 * - `SelfIntersectionsBefore` (vtkIdType): number of pairs of intersecting faces of the repaired
 *   component; see CountSelfIntersections.
 * - `SelfIntersections` (vtkIdType): number of pairs of intersecting faces of the disk; see
 *   CountSelfIntersections.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: no
 * polygons or strips; coordinates that are not finite; zero area; a one-sided surface; parameters out
 * of range or that name something that does not exist (a point off the surface, a component, a plane
 * that misses the surface); a boundary too long to be filled without being asked; handles if HandleMode
 * is HANDLES_ARE_ERRORS.
 *
 * Sources: Gueziec, Taubin, Lazarus, Horn, "Cutting and Stitching: Converting Sets of Polygons to
 * Manifold Surfaces", TVCG 2001; Liepa, "Filling Holes in Meshes", SGP 2003; Xin and Wang, "Improving
 * Chen and Han's Algorithm on the Discrete Geodesic Problem", TOG 2009 (these three as implemented in
 * CGAL); Botsch and Kobbelt, "A Remeshing Approach to Multiresolution Modeling", SGP 2004; Crane,
 * Weischedel, Wardetzky, "Geodesics in Heat", TOG 2013; Rivara, "Algorithms for Refining Triangular
 * Grids", IJNME 1984; Eppstein, "Dynamic Generators of Topologically Embedded Graphs", SODA 2003
 * (tree-cotree).
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
