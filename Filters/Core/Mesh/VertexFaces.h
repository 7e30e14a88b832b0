// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces around every vertex.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The rows of the faces around each vertex, in ascending order.
class VertexFaces
{
public:
  VertexFaces(const FaceMatrix& faces, int vertexCount);

  struct Range
  {
    const int* First;
    const int* Last;
    const int* begin() const { return this->First; }
    const int* end() const { return this->Last; }
    int size() const { return static_cast<int>(this->Last - this->First); }
  };
  int vertexCount() const { return static_cast<int>(this->Starts.size()) - 1; }

  Range operator[](int vertex) const
  {
    const int* rows = this->Rows.data();
    return { rows + this->Starts[vertex], rows + this->Starts[vertex + 1] };
  }

  /// The faces around that one of two vertices which has fewer. All faces with both vertices are among
  /// them.
  Range aroundEither(int a, int b) const
  {
    const Range aroundA = (*this)[a];
    const Range aroundB = (*this)[b];
    return aroundB.size() < aroundA.size() ? aroundB : aroundA;
  }

private:
  std::vector<int> Starts; // where the part of each vertex begins in Rows, and the end
  std::vector<int> Rows;
};

} // namespace flattening
