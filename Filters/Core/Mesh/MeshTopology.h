// SPDX-License-Identifier: GPL-3.0-or-later
/// Connectivity of a triangle mesh: boundary loops, components, genus, and the checks of a disk.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Numbers that describe how a surface is connected, and its boundary.
struct MeshTopology
{
  int Vertices = 0; ///< vertices used by at least one face
  int Edges = 0;
  int Faces = 0;
  int Components = 0;
  int Genus = 0; ///< number of handles of all components together
  /// The vertices of each boundary loop, in the direction that has the surface on its left. A loop
  /// starts with its smallest vertex. Loops with more edges come first, and of equals the one with the
  /// smaller first vertex.
  std::vector<std::vector<int>> BoundaryLoops;

  int eulerCharacteristic() const { return this->Vertices - this->Edges + this->Faces; }
};

/// Analyses an oriented manifold mesh.
/// @throws InvalidInput if a face repeats a vertex or an index is out of range;
/// TopologyError if an edge has more than two faces, two faces disagree in orientation, or a vertex
/// joins surface parts that meet only there.
MeshTopology analyseTopology(const FaceMatrix& faces, int vertexCount);

/// Checks that the mesh can be flattened: finite coordinates, positive area, no unused vertex, manifold,
/// one component, genus 0, exactly one boundary loop. Returns that loop.
/// @throws InvalidInput, TopologyError with the cause and the remedy.
std::vector<int> requireDisk(const TriangleMesh& mesh);

} // namespace flattening
