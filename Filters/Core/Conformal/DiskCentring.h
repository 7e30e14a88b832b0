// SPDX-License-Identifier: GPL-3.0-or-later
/// Which point of the surface a map to the disk puts at the centre, whatever the map's method.
#pragma once

#include "Conformal/DiskNormalisation.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/TriangleMesh.h"

#include <complex>

namespace flattening
{

class DiskCentring
{
public:
  /// The surface's area, one third of every face at each of its corners, has its centroid at 0.
  explicit DiskCentring(const TriangleMesh& mesh);
  /// Vertex @p vertex of @p mesh goes to 0.
  DiskCentring(const TriangleMesh& mesh, int vertex);

  /// The vertex at 0, or -1.
  int vertex() const { return this->Vertex; }
  /// Shares of the vertices in what is centred, of sum 1: sum_i weight_i position_i is to be 0.
  const Eigen::VectorXd& weights() const { return this->Weights; }

  /// The point that the Cayley map must send to 0, for the positions of all vertices in the half-plane.
  /// @throws ConvergenceError as centreOfMass
  std::complex<double> centre(const ComplexVector& halfPlane) const;

private:
  int Vertex = -1;
  Eigen::VectorXd Weights;
};

} // namespace flattening
