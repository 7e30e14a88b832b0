// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConformalFactors.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// Least total length, in radii of the unit disk: a guard that keeps logarithms finite. Positions in the
// unit disk do not resolve shorter edges.
constexpr double LeastResolved = 1e-16;

std::vector<std::pair<int, int>> edgesOf(const FaceMatrix& faces)
{
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace_back(std::minmax({ faces(f, k), faces(f, (k + 1) % 3) }));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

} // namespace

Eigen::VectorXd logConformalFactors(const TriangleMesh& mesh,
  const Points2& positions,
  double addedLength)
{
  const int n = mesh.vertexCount();
  Eigen::VectorXd flat = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd surface = Eigen::VectorXd::Zero(n);
  for (const auto& [a, b] : edgesOf(mesh.Faces))
  {
    const double flatLength = (positions.row(a) - positions.row(b)).norm();
    const double length = (mesh.Vertices.row(a) - mesh.Vertices.row(b)).stableNorm() + addedLength;
    for (const int v : { a, b })
    {
      flat[v] += flatLength;
      surface[v] += length;
    }
  }
  return flat.array().max(LeastResolved).log() - surface.array().log();
}

} // namespace flattening
