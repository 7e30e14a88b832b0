// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConformalDisk.h"

#include "Errors.h"
#include "FaceOrientation.h"
#include "MeshTopology.h"
#include "MoebiusNormalisation.h"
#include "SparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Opposite to a boundary edge, before the flow.
constexpr double LargestBoundaryAngle = 75.0 / 180.0 * EIGEN_PI;
const Complex Infinity(std::numeric_limits<double>::infinity(), 0.0);

// The surface while it is being mapped: more triangles and boundary points than the mesh has.
struct Workpiece
{
  IntrinsicTriangulation Triangulation;
  Points3 Points; // of the mesh and of the inserted boundary points
};

Workpiece prepare(const TriangleMesh& mesh, int& flips, int& inserted)
{
  Workpiece piece{ IntrinsicTriangulation(mesh), mesh.Vertices };
  flips += piece.Triangulation.flipToDelaunay();
  const auto splits = piece.Triangulation.splitBoundaryEdges(LargestBoundaryAngle);
  inserted = static_cast<int>(splits.size());
  piece.Points.conservativeResize(mesh.vertexCount() + inserted, 3);
  for (int s = 0; s < inserted; ++s)
  {
    piece.Points.row(mesh.vertexCount() + s) =
      (1.0 - splits[s].Parameter) * piece.Points.row(splits[s].From) +
      splits[s].Parameter * piece.Points.row(splits[s].To);
  }
  return piece;
}

// Smallest angle at the star of a boundary vertex that can be sent to infinity: its spokes are distinct
// and only the first and the last end on the boundary. Negative if it cannot.
double starQuality(const IntrinsicTriangulation& t, const std::vector<char>& onBoundary, int vertex)
{
  const std::vector<int> around = t.outgoing(vertex);
  std::vector<int> link;
  double quality = EIGEN_PI;
  for (const int h : around)
  {
    const int next = t.next(h);
    const int previous = t.previous(h);
    link.push_back(t.tip(h));
    const TriangleAngles angles =
      triangleAngles(t.logLength(h), t.logLength(next), t.logLength(previous));
    quality = std::min({ quality, angles.Angle[0], angles.Angle[1], angles.Angle[2] });
  }
  link.push_back(t.origin(t.previous(around.back())));
  if (around.size() < 2 || static_cast<int>(around.size()) == t.faceCount())
  {
    return -1.0;
  }
  for (std::size_t k = 1; k + 1 < link.size(); ++k)
  {
    if (onBoundary[link[k]])
    {
      return -1.0;
    }
  }
  link.push_back(vertex);
  std::sort(link.begin(), link.end());
  return std::adjacent_find(link.begin(), link.end()) == link.end() ? quality : -1.0;
}

std::vector<char> boundaryVertices(const IntrinsicTriangulation& t)
{
  std::vector<char> onBoundary(t.vertexCount(), 0);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    if (t.twin(h) < 0)
    {
      onBoundary[t.origin(h)] = onBoundary[t.tip(h)] = 1;
    }
  }
  return onBoundary;
}

// The boundary vertex with the best star, or -1.
int vertexForInfinity(const IntrinsicTriangulation& t, const std::vector<char>& onBoundary)
{
  int best = -1;
  double bestQuality = 0.0;
  for (int v = 0; v < t.vertexCount(); ++v)
  {
    const double quality = onBoundary[v] ? starQuality(t, onBoundary, v) : -1.0;
    if (quality > bestQuality)
    {
      best = v;
      bestQuality = quality;
    }
  }
  return best;
}

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

// Lays the flat metric out in the upper half-plane. Coordinates are harmonic in a flat metric, so with
// the boundary known one linear solve gives them all; laying out face by face from the boundary would be
// a Cauchy problem, whose rounding errors grow exponentially. Vertices without a face get Infinity.
ComplexVector layOut(const IntrinsicTriangulation& t,
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
  double worst = 0.0;
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const double wanted = std::exp(static_cast<double>(t.scaledLogLength(h, u)));
    worst =
      std::max(worst, std::abs(std::abs(position[t.origin(h)] - position[t.tip(h)]) / wanted - 1.0));
  }
  return worst;
}

// Splits every face into four: for surfaces so coarse that no boundary vertex can go to infinity.
TriangleMesh subdivided(const TriangleMesh& mesh);

struct HalfPlaneMap
{
  ComplexVector Positions; // of the mesh's vertices and the inserted ones
  IntrinsicTriangulation::Factors LogFactors;
  int AtInfinity = -1;
};

