// SPDX-License-Identifier: GPL-3.0-or-later
/// The minimisation of the refinement energy in patches of the mesh.
#pragma once

#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementTerms.h"
#include "Base/Progress.h"
#include "Mesh/VertexFaces.h"

#include <vector>

namespace flattening
{

/// Additive Schwarz iteration: the mesh is divided into patches of some thousand vertices, of which
/// those between two patches stay; in each patch the energy is minimised on its own. What is wrong
/// with a map that came out of a transport is so at the scale of the faces, and a patch costs little:
/// time grows as the number of vertices, and patches are independent of each other. The next pass
/// divides the mesh along other lines.
class RefinementPatches
{
public:
  /// Vertices: factors of systems of this size fit into a cache.
  static constexpr int LargestPatch = 2000;
  /// Of its target: a face is right if its area is off by no more.
  static constexpr double AreaTolerance = 0.02;

  /// The arguments must live as long as this does.
  RefinementPatches(const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& dofs);

  struct Pass
  {
    Eigen::VectorXd Targets;      ///< per face, in sum what the boundary encloses
    double Epsilon = 0.0;         ///< FaceAreaEnergy
    double ShapeFactor = 1.0;     ///< times the terms' shape weights
    bool KeepsOrientation = true; ///< RefinementDescent
  };

  /// In patches where too many faces are not right. Returns how many patches that were.
  int run(const Pass& pass, DomainMap& map, const ProgressCallback& progress);

private:
  class Patch;

  const RefinementTerms& Terms;
  const VertexFaces& FacesOf;
  const DegreesOfFreedom& Dofs;
  int Passes = 0;
};

} // namespace flattening
