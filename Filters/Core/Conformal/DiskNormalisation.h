// SPDX-License-Identifier: GPL-3.0-or-later
/// Normalisation of a conformal disk: Moebius maps from the half-plane, the centre and the rotation.
#pragma once

#include "Mesh/ComplexPositions.h"
#include "Mesh/TriangleMesh.h"

#include <complex>
#include <optional>
#include <vector>

namespace flattening
{

/// The Cayley map (z - centre) / (z - conj(centre)), which takes the upper half-plane onto the unit
/// disk, @p centre to 0 and infinity to 1. Infinite entries of @p halfPlane are allowed.
ComplexVector cayley(const ComplexVector& halfPlane, std::complex<double> centre);

/// Moves the given vertices of @p disk radially onto the unit circle.
void moveToCircle(const std::vector<int>& vertices, ComplexVector& disk);

/// The point of the half-plane for which the Cayley map m puts the centre of mass of the images at 0:
/// sum_i mass_i m(z_i) = 0, the conformal barycentre (docs/mathematics.md, "Conformal map"). It is
/// unique if no point on the boundary carries half of the mass.
/// @param masses  >= 0, one per point
/// @throws ConvergenceError if Newton's method does not converge.
std::complex<double> centreOfMass(const ComplexVector& halfPlane, const Eigen::VectorXd& masses);

/// The angle (radians) by which to rotate @p disk about 0 so that the weighted mean of its vertices
/// comes to lie on the positive real axis. The weight of a vertex is its mass times its distance in
/// space from the centroid of @p surface. The orientation of the rotated disk thus depends on the shape
/// of the surface alone, not on the numbering of its vertices or its position in space. None if the
/// weighted mean is 0 up to rounding, as the surface is too symmetric.
std::optional<double> intrinsicRotation(const ComplexVector& disk,
  const Points3& surface,
  const Eigen::VectorXd& masses);

/// The rule that tells which point of the surface a map to the disk puts at the centre.
class DiskCentring
{
public:
  /// The map is centred if the centroid of its vertices is at 0, where the weight of a vertex is a third
  /// of the area on the surface of each face around it.
  explicit DiskCentring(const TriangleMesh& mesh);
  /// Vertex @p vertex of @p mesh goes to 0.
  DiskCentring(const TriangleMesh& mesh, int vertex);

  /// The vertex at 0, or -1.
  int vertex() const { return this->Vertex; }
  /// One weight per vertex, of sum 1: a map is centred if sum_i weight_i position_i = 0.
  const Eigen::VectorXd& weights() const { return this->Weights; }

  /// The point that the Cayley map must send to 0, given the positions of all vertices in the
  /// half-plane.
  /// @throws ConvergenceError as centreOfMass
  std::complex<double> centre(const ComplexVector& halfPlane) const;
  /// The same, or the medians of the coordinates if the positions are too coarse for it.
  std::complex<double> roughCentre(const ComplexVector& halfPlane) const;

private:
  int Vertex = -1;
  Eigen::VectorXd Weights;
};

} // namespace flattening
