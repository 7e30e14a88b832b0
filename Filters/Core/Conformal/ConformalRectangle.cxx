// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConformalRectangle.h"

#include "Base/Errors.h"
#include "Conformal/CotangentWeights.h"
#include "Conformal/HalfPlaneEmbedding.h"
#include "Conformal/PointAtInfinity.h"
#include "Conformal/ProtrusionSpreading.h"
#include "Mesh/ComplexPositions.h"
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
  std::vector<std::size_t> places;
  for (const int corner : corners)
  {
    const auto place = std::find(loop.begin(), loop.end(), corner);
    if (place == loop.end())
    {
      throw InvalidInput("the corner vertex " + std::to_string(corner) +
                         " is not on the boundary: choose four boundary vertices");
    }
    places.push_back(place - loop.begin());
  }
  std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
  for (int k = 0; k < 3; ++k)
  {
    if (places[k] == places[k + 1] || places[0] == places[k + 1])
    {
      throw InvalidInput(
        "two corners are the same boundary vertex: choose four different ones; if they are, the surface "
        "has too few boundary vertices there");
    }
  }
  if (!std::is_sorted(places.begin(), places.end()))
  {
    throw InvalidInput("the corners are not in the order of the boundary with the surface on its left: "
                       "exchange the second and the fourth, or two neighbours");
  }
}

// A vertex of the straightened boundary: on one of the four sides, so far along it and so far inside.
struct BoundaryPlace
{
  int Vertex;
  int Side;
  double Along;
  double Inside;
};

// Walks along the mirror, whose cells tell the places, from the first corner.
std::vector<BoundaryPlace> placesOnSides(const IntrinsicTriangulation& t,
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
  std::vector<BoundaryPlace> places;
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
    places.push_back(
      { boundary[b].Origin, side, along, 0.5 * std::exp(static_cast<double>(cell.LogAtOrigin)) });
    along += trapezoidShape(cell).Extent * std::exp(static_cast<double>(cell.LogEdge));
    b = boundary[b].Next;
  } while (b != first);
  lengths[3] = along;
  return places;
}

struct Rectangle
{
  double Width;
  double Height;

  // Sides are numbered counter-clockwise from the lower one.
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

// Opposite sides, which only rounding makes unequal, become equal.
Rectangle layOut(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u,
  const std::vector<int>& corners,
  const EliminationOrder& order,
  ComplexVector& position,
  const ProgressCallback& progress)
{
  std::array<double, 4> lengths{};
  const std::vector<BoundaryPlace> places = placesOnSides(t, u, corners, lengths);
  const Rectangle rectangle{ 0.5 * (lengths[0] + lengths[2]), 0.5 * (lengths[1] + lengths[3]) };
  std::vector<char> placed(t.vertexCount(), 0);
  position.assign(t.vertexCount(), 0.0);
  for (const BoundaryPlace& place : places)
  {
    position[place.Vertex] = rectangle.at(place.Side, place.Along / lengths[place.Side], place.Inside);
    placed[place.Vertex] = 1;
  }
  relaxSprings(springsOf(t, u), placed, position, order, progress);
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
  result.Corners = options.Corners.empty() ? rectangleCorners(mesh, loop) : options.Corners;
  requireCorners(result.Corners, loop);

  report(progress, 0.0, "Intrinsic Delaunay triangulation");
  const int n = mesh.vertexCount();
  IntrinsicTriangulation t(mesh);
  result.Map.AddedLength = t.addedLength();
  result.Map.Flips += t.flipToDelaunay();
  const std::vector<char> onBoundary = boundaryVertices(t);
  result.Map.Flips += t.flipDoubleToDelaunay();
  Eigen::VectorXd targets(n);
  for (int v = 0; v < n; ++v)
  {
    targets[v] = onBoundary[v] ? EIGEN_PI : 2.0 * EIGEN_PI;
  }
  for (const int corner : result.Corners)
  {
    targets[corner] = 0.5 * EIGEN_PI;
  }
  std::vector<char> fixed(n, 0);
  fixed[result.Corners[0]] = 1; // for the scale; its angle follows from all others
  const RicciFlowResult flow = discreteRicciFlow(t,
    targets,
    fixed,
    IntrinsicTriangulation::Factors::Zero(n),
    options.Flow,
    subrange(progress, 0.1, 0.85));
  result.Map.NewtonIterations = flow.NewtonIterations;
  result.Map.Flips += flow.Flips;
  result.Map.MaxCurvatureError = flow.MaxCurvatureError;

  ComplexVector position;
  const Rectangle rectangle = layOut(
    t, flow.LogFactors, result.Corners, flow.Elimination, position, subrange(progress, 0.9, 0.95));
  result.Map.LayoutError = layoutError(t, flow.LogFactors, position);
  requireLayout(result.Map.LayoutError);
  result.Modulus = rectangle.Width / rectangle.Height;
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  result.Map.SpreadVertices = spreadProtrusions(
    t, flow.LogFactors, 0.5 * std::log(rectangle.Width * rectangle.Height / area), position);
  result.Map.Positions = pointsOf(position) / rectangle.Height;
  for (const int v : loop)
  {
    result.Map.Positions(v, 0) = std::clamp(result.Map.Positions(v, 0), 0.0, result.Modulus);
    result.Map.Positions(v, 1) = std::clamp(result.Map.Positions(v, 1), 0.0, 1.0);
  }
  result.Map.LogFactors = flow.LogFactors.cast<double>().array() - std::log(rectangle.Height);
  result.Map.Repair = untangleMap(mesh, loop, result.Map.Positions, subrange(progress, 0.95, 1.0));
  result.Map.FlippedFaces = result.Map.Repair.FlippedFaces;
  report(progress, 1.0, "Conformal rectangle");
  return result;
}

} // namespace flattening
