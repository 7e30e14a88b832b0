// SPDX-License-Identifier: GPL-3.0-or-later
/// The part of a flat map whose vertices may move while flipped faces are untangled.
#pragma once

#include "Base/Progress.h"
#include "Untangling/PatchUntangling.h"
#include "Untangling/UntanglingMesh.h"

#include <vector>

namespace flattening
{

/// A set of free vertices, which may move, with all faces around them. The corners of a flipped face
/// (one that is not safely positive) among these faces are free too, so that clusters of flipped faces
/// that touch lie in one patch.
class UntanglingPatch
{
public:
  /// Frees the corners of face @p face that are not fixed. @p mesh must outlive the patch. A patch
  /// with more than @p mostVertices free vertices is too large (see tooLarge()): it must not be used,
  /// as the corners of some of its flipped faces may not be free. While the patch grows, it reports to
  /// @p progress, which must outlive it, too. @throws Cancelled.
  UntanglingPatch(const UntanglingMesh& mesh,
    int face,
    int mostVertices,
    const ProgressCallback& progress);

  /// The free vertices in ascending order.
  const std::vector<int>& vertices() const { return this->Vertices; }
  /// The faces around the free vertices in ascending order.
  const std::vector<int>& faces() const { return this->Faces; }

  /// Frees the corners of all faces of the patch. Returns false if all these corners were free or
  /// fixed already. @throws Cancelled.
  bool grow();

  bool tooLarge() const { return static_cast<int>(this->Vertices.size()) > this->MostVertices; }

  /// A copy of the patch in coordinates of its own, relative to one of its vertices and in units of
  /// its size. Doubles resolve these coordinates however small the patch is in the map. Where all
  /// faces are stretched alike, as in the neck of a protrusion, the coordinates undo the stretch.
  /// Undoing it flips no face and untangles none, but brings the shapes of all faces close to their
  /// targets.
  struct Local
  {
    FlatPatch Flat; ///< vertices() and then those of the rim; faces()
    Eigen::RowVector2d Origin;
    /// Positions in the map are Origin + coordinates * Frame. The frame is 0 if there is no free vertex
    /// or all vertices coincide.
    Eigen::Matrix2d Frame = Eigen::Matrix2d::Zero();
  };
  Local local() const;

private:
  void free(int face);
  void includeFlippedFaces();

  const UntanglingMesh& Mesh;
  int MostVertices;
  const ProgressCallback& Progress;
  std::vector<int> Vertices;
  std::vector<int> Faces;
};

} // namespace flattening
