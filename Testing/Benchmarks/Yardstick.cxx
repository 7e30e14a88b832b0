// SPDX-License-Identifier: GPL-3.0-or-later
#include "Yardstick.h"

#include <algorithm>
#include <vector>

namespace flattening::benchmarks
{

SparseMatrix meshLaplacian(const TriangleMesh& mesh)
{
  std::vector<Eigen::Triplet<double>> entries{ { 0, 0, 1.0 } };
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = mesh.Faces(f, k);
      const int j = mesh.Faces(f, (k + 1) % 3);
      entries.emplace_back(i, i, 0.5);
      entries.emplace_back(j, j, 0.5);
      entries.emplace_back(std::max(i, j), std::min(i, j), -0.5);
    }
  }
  SparseMatrix laplacian(mesh.vertexCount(), mesh.vertexCount());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

} // namespace flattening::benchmarks