// Gives every vertex its place in the half-plane, one boundary vertex at infinity.
HalfPlaneMap mapToHalfPlane(Workpiece& piece,
  int atInfinity,
  const ConformalDiskOptions& options,
  ConformalDiskMap& map,
  const ProgressCallback& progress)
{
  IntrinsicTriangulation& t = piece.Triangulation;
  const std::vector<char> onBoundary = boundaryVertices(t);
  t.growStar(atInfinity, onBoundary, 0.2);
  const auto link = t.removeStar(atInfinity);

  const int n = t.vertexCount();
  Eigen::VectorXd targets(n);
  IntrinsicTriangulation::Factors start(n);
  for (int v = 0; v < n; ++v)
  {
    targets[v] = onBoundary[v] ? EIGEN_PI : 2.0 * EIGEN_PI;
    // Inversion of space in the vertex at infinity: exact on planar surfaces.
    start[v] = v == atInfinity
                 ? 0.0
                 : -2.0 * std::log((piece.Points.row(v) - piece.Points.row(atInfinity)).norm());
  }
  std::vector<char> fixed(n, 0);
  fixed[atInfinity] = 1;
  for (const auto& spoke : link)
  {
    fixed[spoke.Vertex] = 1;
    start[spoke.Vertex] = -2.0 * spoke.LogLength;
  }

  const RicciFlowResult flow = discreteRicciFlow(t, targets, fixed, start, options.Flow, progress);
  map.NewtonIterations += flow.NewtonIterations;
  map.Flips += flow.Flips;
  map.MaxCurvatureError = flow.MaxCurvatureError;

  HalfPlaneMap half;
  half.AtInfinity = atInfinity;
  half.LogFactors = flow.LogFactors;
  half.Positions = layOut(t, flow.LogFactors, link.front().Vertex, link.back().Vertex);
  map.LayoutError = layoutError(t, flow.LogFactors, half.Positions);
  if (!(map.LayoutError < 1e-3))
  {
    throw ConvergenceError("the flat metric could not be laid out: an edge is off by a factor of " +
                           std::to_string(1.0 + map.LayoutError) +
                           "; remesh the surface (Surface To Disk, Remesh)");
  }
  return half;
}

} // namespace

ConformalDiskMap conformalDiskMap(const TriangleMesh& mesh,
  const ConformalDiskOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  const int n = mesh.vertexCount();
  const auto isOnBoundary = [&loop](int v)
  { return std::find(loop.begin(), loop.end(), v) != loop.end(); };
  if (options.CenterVertex >= n || (options.CenterVertex >= 0 && isOnBoundary(options.CenterVertex)))
  {
    throw InvalidInput("the centre vertex " + std::to_string(options.CenterVertex) +
                       " is not an interior vertex of the surface: choose one away from the boundary");
  }
  if (options.BoundaryVertex >= n ||
      (options.BoundaryVertex >= 0 && !isOnBoundary(options.BoundaryVertex)))
  {
    throw InvalidInput("the vertex for angle 0, " + std::to_string(options.BoundaryVertex) +
                       ", is not on the boundary: choose a boundary vertex");
  }

  ConformalDiskMap map;
  report(progress, 0.0, "Intrinsic Delaunay triangulation");
  Workpiece piece = prepare(mesh, map.Flips, map.InsertedBoundaryPoints);
  map.AddedLength = piece.Triangulation.addedLength();
  int atInfinity = vertexForInfinity(piece.Triangulation, boundaryVertices(piece.Triangulation));
  for (TriangleMesh fine = mesh; atInfinity < 0;)
  {
    fine = subdivided(fine);
    piece = prepare(fine, map.Flips, map.InsertedBoundaryPoints);
    atInfinity = vertexForInfinity(piece.Triangulation, boundaryVertices(piece.Triangulation));
  }

  HalfPlaneMap half = mapToHalfPlane(piece, atInfinity, options, map, subrange(progress, 0.1, 0.9));
  report(progress, 0.95, "Moebius normalisation");
  half.Positions.resize(n);
  const Eigen::VectorXd masses = vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), n);
  const Complex centre = options.CenterVertex >= 0 ? half.Positions[options.CenterVertex]
                                                   : centreOfMass(half.Positions, masses / masses.sum());
  ComplexVector disk = cayley(half.Positions, centre);
  for (const int v : loop)
  {
    disk[v] /= std::abs(disk[v]);
  }
  double angle = 0.0;
  if (options.BoundaryVertex >= 0)
  {
    angle = -std::arg(disk[options.BoundaryVertex]);
  }
  else if (!intrinsicRotation(disk, mesh.Vertices, masses / masses.sum(), angle))
  {
    angle = -std::arg(disk[loop.front()]);
  }
  const Complex rotation = std::polar(1.0, angle);

  map.Positions.resize(n, 2);
  map.LogFactors.resize(n);
  for (int v = 0; v < n; ++v)
  {
    const Complex w = disk[v] * rotation;
    map.Positions.row(v) << w.real(), w.imag();
    map.LogFactors[v] =
      std::log(2.0 * centre.imag()) +
      (v == half.AtInfinity ? 0.0
                            : static_cast<double>(half.LogFactors[v]) -
                                2.0 * std::log(std::abs(half.Positions[v] - std::conj(centre))));
  }
  map.FlippedFaces = countFlippedFaces(map.Positions, mesh.Faces);
  report(progress, 1.0, "Conformal disk");
  return map;
}

namespace
{

TriangleMesh subdivided(const TriangleMesh& mesh)
{
  TriangleMesh fine;
  fine.Vertices = mesh.Vertices;
  fine.Faces.resize(4 * mesh.faceCount(), 3);
  std::vector<std::pair<std::pair<int, int>, int>> middles;
  const auto middle = [&](int a, int b)
  {
    const auto key = std::minmax(a, b);
    for (const auto& entry : middles)
    {
      if (entry.first == std::pair<int, int>(key))
      {
        return entry.second;
      }
    }
    const int m = fine.vertexCount();
    fine.Vertices.conservativeResize(m + 1, 3);
    fine.Vertices.row(m) = 0.5 * (mesh.Vertices.row(a) + mesh.Vertices.row(b));
    middles.push_back({ key, m });
    return m;
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
  return fine;
}

} // namespace
} // namespace flattening
