// SPDX-License-Identifier: GPL-3.0-or-later
/// The energy of a flat map under a smooth deformation of the plane.
#pragma once

#include "Areas/DeformationLattice.h"
#include "Areas/LatticeMatrix.h"
#include "Areas/RefinementTerms.h"
#include "Transport/ConvexDomain.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace flattening
{

/// For a deformation with the derivative F, the sum over the faces of the map
///   T (s phi + W (r det F - 1)^2).
/// Here T is the target area of a face, r its flat area before the deformation over T, W the area
/// weight, and s the shape weight relative to that of a face that is no sliver. phi is the face's ratio
/// of Dirichlet energy to area, times its greatest slope in the sum that is to fall: that of the
/// logarithms of the ratios, which go on as straight lines where a face is stretched by more than 12 to
/// 1. As the ratios are weighted so, each deformation lowers that sum (majorisation).
///
/// F is taken as constant in the small squares that each square of the lattice is divided into. The
/// faces of a small square then enter by three sums, so that the energy takes the same time for any
/// number of faces. Every small square also keeps its own shape and orientation, with a weight that is
/// small except for det F -> 0. So does the plane around the map, and parts of the outline do not run
/// into each other.
class DeformationEnergy
{
public:
  /// Which shapes the faces should have.
  enum class Shapes
  {
    OfSurface, ///< those of the surface
    OfMap      ///< those of the map: phi is that of similar faces, and nothing moves but for areas
  };

  /// Sums up the faces of @p terms at @p positions (n x 2, in the box of @p lattice), all of them
  /// positive, with the target areas @p targets (m, > 0). @p lattice must live as long as this does.
  DeformationEnergy(const DeformationLattice& lattice,
    const RefinementTerms& terms,
    const Points2& positions,
    const Eigen::VectorXd& targets,
    Shapes shapes = Shapes::OfSurface);

  /// A point of the map on the boundary of a domain.
  struct BoundaryPoint
  {
    Eigen::Vector2d Place;
    double Length; ///< of the boundary that it stands for
    bool Stays;    ///< whether it may not slide along the boundary
  };
  /// Keeps @p points on the boundary of @p domain, which must live as long as this does: their squared
  /// distances from it count with a large weight.
  void keepOnBoundary(const ConvexDomain& domain, const std::vector<BoundaryPoint>& points);

  /// Sets W, > 0.
  void setAreaWeight(double weight) { this->AreaWeight = weight; }

  /// The energy of the nodes' @p displacements (k x 2); infinite if det F <= 0 in a small square.
  double value(const Points2& displacements) const;
  /// The same with its derivatives by the displacements (2 k, x and y of each node in turn): the
  /// gradient, and the second derivative, to which every small square contributes its positive
  /// semidefinite part. @p hessian must have been made for the same lattice.
  double derivatives(const Points2& displacements,
    Eigen::VectorXd& gradient,
    LatticeMatrix& hessian) const;

private:
  struct Square // a small one
  {
    DeformationLattice::Influence Influence; // on its centre
    Eigen::Matrix2d Shape;                   // G: the shapes count as tr(F G F^T) / det F
    double Target;                           // sum of the faces' targets
    double Ratio;                            // flat area of the faces over their targets
  };
  struct KeptPoint // on the boundary of the domain
  {
    BoundaryPoint Point;
    DeformationLattice::Influence Influence;
  };
  struct SquareTerm;
  struct WayOff;   // of a kept point
  struct NodeTerm; // of the nodes that move a square of the lattice
  void addSquares(double weight);
  std::size_t squareOf(const Eigen::Vector2d& point) const;
  static Eigen::Matrix2d derivativeOf(const Square& square, const Points2& displacements);
  double energyOf(const Square& square, const Eigen::Matrix2d& f) const;
  SquareTerm term(const Square& square, const Points2& displacements) const;
  double energyOf(const KeptPoint& kept, const Points2& displacements) const;
  WayOff wayOff(const KeptPoint& kept, const Points2& displacements) const;
  void addTo(NodeTerm& sum, const Square& square, const Points2& displacements) const;
  void addTo(NodeTerm& sum, const KeptPoint& kept, const Points2& displacements) const;
  std::vector<NodeTerm> nodeTerms(const Points2& displacements) const;

  const DeformationLattice& Lattice;
  std::vector<Square> Squares; // by squares of the lattice, row by row
  const ConvexDomain* Domain = nullptr;
  std::vector<std::vector<KeptPoint>> Kept; // per square of the lattice, or empty
  double AreaWeight = 1.0;
};

} // namespace flattening
