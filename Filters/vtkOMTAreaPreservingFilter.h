// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkOMTAreaPreservingFilter
 * @brief   moves the points of a conformal map so that every point keeps its share of the area
 *
 * The input is the output of vtkConformalDiskFilter. With FreeOutline it may be a disk in space as
 * well, such as that of vtkSurfaceToDiskFilter: such a map hardly depends on the conformal one, and a
 * map by mean value coordinates is made in its place. Each point is a site that carries a third of the
 * surface area of its triangles, times the weight of the point. The filter finds power weights for which
 * the power cell of every site, clipped exactly to the domain, has the area that the site carries: the
 * optimal transport from the area of the surface to the uniform domain (Monge-Brenier). Interior points
 * then go to the centroids of their cells, and boundary points to the middle of the part of the boundary
 * that their cells have. The domain is the disk around the origin, or the rectangle along the axes if
 * the boundary of the input lies on one; the points in its corners stay there.
 *
 * The optional input port 1 gives another domain: polydata with one convex polygon, or one closed line,
 * in a plane of constant z. The cells are clipped exactly to it. It may have either orientation and any
 * size; points in the middle of a side are not corners. The transport does not depend on the size and
 * position of the input, but on its rotation about the origin, which decides what lies at which side of
 * the polygon (see UseBoundaryPoint of vtkConformalDiskFilter). A boundary edge across a corner cuts
 * the corner off unless FixCorners is on. The map is one-to-one if no inner edge joins two boundary
 * points, as in the output of vtkSurfaceToDiskFilter; otherwise the triangles between such an edge and
 * a straight side have no area.
 *
 * The areas of the *cells* are exact to Tolerance. The areas of the *triangles* follow those of the
 * cells only as well as the triangulation allows. The refinement (FaceRefinement) therefore moves the
 * points, those of the boundary along it, until the triangles are exact too and none is flipped. With
 * the refinement, the transport takes a few neighbouring points together as one site (PointsPerSite),
 * and the points follow the smooth map through the centroids. vtkDistortionMetrics measures the
 * remaining error; it is large near a boundary that was a hole too small for its number of points.
 *
 * Output port 0 has the points and cells of the input, one to one and with all of their arrays, except
 * those that Distortion Metrics added to an earlier map, in the plane z = 0: in the disk around the
 * origin, in the rectangle with its lower left corner there, or in the polygon, scaled about its
 * centroid. With FreeOutline, the map lies around the centroid of the domain instead. Output port 1 is
 * the power diagram (Zhao et al. 2013, figure 4): one polygon per cell, with arcs as polylines of steps
 * of at most one degree. Points that share a position or a site share a cell. With FreeOutline, the
 * sites are those of the map itself, scaled into the domain, and the cells are carried along with the
 * map; their areas are those in the domain.
 *
 * Newton's method on the convex energy is damped by the rule of Kitagawa, Merigot and Thibert, which
 * converges from any start without empty cells. Where the conformal map shrinks a long protrusion to
 * nearly one position, the method starts from a convex potential that expands it; the result is still
 * the optimal transport of the conformal map.
 *
 * A warm start is made from the arrays `PowerWeight` and `FlatPoints` of an earlier run with the same
 * settings and domain, if the input has them (Append Attributes in ParaView adds both to the conformal
 * map). The transport starts from `PowerWeight` if no cell is then off by more than a factor of ten, or
 * if that start is nearer than its own: after a small change of the weights it takes a few steps only.
 * Its result depends on the start only within Tolerance. With `FlatPoints` as well, the refinement goes
 * on from those points, moved by what changed in the transport: it takes a quarter to two fifths of the
 * time and reaches the same accuracy, but not the same bits as without. `FlatPoints` is not used if it
 * is not a one-to-one map to the present domain, if more than a percent of the triangles would flip on
 * the way, or with an AngleWeight. With FreeOutline, the map is made from `FlatPoints` of a map with a
 * free outline, if that is one-to-one.
 *
 * A warning is given if the map is not one-to-one, if its outline could not be freed, or if areas were
 * asked for alone and those of more than a tenth of the triangles are off by more than 2 percent; also
 * if the outline, which is a polygon, encloses more than 1 percent less than the domain: all areas on
 * the map are then too small by that, and the warning names the factor that makes them right.
 *
 * Output arrays of port 0:
 * - point `TargetArea` (double, output units squared): area that the point is to have; the sum is the
 *   area of the domain.
 * - point `CellArea` (double, output units squared): area of the power cell of the point, or its share
 *   of the cell of its site; the sum is the area of the domain.
 * - point `PowerWeight` (double, output units squared): weight of the site of the point in the power
 *   diagram.
 * - point `FlatPoints` (double x 3, output units): flat position of the point, for the warm start of a
 *   later run.
 * - point `SurfacePoints` (double x 3, input units): position of the point on the surface, as in the
 *   input or, if that is in space, its points.
 * - point `TCoords` (float x 2, [0, 1]): active texture coordinates, the flat position in the smallest
 *   square around the map with the same centre.
 *
 * Output arrays of port 1:
 * - cell `SiteId` (vtkIdType): lowest id of the points of the site.
 * - cell `CellArea` (double, output units squared): area of the cell.
 * - cell `TargetArea` (double, output units squared): area that the cell is to have.
 *
 * Field data of both ports (one tuple each unless stated otherwise):
 * - `NewtonIterations` (vtkIdType): steps of Newton's method.
 * - `Sites` (vtkIdType): number of sites.
 * - `PowerDiagrams` (vtkIdType): number of power diagrams that were computed.
 * - `MaxCellAreaError` (double, dimensionless): greatest relative error of the area of a cell, max_i
 *   |CellArea - TargetArea| / TargetArea.
 * - `CoincidentPoints` (vtkIdType): number of points that shared the position of another.
 * - `FlippedFaces` (vtkIdType): number of triangles that are not positively oriented.
 * - `Bijective` (vtkIdType): 1 if the map is one-to-one: no triangle is flipped, and the boundary points
 *   are in order on the domain or, with FreeOutline, the outline does not cross itself; else 0.
 * - `WarmStart` (vtkIdType): 1 if the map was made from `FlatPoints`, else 0.
 * - `RefinementRounds` (vtkIdType): passes of the refinement over the parts that were not yet exact.
 * - `RefinementRepairs` (vtkIdType): number of triangles that were flipped on the way and were
 *   untangled.
 * - `FreeOutline` (vtkIdType): 1 if the outline is free, else 0.
 * - `WeightsInUse` (string): name and range of the array of weights, or "none".
 * - `CornerPointIds` (vtkIdType, one tuple per corner): ids of the points in the corners of the domain,
 *   counter-clockwise; absent if there are none or the outline is free.
 *
 * An empty input gives empty outputs. The following are errors, each with empty outputs: no array
 * `SurfacePoints`, unless FreeOutline is on; a boundary that is neither a circle around the origin nor a
 * rectangle with a point in each corner; weights that are not positive and finite, or that leave a point
 * less than 2e-16 of the domain, or, with FaceRefinement, that differ by a factor of more than a
 * million; a weight array that does not exist; the errors of vtkConformalDiskFilter about its input; no
 * convergence to Tolerance. On port 1: not exactly one polygon or closed line; an outline that is not
 * flat, not finite or not convex, crosses itself, has fewer than three corners or no area, is more than
 * a million times as long as wide, is smaller than 1e-9 of its coordinates, has a centroid at more than
 * 1e9 times the radius of a disk with the area of the surface, unless NormalizeTo is UNIT_DOMAIN, or has
 * more corners to be fixed than there are boundary points.
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

