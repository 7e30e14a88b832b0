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
/// weights w_i (paper, equations 3 and 4; w_i = 2 h_i + |y_i|^2). Their sides are straight, the rest of
/// a cell's boundary is that of the domain; areas, centroids and side lengths count both exactly.
///
/// Weights have twice the precision of double because cells depend on their differences divided by the
/// distance of the sites, which in the horns of a surface is 1e-15 and less. The triangulation behind
/// the cells is exact for them.
///
/// The sites stay, the weights change: what depends on the sites alone is done once.
class PowerDiagram
{
public:
  using Weights = Eigen::Matrix<DoubleDouble, Eigen::Dynamic, 1>;

  /// @p sites n x 2, n >= 3, pairwise distinct, not all on a line.
  explicit PowerDiagram(const Points2& sites,
    std::shared_ptr<const ConvexDomain> domain = std::make_shared<UnitDisk>());

  /// Computes the cells for @p weights (n, same unit as squared lengths). Returns false, and leaves the
  /// cells undefined, if more than @p largestHidden sites have no cell in the plane; theirs have area 0.
  bool update(const Weights& weights, int largestHidden = 0);

  int siteCount() const { return static_cast<int>(this->Sites.rows()); }
  const Points2& sites() const { return this->Sites; }
  const ConvexDomain& domain() const { return *this->Domain; }
  /// Diagrams computed so far, failed ones included.
  int updates() const { return this->Updates; }

  /// The sites without a cell in the plane, and by how much their weight would have to be larger to have
  /// one.
  struct HiddenSite
  {
    int Site;
    double Lacking; ///< weight, >= 0
  };
  const std::vector<HiddenSite>& hiddenSites() const { return this->HiddenSites; }

  /// Area of every cell in the domain (n). Zero for a cell outside.
  const Eigen::VectorXd& areas() const { return this->Areas; }
  /// Centroid of every cell in the disk (n x 2); the site itself for a cell without area.
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

  /// The middle of the part of the domain's boundary that a cell has, as a place (ConvexDomain.h), and
  /// its length; length 0 if the cell does not reach the boundary. With several parts: the longest.
  struct BoundaryPart
  {
    double Middle = 0.0;
    double Length = 0.0;
  };
  BoundaryPart boundaryPart(int site) const;

  /// Outline of a cell, counter-clockwise, arcs as polylines with steps of at most @p maximumStep
  /// radians. Empty for a cell outside the domain.
  std::vector<Eigen::Vector2d> outline(int site, double maximumStep) const;

private:
  // Half-edges 3 f + k of the regular triangulation's finite faces, as in IntrinsicTriangulation.
  struct Segment
  {
    Eigen::Vector2d From;
    Eigen::Vector2d To;
    bool FromOnBoundary;
    bool ToOnBoundary;
    bool Inside; ///< false: no part in the domain
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
  std::vector<std::size_t> Order; ///< space-filling order for insertion
  Weights SiteWeights;
  int Updates = 0;

  std::vector<int> Origins;
  std::vector<int> Twins;    ///< -1 on the convex hull
  std::vector<int> Outgoing; ///< per site; the hull's half-edge where there is one, -1 without a cell
  std::vector<Eigen::Vector2d> Centres; ///< per face: the point of equal power
  std::vector<HiddenSite> HiddenSites;
  std::vector<int> HiddenIn;     ///< per hidden site: the face that covers it
  std::vector<Segment> Segments; ///< per half-edge that stands for its edge (the lower of the two)
  std::vector<CommonSide> Sides;
  Eigen::VectorXd Areas;
  Points2 Centroids;
};

} // namespace flattening
