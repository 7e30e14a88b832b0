// SPDX-License-Identifier: GPL-3.0-or-later
/// A short set of edges, the cut graph, along which a surface with handles opens into a disk.
#pragma once

#include "Base/Progress.h"
#include "Disk/EdgeCut.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Completes @p loops to a cut graph: edges of the mesh such that cutAlongEdges along all of them leaves
/// one disk. Cut along the loops alone, the surface has several boundaries: its own, and both sides of
/// every loop. A minimum spanning tree of shortest edge paths joins these boundaries (Mehlhorn 1988, "A
/// faster approximation algorithm for the Steiner problem in graphs"). The tree is at most twice as long
/// as the shortest set of edges that joins the boundaries. All paths belong to one search, so they may
/// merge but never cross, and no edge of the result is a dead end.
/// @param mesh connected oriented manifold, with or without boundary.
/// @param loops closed loops of vertices along edges, such as handleLoops finds. The surface, cut along
/// all of the loops, must be connected and of genus 0. A surface of genus 0 with boundary needs no
/// loops.
/// @return the edges of the loops and of the paths, in ascending order of their vertices.
/// @throws InvalidInput if a loop is not made of edges; TopologyError if the loops leave handles or
/// separate the surface, or if there is no boundary and no loop.
std::vector<MeshEdge> shortCutGraph(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress = {});

/// Cuts the surface along its cut graph. @throws as shortCutGraph, requireDisk.
CutSurface cutToDisk(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress = {});

} // namespace flattening
