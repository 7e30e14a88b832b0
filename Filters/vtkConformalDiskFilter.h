// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkConformalDiskFilter
 * @brief   maps a surface of disk topology to a disk with all angles kept
 *
 * The input is one oriented triangle surface with one boundary loop and no handle, as
 * vtkSurfaceToDiskFilter makes it. The output has the same points and cells, one to one and with all of
 * their arrays, but the points lie in the disk around the origin of the plane z = 0, boundary vertices
 * exactly on its circle. Two point arrays are added:
 * - `SurfacePoints` (double x 3, input units), where each point came from; warping by it restores the
 *   surface
 * - `ConformalFactor` (double), natural logarithm of flat length over surface length at the point
 *
 * The method is discrete Ricci flow: logarithmic factors u_i at the vertices scale each edge by
 * exp((u_i + u_j) / 2) so that the metric becomes flat inside and its boundary straight; they minimise a
 * convex energy, by Newton's method. Edges are flipped intrinsically (Ptolemy, Delaunay) on the way,
 * which makes it converge on the slivers of marching cubes; the output keeps the input's triangles. The
 * half-plane that comes out goes to the disk by a Moebius map.
 *
 * A conformal map to the disk is unique up to a Moebius map. It is fixed by an interior point that goes
 * to the centre (SetCenterPoint) and a boundary point that goes to angle 0 (SetBoundaryPoint); without
 * the first, by the Moebius map that puts the surface's area centroid at the centre, which also is the
 * easiest start for vtkOMTAreaPreservingFilter; without the second, by a rotation that depends on the
 * surface's shape alone.
 *
 * Field data (one tuple each): `NewtonIterations`; `MaxCurvatureError` (radians), greatest error of an
 * angle sum; `LayoutError`, greatest relative error of a flat intrinsic edge; `IntrinsicFlips`;
 * `InsertedBoundaryPoints`, intrinsic points used on the way, not in the output; `AddedLength` (input
 * units), the length added to every edge to open triangles without area, 0 for most surfaces;
 * `FlippedFaces`, triangles of the output that are not positively oriented: a coarse or very uneven
 * triangulation cannot always follow the map.
 *
 * An empty input gives an empty output. Errors, each with an empty output: cells that are not triangles,
 * coordinates that are not finite, zero area, unused points, non-manifold or inconsistently oriented
 * triangles, several components, genus > 0, no or several boundaries, a centre on the boundary, no
 * convergence.
 *
 * Sources: Zhao et al., "Area-Preservation Mapping using Optimal Mass Transport", TVCG 2013,
 * sections 3.3 and 4.1; Springborn, Schroeder, Pinkall, "Conformal Equivalence of Triangle Meshes",
 * SIGGRAPH 2008; Gu, Luo, Sun, Wu, "A Discrete Uniformization Theorem for Polyhedral Surfaces", 2018;
 * Gillespie, Springborn, Crane, "Discrete Conformal Equivalence of Polyhedral Surfaces", SIGGRAPH 2021.
 *
 * @sa vtkSurfaceToDiskFilter vtkOMTAreaPreservingFilter vtkDistortionMetrics
 */
#ifndef vtkConformalDiskFilter_h
#define vtkConformalDiskFilter_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class SURFACEFLATTENINGFILTERS_EXPORT vtkConformalDiskFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkConformalDiskFilter* New();
  vtkTypeMacro(vtkConformalDiskFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the size of the disk is.
  enum Normalization
  {
    SURFACE_AREA = 0, ///< area of the disk = area of the surface, in input units
    UNIT_DOMAIN = 1   ///< radius 1
  };

  ///@{
  /**
   * Size of the disk: SURFACE_AREA (0) or UNIT_DOMAIN (1). Default: SURFACE_AREA, so that lengths and
   * areas on the flat picture are in input units.
   */
  vtkSetClampMacro(NormalizeTo, int, SURFACE_AREA, UNIT_DOMAIN);
  vtkGetMacro(NormalizeTo, int);
  void SetNormalizeToSurfaceArea() { this->SetNormalizeTo(SURFACE_AREA); }
  void SetNormalizeToUnitDomain() { this->SetNormalizeTo(UNIT_DOMAIN); }
  ///@}

  ///@{
  /**
   * Whether CenterPoint is used. Default: off, the surface's area is centred.
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
   * Whether BoundaryPoint is used. Default: off, the rotation depends on the surface's shape alone.
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
   * 1e-11. More than 1e-10 is an error: the map would not be conformal.
   */
  vtkSetClampMacro(Tolerance, double, 1e-14, 1e-10);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkConformalDiskFilter();
  ~vtkConformalDiskFilter() override = default;

  int RequestData(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

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
