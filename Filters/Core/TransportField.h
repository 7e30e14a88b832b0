// SPDX-License-Identifier: GPL-3.0-or-later
/// A smooth map through the centroids of transported cells.
#pragma once

#include "TriangleMesh.h"
#include "VertexFaces.h"

#include <vector>

namespace flattening
{

/// The optimal transport is a smooth map of the conformal disk, but the centroids of its cells follow it
/// only to about the size of a cell, and their order in slivers is lost. Every vertex that is not
/// @p fixed (n, not 0) is put where the affine map takes it that fits best, in the sense of least
/// squares with weights @p masses (n, > 0), how its neighbours and itself go from @p conformal (n x 2)
/// to
/// @p transported (n x 2). So faces keep, but for the stretch, the shapes that they have in the
/// conformal map. Vertices around which that map is degenerate stay where they were transported to.
Points2 transportField(const FaceMatrix& faces,
  const VertexFaces& facesOf,
  const Points2& conformal,
  const Points2& transported,
  const Eigen::VectorXd& masses,
  const std::vector<char>& fixed);

} // namespace flattening
