// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/RicciFlowDisk.h"

#include "Base/Errors.h"
#include "Conformal/CurvatureSystem.h"
#include "Conformal/HalfPlaneEmbedding.h"
#include "Conformal/PointAtInfinity.h"
#include "Conformal/ProtrusionSpreading.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Number of vertices that are tried at infinity before the map is given up: a choice, as each attempt
// costs a whole flow.
constexpr int MostAttempts = 4;
// Newton steps of failed attempts after which no other vertex is tried: two flows that fail late, as on
// nearly degenerate triangles, are enough. A guard for the time; with one, surfaces with many slivers
// are given up that the second vertex maps.
constexpr int LateSteps = 90;
// The same for excessive flips: about ten seconds.
constexpr long long LateFlips = 8000000;
// Distance of the centre of the disk from the origin of the half-plane, in units of its height, above
// which another vertex is sent to infinity. Derived: the disk loses as many digits as this has, and six
// of sixteen leave faces of a millionth of the radius in order.
constexpr double MostLopsided = 1e6;
// A vertex counts as near the centre if the boundary around it subtends at most so many times less of an
// angle there than around the nearest one. A choice: among these the vertex with the best star is taken.
constexpr double NearCentre = 10.0;
// Number of times that another vertex is sent to infinity: a choice, as each costs a whole flow. Each
// brings the centre closer by up to the sixteen digits that the positions have.
constexpr int MostCloser = 3;
// A surface without a vertex for infinity is subdivided once, which gives every boundary edge a vertex
// with interior neighbours, and further while it has at most this number of faces. A guard: surfaces of
// 1 to 30 faces needed two or three times, and with more faces it is not coarse but nearly degenerate.
// One of 536 faces had such a vertex after four times, and then a flow of a minute failed.
constexpr int MostFacesOfCoarse = 2000;

// A surface and its intrinsic Delaunay triangulation.
struct IntrinsicSurface
{
  IntrinsicTriangulation Triangulation;
  Points3 Points;
};

IntrinsicSurface intrinsicSurface(const TriangleMesh& mesh,
  long long& flips,
  const ProgressCallback& progress)
{
  IntrinsicSurface surface{ IntrinsicTriangulation(mesh), mesh.Vertices };
  flips += surface.Triangulation.flipToDelaunay(subrange(progress, 0.0, 0.1));
  return surface;
}

struct HalfPlaneMap
{
  IntrinsicTriangulation Triangulation; // in which it is flat
  ComplexVector Positions;
  IntrinsicTriangulation::Factors LogFactors;
  int AtInfinity = -1;
};

