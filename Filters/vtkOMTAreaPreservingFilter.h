// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkOMTAreaPreservingFilter
 * @brief   moves the points of a conformal map so that every point keeps its share of the area
 *
 * The input is the output of vtkConformalDiskFilter. Each of its points is a site that carries a third
 * of the surface area of its triangles, times the point's weight. The filter finds power weights for
 * which the power cell of every site, clipped exactly to the domain, has the area that the site carries:
 * the optimal transport of the surface's area to the uniform domain (Monge-Brenier). Interior points
 * then go to the centroids of their cells, boundary points to the middle of their cells' part of the
 * boundary. The domain is the disk around the origin, or the rectangle with sides along the axes if the
 * boundary lies on them; points in its corners stay there.
 *
 * The optional input port 1 gives another domain: a polydata with one convex polygon, or one closed
 * line, in a plane of constant z. The cells are clipped exactly to it. It may be given in either
 * direction and be of any size; points in the middle of a side are no corners. The sites are then the
 * points of the input map, disk or rectangle, in the proportions that they have there: of its size and
 * place the transport is independent, but as the input is turned about the origin, so is what comes to
 * lie at which side (see UseBoundaryPoint of vtkConformalDiskFilter). A boundary edge across a corner
 * cuts that off, unless FixCorners is on. The map stays one-to-one if no inner edge joins two boundary
 * points, as in the output of vtkSurfaceToDiskFilter; else the triangles between it and a straight side
 * have no area.
 *
 * The areas of the *cells* are exact to Tolerance. Areas of *triangles* follow the cells only as well as
 * the triangulation allows, so the points are then moved, those of the boundary along it, until the
 * triangles are exact too and none is flipped (FaceRefinement). For that the transport takes a few
 * neighbouring points together as one site (PointsPerSite), and the points follow the smooth map through
 * the centroids. What error is left is measured with vtkDistortionMetrics; near a boundary that was a
 * hole too small for its number of points it is large.
 *
 * Output port 0 has the input's points and cells, one to one and with all of their arrays (among them
 * `SurfacePoints`), in the plane z = 0, in the disk around the origin, in the rectangle with its lower
 * left corner there or in the polygon, scaled about its centroid, and adds the point arrays (double)
 * - `TargetArea`, the area asked for, and `CellArea`, the area of the point's power cell or its share of
 *   its site's cell (output units squared; both sum to the area of the domain)
 * - `PowerWeight` (output units squared), the weight w_i of the point's site in the power diagram,
 *   scaled to the size of the output
 * - `FlatPoints` (3 components), the output's points once more, for a later run to start from
 *
 * and the active texture coordinates `TCoords`, of this map (see vtkConformalDiskFilter).
 *
 * Output port 1 is the power diagram: one polygon per cell, arcs as polylines of steps of at most one
 * degree, with the cell arrays `SiteId` (point id), `CellArea` and `TargetArea` (paper, figure 4).
 * Points that share a position or a site share a cell; SiteId is the lowest of their ids.
 *
 * Field data of port 0 (one tuple each): `NewtonIterations`; `Sites`; `PowerDiagrams` computed;
 * `MaxCellAreaError`, max_i |CellArea - TargetArea| / TargetArea; `CoincidentPoints`, points that shared
 * the position of another; `FlippedFaces`, triangles not positively oriented; `Bijective`, 1 if the map
 * is one-to-one: there are none, and the boundary points are in order; `WarmStart`, 0 or 1, see below;
 * `RefinementRounds`, passes over what is not right yet; `RefinementRepairs`, triangles that had flipped
 * on the way. A warning tells when Bijective is 0. With points in corners also `CornerPointIds`,
 * counter-clockwise.
 *
 * If the input has a point array `PowerWeight`, as an earlier run with the same settings and domain
 * wrote it, the transport starts there where no cell is off by more than a decade, or where that is
 * nearer than its own starts: after a small change of the weights it takes a few steps only. Its result
 * does not depend on it but for Tolerance. If there is `FlatPoints` of the same run as well, the
 * refinement goes on from those points, carried along with what changed in the transport: in a fifth to
 * a third of the time, to the same accuracy, but not to the same bits as from the beginning. Field data
 * `WarmStart` is 1 then; 0 if there is none, if it is no one-to-one map to the present domain, if more
 * than a percent of the triangles would flip on the way, or with an AngleWeight. Append Attributes in
 * ParaView puts both arrays on the conformal map.
 *
 * Newton's method on the convex energy is damped by the rule of Kitagawa, Merigot and Thibert, which
 * converges from any start without empty cells. Where the conformal map puts the points of a long
 * protrusion all but into one place, it starts from a convex potential that opens that place; the result
 * is the optimal transport of the conformal map all the same.
 *
 * An empty input gives empty outputs. Errors, each with empty outputs: no array `SurfacePoints`, a
 * boundary that is neither a circle around the origin nor a rectangle with a point in each corner,
 * weights that are not positive and finite or leave a point less than 2e-16 of the domain, a weight
 * array that does not exist, what vtkConformalDiskFilter refuses, no convergence to Tolerance; on port 1
 * not exactly one polygon or closed line, or one that is not flat, not finite, not convex, crosses
 * itself, has less than three corners or no area, is smaller than 1e-9 of its coordinates, or has more
 * corners to be fixed than there are boundary points.
 *
 * Sources: Zhao et al., "Area-Preservation Mapping using Optimal Mass Transport", TVCG 2013, section 4
 * and Algorithm 1; Kitagawa, Merigot, Thibert, "Convergence of a Newton algorithm for semi-discrete
 * optimal transport", 2016.
 *
 * @sa vtkConformalDiskFilter vtkDistortionMetrics
 */
