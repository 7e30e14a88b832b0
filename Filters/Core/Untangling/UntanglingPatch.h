// SPDX-License-Identifier: GPL-3.0-or-later
/// The part of a flat mesh that is freed to turn flipped faces over.
#pragma once

#include "Untangling/PatchUntangling.h"
#include "Untangling/UntanglingMesh.h"

#include <vector>

namespace flattening
{

/// Vertices that may move and all faces around them. Where a flipped face (one that is not safely
/// positive) is among these, its vertices may move too, so that patches that touch are one.
class UntanglingPatch
{
public:
  /// Frees the vertices of face @p face but the fixed ones. @p mesh must live as long as the patch does.
  /// With more than @p mostVertices free it is of no use, and grows no further.
  UntanglingPatch(const UntanglingMesh& mesh, int face, int mostVertices);

  /// Both in ascending order.
  const std::vector<int>& vertices() const { return this->Vertices; }
  const std::vector<int>& faces() const { return this->Faces; }

  /// Frees the vertices of all its faces. Returns false if there is none to free.
  bool grow();

  bool tooLarge() const { return static_cast<int>(this->Vertices.size()) > this->MostVertices; }

  /// A copy in coordinates around its own place, of its own size: doubles resolve them however small the
  /// patch is in the map. Where all faces are stretched alike, as in the neck of a horn, they are so in
  /// the coordinates no more: which faces are flipped does not change, and no shape is far from its
  /// target's.
  struct Local
  {
    FlatPatch Flat; ///< numbered as vertices() and faces(), and after these the rim's vertices
    Eigen::RowVector2d Origin;
    /// Places in the map are Origin + coordinates * Frame; 0 if there is nothing to free, or all of it
    /// lies in one place.
    Eigen::Matrix2d Frame = Eigen::Matrix2d::Zero();
  };
  Local local() const;

private:
  void free(int face);
  void includeFlippedFaces();

  const UntanglingMesh& Mesh;
  int MostVertices;
  std::vector<int> Vertices;
  std::vector<int> Faces;
};

} // namespace flattening
