// SPDX-License-Identifier: GPL-3.0-or-later
/// Untangling of a flat map whose outline is free to move.
#pragma once

#include "Base/Progress.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/TriangleMesh.h"
#include "Mesh/VertexFaces.h"
#include "Untangling/MapUntangling.h"

#include <vector>

namespace flattening
{

/// Makes the flat map @p positions (n x 2) one-to-one near where faces are flipped or edges of its
/// outline cross: it untangles the faces (untangleMap) and frees the vertices of the outline there,
/// which faces with all their vertices on the outline need. The gaps beside the outline (outlineGaps)
/// count as faces, so that no part of the outline moves across another.
/// @param outline  the edges of the boundary
/// @param before   positions near these (n x 2) at which no edges of the outline cross. The gaps are
///                 found there, and should keep the shapes that they have there.
/// @throws Cancelled.
void untangleWithOutline(const FaceMatrix& faces,
  const VertexFaces& facesOf,
  const std::vector<FlatEdge>& outline,
  const Points2& before,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options = {},
  const ProgressCallback& progress = {});

/// Makes the flat map @p positions (n x 2) of a disk with the boundary @p loop one-to-one, if its
/// outline does not cross itself. The outline moves only where faces cannot be untangled otherwise.
/// Returns whether the map is one-to-one afterwards. @throws Cancelled.
bool makeOneToOne(const FaceMatrix& faces,
  const std::vector<int>& loop,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