// Maps the surface to the half-plane, with one boundary vertex at infinity.
HalfPlaneMap mapToHalfPlane(IntrinsicSurface surface,
  int atInfinity,
  const RicciFlowOptions& options,
  ConformalDiskMap& map,
  const ProgressCallback& progress)
{
  IntrinsicTriangulation& t = surface.Triangulation;
  const Eigen::VectorXd targets = flatAngleSums(t);
  const IntrinsicTriangulation::Star star = t.removeStar(atInfinity);

  // A vertex on the other side of a seam has the very position of the vertex at infinity.
  double nearest = HUGE_VAL;
  for (const auto& spoke : star.Spokes)
  {
    nearest = std::min(nearest, static_cast<double>(std::exp(spoke.LogLength)));
  }
  const int n = t.vertexCount();
  IntrinsicTriangulation::Factors start(n);
  for (int v = 0; v < n; ++v)
  {
    // The inversion of space in the vertex at infinity, which is exact on planar surfaces.
    const double distance = (surface.Points.row(v) - surface.Points.row(atInfinity)).norm();
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

  const ComplexVector positions = embedInHalfPlane(
    t, flow.LogFactors, star.FirstBoundaryEdge, flow.Order, subrange(progress, 0.9, 0.95));
  report(progress, 0.95, "Layout");
  map.LayoutError = layoutError(t, flow.LogFactors, positions);
  requireLayout(map.LayoutError);
  return { std::move(t), positions, flow.LogFactors, atInfinity };
}

// Maps the surface with the first of the candidates at infinity that succeeds: near a vertex with an
// unlucky star the flow, which cannot flip the edges around infinity, may have no solution.
HalfPlaneMap mapToHalfPlane(const IntrinsicSurface& surface,
  const std::vector<int>& candidates,
  const RicciFlowOptions& options,
  ConformalDiskMap& map,
  const ProgressCallback& progress)
{
  const int attempts = std::min(static_cast<int>(candidates.size()), MostAttempts);
  int steps = 0;       // of the attempts that failed
  long long flips = 0; // the excessive ones of the same
  for (int k = 0; k < attempts; ++k)
  {
    try
    {
      const double begin = static_cast<double>(k) / attempts;
      const double end = static_cast<double>(k + 1) / attempts;
      return mapToHalfPlane(surface, candidates[k], options, map, subrange(progress, begin, end));
    }
    catch (const ConvergenceError& error)
    {
      const auto* flow = dynamic_cast<const RicciFlowStopped*>(&error);
      steps += flow ? flow->NewtonIterations : 0;
      flips += flow ? flow->ExcessiveFlips : 0;
      if (k + 1 == attempts || steps >= LateSteps || flips >= LateFlips)
      {
        throw;
      }
    }
  }
  throw ConvergenceError("no boundary vertex of the surface can be sent to infinity: remesh the surface "
                         "(Surface To Disk, Remesh)");
}

// The candidates for infinity that are close to the centre, best first: those around which the boundary
// subtends large angles there. (Distances in the half-plane do not tell: beyond the centre, all of the
// surface is as near as the centre itself.)
std::vector<int> candidatesNear(Complex centre,
  const HalfPlaneMap& half,
  const std::vector<int>& candidates)
{
  std::vector<int> along = candidates;
  along.erase(std::remove(along.begin(), along.end(), half.AtInfinity), along.end());
  std::sort(along.begin(),
    along.end(),
    [&half](int a, int b)
    {
      const double left = half.Positions[a].real();
      const double right = half.Positions[b].real();
      return left != right ? left < right : a < b;
    });
  std::map<int, double> angles;
  double greatest = 0.0;
  for (std::size_t i = 1; i + 1 < along.size(); ++i)
  {
    const double width = half.Positions[along[i + 1]].real() - half.Positions[along[i - 1]].real();
    const double angle = width / std::norm(half.Positions[along[i]] - centre);
    angles[along[i]] = angle;
    greatest = std::max(greatest, angle);
  }
  std::vector<int> near;
  std::copy_if(candidates.begin(),
    candidates.end(),
    std::back_inserter(near),
    [&](int v) { return angles.count(v) > 0 && angles[v] >= greatest / NearCentre; });
  return near;
}

// The positions of the first vertices.
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
  IntrinsicSurface surface = intrinsicSurface(mesh, map.Flips, progress);
  map.AddedLength = surface.Triangulation.addedLength();
  std::vector<int> candidates = verticesForInfinity(surface.Triangulation);
  TriangleMesh fine = mesh;
  while (candidates.empty() &&
         (fine.faceCount() == mesh.faceCount() || fine.faceCount() <= MostFacesOfCoarse))
  {
    fine = subdivided(fine);
    surface = intrinsicSurface(fine, map.Flips, progress);
    candidates = verticesForInfinity(surface.Triangulation);
  }
  HalfPlaneMap half = mapToHalfPlane(surface, candidates, options, map, subrange(progress, 0.1, 0.9));
  // Seen from an unlucky vertex at infinity, the surface is a speck, in which the next one is chosen.
  for (int closer = 0; closer < MostCloser; ++closer)
  {
    const Complex rough = centring.roughCentre(firstOf(half.Positions, n));
    if (std::abs(rough) <= MostLopsided * rough.imag())
    {
      break;
    }
    const std::vector<int> near = candidatesNear(rough, half, candidates);
    if (near.empty())
    {
      break;
    }
    half =
      mapToHalfPlane(surface, near, options, map, atFraction(progress, 0.9, "Moebius normalisation"));
  }
  report(progress, 0.95, "Moebius normalisation");
  const Complex centre = centring.centre(firstOf(half.Positions, n));
  ComplexVector disk = cayley(half.Positions, centre);
  moveToCircle(loop, disk);

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
  const double logMeanFactor = 0.5 * std::log(EIGEN_PI / area);
  const ComplexVector conformal = disk;
  map.SpreadVertices =
    spreadProtrusions(half.Triangulation, logFactors, logFactors, logMeanFactor, disk, n);
  // The triangulation of the flow may have inner vertices on its boundary.
  disk =
    spreadAlongCircle(surface.Triangulation, logFactors, logMeanFactor, fine.Faces, conformal, disk);
  map.Positions = pointsOf(firstOf(disk, n));
  return map;
}

} // namespace flattening
