// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceToDiskFilter
 * @brief   makes one clean oriented disk of triangles out of any surface
 *
 * The input is any polydata with polygons or triangle strips; vertices and lines are dropped. In this
 * order, the filter
 * - triangulates,
 * - merges coincident points, drops degenerate and duplicate faces without leaving cracks, and where
 * more than two faces share an edge, or fans of faces only a vertex, cuts the surface into its sheets,
 * - keeps one component, turns its faces to the same side, a closed one outward,
 * - fills all of its boundaries but the longest with patches of the density around them; the longest too
 *   if it is shorter than that of the hole below: the surface is then opened there,
 * - on request replaces the triangles by nearly equilateral ones,
 * - cuts a small geodesic hole if the component is closed, with a boundary of at least
 *   MinimumBoundaryVertices vertices: the mesh is refined there, as a hole of six edges cannot fill a
 * disk.
 *
 * The output is a single component of genus 0 with one boundary loop, points in double precision, no
 * unused point. It keeps all point and cell arrays. Where new points are needed, arrays of floating
 * point numbers are interpolated linearly, all others (labels, strings) take the value of the nearest
 * point; cell arrays follow the input cell that a face is part of or, after remeshing, lies nearest to,
 * and hold 0 on filled holes. Global ids are not kept. Added arrays:
 * - point `vtkOriginalPointIds` (vtkIdType): the input point that lies exactly here, of merged points
 * the one with the smallest id; -1 for new points, which after remeshing are nearly all
 * - cell `vtkOriginalCellIds` (vtkIdType): the input cell; -1 on filled holes
 * - cell `Filled` (unsigned char): 1 on filled holes, else 0
 *
 * Field data, one tuple each, says what was changed: `DroppedCells` (vertices and lines),
 * `MergedPoints`, `UnusedPoints` (of no face), `DroppedFaces` = `DroppedDegenerateFaces` +
 * `DroppedDuplicateFaces`, `SplitPoints` (copies made where the surface was not manifold), `Components`,
 * `DroppedComponents`, `ReorientedFaces`, `Genus`, `FilledHoles`, `FilledArea`, `RemeshEdgeLength` (0:
 * not remeshed), `HoleCentre` (3 components), `HoleRadius` (geodesic; 0: no hole was cut), `RemovedArea`
 * (of the hole), and what came of it: `BoundaryVertices`, `BoundaryLength`, `SurfaceArea`. Lengths and
 * areas in units of the input.
 *
 * Empty input gives empty output. Errors, each with an empty output: no polygons or strips, coordinates
 * that are not finite, zero area, a one-sided surface, a surface with handles (genus > 0), parameters
 * that make no sense.
 *
 * Sources: Gueziec, Taubin, Lazarus, Horn, "Cutting and Stitching: Converting Sets of Polygons to
 * Manifold Surfaces", TVCG 2001; Liepa, "Filling Holes in Meshes", SGP 2003; Botsch and Kobbelt, "A
 * Remeshing Approach to Multiresolution Modeling", SGP 2004; Crane, Weischedel, Wardetzky, "Geodesics in
 * Heat", TOG 2013; Rivara, "Algorithms for Refining Triangular Grids", IJNME 1984. The first four as
 * implemented in CGAL.
 *
 * @sa vtkConformalDiskFilter vtkOMTAreaPreservingFilter
 */
#ifndef vtkSurfaceToDiskFilter_h
#define vtkSurfaceToDiskFilter_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class SURFACEFLATTENINGFILTERS_EXPORT vtkSurfaceToDiskFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceToDiskFilter* New();
  vtkTypeMacro(vtkSurfaceToDiskFilter, vtkPolyDataAlgorithm);
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
    CLOSEST_TO_POINT = 1
  };

  ///@{
  /**
   * Which connected component is kept: the one with the largest area, or the one closest to
   * ComponentPoint. Default: LARGEST.
   */
  vtkSetClampMacro(ComponentMode, int, LARGEST, CLOSEST_TO_POINT);
  vtkGetMacro(ComponentMode, int);
  void SetComponentModeToLargest() { this->SetComponentMode(LARGEST); }
  void SetComponentModeToClosestToPoint() { this->SetComponentMode(CLOSEST_TO_POINT); }
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
   * In units of the input. Default: (0, 0, 0).
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
   * The boundary of the hole that is cut gets at least this many vertices. A boundary that the input has
   * stays as it is. Default: 128; range: 3 and above.
   */
  vtkSetClampMacro(MinimumBoundaryVertices, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumBoundaryVertices, int);
  ///@}

  ///@{
  /**
   * Whether the triangles are replaced by nearly equilateral ones of edge length TargetEdgeLength. The
   * boundary is resampled alike. Default: off.
   */
  vtkSetMacro(Remesh, bool);
  vtkGetMacro(Remesh, bool);
  vtkBooleanMacro(Remesh, bool);
  ///@}

  ///@{
  /**
   * Edge length for Remesh, in units of the input; 0 takes the mean edge length of the surface. Default:
   * 0. Error if negative, not finite, or so large that fewer than 20 faces would be left.
   */
  vtkSetMacro(TargetEdgeLength, double);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

protected:
  vtkSurfaceToDiskFilter() = default;
  ~vtkSurfaceToDiskFilter() override = default;

  int RequestData(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double MergeTolerance = 0.0;
  int ComponentMode = LARGEST;
  double ComponentPoint[3] = { 0.0, 0.0, 0.0 };
  bool UseHolePoint = false;
  double HolePoint[3] = { 0.0, 0.0, 0.0 };
  double HoleAreaFraction = 1e-3;
  int MinimumBoundaryVertices = 128;
  bool Remesh = false;
  double TargetEdgeLength = 0.0;

private:
  vtkSurfaceToDiskFilter(const vtkSurfaceToDiskFilter&) = delete;
  void operator=(const vtkSurfaceToDiskFilter&) = delete;
};

#endif
