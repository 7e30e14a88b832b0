// SPDX-License-Identifier: GPL-3.0-or-later
#include "HalfPlaneLayout.h"

#include "Errors.h"
#include "SparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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
constexpr int Refinements = 2;
const Complex Infinity(std::numeric_limits<double>::infinity(), 0.0);

// Places the boundary of the finite part: along the real axis, where the mirror cells tell places, from
// @p firstEdge on, then the link of the vertex at infinity, whose shape the angles at its vertices tell.
// Returns which vertices it placed.
std::vector<char> layOutBoundary(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge,
  ComplexVector& position)
{
  std::vector<char> placed(t.vertexCount(), 0);
  std::vector<double> angle(t.vertexCount(), 0.0);
  for (int f = 0; f < t.faceCount(); ++f)
  {
    const TriangleAngles angles = t.scaledAngles(f, u);
    for (int k = 0; k < 3; ++k)
    {
      angle[t.origin(t.previous(3 * f + k))] += angles.Angle[k];
    }
  }
  const auto& boundary = t.boundaryEdges();
  int b = firstEdge;
  double along = 0.0;
  for (; !boundary[b].AtInfinity; b = boundary[b].Next)
  {
    const MirrorCell cell = t.scaledMirrorCell(b, u);
    const MirrorCellShape shape = mirrorCellShape(cell);
    position[boundary[b].Origin] = Complex(along, 0.5 * std::exp(static_cast<double>(cell.LogAtOrigin)));
    placed[boundary[b].Origin] = 1;
    angle[boundary[b].Origin] += shape.AngleAtOrigin;
    angle[t.tipOfBoundaryEdge(b)] += shape.AngleAtTip;
    along += shape.Extent * std::exp(static_cast<double>(cell.LogEdge));
  }
  double heading = 0.0;
  Complex place(along, 0.0);
  std::vector<int> link;
  for (; b != firstEdge; b = boundary[b].Next)
  {
    const int v = boundary[b].Origin;
    position[v] = place;
    placed[v] = 1;
    link.push_back(v);
    heading += EIGEN_PI - angle[v];
    const long double scale = 0.5L * (u[v] + u[t.tipOfBoundaryEdge(b)]);
    place += std::polar(std::exp(static_cast<double>(boundary[b].LogLength + scale)), heading);
  }
  // Spread what rounding left open over the link.
  const Complex gap = position[boundary[firstEdge].Origin] - place;
  for (std::size_t k = 1; k < link.size(); ++k)
  {
    position[link[k]] += gap * (static_cast<double>(k) / link.size());
  }
  return placed;
}

struct Spring
{
  int From;
  int To;
  double Weight; // > 0
};

// The edges with their cotangent weights, which are not negative in a Delaunay triangulation but for
// rounding. The two cotangents of an edge may nearly cancel, so they are summed before anything else.
std::vector<Spring> springsOf(const IntrinsicTriangulation& t, const IntrinsicTriangulation::Factors& u)
{
  std::vector<double> cotangents(t.halfedgeCount());
  for (int f = 0; f < t.faceCount(); ++f)
  {
    const TriangleAngles angles = t.scaledAngles(f, u);
    std::copy(std::begin(angles.Cotangent), std::end(angles.Cotangent), &cotangents[3 * f]);
  }
  std::vector<Spring> springs;
  springs.reserve(t.halfedgeCount() / 2);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const int twin = t.twin(h);
    const double weight = twin < 0 ? 0.0 : cotangents[h] + cotangents[twin];
    if (twin > h && weight > 0.0 && t.origin(h) != t.tip(h))
    {
      springs.push_back({ t.origin(h), t.tip(h), weight });
    }
  }
  return springs;
}

} // namespace

ComplexVector layOutInHalfPlane(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge)
{
  ComplexVector position(t.vertexCount(), Infinity);
  const std::vector<char> placed = layOutBoundary(t, u, firstEdge, position);
  std::vector<char> hasFace(t.vertexCount(), 0);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    hasFace[t.origin(h)] = 1;
  }
  std::vector<int> row(t.vertexCount(), -1);
  std::vector<int> vertex;
  for (int v = 0; v < t.vertexCount(); ++v)
  {
    if (!placed[v] && hasFace[v])
    {
      row[v] = static_cast<int>(vertex.size());
      vertex.push_back(v);
    }
  }
  if (vertex.empty())
  {
    return position;
  }
  const std::vector<Spring> springs = springsOf(t, u);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Spring& s : springs)
  {
    const int i = row[s.From];
    const int j = row[s.To];
    for (const int k : { i, j })
    {
      if (k >= 0)
      {
        entries.emplace_back(k, k, s.Weight);
      }
    }
    if (i >= 0 && j >= 0)
    {
      entries.emplace_back(std::max(i, j), std::min(i, j), -s.Weight);
    }
    for (const int v : { s.From, s.To })
    {
      if (row[v] >= 0)
      {
        position[v] = 0.0;
      }
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
  // Forces are sums of differences: refined by them, positions are as good as the springs' weights.
  for (int round = 0; round < 1 + Refinements; ++round)
  {
    Eigen::MatrixX2d force = Eigen::MatrixX2d::Zero(vertex.size(), 2);
    for (const Spring& s : springs)
    {
      const Complex pull = s.Weight * (position[s.To] - position[s.From]);
      const Eigen::RowVector2d f(pull.real(), pull.imag());
      if (row[s.From] >= 0)
      {
        force.row(row[s.From]) += f;
      }
      if (row[s.To] >= 0)
      {
        force.row(row[s.To]) -= f;
      }
    }
    const Eigen::MatrixX2d change = cholesky.solve(force);
    for (std::size_t i = 0; i < vertex.size(); ++i)
    {
      position[vertex[i]] += Complex(change(i, 0), change(i, 1));
    }
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
