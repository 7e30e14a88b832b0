// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkConformalDiskFilter
 * @brief   maps a surface of disk topology conformally to a disk or a rectangle
 *
 * The input is an oriented triangle surface with one component, one boundary loop and no handle, as
 * vtkSurfaceToDiskFilter makes it. The output has the same points and cells, one to one and with all of
 * their arrays except those that Distortion Metrics added to an earlier map, and without the field data
 * of an earlier map, but its points lie in the disk around the origin of the plane z = 0, and the
 * boundary vertices lie exactly on the circle.
 *
 * There are three methods (SetMethod), which share the centring and the rotation of the disk;
 * docs/conformal_methods.md compares them.
 *
 * Ricci flow, the default, finds logarithmic factors u_i of the vertices that scale each edge by
 * exp((u_i + u_j) / 2) so that the metric becomes flat inside and the boundary straight. The factors
 * minimise a convex energy by Newton's method. On the way edges are flipped intrinsically (Ptolemy,
 * Delaunay), so that the method converges on the slivers of isosurfaces, too; the output keeps the
 * triangles of the input. The result is a half-plane, which a Moebius map takes to the disk.
 *
 * Boundary First finds the lengths of the boundary in the disk by a few solutions of a Poisson equation
 * and extends the boundary harmonically to the inside. The map is conformal up to the error of
 * piecewise linear functions.
 *
 * Mean Value maps the boundary to the circle in proportion to its length, up to the Moebius map that
 * centres the surface, and each inner vertex to a mean of its neighbours with positive weights. The map
 * is not conformal, but it flips no triangle as long as double precision tells the positions apart and
 * no boundary vertex outweighs all others (see Filters/Core/Conformal/ConvexCombinationDisk.h).
 *
 * A conformal map to the disk is unique up to a Moebius map. It is fixed by an interior point that goes
 * to the centre (SetCenterPoint) and a boundary point that goes to angle 0 (SetBoundaryPoint). Without
 * the first, the area centroid of the surface goes to the centre, which is also the easiest start for
 * vtkOMTAreaPreservingFilter; without the second, the rotation depends on the shape of the surface
 * alone.
 *
 * SetDomainToRectangle() maps the surface to a rectangle with its lower left corner at the origin, and
 * the boundary vertices exactly to its sides. This suits tubes that were cut open along a line, which a
 * disk shrinks exponentially. The ratio of width to height of the rectangle is a property of the
 * surface and its four corners, the conformal modulus.
 *
 * A warning is given if triangles of the map are flipped, or if more than one percent of the points had
 * to be moved apart; for a long tube a rectangle is better then.
 *
 * Output arrays:
 * - point `SurfacePoints` (double x 3, input units): where the flat point lies on the surface;
 *   ParaView's Calculator with Coordinate Results puts the points of the map back there.
 * - point `ConformalFactor` (double, dimensionless): natural logarithm of flat length over surface
 *   length, u of the Ricci flow; for the other methods, of the root mean square length of the sides of
 *   the faces at the point on the map over that on the surface.
 * - point `TCoords` (float x 2, [0, 1]): active texture coordinates, the flat position in the smallest
 *   square around the map with the same centre.
 * - point `SurfaceTCoords` (as in the input): texture coordinates that the surface had under the name
 *   `TCoords` before it was flattened; absent if it had none.
 *
 * Field data (one tuple each unless stated otherwise):
 * - `NewtonIterations` (vtkIdType): steps of Newton's method; Ricci flow only.
 * - `MaxCurvatureError` (double, radians): greatest error of an angle sum; Ricci flow only.
 * - `LayoutError` (double, dimensionless): greatest relative error of the length of a flat intrinsic
 *   edge; Ricci flow only.
 * - `SpreadPoints` (vtkIdType): number of points in narrow protrusions whose images double precision
 *   hardly tells apart, and which were moved apart; absent for Mean Value.
 * - `BoundaryIterations` (vtkIdType): steps that fitted the boundary to the circle; Boundary First
 *   only.
 * - `IntrinsicFlips` (vtkIdType): number of intrinsic edge flips.
 * - `AddedLength` (double, input units): length that was added to every edge to open triangles without
 *   area; 0 for most surfaces.
 * - `RepairedFaces` (vtkIdType): number of flipped triangles that were untangled; a coarse or very
 *   uneven triangulation cannot always follow the map.
 * - `MovedPoints` (vtkIdType): number of points that were moved to untangle them.
 * - `GreatestMove` (double, mean lengths of the edges around the point): greatest distance by which a
 *   point was moved to untangle triangles.
 * - `FlippedFaces` (vtkIdType): number of triangles that are still not positively oriented.
 * - `BoundaryAnisotropy` (double, dimensionless): 4 pi area / length^2 of the boundary of the surface:
 *   a map to the disk that keeps areas must stretch the surface along its boundary so many times more
 *   in one direction than in the other.
 * - `Modulus` (double, dimensionless): width over height; rectangle only.
 * - `CornerPointIds` (vtkIdType, four tuples): ids of the corner points, counter-clockwise from the
 *   lower left corner; rectangle only.
 *
 * Boundary First and Mean Value place vertices in the plane, where every angle sum is right, so they
 * have no curvature error; vtkDistortionMetrics tells how conformal they are.
 *
 * An empty input gives an empty output. The following are errors, each with an empty output: cells that
 * are not triangles; coordinates that are not finite; zero area; unused points; triangles that are not
 * manifold or not consistently oriented; several components; genus > 0; no boundary or several; a
 * centre on the boundary; corners that are not four different boundary vertices in order; a rectangle
 * by a method other than Ricci flow; no convergence.
 *
 * Sources: Zhao et al., "Area-Preservation Mapping using Optimal Mass Transport", TVCG 2013, sections
 * 3.3 and 4.1; Springborn, Schroeder, Pinkall, "Conformal Equivalence of Triangle Meshes", SIGGRAPH
 * 2008; Gu, Luo, Sun, Wu, "A Discrete Uniformization Theorem for Polyhedral Surfaces", 2018; Gillespie,
 * Springborn, Crane, "Discrete Conformal Equivalence of Polyhedral Surfaces", SIGGRAPH 2021; Sawhney,
 * Crane, "Boundary First Flattening", ACM TOG 2017; Floater, "Mean value coordinates", CAGD 2003;
 * Floater, "One-to-one piecewise linear mappings over triangulations", Math. Comp. 2003.
 *
 * @sa vtkSurfaceToDiskFilter vtkOMTAreaPreservingFilter vtkDistortionMetrics
 */