#include <string>

class SURFACEFLATTENINGFILTERS_EXPORT vtkOMTAreaPreservingFilter : public vtkBlockwisePolyDataAlgorithm
{
public:
  static vtkOMTAreaPreservingFilter* New();
  vtkTypeMacro(vtkOMTAreaPreservingFilter, vtkBlockwisePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The sizes of the domain.
  enum Normalization
  {
    SURFACE_AREA = 0, ///< the area of the surface, input units squared
    UNIT_DOMAIN = 1   ///< a disk of radius 1, a rectangle of height 1, or the size of the given polygon
  };

  ///@{
  /**
   * Size of the domain: SURFACE_AREA (0), so that areas can be measured on the map in input units, or
   * UNIT_DOMAIN (1). Default: SURFACE_AREA.
   */
  vtkSetClampMacro(NormalizeTo, int, SURFACE_AREA, UNIT_DOMAIN);
  vtkGetMacro(NormalizeTo, int);
  void SetNormalizeToSurfaceArea() { this->SetNormalizeTo(SURFACE_AREA); }
  void SetNormalizeToUnitDomain() { this->SetNormalizeTo(UNIT_DOMAIN); }
  ///@}

  ///@{
  /**
   * Greatest relative error of the area of a cell, max_i |A_i - nu_i| / nu_i. If it cannot be reached,
   * the error message tells how near the transport came. Range [1e-12, 0.1]. Default: 1e-6.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Whether the points have weights. If on, the input array to process 0 (SetInputArrayToProcess; by
   * default the point array `AreaWeight`) gives each point the factor by which its area grows relative
   * to the others (dimensionless, > 0). If no array was chosen, or "None", which ParaView sends for no
   * choice, and there is no `AreaWeight`, all weights are 1. An array that was chosen and is missing is
   * an error. GetWeightsInUse and the field data tell which weights were used. With FaceRefinement,
   * weights whose greatest is more than 32 times the least are reached in steps, each of which takes as
   * long as a map; the transport's numbers are those of the last step. Default: on.
   */
  vtkSetMacro(UseAreaWeight, bool);
  vtkGetMacro(UseAreaWeight, bool);
  vtkBooleanMacro(UseAreaWeight, bool);
  ///@}

  /**
   * The weights of the last run: the name and the range of the array, or "none".
   */
  const char* GetWeightsInUse() const { return this->WeightsInUse.c_str(); }

  ///@{
  /**
   * Whether the refinement makes the areas of the triangles as exact as those of the cells. If off, the
   * points of the output are the centroids of their cells. Default: on.
   */
  vtkSetMacro(FaceRefinement, bool);
  vtkGetMacro(FaceRefinement, bool);
  vtkBooleanMacro(FaceRefinement, bool);
  ///@}

  ///@{
  /**
   * Weight of angles against areas in the refinement (dimensionless). 0 keeps areas alone; larger values
   * continuously give up area for shape. Range [0, 0.99]. Default: 0.
   */
  vtkSetClampMacro(AngleWeight, double, 0.0, 0.99);
  vtkGetMacro(AngleWeight, double);
  ///@}

  ///@{
  /**
   * Whether the boundary points are free instead of on the boundary of the domain: the triangles keep
   * their areas, and their shapes are less distorted, most so if the surface was cut for it (FreeOutline
   * of vtkSurfaceToDiskFilter). The outline does not cross itself. If areas would be lost, the map stays
   * in the domain, and a warning says so. The input may be a disk in space then. It needs
   * FaceRefinement; an error says so. Default: off.
   */
  vtkSetMacro(FreeOutline, bool);
  vtkGetMacro(FreeOutline, bool);
  vtkBooleanMacro(FreeOutline, bool);
  ///@}

  ///@{
  /**
   * Number of neighbouring points that the transport takes together as one site, if FaceRefinement is
   * on: the transport then has to correct areas over whole regions only. On surfaces of less than some
   * thousand points it is reduced, and in narrow protrusions, where the scale of the conformal map
   * changes by more than a factor of e among neighbouring points, every point is a site. 1 makes every
   * point a site, as without refinement, where this setting is ignored. The points of a site share its
   * power cell, its weight and, in proportion to their target areas, the area of the cell. Range [1,
   * 1000]. Default: 16.
   */
  vtkSetClampMacro(PointsPerSite, int, 1, 1000);
  vtkGetMacro(PointsPerSite, int);
  ///@}

  ///@{
  /**
   * Convex polygon to map to, input port 1. Default, and after RemoveDomain(): none.
   */
  void SetDomainConnection(vtkAlgorithmOutput* polygon);
  void SetDomainData(vtkPolyData* polygon);
  void RemoveDomain();
  ///@}

  ///@{
  /**
   * Whether a boundary point goes to each corner of the polygon of port 1: the one whose power cell
   * contains the corner, or the nearest one that is free. A rectangular input without a polygon always
   * keeps its corners. Default: off.
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
  std::string WeightsInUse = "none";
  bool FaceRefinement = true;
  double AngleWeight = 0.0;
  int PointsPerSite = 16;
  bool FixCorners = false;
  bool FreeOutline = false;

private:
  vtkOMTAreaPreservingFilter(const vtkOMTAreaPreservingFilter&) = delete;
  void operator=(const vtkOMTAreaPreservingFilter&) = delete;
};

#endif
