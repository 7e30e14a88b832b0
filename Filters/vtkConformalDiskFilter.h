// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkConformalDiskFilter
 * @brief   maps a surface of disk topology to a disk, or a rectangle, with all angles kept
 *
 * The input is one oriented triangle surface with one boundary loop and no handle, as
 * vtkSurfaceToDiskFilter makes it. The output has the same points and cells, one to one and with all of
 * their arrays, but the points lie in the disk around the origin of the plane z = 0, boundary vertices
 * exactly on its circle. Three point arrays are added:
 * - `SurfacePoints` (double x 3, input units), where each point came from; warping by it restores the
 *   surface
 * - `ConformalFactor` (double), natural logarithm of flat length over surface length at the point
 * - `TCoords` (float x 2), the active texture coordinates: the flat position in the smallest square
 *   around the map with the same centre, [0,1]^2. An array of that name of the surface itself, a
 *   photograph's, is called `SurfaceTCoords`.
 *
 * There are three methods (SetMethod), with centre and rotation of the disk in common;
 * docs/conformal_methods.md compares them.
 *
 * Ricci flow, the default: logarithmic factors u_i at the vertices scale each edge by
 * exp((u_i + u_j) / 2) so that the metric becomes flat inside and its boundary straight; they minimise a
 * convex energy, by Newton's method. Edges are flipped intrinsically (Ptolemy, Delaunay) on the way,
 * which makes it converge on the slivers of marching cubes; the output keeps the input's triangles. The
 * half-plane that comes out goes to the disk by a Moebius map.
 *
 * Boundary First: the boundary's lengths in the disk by some solutions of a Poisson equation, then the
 * harmonic extension to the inside. It is conformal up to the error of piecewise linear functions.
 *
 * Mean Value: the boundary goes to the circle in proportion to its length, but for the Moebius map that
 * centres the surface, and every inner vertex to a mean of its neighbours with positive weights. It is
 * not conformal, but no triangle is flipped as long as double precision tells the positions apart and no
 * boundary vertex outweighs all others (see Filters/Core/ConvexCombinationDisk.h).
 *
 * A conformal map to the disk is unique up to a Moebius map. It is fixed by an interior point that goes
 * to the centre (SetCenterPoint) and a boundary point that goes to angle 0 (SetBoundaryPoint); without
 * the first, by the Moebius map that puts the surface's area centroid at the centre, which also is the
 * easiest start for vtkOMTAreaPreservingFilter; without the second, by a rotation that depends on the
 * surface's shape alone.
 *
 * With SetDomainToRectangle() the surface goes to a rectangle instead, its lower left corner at the
 * origin, boundary vertices exactly on its sides: for tubes that were cut open along a line, which a
 * disk squeezes exponentially. The four corners can be chosen; the ratio of width to height then is a
 * property of the surface, its conformal modulus.
 *
 * Field data (one tuple each): `IntrinsicFlips`; `AddedLength` (input units), the length added to every
 * edge to open triangles without area, 0 for most surfaces; `RepairedFaces`, triangles of the output
 * that were flipped and no longer are, as a coarse or very uneven triangulation cannot always follow the
 * map; `MovedPoints`, how many points were moved for that, and `GreatestMove`, by how much at most, in
 * mean lengths of the edges around the point; `FlippedFaces`, triangles that are still not positively
 * oriented, with a warning if there are any; `BoundaryAnisotropy`, 4 pi area / boundary length^2 of the
 * surface: along its boundary a map to the disk that keeps areas must stretch so many times more in one
 * direction than in the other. But for Mean Value: `SpreadPoints`, points in narrow parts of the surface
 * whose images double precision hardly tells apart, and which were moved apart. Ricci flow only:
 * `NewtonIterations`; `MaxCurvatureError` (radians), greatest error of an angle sum; `LayoutError`,
 * greatest relative error of a flat intrinsic edge; `InsertedBoundaryPoints`, intrinsic points used on
 * the way, not in the output. Boundary First only: `BoundaryIterations`.
 * Rectangle only: `Modulus`, width / height, and `CornerPointIds`, four tuples
 * counter-clockwise from the lower left corner. Boundary First and Mean Value place vertices in the
 * plane, where every angle sum is right: they have no curvature error, and vtkDistortionMetrics tells
 * how conformal they are.
 *
 * `ConformalFactor` is u of the Ricci flow; for the other methods the logarithm of the sum of the flat
 * lengths of the edges at the point over the sum of their lengths on the surface.
 *
 * A warning if more than a hundredth of the points were moved apart; if the surface is a long tube, a
 * rectangle serves better.
 *
 * An empty input gives an empty output. Errors, each with an empty output: cells that are not triangles,
 * coordinates that are not finite, zero area, unused points, non-manifold or inconsistently oriented
 * triangles, several components, genus > 0, no or several boundaries, a centre on the boundary, corners
 * that are not four different boundary vertices in order, a rectangle by another method than Ricci flow,
 * no convergence.
 *
 * Sources: Zhao et al., "Area-Preservation Mapping using Optimal Mass Transport", TVCG 2013,
 * sections 3.3 and 4.1; Springborn, Schroeder, Pinkall, "Conformal Equivalence of Triangle Meshes",
 * SIGGRAPH 2008; Gu, Luo, Sun, Wu, "A Discrete Uniformization Theorem for Polyhedral Surfaces", 2018;
 * Gillespie, Springborn, Crane, "Discrete Conformal Equivalence of Polyhedral Surfaces", SIGGRAPH 2021;
 * Sawhney, Crane, "Boundary First Flattening", ACM TOG 2017; Floater, "Mean value coordinates", CAGD
 * 2003; Floater, "One-to-one piecewise linear mappings over triangulations", Math. Comp. 2003.
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

  /// How the map is found.
  enum MethodType
  {
    RICCI_FLOW = 0,     ///< discrete Ricci flow
    BOUNDARY_FIRST = 1, ///< Boundary First Flattening
    MEAN_VALUE = 2      ///< mean value coordinates: no flipped triangle, not conformal
  };

  ///@{
  /**
   * Method of the map: RICCI_FLOW (0), BOUNDARY_FIRST (1) or MEAN_VALUE (2). Default: RICCI_FLOW. The
   * others are for the disk alone; it is an error to ask them for a rectangle.
   */
  vtkSetClampMacro(Method, int, RICCI_FLOW, MEAN_VALUE);
  vtkGetMacro(Method, int);
  void SetMethodToRicciFlow() { this->SetMethod(RICCI_FLOW); }
  void SetMethodToBoundaryFirst() { this->SetMethod(BOUNDARY_FIRST); }
  void SetMethodToMeanValue() { this->SetMethod(MEAN_VALUE); }
  ///@}

  /// What the surface is mapped to.
  enum DomainType
  {
    DISK = 0,
    RECTANGLE = 1
  };

  ///@{
  /**
   * DISK (0) or RECTANGLE (1). Default: DISK.
   */
  vtkSetClampMacro(Domain, int, DISK, RECTANGLE);
  vtkGetMacro(Domain, int);
  void SetDomainToDisk() { this->SetDomain(DISK); }
  void SetDomainToRectangle() { this->SetDomain(RECTANGLE); }
  ///@}

  ///@{
  /**
   * Whether the four corners of the rectangle are chosen. Default: off, they are where the two
   * sides of the seam of a tube, marked by the point array `Seam` of vtkSurfaceToDiskFilter, meet its
   * ends: the lower side is the seam from the longer end to the other. Without such a seam they are
   * where the boundary turns most sharply, or a quarter of its length apart if it does not turn four
   * times by 45 degrees or more.
   */
  vtkSetMacro(UseCorners, bool);
  vtkGetMacro(UseCorners, bool);
  vtkBooleanMacro(UseCorners, bool);
  ///@}

  ///@{
  /**
   * Points in space (input units) whose nearest boundary vertices become the corners of the rectangle.
   * They must be in this order, counter-clockwise, on the boundary with the surface on its left; which
   * one is the lower left corner is free. Default: (0, 0, 0), not used.
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

  /// What the size of the disk or rectangle is.
  enum Normalization
  {
    SURFACE_AREA = 0, ///< its area = area of the surface, in input units
    UNIT_DOMAIN = 1   ///< radius 1, or height 1
  };

  ///@{
  /**
   * Size of the disk or rectangle: SURFACE_AREA (0) or UNIT_DOMAIN (1). Default: SURFACE_AREA, so that
   * lengths and areas on the flat picture are in input units.
   */
  vtkSetClampMacro(NormalizeTo, int, SURFACE_AREA, UNIT_DOMAIN);
  vtkGetMacro(NormalizeTo, int);
  void SetNormalizeToSurfaceArea() { this->SetNormalizeTo(SURFACE_AREA); }
  void SetNormalizeToUnitDomain() { this->SetNormalizeTo(UNIT_DOMAIN); }
  ///@}

  ///@{
  /**
   * Disk: whether CenterPoint is used. Default: off, the surface's area is centred.
   */
  vtkSetMacro(UseCenterPoint, bool);
  vtkGetMacro(UseCenterPoint, bool);
  vtkBooleanMacro(UseCenterPoint, bool);
  ///@}

  ///@{
  /**
   * Point in space (input units) whose nearest vertex of the surface goes to the centre of the disk. It
   * is an error if that vertex is on the boundary. Default: (0, 0, 0), not used.
   */
  vtkSetVector3Macro(CenterPoint, double);
  vtkGetVector3Macro(CenterPoint, double);
  ///@}

  ///@{
  /**
   * Disk: whether BoundaryPoint is used. Default: off, the rotation depends on the surface's shape
   * alone.
   */
  vtkSetMacro(UseBoundaryPoint, bool);
  vtkGetMacro(UseBoundaryPoint, bool);
  vtkBooleanMacro(UseBoundaryPoint, bool);
  ///@}

  ///@{
  /**
   * Point in space (input units) whose nearest boundary vertex goes to angle 0, the right end of the
   * disk. Default: (0, 0, 0), not used.
   */
  vtkSetVector3Macro(BoundaryPoint, double);
  vtkGetVector3Macro(BoundaryPoint, double);
  ///@}

  ///@{
  /**
   * Greatest error of an angle sum (radians) at which the flow may stop. Range [1e-14, 1e-10]. Default:
   * 1e-11. More than 1e-10 is an error: the map would not be conformal. Of Ricci flow alone.
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
};

#endif
