// SPDX-License-Identifier: GPL-3.0-or-later
/// What face refinement minimises: the sum over all faces and boundary edges of a flat map.
#pragma once

#include "Areas/DegreesOfFreedom.h"
#include "Areas/FaceAreaEnergy.h"
#include "Areas/RefinementTerms.h"
#include "Base/SparseFactorization.h"
#include "Mesh/VertexFaces.h"

#include <vector>

namespace flattening
{

/// The energies of all faces (FaceAreaEnergy), and for every gap between neighbours on the boundary,
/// rho of its share by length on the surface, rho - 1 - log rho with a small weight, which keeps
/// boundary vertices in their order as they slide. Sums do not depend on the number of threads.
class RefinementEnergy
{
public:
  /// @p facesOf of the terms' faces. The arguments must live as long as this does.
  RefinementEnergy(const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& unknowns);

  /// @p targets (m, > 0) sum up to what the boundary is taken to enclose; see setEnclosed().
  void setTargets(const Eigen::VectorXd& targets) { this->Targets = targets; }
  /// 0: faces that flip cost infinitely much.
  void setEpsilon(double epsilon);
  /// The targets are scaled to the area that the boundary of @p state encloses.
  void setEnclosed(const FlatState& state);
  double targetOf(int face) const { return this->Scale * this->Targets[face]; }

  double value(const FlatState& state) const;
  /// Returns the value.
  double gradient(const FlatState& state, Eigen::VectorXd& gradient);

  /// Positive semidefinite and nearly the second derivative: where the exact one of an area could be
  /// indefinite, a bound of it, for |ByArea| times the area of a displacement is at most that times its
  /// Dirichlet energy. Of the map of the last gradient(); lower triangle, the same pattern every time.
  const SparseMatrix& hessian(const FlatState& state);

  /// Signed areas of all faces over their targets.
  Eigen::VectorXd areaRatios(const FlatState& state) const;

private:
  struct FlatFace;
  FlatFace flatFace(const Points2& positions, int face) const;
  FaceAreaEnergy::Value faceValue(const FlatFace& flat, int face) const;
  double gapValue(const FlatState& state,
    const BoundaryGap& gap,
    double& slope,
    double& curvature) const;
  Eigen::Matrix2d block(const FlatFace& flat, int face, int a, int b) const;
  void findPattern();
  void addVertexBlocks(const FlatState& state, int vertex);

  const RefinementTerms& Terms;
  const VertexFaces& FacesOf;
  const DegreesOfFreedom& Unknowns;
  FaceAreaEnergy Energy;
  Eigen::VectorXd Targets;
  double Scale = 1.0;
  std::vector<FaceAreaEnergy::Value> Values; // of the last gradient
  SparseMatrix Hessian;
  std::vector<int> Rows; // per face and ordered pair of its corners: the block's first row in its column
};

} // namespace flattening
