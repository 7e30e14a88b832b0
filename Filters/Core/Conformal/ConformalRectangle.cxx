// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConformalRectangle.h"

#include "Base/Errors.h"
#include "Conformal/CotangentWeights.h"
#include "Conformal/CurvatureSystem.h"
#include "Conformal/HalfPlaneEmbedding.h"
#include "Conformal/ProtrusionSpreading.h"
#include "Mesh/GraphLaplacian.h"
#include "Mesh/MeshTopology.h"
#include "Untangling/MapUntangling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;

void requireCorners(const std::vector<int>& corners, const std::vector<int>& loop)
{
  if (corners.size() != 4)
  {
    throw InvalidInput("a rectangle has 4 corners; " + std::to_string(corners.size()) + " were given");
  }
  std::vector<std::size_t> indices;
  for (const int corner : corners)
  {
    const auto found = std::find(loop.begin(), loop.end(), corner);
    if (found == loop.end())
    {
      throw InvalidInput("the corner vertex " + std::to_string(corner) +
                         " is not on the boundary: choose four boundary vertices");
    }
    indices.push_back(found - loop.begin());
  }
  std::rotate(indices.begin(), std::min_element(indices.begin(), indices.end()), indices.end());
  for (int k = 0; k < 3; ++k)
  {
    if (indices[k] == indices[k + 1] || indices[0] == indices[k + 1])
    {
      throw InvalidInput(
        "two corners are the same boundary vertex: choose four different ones; if they are, the surface "
        "has too few boundary vertices there");
    }
  }
  if (!std::is_sorted(indices.begin(), indices.end()))
  {
    throw InvalidInput("the corners are not in the order of the boundary with the surface on its left: "
                       "exchange the second and the fourth, or two neighbours");
  }
}

// The position of a boundary vertex on the straightened boundary.
struct SidePosition
{
  int Vertex;
  int Side;      // 0 to 3, counter-clockwise from the lower one
  double Along;  // length from the beginning of the side
  double Inside; // distance from the side
};

// Positions of the boundary vertices, by a walk along the mirror cells from the first corner. Sets the
// lengths of the sides, too.
std::vector<SidePosition> sidePositions(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  const std::vector<int>& corners,
  std::array<double, 4>& lengths)
{
  const auto& boundary = t.boundaryEdges();
  int first = 0;
  while (boundary[first].Origin != corners[0])
  {
    ++first;
  }
  std::vector<SidePosition> positions;
  int side = 0;
  double along = 0.0;
  int b = first;
  do
  {
    if (side < 3 && boundary[b].Origin == corners[side + 1])
    {
      lengths[side++] = along;
      along = 0.0;
    }
    const SymmetricTrapezoid cell = t.scaledTrapezoid(b, u);
    positions.push_back(
      { boundary[b].Origin, side, along, 0.5 * std::exp(static_cast<double>(cell.LogAtOrigin)) });
    along += trapezoidShape(cell).Extent * std::exp(static_cast<double>(cell.LogEdge));
    b = boundary[b].Next;
  } while (b != first);
  lengths[3] = along;
  return positions;
}

struct Rectangle
{
  double Width;
  double Height;

  Complex at(int side, double share, double inside) const
  {
    switch (side)
    {
      case 0:
        return { share * this->Width, inside };
      case 1:
        return { this->Width - inside, share * this->Height };
      case 2:
        return { (1.0 - share) * this->Width, this->Height - inside };
      default:
        return { inside, (1.0 - share) * this->Height };
    }
  }
};

// Gives all vertices their positions in a rectangle, which it returns. Its sides are the means of
// opposite sides, which differ by rounding only.
Rectangle embed(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  const std::vector<int>& corners,
  const EliminationOrder& order,
  ComplexVector& position,
  const ProgressCallback& progress)
{
  std::array<double, 4> lengths{};
  const std::vector<SidePosition> boundary = sidePositions(t, u, corners, lengths);
  const Rectangle rectangle{ 0.5 * (lengths[0] + lengths[2]), 0.5 * (lengths[1] + lengths[3]) };
  std::vector<char> placed(t.vertexCount(), 0);
  position.assign(t.vertexCount(), 0.0);
  for (const SidePosition& p : boundary)
  {
    position[p.Vertex] = rectangle.at(p.Side, p.Along / lengths[p.Side], p.Inside);
    placed[p.Vertex] = 1;
  }
  WeightedMeans(cotangentWeights(t, u), WeightSymmetry::Symmetric, placed, progress, order)
    .extend(position, progress);
  return rectangle;
}

} // namespace

ConformalRectangleMap conformalRectangleMap(const TriangleMesh& mesh,
  const ConformalRectangleOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  if (loop.size() < 4)
  {
    throw InvalidInput(
      "the boundary has " + std::to_string(loop.size()) +
      " vertices: a rectangle needs 4 corners; remesh the surface or map it to the disk");
  }
  ConformalRectangleMap result;
  ConformalDiskMap& map = result.Map;
  result.Corners = options.Corners.empty() ? rectangleCorners(mesh, loop) : options.Corners;
  requireCorners(result.Corners, loop);

  const int n = mesh.vertexCount();
  IntrinsicTriangulation t(mesh);
  map.AddedLength = t.addedLength();
  map.Flips += t.flipToDelaunay(subrange(progress, 0.0, 0.1));
  Eigen::VectorXd targets = flatAngleSums(t);
  map.Flips += t.flipDoubleToDelaunay(subrange(progress, 0.05, 0.1));
  targets(result.Corners).setConstant(0.5 * EIGEN_PI);
  std::vector<char> fixed(n, 0);
  fixed[result.Corners[0]] = 1; // for the scale; its angle follows from all others
  const RicciFlowResult flow = discreteRicciFlow(t,
    targets,
    fixed,
    IntrinsicTriangulation::Factors::Zero(n),
    options.Flow,
    subrange(progress, 0.1, 0.85));
  map.NewtonIterations = flow.NewtonIterations;
  map.Flips += flow.Flips;
  map.MaxCurvatureError = flow.MaxCurvatureError;

  ComplexVector position;
  const Rectangle rectangle =
    embed(t, flow.LogFactors, result.Corners, flow.Order, position, subrange(progress, 0.9, 0.95));
  map.LayoutError = layoutError(t, flow.LogFactors, position);
  requireLayout(map.LayoutError);
  result.Modulus = rectangle.Width / rectangle.Height;
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  map.SpreadVertices = spreadProtrusions(t,
    flow.LogFactors,
    flow.LogFactors,
    0.5 * std::log(rectangle.Width * rectangle.Height / area),
    position,
    n);
  map.Positions = pointsOf(position) / rectangle.Height;
  for (const int v : loop)
  {
    map.Positions(v, 0) = std::clamp(map.Positions(v, 0), 0.0, result.Modulus);
    map.Positions(v, 1) = std::clamp(map.Positions(v, 1), 0.0, 1.0);
  }
  map.LogFactors = flow.LogFactors.cast<double>().array() - std::log(rectangle.Height);
  map.Untangling = untangleMap(mesh, loop, map.Positions, subrange(progress, 0.95, 1.0));
  report(progress, 1.0, "Conformal rectangle");
  return result;
}

} // namespace flattening
