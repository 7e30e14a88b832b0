// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/HalfPlaneEmbedding.h"

#include "Base/Errors.h"
#include "Conformal/CotangentWeights.h"
#include "Mesh/GraphLaplacian.h"
#include "Mesh/Halfedges.h"

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
// Greatest relative error of an edge that is accepted: a guard, for a metric that is flat to 1e-10
// radians is laid out to far less. Maps with larger errors are not conformal.
constexpr double LargestLayoutError = 1e-3;
// Shortest edge whose relative error counts, as a share of the embedding's extent. Along a protrusion
// lengths fall exponentially, past the resolution of doubles; with a smaller share, maps of real
// surfaces are refused for edges that nobody can see.
constexpr double LeastResolvedLength = 1e-11;
const Complex Infinity(std::numeric_limits<double>::infinity(), 0.0);

// Positions the boundary: first along the real axis from @p firstEdge on, by the mirror cells, then
// along the link of the vertex at infinity, by the angles at the link's vertices. Returns one flag per
// vertex, 1 if it has a position.
std::vector<char> embedBoundary(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge,
  ComplexVector& position)
{
  std::vector<char> placed(t.vertexCount(), 0);
  std::vector<double> angle(t.vertexCount(), 0.0);
  std::vector<char> onBoundary(t.vertexCount(), 0);
  for (const auto& edge : t.boundaryEdges())
  {
    if (edge.Origin >= 0)
    {
      onBoundary[edge.Origin] = 1;
    }
  }
  for (int f = 0; f < t.faceCount(); ++f)
  {
    if (!onBoundary[t.origin(3 * f)] && !onBoundary[t.origin(3 * f + 1)] &&
        !onBoundary[t.origin(3 * f + 2)])
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
  double heading = 0.0; // angle of the next edge of the link against the real axis
  Complex end(along, 0.0);
  std::vector<int> link;
  for (; b != firstEdge; b = boundary[b].Next)
  {
    const int v = boundary[b].Origin;
    position[v] = end;
    placed[v] = 1;
    link.push_back(v);
    heading += EIGEN_PI - angle[v];
    const long double scale = 0.5L * (u[v] + u[t.tipOfBoundaryEdge(b)]);
    end += std::polar(std::exp(static_cast<double>(boundary[b].LogLength + scale)), heading);
  }
  // The link does not end where it should, by rounding: its vertices share the gap.
  const Complex gap = position[boundary[firstEdge].Origin] - end;
  for (std::size_t k = 1; k < link.size(); ++k)
  {
    position[link[k]] += gap * (static_cast<double>(k) / link.size());
  }
  return placed;
}

} // namespace

ComplexVector embedInHalfPlane(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge,
  const EliminationOrder& order,
  const ProgressCallback& progress)
{
  ComplexVector position(t.vertexCount(), Infinity);
  const std::vector<char> placed = embedBoundary(t, u, firstEdge, position);
  std::vector<char> fixed(t.vertexCount(), 1);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const int v = t.origin(h);
    fixed[v] = placed[v];
    position[v] = placed[v] ? position[v] : 0.0;
  }
  WeightedMeans(cotangentWeights(t, u), WeightSymmetry::Symmetric, fixed, progress, order)
    .extend(position, progress);
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
        worst =
          std::max(worst, std::abs(found - wanted) / std::max(wanted, LeastResolvedLength * extent));
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
