// SPDX-License-Identifier: GPL-3.0-or-later
/// The energy that face refinement minimises: a sum over the faces and boundary edges of a flat map.
#pragma once

#include "Areas/DegreesOfFreedom.h"
#include "Areas/FaceAreaEnergy.h"
#include "Areas/RefinementTerms.h"
#include "Base/SparseFactorization.h"
#include "Mesh/VertexFaces.h"

#include <vector>

namespace flattening
{

/// The sum of the energies of all faces (FaceAreaEnergy) and of all intervals between neighbours on the
/// boundary. With rho, the length of an interval over its share by length on the surface, its energy is
/// rho - 1 - log rho, with a small weight: boundary vertices keep their order as they slide. A tiny
/// interval, whose face is a sliver without a shape to keep, has the energy (rho / 3 - 1)^2 beyond
/// rho = 3 as well. Sums do not depend on the number of threads.
class RefinementEnergy
{
public:
  /// @p facesOf holds the faces of @p terms. The arguments must live as long as this does.
  RefinementEnergy(const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& dofs);

  /// Sets the target areas (m, > 0), up to a common factor; see setEnclosed(). @p areaWeights and
  /// @p counts (m, > 0) are those of FaceAreaEnergy.
  void setTargets(const Eigen::VectorXd& targets,
    const Eigen::VectorXd& areaWeights,
    const Eigen::VectorXd& counts)
  {
    this->Targets = targets;
    this->AreaWeights = areaWeights;
    this->Counts = counts;
  }
  /// Sets epsilon of FaceAreaEnergy, >= 0; with 0 the energy of flipped faces is infinite.
  void setEpsilon(double epsilon);
  /// Scales the targets to the area that the boundary of @p map encloses.
  void setEnclosed(const DomainMap& map);
  /// The scaled targets (m).
  Eigen::VectorXd targets() const { return this->Scale * this->Targets; }

  /// Returns the energy of @p map, and keeps what its derivatives are made of.
  double evaluate(const DomainMap& map);

  /// The derivative by the degrees of freedom, for the map of the last evaluate().
  Eigen::VectorXd gradient(const DomainMap& map) const;

  /// A positive semidefinite approximation of the second derivative, for the map of the last evaluate();
  /// lower triangle, always with the same pattern. The second derivative of an area is indefinite; it is
  /// replaced by a bound: the area of a displacement is at most its Dirichlet energy.
  const SparseMatrix& hessian(const DomainMap& map);

  /// Signed areas of all faces over their targets.
  Eigen::VectorXd areaRatios(const DomainMap& map) const;

private:
  struct FlatFace;
  struct IntervalTerm // of an interval, with its derivatives by the length
  {
    double Energy;
    double Slope;
    double Curvature;
  };
  FlatFace flatFace(const Points2& positions, int face) const;
  double evaluateFace(const Points2& positions, int face);
  FaceAreaEnergy::Value faceValue(const FlatFace& flat, int face) const;
  IntervalTerm intervalTerm(const DomainMap& map, const BoundaryInterval& interval) const;
  int cornerOf(int vertex, int face) const;
  Eigen::Matrix2d block(const FlatFace& flat, int face, int a, int b) const;
  std::vector<int> higherNeighbours(int vertex) const;
  void findBlockRows(int vertex, const std::vector<int>& neighbours);
  void findPattern();
  void addVertexBlocks(const DomainMap& map, int vertex);

  const RefinementTerms& Terms;
  const VertexFaces& FacesOf;
  const DegreesOfFreedom& Dofs;
  FaceAreaEnergy Energy;
  Eigen::VectorXd Targets;
  Eigen::VectorXd AreaWeights;
  Eigen::VectorXd Counts;
  double Scale = 1.0;
  // The energies of the faces of the map that was evaluated last, and their derivatives by the positions
  // of its corners (three per face).
  std::vector<FaceAreaEnergy::Value> Values;
  std::vector<Eigen::Vector2d> Slopes;
  SparseMatrix Hessian;
  // Per face and ordered pair of its corners: where the pair's block begins in its columns, or -1.
  std::vector<int> Rows;
};

} // namespace flattening
