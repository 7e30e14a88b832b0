// SPDX-License-Identifier: GPL-3.0-or-later
/// The intersecting faces of a surface that changes step by step.
#pragma once

#include "Base/Progress.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace flattening
{

/// Knows which faces of a mesh intersect, as intersectingPairs finds them, and finds them sooner for a
/// mesh that differs from it in few faces: faces with the same corners need not be compared again.
class TrackedIntersections
{
public:
  using Pairs = std::vector<std::pair<int, int>>;

  /// Looks at another mesh: at its new faces alone, or at all if a quarter of them are new. A face is
  /// new unless a face of the mesh before lies on the same points and shares the same corners with
  /// others.
  /// @throws Cancelled; the next mesh is then looked at as the first one is.
  void update(const TriangleMesh& mesh, const ProgressCallback& progress = {});

  /// The number of intersecting pairs of the mesh; 0 before the first one.
  std::size_t count() const { return this->Count; }
  /// The pairs of faces (i < j, sorted) if there are no more of them than faces. More are not kept: ten
  /// thousand faces can have fifty million.
  const std::optional<Pairs>& pairs() const { return this->Known; }

private:
  TriangleMesh Mesh;
  std::size_t Count = 0;
  std::optional<Pairs> Known = Pairs();
};

} // namespace flattening
