// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/RicciFlowDisk.h"

#include "Base/Errors.h"
#include "Conformal/DiskNormalisation.h"
#include "Conformal/HalfPlaneEmbedding.h"
#include "Conformal/PointAtInfinity.h"
#include "Conformal/ProtrusionSpreading.h"
#include "Mesh/ComplexPositions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// How many vertices are tried at infinity before the map is given up.
constexpr int LargestAttempts = 4;
// How often a surface too coarse for any of them is subdivided.
constexpr int LargestSubdivisions = 4;

// The surface while it is being mapped.
struct Workpiece
{
  IntrinsicTriangulation Triangulation;
  Points3 Points;
};

Workpiece prepare(const TriangleMesh& mesh, int& flips)
{
  Workpiece piece{ IntrinsicTriangulation(mesh), mesh.Vertices };
  flips += piece.Triangulation.flipToDelaunay();
  return piece;
}

struct HalfPlaneMap
{
  IntrinsicTriangulation Triangulation; // in which it is flat
  ComplexVector Positions;
  IntrinsicTriangulation::Factors LogFactors;
  int AtInfinity = -1;
};

// Gives every vertex its place in the half-plane, one boundary vertex at infinity.
HalfPlaneMap mapToHalfPlane(Workpiece& piece,
  int atInfinity,
  const RicciFlowOptions& options,
  ConformalDiskMap& map,
  const ProgressCallback& progress)
{
  IntrinsicTriangulation& t = piece.Triangulation;
  const std::vector<char> onBoundary = boundaryVertices(t);
  const IntrinsicTriangulation::Star star = t.removeStar(atInfinity);

  // The other side of a seam lies in the very place of the vertex at infinity.
  double nearest = HUGE_VAL;
  for (const auto& spoke : star.Spokes)
  {
    nearest = std::min(nearest, static_cast<double>(std::exp(spoke.LogLength)));
  }
  const int n = t.vertexCount();
  Eigen::VectorXd targets(n);
  IntrinsicTriangulation::Factors start(n);
  for (int v = 0; v < n; ++v)
  {
    targets[v] = onBoundary[v] ? EIGEN_PI : 2.0 * EIGEN_PI;
    // Inversion of space in the vertex at infinity: exact on planar surfaces.
    const double distance = (piece.Points.row(v) - piece.Points.row(atInfinity)).norm();
    start[v] = v == atInfinity ? 0.0 : -2.0 * std::log(std::max(distance, nearest));
  }
  std::vector<char> fixed(n, 0);
  fixed[atInfinity] = 1;
  for (const auto& spoke : star.Spokes)
  {
    fixed[spoke.Vertex] = 1;
    start[spoke.Vertex] = -2.0 * spoke.LogLength;
  }

  const RicciFlowResult flow =
    discreteRicciFlow(t, targets, fixed, start, options, subrange(progress, 0.0, 0.9));
  map.NewtonIterations += flow.NewtonIterations;
  map.Flips += flow.Flips;
  map.MaxCurvatureError = flow.MaxCurvatureError;

  const ComplexVector positions = layOutInHalfPlane(
    t, flow.LogFactors, star.FirstBoundaryEdge, flow.Elimination, subrange(progress, 0.9, 0.95));
  report(progress, 0.95, "Layout");
  map.LayoutError = layoutError(t, flow.LogFactors, positions);
  requireLayout(map.LayoutError);
  return { std::move(t), positions, flow.LogFactors, atInfinity };
}

