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
 * - It keeps one side of a plane, or removes a labelled part, if CutMode is PLANE or LABEL.
 * - It keeps one boundary (BoundaryMode) and fills all others with patches of the density around them.
 *   A boundary shorter than that of the hole below is filled, too, and the surface opened anew; a hole
 *   is cut in the same place.
 * - It removes handles and tunnels, or cuts them open without changing the surface (HandleMode).
 * - On request it replaces the triangles by nearly equilateral ones (Remesh).
 * - It opens a closed surface along a tree of seams, along a seam or by a small geodesic hole (CutMode).
 *   The new boundary gets at least MinimumBoundaryVertices vertices: the mesh is refined there, as a
 *   boundary of six edges cannot become that of a disk. A tube with two open ends is cut from end to end
 *   (CutMode SEAM), and an open surface along a tree of seams from its boundary inwards (CutMode
 *   RELIEF).
 *
 * The second input is optional: polydata whose lines are the seams, if CutMode is SEAM or AUTOMATIC.
 *
 * The second output (GetCuts) is the boundary of the disk as lines on the surface, each seam once: a
 * polyline for each piece of the seams that begins and ends where seams end, branch or meet the boundary
 * of the surface before it was cut, then the rest of the boundary, and the edges around filled holes and
 * caps. It has the point arrays of the
 * disk, and can be the second input of another filter, which leaves the rest of the boundary out.
 *
 * The third output (GetReport) is a vtkTable of what was changed, for readers: a row for each change, in
 * the order of the steps. The field data have the same numbers and more, for programs.
 *
 * A disk whose triangles all have an area keeps its points apart, so that the banks of its seams are not
 * merged; so do the points whose array `Seam` is not 0 on any surface. A disk with that array, which an
 * earlier filter of this class made, passes unchanged unless a cut, a point or remeshing is asked for.
 *
 * The output is a single component of genus 0 with one boundary loop, points in double precision and no
 * unused point. It keeps all point and cell arrays but the global ids. At new points, arrays of
 * floating point numbers are interpolated linearly, and all others (labels, strings) take the value of
 * the nearest point. Cell arrays take the value of the input cell that a face is part of or, after
 * remeshing, lies nearest to, and 0 on filled holes and caps. Active normals are reversed where they
 * point to the back of the oriented surface.
 *
 * Output arrays of port 0:
 * - point `vtkOriginalPointIds` (vtkIdType): id of the same point in the input, the smallest one of
 *   merged points; -1 for new points, which after remeshing are nearly all. The points on both sides of
 *   a seam have the same id. A point that FlattenFolds or HandleMode moved keeps its id; one that
 *   another step moved is a new point.
 * - point `Seam` (unsigned char): 1 where the surface was cut open along a seam, 0 elsewhere.
 * - point `SeamId` (int): number of the piece of the seams, from 1, the same on both of its banks; the
 *   smallest one where several pieces meet; 0 elsewhere.
 * - point `SeamDistance` (double, input units): distance along the seams from their start, the same on
 *   both banks; 0 elsewhere. Seams start at the boundary of the surface before it was cut or, if they do
 *   not meet it, at one of their ends: at the one nearest to the first of SeamPoints if there are such.
 * - point `ScaledCurvature` (double, dimensionless; only with ScaledCurvature): mean curvature, averaged
 *   over some 0.5 % of the square root of the area and scaled so that nine tenths of the area are from
 * -1 to 1: positive on ridges, negative in furrows. The active scalars unless those of the input vary.
 * - cell `vtkOriginalCellIds` (vtkIdType): id of the input cell; -1 on filled holes and caps.
 * - cell `Filled` (unsigned char): 1 on filled holes and on the caps of removed handles, 0 elsewhere.
 *
 * Output arrays of port 1:
 * - cell `SeamId` (int): number of the piece, from 1, in the order in which the boundary of the disk
 * meets them after the start; 0 on the rest of the boundary; -1 on the outlines of filled holes and
 * caps, which are no part of the boundary.
 * - cell `Length` (double, input units): length of the line.
 *
 * Output arrays of port 2:
 * - row `Amount` (double): number, or length or area in input units.
 * - row `Change` (string): what was changed, or what the amount is.
 * - row `Setting` (string): label in ParaView of the parameter that decides it; empty if none does.
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
 * - `RemeshAreaChange` (double, input units squared): area after remeshing less that before. New
 *   triangles span folds and corners that are sharper than their edges are long.
 * - `HoleCentre` (double x 3, input units): centre of the hole that was cut.
 * - `HoleRadius` (double, input units): geodesic radius of that hole; 0 if none was cut.
 * - `SeamLength` (double, input units): length of all seams, those of a relief and of handles included;
 *   0 if there is none.
 * - `ChosenCut` (vtkIdType): the way in which the surface was opened or cut, as a value of CutMode; -1
 *   if its own boundary, or the cut of its handles alone, is that of the disk.
 * - `ReasonOfCut` (string): why it was opened so.
 * - `ReliefBranches` (vtkIdType): number of branches of the relief; 0 if there is none.
 * - `ReliefLength` (double, input units): length of these branches.
 * - `ReliefStrain` (double x 2, without unit): strain before and after the relief was cut: the standard
 *   deviation over the area of the conformal factor of the map with a free outline. A map with exact
 *   areas stretches by about e to this power one way, and as much less the other way. On brains 0.03 is
 *   about one degree of mean angle error. 0 if CutMode is another.
 * - `RemovedArea` (double, input units squared): area of the hole, of the side of the plane that was cut
 *   off, or of the label.
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
 * polygons or strips; coordinates that are not finite; an extent below 1e-290 or above 4e307 units; a
 * distance from the origin at which double precision cannot hold points between those of the surface
 * (some 1e8 times its size); zero area; a one-sided surface; parameters out
 * of range or that name something that does not exist (a point off the surface, a component, a plane
 * that misses the surface); seams that cross, close a loop or do not meet; a label that is nowhere, in
 * several pieces or the whole surface; a boundary too long to be filled without being asked; handles if
 * HandleMode is HANDLES_ARE_ERRORS. Other sizes and places do not change the result.
 *
 * A warning is given if handles are removed whose longest loop could surround 0.01 % of the area, if
 * components are dropped with more than 0.1 % of it, and if a hole that is cut is smaller than 50
 * triangles, as a flat map cannot keep the areas around it.
 *
 * Sources: Gueziec, Taubin, Lazarus, Horn, "Cutting and Stitching: Converting Sets of Polygons to
 * Manifold Surfaces", TVCG 2001; Liepa, "Filling Holes in Meshes", SGP 2003; Xin and Wang, "Improving
 * Chen and Han's Algorithm on the Discrete Geodesic Problem", TOG 2009 (these three as implemented in
 * CGAL); Botsch and Kobbelt, "A Remeshing Approach to Multiresolution Modeling", SGP 2004; Crane,
 * Weischedel, Wardetzky, "Geodesics in Heat", TOG 2013; Rivara, "Algorithms for Refining Triangular
 * Grids", IJNME 1984; Eppstein, "Dynamic Generators of Topologically Embedded Graphs", SODA 2003
 * (tree-cotree); Sawhney and Crane, "Boundary First Flattening", TOG 2017; Li et al., "OptCuts: Joint
 * Optimization of Surface Cuts and Parameterization", TOG 2018; Chai et al., "Surface Cutting by
 * Voting", 2019 (the relief).
 *
 * @sa vtkConformalDiskFilter vtkOMTAreaPreservingFilter
 */
