// SPDX-License-Identifier: GPL-3.0-or-later
/// The minimisation of the refinement energy in patches of the mesh.
#pragma once

#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementTerms.h"
#include "Base/Progress.h"
#include "Mesh/VertexFaces.h"

#include <tbb/enumerable_thread_specific.h>

#include <vector>

namespace flattening
{

/// A domain decomposition (Schwarz iteration): each pass divides the mesh into patches of about two
/// thousand vertices along other lines of a chart, and minimises the energy in every patch while the
/// vertices between patches stay. Most errors of a transported map are local, so that patches are
/// enough; they are independent of each other, and the time grows linearly with the number of vertices.
class RefinementPatches
{
public:
  /// Most vertices of a patch: factors of systems of this size fit into a cache.
  static constexpr int LargestPatch = 2000;
  /// A face is right if its area is off by at most this share of its target: the limit that users see in
  /// "faces within 2 %".
  static constexpr double AreaTolerance = 0.02;

  /// @p chart (n x 2) is a map in which patches are compact, such as the conformal map, whose small
  /// parts have the shapes that they have on the surface. In the map that is refined, faces may be
  /// stretched a thousand to one along the boundary. A patch that is compact there is a few faces long
  /// along the boundary and hundreds wide across it, so that area hardly moves along the boundary:
  /// beside a small hole the passes took a quarter longer and left 1.5 instead of 1.3 % of the faces
  /// wrong. The arguments must live as long as this does.
  RefinementPatches(const RefinementTerms& terms,
    const VertexFaces& facesOf,
    const DegreesOfFreedom& dofs,
    const Points2& chart);

  /// The energy of one pass.
  struct Pass
  {
    Eigen::VectorXd Targets;      ///< per face (m), with the area that the boundary encloses as sum
    Eigen::VectorXd AreaWeights;  ///< per face (m), see FaceAreaEnergy
    Eigen::VectorXd Counts;       ///< the same
    double Epsilon = 0.0;         ///< see FaceAreaEnergy
    double ShapeFactor = 1.0;     ///< factor of the terms' shape weights
    bool KeepsOrientation = true; ///< whether faces may not flip (RefinementDescent)
    int Number = 0;               ///< of the pass: each divides the mesh along other lines
    int MostRounds = 2;           ///< of steps in a patch; it ends earlier if they gain little
    /// Per vertex (n), whether it may move. If this is empty, all may, and patches are left out in which
    /// few faces are not right.
    std::vector<char> Moving;
  };

  /// Minimises the energy in the patches, and returns how many of them needed it. If only some vertices
  /// may move, each connected group of these is a patch, or several if it is larger than LargestPatch.
  int run(const Pass& pass, DomainMap& map, const ProgressCallback& progress);

private:
  class Patch;
  std::vector<std::vector<int>> parts(const Pass& pass) const;
  std::vector<int> connectedGroup(int first,
    const std::vector<char>& moving,
    std::vector<char>& isFound) const;
  // A vertex stays if it has a neighbour in an earlier part.
  bool moves(int vertex, const std::vector<int>& partOf) const;

  const RefinementTerms& Terms;
  const VertexFaces& FacesOf;
  const DegreesOfFreedom& Dofs;
  const Points2& Chart;
  // Each thread numbers the vertices of the patch that it sets up; all others have -1.
  mutable tbb::enumerable_thread_specific<std::vector<int>> LocalOf;
};

} // namespace flattening
