// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/HalfPlaneEmbedding.h"

#include "Base/Errors.h"
#include "Conformal/CotangentWeights.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/GraphLaplacian.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
constexpr double LargestLayoutError = 1e-3;
// Of the layout's extent. Along a horn of the surface lengths fall exponentially, past what doubles tell
// apart.
constexpr double LeastResolved = 1e-11;
constexpr int HalfedgesPerTask = 4096;
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
  std::vector<char> isWanted(t.vertexCount(), 0);
  for (const auto& edge : t.boundaryEdges())
  {
    if (edge.Origin >= 0)
    {
      isWanted[edge.Origin] = 1;
    }
  }
  for (int f = 0; f < t.faceCount(); ++f)
  {
    if (!isWanted[t.origin(3 * f)] && !isWanted[t.origin(3 * f + 1)] && !isWanted[t.origin(3 * f + 2)])
    {
      continue;
    }
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
    const SymmetricTrapezoid cell = t.scaledTrapezoid(b, u);
    const TrapezoidShape shape = trapezoidShape(cell);
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

} // namespace

ComplexVector layOutInHalfPlane(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge,
  const EliminationOrder& order,
  const ProgressCallback& progress)
{
  ComplexVector position(t.vertexCount(), Infinity);
  std::vector<char> placed = layOutBoundary(t, u, firstEdge, position);
  std::vector<char> hasFace(t.vertexCount(), 0);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    hasFace[t.origin(h)] = 1;
  }
  for (int v = 0; v < t.vertexCount(); ++v)
  {
    if (!placed[v] && hasFace[v])
    {
      position[v] = 0.0;
    }
    else
    {
      placed[v] = 1;
    }
  }
  relaxSprings(springsOf(t, u), placed, position, order, progress);
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
  return tbb::parallel_reduce(
    tbb::blocked_range<int>(0, t.halfedgeCount(), HalfedgesPerTask),
    0.0,
    [&](const tbb::blocked_range<int>& halfedges, double worst)
    {
      for (int h = halfedges.begin(); h < halfedges.end(); ++h)
      {
        const double wanted = std::exp(static_cast<double>(t.scaledLogLength(h, u)));
        const double found = std::abs(position[t.origin(h)] - position[t.tip(h)]);
        worst = std::max(worst, std::abs(found - wanted) / std::max(wanted, LeastResolved * extent));
      }
      return worst;
    },
    [](double a, double b) { return std::max(a, b); });
}

void requireLayout(double layoutError)
{
  if (!(layoutError < LargestLayoutError))
  {
    throw ConvergenceError("the flat metric could not be laid out: an edge is off by a factor of " +
                           std::to_string(1.0 + layoutError) +
                           "; remesh the surface (Surface To Disk, Remesh)");
  }
}

} // namespace flattening
