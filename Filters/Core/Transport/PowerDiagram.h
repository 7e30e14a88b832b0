// SPDX-License-Identifier: GPL-3.0-or-later
/// The power diagram of weighted sites, clipped exactly to a convex domain.
#pragma once

#include "Base/DoubleDouble.h"
#include "Mesh/TriangleMesh.h"
#include "Transport/ConvexDomain.h"

#include <memory>
#include <vector>

namespace flattening
{

/// Cells W_i = { x in domain : |x - y_i|^2 - w_i <= |x - y_j|^2 - w_j for all j } of sites y_i with
/// weights w_i (paper, equations 3 and 4; w_i = 2 h_i + |y_i|^2). A cell is bounded by straight sides
/// and parts of the domain's boundary; areas, centroids and side lengths take both into account exactly.
///
/// Weights have twice the precision of double because cells depend on differences of weights divided by
/// the distance of the sites, which is 1e-15 and less in protrusions of a surface. The triangulation
/// behind the cells is exact for such weights.
///
/// The sites stay while the weights change: what depends on the sites alone is computed once.
class PowerDiagram
{
public:
  using Weights = Eigen::Matrix<DoubleDouble, Eigen::Dynamic, 1>;

  /// @p sites n x 2, n >= 3, pairwise distinct, not all on a line.
  explicit PowerDiagram(const Points2& sites,
    std::shared_ptr<const ConvexDomain> domain = std::make_shared<UnitDisk>());

  /// Computes the cells for @p weights (n, squared lengths). A site that has no cell in the plane is
  /// hidden; its area is 0. Returns false, and leaves the cells undefined, if more than @p largestHidden
  /// sites are.
  bool update(const Weights& weights, int largestHidden = 0);

  int siteCount() const { return static_cast<int>(this->Sites.rows()); }
  const Points2& sites() const { return this->Sites; }
  const ConvexDomain& domain() const { return *this->Domain; }
  /// The number of diagrams computed so far, failed ones included.
  int updates() const { return this->Updates; }

  /// A site without a cell in the plane, and the increase of its weight with which it would get one.
  struct HiddenSite
  {
    int Site;
    double Lacking; ///< weight, >= 0
  };
  const std::vector<HiddenSite>& hiddenSites() const { return this->HiddenSites; }

  /// The area of every cell inside the domain (n); 0 for a cell outside.
  const Eigen::VectorXd& areas() const { return this->Areas; }
  /// The centroid of every cell inside the domain (n x 2); the site itself for a cell without area.
  const Points2& centroids() const { return this->Centroids; }

  /// A common side of two cells: its length inside the domain and the distance of the sites.
  /// The area of either cell changes by -slope() per unit of the other site's weight.
  struct CommonSide
  {
    int First;
    int Second;
    double Length;
    double Distance;
    double slope() const { return this->Length / (2.0 * this->Distance); }
  };
  const std::vector<CommonSide>& commonSides() const { return this->Sides; }

  /// The longest part of the domain's boundary that belongs to a cell.
  struct BoundaryPart
  {
    double Middle = 0.0; ///< boundary parameter (ConvexDomain.h)
    double Length = 0.0; ///< 0 if the cell does not reach the boundary
  };
  BoundaryPart boundaryPart(int site) const;

  /// The outline of a cell, counter-clockwise, with arcs as polylines of at most @p maximumStep radians
  /// a step. Empty for a cell outside the domain.
  std::vector<Eigen::Vector2d> outline(int site, double maximumStep) const;

private:
  // A side of a cell, cut to the domain.
  struct Segment
  {
    Eigen::Vector2d From;
    Eigen::Vector2d To;
    bool FromOnBoundary;
    bool ToOnBoundary;
    bool Inside; // whether any part lies in the domain
  };

  bool triangulate(int largestHidden);
  double weightDifference(int from, int to) const;
  double squaredLength(int halfedge) const;
  void placeCentres();
  void measureHidden();
  void clipSides();
  void measureCells();
  Segment sideOf(int site, int halfedge) const;
  void sidesOf(int site, std::vector<Segment>& sides) const;
  bool coversDomain(int site) const;

  std::shared_ptr<const ConvexDomain> Domain;
  Points2 Sites;
  std::vector<std::size_t> Order; // of insertion, along a space-filling curve
  Weights SiteWeights;
  int Updates = 0;

  // Side k of face f of the regular triangulation is the half-edge 3 f + k.
  std::vector<int> Origins;  // per half-edge: the site where it begins
  std::vector<int> Twins;    // per half-edge: the opposite one, -1 on the convex hull
  std::vector<int> Outgoing; // per site: a half-edge, on the hull if it lies there; -1 if it is hidden
  std::vector<Eigen::Vector2d> Centres; // per face: the point of equal power
  std::vector<HiddenSite> HiddenSites;
  std::vector<int> HiddenIn;     // per hidden site: the face that covers it
  std::vector<Segment> Segments; // per edge, at the lower of its two half-edges
  std::vector<CommonSide> Sides;
  Eigen::VectorXd Areas;
  Points2 Centroids;
};

} // namespace flattening