#ifndef vtkOMTAreaPreservingFilter_h
#define vtkOMTAreaPreservingFilter_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include "vtkBlockwisePolyDataAlgorithm.h"

class SURFACEFLATTENINGFILTERS_EXPORT vtkOMTAreaPreservingFilter : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkOMTAreaPreservingFilter* New();
  vtkTypeMacro(vtkOMTAreaPreservingFilter, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the size of the domain is.
  enum Normalization
  {
    SURFACE_AREA = 0, ///< its area = area of the surface, in input units
    UNIT_DOMAIN = 1   ///< radius 1, or height 1; the polygon as it is
  };

  ///@{
  /**
   * Size of the domain: SURFACE_AREA (0) or UNIT_DOMAIN (1). Default: SURFACE_AREA, so that areas can be
   * measured on the flat picture in input units.
   */
  vtkSetClampMacro(NormalizeTo, int, SURFACE_AREA, UNIT_DOMAIN);
  vtkGetMacro(NormalizeTo, int);
  void SetNormalizeToSurfaceArea() { this->SetNormalizeTo(SURFACE_AREA); }
  void SetNormalizeToUnitDomain() { this->SetNormalizeTo(UNIT_DOMAIN); }
  ///@}

  ///@{
  /**
   * Greatest relative error of a cell's area, max_i |A_i - nu_i| / nu_i. Range [1e-12, 0.1]. Default:
   * 1e-6. What cannot be reached is an error that says how near it came.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Whether the points have weights. If on, the input array to process 0 (SetInputArrayToProcess; by
   * default the point array `AreaWeight`) gives each point the factor by which its area is to grow
   * relative to the others: dimensionless, > 0, 1 everywhere = no change. If the array has not been
   * chosen and there is no `AreaWeight`, all are 1; "None", which ParaView sends for no choice, asks for
   * `AreaWeight` and is an error without. Default: on.
   */
  vtkSetMacro(UseAreaWeight, bool);
  vtkGetMacro(UseAreaWeight, bool);
  vtkBooleanMacro(UseAreaWeight, bool);
  ///@}

  ///@{
  /**
   * Whether triangles are made as exact as cells. If off, the output has the centroids of the cells.
   * Default: on.
   */
  vtkSetMacro(FaceRefinement, bool);
  vtkGetMacro(FaceRefinement, bool);
  vtkBooleanMacro(FaceRefinement, bool);
  ///@}

  ///@{
  /**
   * What angles count against areas in the refinement, dimensionless. 0: areas alone. Larger values give
   * up some area for shape, continuously. Range [0, 0.99]. Default: 0.
   */
  vtkSetClampMacro(AngleWeight, double, 0.0, 0.99);
  vtkGetMacro(AngleWeight, double);
  ///@}

  ///@{
  /**
   * How many neighbouring points the transport takes together as one site, if faces are refined: the
   * refinement needs of the transport what is wrong over whole regions, not the cell of every point.
   * Fewer on surfaces of less than some thousand points. 1: every point is a site, as without
   * refinement, where this setting counts for nothing. Points of one site share its power cell, its
   * weight and, by their target areas, the cell's area. Range [1, 1000]. Default: 8.
   */
  vtkSetClampMacro(PointsPerSite, int, 1, 1000);
  vtkGetMacro(PointsPerSite, int);
  ///@}

  ///@{
  /**
   * The polygon to be filled, input port 1. Default, and after RemoveDomain(): none.
   */
  void SetDomainConnection(vtkAlgorithmOutput* polygon);
  void SetDomainData(vtkPolyData* polygon);
  void RemoveDomain();
  ///@}

  ///@{
  /**
   * Whether a boundary point lies in each corner of the polygon of port 1: the one whose power cell has
   * the corner, or the nearest that is free. A rectangular input without a polygon keeps its corners
   * whatever this is. Default: off.
   */
  vtkSetMacro(FixCorners, bool);
  vtkGetMacro(FixCorners, bool);
  vtkBooleanMacro(FixCorners, bool);
  ///@}

  /**
   * The power diagram of output port 1.
   */
  vtkPolyData* GetPowerDiagram();

protected:
  vtkOMTAreaPreservingFilter();
  ~vtkOMTAreaPreservingFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int NormalizeTo = SURFACE_AREA;
  double Tolerance = 1e-6;
  bool UseAreaWeight = true;
  bool FaceRefinement = true;
  double AngleWeight = 0.0;
  int PointsPerSite = 8;
  bool FixCorners = false;

private:
  vtkOMTAreaPreservingFilter(const vtkOMTAreaPreservingFilter&) = delete;
  void operator=(const vtkOMTAreaPreservingFilter&) = delete;
};

#endif
