// SPDX-License-Identifier: GPL-3.0-or-later
#include "HalfPlaneLayout.h"

#include "Errors.h"
#include "SparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Of the layout's extent. Along a horn of the surface lengths fall exponentially, past what doubles tell
// apart.
constexpr double LeastResolved = 1e-11;
const Complex Infinity(std::numeric_limits<double>::infinity(), 0.0);

// Places the boundary of the finite part: the surface's boundary on the real axis in order, then the
// link of the vertex at infinity, whose shape the angles at its vertices tell. Returns which vertices it
// placed.
std::vector<char> layOutBoundary(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstOnAxis,
  int lastOnAxis,
  ComplexVector& position)
{
  std::vector<double> angle(t.vertexCount(), 0.0);
  for (int f = 0; f < t.faceCount(); ++f)
  {
    const TriangleAngles angles = triangleAngles(
      t.scaledLogLength(3 * f, u), t.scaledLogLength(3 * f + 1, u), t.scaledLogLength(3 * f + 2, u));
    for (int k = 0; k < 3; ++k)
    {
      angle[t.origin(t.previous(3 * f + k))] += angles.Angle[k];
    }
  }
  std::vector<char> placed(t.vertexCount(), 0);
  position[firstOnAxis] = 0.0;
  placed[firstOnAxis] = 1;
  double heading = 0.0;
  std::vector<int> link{ lastOnAxis };
  bool onAxis = true;
  for (int v = firstOnAxis;;)
  {
    const int h = t.anyOutgoing()[v];
    const int next = t.tip(h);
    const Complex place =
      position[v] + std::polar(std::exp(static_cast<double>(t.scaledLogLength(h, u))), heading);
    if (next == firstOnAxis)
    {
      // Spread what rounding left open over the link.
      const Complex gap = -place;
      for (std::size_t k = 1; k < link.size(); ++k)
      {
        position[link[k]] += gap * (static_cast<double>(k) / link.size());
      }
      return placed;
    }
    position[next] = place;
    placed[next] = 1;
    if (!onAxis)
    {
      link.push_back(next);
    }
    onAxis = onAxis && next != lastOnAxis;
    heading = onAxis ? 0.0 : heading + EIGEN_PI - angle[next];
    v = next;
  }
}

} // namespace

ComplexVector layOutInHalfPlane(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstOnAxis,
  int lastOnAxis)
{
  ComplexVector position(t.vertexCount(), Infinity);
  const std::vector<char> placed = layOutBoundary(t, u, firstOnAxis, lastOnAxis, position);
  std::vector<int> row(t.vertexCount(), -1);
  std::vector<int> vertex;
  for (int v = 0; v < t.vertexCount(); ++v)
  {
    if (!placed[v] && t.anyOutgoing()[v] >= 0)
    {
      row[v] = static_cast<int>(vertex.size());
      vertex.push_back(v);
    }
  }
  if (vertex.empty())
  {
    return position;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(vertex.size(), 2);
  const auto couple = [&](int from, int to, double weight)
  {
    const int i = row[from];
    const int j = row[to];
    if (i < 0 || from == to)
    {
      return;
    }
    entries.emplace_back(i, i, weight);
    if (j < 0)
    {
      right.row(i) += weight * Eigen::RowVector2d(position[to].real(), position[to].imag());
    }
    else if (j < i)
    {
      entries.emplace_back(i, j, -weight);
    }
  };
  for (int f = 0; f < t.faceCount(); ++f)
  {
    const TriangleAngles angles = triangleAngles(
      t.scaledLogLength(3 * f, u), t.scaledLogLength(3 * f + 1, u), t.scaledLogLength(3 * f + 2, u));
    for (int k = 0; k < 3; ++k)
    {
      couple(t.origin(3 * f + k), t.tip(3 * f + k), angles.Cotangent[k]);
      couple(t.tip(3 * f + k), t.origin(3 * f + k), angles.Cotangent[k]);
    }
  }
  SparseMatrix laplacian(vertex.size(), vertex.size());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const SparseCholesky cholesky(laplacian);
  if (cholesky.info() != Eigen::Success)
  {
    throw ConvergenceError(
      "the flat metric could not be laid out: remesh the surface (Surface To Disk, Remesh)");
  }
  const Eigen::MatrixX2d solution = cholesky.solve(right);
  for (std::size_t i = 0; i < vertex.size(); ++i)
  {
    position[vertex[i]] = Complex(solution(i, 0), solution(i, 1));
  }
  return position;
}

double layoutError(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  const ComplexVector& position)
{
  double extent = 0.0;
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    extent = std::max(extent, std::abs(position[t.origin(h)]));
  }
  double worst = 0.0;
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const double wanted = std::exp(static_cast<double>(t.scaledLogLength(h, u)));
    const double found = std::abs(position[t.origin(h)] - position[t.tip(h)]);
    worst = std::max(worst, std::abs(found - wanted) / std::max(wanted, LeastResolved * extent));
  }
  return worst;
}

} // namespace flattening