#ifndef vtkSurfaceToDiskFilter_h
#define vtkSurfaceToDiskFilter_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include "vtkBlockwisePolyDataAlgorithm.h"

#include <array>
#include <vector>

class vtkTable;

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
   * Distance below which points are merged (input units). 0 merges points that coincide exactly. A
   * little more, such as a tenth of the edge length, removes the thinnest slivers of an isosurface.
   * Range [0, inf), otherwise an error. Default: 0.
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
   * Connected component that is kept: the one with the largest area (LARGEST, 0), the one closest to
   * ComponentPoint (CLOSEST_TO_POINT, 1), or the one with the number ComponentIndex (BY_INDEX, 2).
   * Default: LARGEST.
   */
  vtkSetClampMacro(ComponentMode, int, LARGEST, BY_INDEX);
  vtkGetMacro(ComponentMode, int);
  void SetComponentModeToLargest() { this->SetComponentMode(LARGEST); }
  void SetComponentModeToClosestToPoint() { this->SetComponentMode(CLOSEST_TO_POINT); }
  void SetComponentModeToByIndex() { this->SetComponentMode(BY_INDEX); }
  ///@}

  ///@{
  /**
   * Point that chooses the component if ComponentMode is CLOSEST_TO_POINT (input units). Default: (0, 0,
   * 0).
   */
  vtkSetVector3Macro(ComponentPoint, double);
  vtkGetVector3Macro(ComponentPoint, double);
  ///@}

  ///@{
  /**
   * Number of the component if ComponentMode is BY_INDEX; components are numbered from 0 in order of
   * decreasing area. An error if there is no such component. Default: 0.
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
   * Boundary loop that becomes that of the disk, while all others are filled: the longest
   * (LONGEST_BOUNDARY, 0), the one closest to BoundaryPoint (BOUNDARY_CLOSEST_TO_POINT, 1), or none
   * (FILL_ALL_BOUNDARIES, 2), so that the surface is closed and then opened by CutMode. Default:
   * LONGEST_BOUNDARY.
   */
  vtkSetClampMacro(BoundaryMode, int, LONGEST_BOUNDARY, FILL_ALL_BOUNDARIES);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToLongest() { this->SetBoundaryMode(LONGEST_BOUNDARY); }
  void SetBoundaryModeToClosestToPoint() { this->SetBoundaryMode(BOUNDARY_CLOSEST_TO_POINT); }
  void SetBoundaryModeToFillAll() { this->SetBoundaryMode(FILL_ALL_BOUNDARIES); }
  ///@}

  ///@{
  /**
   * Point that chooses the boundary if BoundaryMode is BOUNDARY_CLOSEST_TO_POINT (input units). Default:
   * (0, 0, 0).
   */
  vtkSetVector3Macro(BoundaryPoint, double);
  vtkGetVector3Macro(BoundaryPoint, double);
  ///@}

  ///@{
  /**
   * Greatest length of a boundary loop that is filled (input units); a longer one is an error, as its
   * patch would be an invention. 0 takes the circumference of a circle of 5 % of the area of the
   * surface. Range [0, inf), otherwise an error. Default: 0.
   */
  vtkSetMacro(FillLengthLimit, double);
  vtkGetMacro(FillLengthLimit, double);
  ///@}

  ///@{
  /**
   * Whether spikes, pits and fins as thin as one voxel, which noise leaves on an isosurface, are
   * flattened into the surface around them, as a flat map has nearly no room for the area of such a
   * fold. At most 20 neighbouring points are moved together; larger sheets stay. The field data
   * RemovedSpikes, RemovedFins, FoldAreaChange and LeftFolded report the changes. Ignored if HandleMode
   * is CUT_HANDLES. Default: on.
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
   * Treatment of handles and tunnels (genus > 0).
   * - REMOVE_HANDLES (0): each handle is cut along a shortest loop, around the handle or around its
   *   tunnel, and the two openings are capped. This suits topological noise, whose loops are short.
   * Where a cap would pass through another part of the surface, a longer loop is taken, or the surface
   * is smoothed there.
   * - CUT_HANDLES (1): the surface is cut open along a short graph of its edges and keeps its shape and
   *   area. A closed surface is then open and gets no hole or seam, unless points are chosen for one:
   * the hole of HolePoint (UseHolePoint) or the seam of SeamPoints (UseSeamPoints) is cut first. The
   * graph does not avoid a region of interest; a warning tells if it meets one.
   * - HANDLES_ARE_ERRORS (2): handles are an error, whose message tells their number.
   *
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
    PLANE = 2,
    RELIEF = 3,
    LABEL = 4,
    AUTOMATIC = 5
  };

  ///@{
  /**
   * Way to cut the surface.
   * - HOLE (0): a surface without boundary loses a geodesic disk around a point (HolePoint,
   *   HoleAreaFraction).
   * - SEAM (1): the surface is cut along a geodesic path (UseSeamPoints, SeamPoints) and keeps its area.
   *   If it has a boundary, the path must start there. Without SeamPoints, a tube with two open ends is
   *   cut from end to end along a shortest path, ready for the rectangle of vtkConformalDiskFilter. Its
   *   ends are the longest boundary and the next one, if that is at least a quarter as long. A tube is
   * not cut if BoundaryMode is FILL_ALL_BOUNDARIES, or if HandleMode is CUT_HANDLES and there are
   * handles. The seam of a tube does not avoid a region of interest; a warning tells if it meets one.
   * - PLANE (2): the part on the side of the plane to which PlaneNormal points is kept; of several
   * parts, ComponentMode chooses one (for BY_INDEX the largest).
   * - RELIEF (3): the surface is cut along a tree of geodesics and keeps its area. The tree grows from
   *   the boundary, or on a closed surface from a first branch, to the places where a conformal map
   *   would change the scale most, as far as its length lowers the strain by enough (ReliefGain,
   *   LongestRelief). This suits a flat map whose outline is free. Handles that are to be cut are cut
   *   first.
   * - LABEL (4): the part with a label (CutLabel) is removed, and its border becomes the boundary of the
   *   disk.
   * - AUTOMATIC (5): a seam if UseSeamPoints or SeamLines give its place, a hole if UseHolePoint does.
   *   Otherwise a closed surface gets the opening that mostly leaves the best map: with FreeOutline a
   *   relief as RELIEF cuts it; without, one that suits a disk, with a ReliefGain of 0.07 at least and a
   *   boundary no longer than 1.5 circumferences of a disk of the surface's area; or a hole where the
   *   region of interest leaves no room for a relief. An open surface keeps its boundary, and is cut
   *   along a relief from there if its strain (see ReliefStrain) is 0.7 or more, or 0.3 with
   * FreeOutline, unless BoundaryMode chooses the boundary by a point. ChosenCut and ReasonOfCut report
   * the choice.
   *
   * Default: AUTOMATIC. The paper cuts a hole.
   */
  vtkSetClampMacro(CutMode, int, HOLE, AUTOMATIC);
  vtkGetMacro(CutMode, int);
  void SetCutModeToHole() { this->SetCutMode(HOLE); }
  void SetCutModeToSeam() { this->SetCutMode(SEAM); }
  void SetCutModeToPlane() { this->SetCutMode(PLANE); }
  void SetCutModeToRelief() { this->SetCutMode(RELIEF); }
  void SetCutModeToLabel() { this->SetCutMode(LABEL); }
  void SetCutModeToAutomatic() { this->SetCutMode(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Whether HolePoint chooses where a closed surface is opened, if CutMode is HOLE or AUTOMATIC. If off
   * and CutMode is HOLE, the hole is placed where the mean distance along the surface to all other
   * points is smallest: neither on a tip nor deep in a fold, which keeps the distortion of the
   * flattening low. Default: off.
   */
  vtkSetMacro(UseHolePoint, bool);
  vtkGetMacro(UseHolePoint, bool);
  vtkBooleanMacro(UseHolePoint, bool);
  ///@}

  ///@{
  /**
   * Point whose closest point on the surface becomes the centre of the hole, if UseHolePoint is on
   * (input units). An error if it is farther from the surface than 5 % of the diagonal of its bounding
   * box. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(HolePoint, double);
  vtkGetVector3Macro(HolePoint, double);
  ///@}

  ///@{
  /**
   * Area of the hole that is cut into a closed surface, as a share of the area of the surface. A smaller
   * hole loses less of the surface, but stretches the conformal map more. Range [1e-6, 0.5]. Default:
   * 0.001.
   */
  vtkSetClampMacro(HoleAreaFraction, double, 1e-6, 0.5);
  vtkGetMacro(HoleAreaFraction, double);
  ///@}

  ///@{
  /**
   * Whether a hole, seam or relief that is placed automatically avoids a region of interest: the points
   * where the input array to process 0 (SetInputArrayToProcess) is not 0, or the corners of cells where
   * it is not 0. An error if the array is missing, has the wrong length or leaves no room for a seam or
   * a relief; a warning tells if the hole takes points of the region. Default: off.
   */
  vtkSetMacro(UseRegionOfInterest, bool);
  vtkGetMacro(UseRegionOfInterest, bool);
  vtkBooleanMacro(UseRegionOfInterest, bool);
  ///@}

  ///@{
  /**
   * Whether SeamPoints choose the seam, if CutMode is SEAM or AUTOMATIC. If off and CutMode is SEAM, the
   * seam of a closed surface joins two extremities that are far from each other, the seam of a tube
   * joins its ends, and any other open surface is not cut. Default: off.
   */
  vtkSetMacro(UseSeamPoints, bool);
  vtkGetMacro(UseSeamPoints, bool);
  vtkBooleanMacro(UseSeamPoints, bool);
  ///@}

  ///@{
  /**
   * Number of points that the seam goes through, if UseSeamPoints is on. Range [2, 100000]; less is an
   * error, more is 100000. Default: 0.
   */
  void SetNumberOfSeamPoints(int number);
  int GetNumberOfSeamPoints();
  ///@}

  ///@{
  /**
   * Points whose closest points on the surface the seam goes through, in order (input units). An error
   * if one is too far from the surface, as for HolePoint. Default: none.
   */
  void SetSeamPoint(int index, double x, double y, double z);
  void SetSeamPoint(int index, const double point[3]);
  void GetSeamPoint(int index, double point[3]);
  void AddSeamPoint(double x, double y, double z);
  void RemoveAllSeamPoints();
  ///@}

  ///@{
  /**
   * Number of further paths of the seam, if UseSeamPoints is on. Range [0, 100000]; other
   * numbers become the nearest of these. Default: 0.
   */
  void SetNumberOfSeamPathStarts(int number);
  int GetNumberOfSeamPathStarts();
  ///@}

  ///@{
  /**
   * Numbers of the seam points with which a further path begins, counted from 0, in ascending order. No
   * seam runs from the point before to such a point. A path may begin or end on one before it, so that
   * the seams form a tree; paths that cross, close a loop or do not meet are an error, and so is a path
   * of one point. Range of each [2, number of points - 2]. Default: none, all points are on one path.
   */
  void SetSeamPathStart(int index, int point);
  int GetSeamPathStart(int index);
  void AddSeamPathStart(int point);
  void RemoveAllSeamPathStarts();
  ///@}

  ///@{
  /**
   * Lines along which the surface is cut if CutMode is SEAM or AUTOMATIC, in place of SeamPoints (second
   * input; optional). The cut runs along geodesics between the points of the lines; points closer to
   * each other than the edges of the surface are skipped, except for the ends of lines. Lines may meet
   * at points of theirs, as paths of SeamPathStarts do. A point farther from the surface than 5 % of the
   * diagonal of its bounding box is an error. Lines whose cell array `SeamId` is 0 or less are left out,
   * as the second output of this filter marks borders and caps so.
   */
  void SetSeamLinesConnection(vtkAlgorithmOutput* lines);
  void SetSeamLinesData(vtkPolyData* lines);
  void RemoveSeamLines();
  ///@}

  /**
   * The second output: the cuts as lines on the surface. nullptr if the input is composite; the second
   * output then has one block for each of the input.
   */
  vtkPolyData* GetCuts();

  /**
   * The third output: the table of the changes. nullptr if the input is composite.
   */
  vtkTable* GetReport();

  ///@{
  /**
   * The strain (see ReliefStrain) that a relief as long as the square root of the surface's area must
   * take away to be worth its length, if CutMode is RELIEF or AUTOMATIC, and in proportion if it has
   * another length: of all reliefs that are tried, the one is taken for which the strain and this number
   * times the length make the least sum. Each branch counts as if it were longer by 0.05. AUTOMATIC
   * takes 0.07 if this is less and FreeOutline is off. Less makes more branches. Range [0, inf),
   * otherwise an error. Default: 0.01.
   */
  vtkSetMacro(ReliefGain, double);
  vtkGetMacro(ReliefGain, double);
  ///@}

  ///@{
  /**
   * Greatest length of all branches together if CutMode is RELIEF or AUTOMATIC, in square roots of the
   * surface's area. The first branch of a closed surface is cut whatever its length. Range (0, inf),
   * otherwise an error. Default: 20.
   */
  vtkSetMacro(LongestRelief, double);
  vtkGetMacro(LongestRelief, double);
  ///@}

  ///@{
  /**
   * Whether the flat map will have a free outline (FreeOutline of vtkOMTAreaPreservingFilter). AUTOMATIC
   * then cuts a longer relief, see there; other ways to cut do not depend on it. In a disk, the map of a
   * surface that is cut for a free outline is mostly worse than that of one cut for a disk. Default:
   * off.
   */
  vtkSetMacro(FreeOutline, bool);
  vtkGetMacro(FreeOutline, bool);
  vtkBooleanMacro(FreeOutline, bool);
  ///@}

  ///@{
  /**
   * Label of the part that is removed if CutMode is LABEL: the triangles of cells with this value, or
   * with two corners or more with this value, of the input array to process 1 (SetInputArrayToProcess).
   * An error if no part has it, if it has several pieces, if its border is several loops or if it is the
   * whole surface. Default: 1.
   */
  vtkSetMacro(CutLabel, int);
  vtkGetMacro(CutLabel, int);
  ///@}

  ///@{
  /**
   * Point of the plane of CutMode PLANE (input units). Default: (0, 0, 0).
   */
  vtkSetVector3Macro(PlaneOrigin, double);
  vtkGetVector3Macro(PlaneOrigin, double);
  ///@}

  ///@{
  /**
   * Normal of the plane of CutMode PLANE, which points to the side that is kept. Any length but 0,
   * otherwise an error. Default: (1, 0, 0).
   */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /**
   * Least number of vertices of a boundary that the filter cuts: edges there are split where needed. A
   * boundary of the input gets at least 8 vertices, or this number if it is smaller, as a triangle
   * covers less than half of its circle. A hole (CutMode HOLE) in place of a few triangles can have
   * about three thousand; more are an error. Range [3, 10000]. Default: 128.
   */
  vtkSetClampMacro(MinimumBoundaryVertices, int, 3, 10000);
  vtkGetMacro(MinimumBoundaryVertices, int);
  ///@}

  ///@{
  /**
   * Angle below which a face is removed without Remesh, by moving its vertices, collapsing and flipping
   * edges, as slivers cannot be flattened well (degrees). Faces beside seams are opened again after the
   * cut, as far as the seams can stay as they are. 0 leaves all faces as they are. Ignored if HandleMode
   * is CUT_HANDLES. Range [0, 15]. Default: 1.
   */
  vtkSetClampMacro(SmallestAngle, double, 0.0, 15.0);
  vtkGetMacro(SmallestAngle, double);
  ///@}

  ///@{
  /**
   * Whether the triangles are replaced by nearly equilateral ones; the boundary is resampled, too.
   * vtkFlatMapTransfer transfers the flat map back to the points of the input. Default: off.
   */
  vtkSetMacro(Remesh, bool);
  vtkGetMacro(Remesh, bool);
  vtkBooleanMacro(Remesh, bool);
  ///@}

  ///@{
  /**
   * Edge length for Remesh (input units); 0 uses RelativeEdgeLength instead. Range [0, inf); an error
   * otherwise, or if fewer than 20 faces would be left. Default: 0.
   */
  vtkSetMacro(TargetEdgeLength, double);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Edge length for Remesh, if TargetEdgeLength is 0, in units of the mean edge length of the surface.
   * The default leaves an isosurface about as many points as it had. Range (0, inf), otherwise an error.
   * Default: 0.9.
   */
  vtkSetMacro(RelativeEdgeLength, double);
  vtkGetMacro(RelativeEdgeLength, double);
  ///@}

  ///@{
  /**
   * Whether pairs of intersecting faces are counted, before and after. This takes about as long as all
   * other steps without remeshing. If off, both counts are 0. Default: on.
   */
  vtkSetMacro(CountSelfIntersections, bool);
  vtkGetMacro(CountSelfIntersections, bool);
  vtkBooleanMacro(CountSelfIntersections, bool);
  ///@}

  ///@{
  /**
   * Whether the point array ScaledCurvature is added, a picture of the folds and features of the surface
   * that can be recognised on a flat map. It becomes the active scalars unless those of the input vary.
   * Takes less time than any other step. Default: on.
   */
  vtkSetMacro(ScaledCurvature, bool);
  vtkGetMacro(ScaledCurvature, bool);
  vtkBooleanMacro(ScaledCurvature, bool);
  ///@}

protected:
  vtkSurfaceToDiskFilter();
  ~vtkSurfaceToDiskFilter() override = default;

  const char* GetBlockOutputType(int port, vtkInformationVector** inputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
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
  int CutMode = AUTOMATIC;
  bool UseHolePoint = false;
  double HolePoint[3] = { 0.0, 0.0, 0.0 };
  double HoleAreaFraction = 1e-3;
  bool UseRegionOfInterest = false;
  bool UseSeamPoints = false;
  std::vector<std::array<double, 3>> SeamPoints;
  std::vector<int> SeamPathStarts;
  double ReliefGain = 0.01;
  double LongestRelief = 20.0;
  bool FreeOutline = false;
  int CutLabel = 1;
  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 1.0, 0.0, 0.0 };
  int MinimumBoundaryVertices = 128;
  double SmallestAngle = 1.0;
  bool Remesh = false;
  double TargetEdgeLength = 0.0;
  double RelativeEdgeLength = 0.9;
  bool CountSelfIntersections = true;
  bool ScaledCurvature = true;

private:
  flattening::SurfaceToDiskOptions GetOptions(vtkPolyData* input);
  void SetSeam(flattening::SurfaceToDiskOptions& options, vtkPolyData* lines);

  vtkSurfaceToDiskFilter(const vtkSurfaceToDiskFilter&) = delete;
  void operator=(const vtkSurfaceToDiskFilter&) = delete;
};

#endif
