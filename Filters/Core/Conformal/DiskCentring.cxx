// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/DiskCentring.h"

#include "Mesh/ComplexPositions.h"

namespace flattening
{

DiskCentring::DiskCentring(const TriangleMesh& mesh)
  : Weights(vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), mesh.vertexCount()))
{
  this->Weights /= this->Weights.sum();
}

DiskCentring::DiskCentring(const TriangleMesh& mesh, int vertex)
  : Vertex(vertex)
  , Weights(Eigen::VectorXd::Unit(mesh.vertexCount(), vertex))
{
}

std::complex<double> DiskCentring::centre(const ComplexVector& halfPlane) const
{
  return this->Vertex >= 0 ? halfPlane[this->Vertex] : centreOfMass(halfPlane, this->Weights);
}

} // namespace flattening
