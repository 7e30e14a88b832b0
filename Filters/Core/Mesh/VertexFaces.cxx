// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/VertexFaces.h"

#include <numeric>

namespace flattening
{

VertexFaces::VertexFaces(const FaceMatrix& faces, int vertexCount)
  : Starts(vertexCount + 1, 0)
  , Rows(faces.size())
{
  for (Eigen::Index i = 0; i < faces.size(); ++i)
  {
    ++this->Starts[faces.data()[i] + 1];
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  std::vector<int> next(this->Starts.begin(), this->Starts.end() - 1);
  for (Eigen::Index i = 0; i < faces.size(); ++i)
  {
    this->Rows[next[faces.data()[i]]++] = static_cast<int>(i / 3);
  }
}

} // namespace flattening