// The same from the first of the candidates for infinity that gets there: near a vertex with an unlucky
// star the flow, which cannot flip the edges around infinity, may have no solution.
HalfPlaneMap mapToHalfPlane(const Workpiece& piece,
  const std::vector<int>& candidates,
  const RicciFlowOptions& options,
  ConformalDiskMap& map,
  const ProgressCallback& progress)
{
  const int attempts = std::min(static_cast<int>(candidates.size()), LargestAttempts);
  for (int k = 0; k + 1 < attempts; ++k)
  {
    try
    {
      Workpiece attempt = piece;
      return mapToHalfPlane(attempt,
        candidates[k],
        options,
        map,
        subrange(progress, static_cast<double>(k) / attempts, static_cast<double>(k + 1) / attempts));
    }
    catch (const ConvergenceError&)
    {
    }
  }
  if (attempts == 0)
  {
    throw ConvergenceError(
      "no boundary vertex of the surface can be sent to infinity: remesh the surface "
      "(Surface To Disk, Remesh)");
  }
  Workpiece attempt = piece;
  return mapToHalfPlane(
    attempt, candidates[attempts - 1], options, map, subrange(progress, 1.0 - 1.0 / attempts, 1.0));
}

ComplexVector firstOf(const ComplexVector& positions, int count)
{
  return ComplexVector(positions.begin(), positions.begin() + count);
}

// Splits every face into four: for surfaces so coarse that no boundary vertex can go to infinity.
TriangleMesh subdivided(const TriangleMesh& mesh)
{
  TriangleMesh fine;
  fine.Vertices = mesh.Vertices;
  fine.Vertices.conservativeResize(mesh.vertexCount() + 3 * mesh.faceCount(), 3);
  fine.Faces.resize(4 * mesh.faceCount(), 3);
  int count = mesh.vertexCount();
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b)
  {
    const auto [entry, isNew] = middles.emplace(std::pair<int, int>(std::minmax(a, b)), count);
    if (isNew)
    {
      fine.Vertices.row(count++) = 0.5 * (mesh.Vertices.row(a) + mesh.Vertices.row(b));
    }
    return entry->second;
  };
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const int a = mesh.Faces(f, 0);
    const int b = mesh.Faces(f, 1);
    const int c = mesh.Faces(f, 2);
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    fine.Faces.row(4 * f) << a, ab, ca;
    fine.Faces.row(4 * f + 1) << b, bc, ab;
    fine.Faces.row(4 * f + 2) << c, ca, bc;
    fine.Faces.row(4 * f + 3) << ab, bc, ca;
  }
  fine.Vertices.conservativeResize(count, 3);
  return fine;
}

} // namespace

ConformalDiskMap ricciFlowDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const RicciFlowOptions& options,
  const ProgressCallback& progress)
{
  const int n = mesh.vertexCount();
  ConformalDiskMap map;
  report(progress, 0.0, "Intrinsic Delaunay triangulation");
  Workpiece piece = prepare(mesh, map.Flips);
  map.AddedLength = piece.Triangulation.addedLength();
  std::vector<int> candidates = verticesForInfinity(piece.Triangulation);
  TriangleMesh fine = mesh;
  for (int round = 0; candidates.empty() && round < LargestSubdivisions; ++round)
  {
    fine = subdivided(fine);
    piece = prepare(fine, map.Flips);
    candidates = verticesForInfinity(piece.Triangulation);
  }
  HalfPlaneMap half = mapToHalfPlane(piece, candidates, options, map, subrange(progress, 0.1, 0.9));
  report(progress, 0.95, "Moebius normalisation");
  const Complex centre = centring.centre(firstOf(half.Positions, n));
  ComplexVector disk = cayley(half.Positions, centre);
  for (const int v : loop)
  {
    disk[v] /= std::abs(disk[v]);
  }

  IntrinsicTriangulation::Factors logFactors = half.LogFactors;
  for (Eigen::Index v = 0; v < logFactors.size(); ++v)
  {
    logFactors[v] =
      std::log(2.0 * centre.imag()) +
      (v == half.AtInfinity
          ? 0.0L
          : half.LogFactors[v] - 2.0 * std::log(std::abs(half.Positions[v] - std::conj(centre))));
  }
  map.LogFactors = logFactors.head(n).cast<double>();
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  map.SpreadVertices =
    spreadProtrusions(half.Triangulation, logFactors, 0.5 * std::log(EIGEN_PI / area), disk);
  map.Positions = pointsOf(firstOf(disk, n));
  return map;
}

} // namespace flattening