#ifndef vtkConformalDiskFilter_h
#define vtkConformalDiskFilter_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class SURFACEFLATTENINGFILTERS_EXPORT vtkConformalDiskFilter : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkConformalDiskFilter* New();
  vtkTypeMacro(vtkConformalDiskFilter, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The methods that compute the map.
  enum MethodType
  {
    RICCI_FLOW = 0,     ///< discrete Ricci flow
    BOUNDARY_FIRST = 1, ///< Boundary First Flattening
    MEAN_VALUE = 2      ///< mean value coordinates: no flipped triangle, not conformal
  };

  ///@{
  /**
   * Method that computes the map: RICCI_FLOW (0), BOUNDARY_FIRST (1) or MEAN_VALUE (2). The latter two
   * map to the disk only; with Domain RECTANGLE they are an error. Default: RICCI_FLOW.
   */
  vtkSetClampMacro(Method, int, RICCI_FLOW, MEAN_VALUE);
  vtkGetMacro(Method, int);
  void SetMethodToRicciFlow() { this->SetMethod(RICCI_FLOW); }
  void SetMethodToBoundaryFirst() { this->SetMethod(BOUNDARY_FIRST); }
  void SetMethodToMeanValue() { this->SetMethod(MEAN_VALUE); }
  ///@}

  /// The domains of the map.
  enum DomainType
  {
    DISK = 0,
    RECTANGLE = 1
  };

  ///@{
  /**
   * Domain of the map: DISK (0) or RECTANGLE (1). Default: DISK.
   */
  vtkSetClampMacro(Domain, int, DISK, RECTANGLE);
  vtkGetMacro(Domain, int);
  void SetDomainToDisk() { this->SetDomain(DISK); }
  void SetDomainToRectangle() { this->SetDomain(RECTANGLE); }
  ///@}

  ///@{
  /**
   * Whether the four corner points below choose the corners of the rectangle. If off, the corners are
   * where the two sides of the seam of a tube, marked by the point array `Seam` of
   * vtkSurfaceToDiskFilter, meet its ends; the lower side is the seam from the longer end to the other.
   * Without such a seam they are where the boundary turns most sharply, or a quarter of its length apart
   * if it does not turn four times by 45 degrees or more. Default: off.
   */
  vtkSetMacro(UseCorners, bool);
  vtkGetMacro(UseCorners, bool);
  vtkBooleanMacro(UseCorners, bool);
  ///@}

  ///@{
  /**
   * Points in space (input units) whose nearest boundary vertices become the corners of the rectangle,
   * if UseCorners is on. Along the boundary, with the surface on its left, they must follow in the order
   * lower left, lower right, upper right, upper left, otherwise an error. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(LowerLeftCorner, double);
  vtkGetVector3Macro(LowerLeftCorner, double);
  /// The second corner, as LowerLeftCorner is the first.
  vtkSetVector3Macro(LowerRightCorner, double);
  vtkGetVector3Macro(LowerRightCorner, double);
  /// The third corner, as LowerLeftCorner is the first.
  vtkSetVector3Macro(UpperRightCorner, double);
  vtkGetVector3Macro(UpperRightCorner, double);
  /// The fourth corner, as LowerLeftCorner is the first.
  vtkSetVector3Macro(UpperLeftCorner, double);
  vtkGetVector3Macro(UpperLeftCorner, double);
  ///@}

  /// The sizes of the disk or rectangle.
  enum Normalization
  {
    SURFACE_AREA = 0, ///< the area of the surface, input units squared
    UNIT_DOMAIN = 1   ///< a disk of radius 1, or a rectangle of height 1
  };

  ///@{
  /**
   * Size of the disk or rectangle: SURFACE_AREA (0), so that lengths and areas on the map are in input
   * units, or UNIT_DOMAIN (1). Default: SURFACE_AREA.
   */
  vtkSetClampMacro(NormalizeTo, int, SURFACE_AREA, UNIT_DOMAIN);
  vtkGetMacro(NormalizeTo, int);
  void SetNormalizeToSurfaceArea() { this->SetNormalizeTo(SURFACE_AREA); }
  void SetNormalizeToUnitDomain() { this->SetNormalizeTo(UNIT_DOMAIN); }
  ///@}

  ///@{
  /**
   * Whether CenterPoint chooses the centre of the disk. If off, the area of the surface is centred.
   * Default: off.
   */
  vtkSetMacro(UseCenterPoint, bool);
  vtkGetMacro(UseCenterPoint, bool);
  vtkBooleanMacro(UseCenterPoint, bool);
  ///@}

  ///@{
  /**
   * Point in space (input units) whose nearest vertex of the surface goes to the centre of the disk, if
   * UseCenterPoint is on. An error if that vertex is on the boundary. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(CenterPoint, double);
  vtkGetVector3Macro(CenterPoint, double);
  ///@}

  ///@{
  /**
   * Whether BoundaryPoint chooses the rotation of the disk. If off, the rotation depends on the shape of
   * the surface alone. Default: off.
   */
  vtkSetMacro(UseBoundaryPoint, bool);
  vtkGetMacro(UseBoundaryPoint, bool);
  vtkBooleanMacro(UseBoundaryPoint, bool);
  ///@}

  ///@{
  /**
   * Point in space (input units) whose nearest boundary vertex goes to angle 0, the right end of the
   * disk, if UseBoundaryPoint is on. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(BoundaryPoint, double);
  vtkGetVector3Macro(BoundaryPoint, double);
  ///@}

  ///@{
  /**
   * Greatest error of an angle sum (radians) at which the Ricci flow may stop. If it cannot get below
   * 1e-10, that is an error, as the map would not be conformal. Range [1e-14, 1e-10]. Default: 1e-11.
   */
  vtkSetClampMacro(Tolerance, double, 1e-14, 1e-10);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkConformalDiskFilter();
  ~vtkConformalDiskFilter() override = default;

  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int Method = RICCI_FLOW;
  int Domain = DISK;
  bool UseCorners = false;
  double LowerLeftCorner[3] = { 0.0, 0.0, 0.0 };
  double LowerRightCorner[3] = { 0.0, 0.0, 0.0 };
  double UpperRightCorner[3] = { 0.0, 0.0, 0.0 };
  double UpperLeftCorner[3] = { 0.0, 0.0, 0.0 };
  int NormalizeTo = SURFACE_AREA;
  bool UseCenterPoint = false;
  double CenterPoint[3] = { 0.0, 0.0, 0.0 };
  bool UseBoundaryPoint = false;
  double BoundaryPoint[3] = { 0.0, 0.0, 0.0 };
  double Tolerance = 1e-11;

private:
  vtkConformalDiskFilter(const vtkConformalDiskFilter&) = delete;
  void operator=(const vtkConformalDiskFilter&) = delete;

  void Warn(int flippedFaces, int spreadPoints, int points, double anisotropy);
};

#endif
