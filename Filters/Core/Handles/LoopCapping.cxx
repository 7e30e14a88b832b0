// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/LoopCapping.h"

#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/HoleTriangulation.h"
#include "Mesh/SliverThresholds.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

using Polyline = std::vector<Eigen::Vector3d>;
using Faces = std::vector<std::array<int, 3>>;

// Reverses the faces if their sides do not have the direction of the loop.
void orientAlongLoop(Faces& faces, int n)
{
  const bool along = std::any_of(faces.begin(),
    faces.end(),
    [n](const auto& face)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (face[k] < n && face[(k + 1) % 3] == (face[k] + 1) % n)
        {
          return true;
        }
      }
      return false;
    });
  if (!along)
  {
    for (auto& face : faces)
    {
      std::swap(face[1], face[2]);
    }
  }
}

std::vector<double> sideLengths(const Polyline& loop)
{
  std::vector<double> lengths;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    lengths.push_back((loop[(i + 1) % loop.size()] - loop[i]).norm());
  }
  return lengths;
}

double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TriangleMesh meshOf(const Polyline& points, const Faces& faces)
{
  return { Eigen::Map<const Points3>(points[0].data(), static_cast<Eigen::Index>(points.size()), 3),
    Eigen::Map<const FaceMatrix>(faces[0].data(), static_cast<Eigen::Index>(faces.size()), 3) };
}

// Replaces the faces by nearly equilateral ones with the loop's mean side length. This works on a cone
// too, where the long edges to the centre would make refine() add hardly any vertex.
void remesh(SurfaceMesh& mesh, const Polyline& loop)
{
  const std::vector<double> sides = sideLengths(loop);
  // CGAL splits edges above 4/3 of the target. If the loop's edges, which stay, were longer than that,
  // the edges beside them would be too, and splitting would not end: so they are 1.2 targets long at
  // most. With a factor above 4/3 remeshing can use up all memory; one near 1 makes caps coarser.
  constexpr double LongestOfLoop = 1.2;
  constexpr int Iterations = 3; // a convention, as in CGAL's examples
  PMP::isotropic_remeshing(mesh.faces(),
    std::max(sum(sides) / static_cast<double>(loop.size()),
      *std::max_element(sides.begin(), sides.end()) / LongestOfLoop),
    mesh,
    CGAL::parameters::number_of_iterations(Iterations).protect_constraints(true));
  mesh.collect_garbage();
}

// Whether a face is a cap by the measure of the repair. The centre of a loop on a straight line lies off
// the line by rounding, so that the faces of the cone have an area but no shape: around a vertex among
// them CGAL's relaxation finds no normal, and crashes.
bool hasCap(const TriangleMesh& cone)
{
  const Eigen::VectorXd areas = faceAreas(cone.Vertices, cone.Faces);
  for (int f = 0; f < cone.faceCount(); ++f)
  {
    const Eigen::Matrix3d corners = faceCorners(cone, f);
    double longest2 = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest2 = std::max(longest2, (corners.row((k + 1) % 3) - corners.row(k)).squaredNorm());
    }
    if (!(2.0 * areas[f] > slivers::CapAltitude * longest2))
    {
      return true;
    }
  }
  return false;
}

// The weights of the loop's vertices at a point of a coarse triangulation of the loop. Its vertices may
// include the centre of the loop, which is made of all of them in equal shares.
Origin weightsAt(const SurfacePoint& point, const TriangleMesh& coarse, int loopSize)
{
  Origin weights;
  double share = 0.0; // of each vertex in the centre's weight
  for (int k = 0; k < 3; ++k)
  {
    const int corner = coarse.Faces(point.Face, k);
    if (corner >= loopSize)
    {
      share = point.Weights[k] / loopSize;
    }
    else if (point.Weights[k] > 0.0)
    {
      weights.emplace_back(corner, point.Weights[k]);
    }
  }
  if (!(share > 0.0))
  {
    return weights;
  }
  Origin all;
  for (int i = 0; i < loopSize; ++i)
  {
    all.emplace_back(i, share);
  }
  for (const auto& [corner, weight] : weights)
  {
    all[corner].second += weight;
  }
  return all;
}

// The cap of a refined mesh, with weights by the coarse triangulation that it was made from.
LoopCap capOf(const SurfaceMesh& mesh, const TriangleMesh& coarse, std::size_t loopSize)
{
  const TriangleMesh fine = toTriangleMesh(mesh);
  LoopCap cap;
  for (int f = 0; f < fine.faceCount(); ++f)
  {
    cap.Faces.push_back({ fine.Faces(f, 0), fine.Faces(f, 1), fine.Faces(f, 2) });
  }
  const auto n = static_cast<int>(loopSize);
  if (fine.vertexCount() > n)
  {
    const ClosestPointTree surface(coarse);
    for (int v = n; v < fine.vertexCount(); ++v)
    {
      cap.Inside.push_back(fine.Vertices.row(v).transpose());
      cap.Weights.push_back(weightsAt(surface.closest(cap.Inside.back()), coarse, n));
    }
  }
  return cap;
}

// Splits the edge between two vertices, and the faces beside it, at a vertex in the middle.
void splitFacesAt(Faces& faces, int a, int b, int middle)
{
  const std::size_t old = faces.size();
  for (std::size_t f = 0; f < old; ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = faces[f][k];
      const int to = faces[f][(k + 1) % 3];
      if ((from == a && to == b) || (from == b && to == a))
      {
        const int corner = faces[f][(k + 2) % 3];
        faces[f] = { from, middle, corner };
        faces.push_back({ middle, to, corner });
        break;
      }
    }
  }
}

} // namespace

LoopCap spanningCap(const Polyline& loop)
{
  Faces faces = triangulatedLoop(loop);
  if (faces.empty())
  {
    return {};
  }
  orientAlongLoop(faces, static_cast<int>(loop.size()));
  const TriangleMesh coarse = meshOf(loop, faces);
  SurfaceMesh mesh = toSurfaceMesh(coarse);
  refineFaces(mesh, { mesh.faces().begin(), mesh.faces().end() });
  return capOf(mesh, coarse, loop.size());
}

LoopCap coneCap(const Polyline& loop)
{
  const auto n = static_cast<int>(loop.size());
  Polyline points = loop;
  points.emplace_back(Eigen::Vector3d::Zero());
  Faces faces;
  for (int i = 0; i < n; ++i)
  {
    points.back() += loop[i] / n;
    faces.push_back({ i, (i + 1) % n, n });
  }
  const TriangleMesh coarse = meshOf(points, faces);
  SurfaceMesh mesh = toSurfaceMesh(coarse);
  if (!hasCap(coarse))
  {
    remesh(mesh, loop);
  }
  return capOf(mesh, coarse, loop.size());
}

void splitEdgesOf(const HalfedgeSurface& surface,
  const std::vector<int>& vertices,
  const Polyline& loop,
  LoopCap& cap)
{
  const auto n = static_cast<int>(vertices.size());
  for (std::size_t f = 0; f < cap.Faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = cap.Faces[f][k];
      const int b = cap.Faces[f][(k + 1) % 3];
      if (a >= n || b >= n || (a + 1) % n == b || (b + 1) % n == a ||
          surface.edgeBetween(vertices[a], vertices[b]) < 0)
      {
        continue;
      }
      cap.Inside.push_back(0.5 * (loop[a] + loop[b]));
      cap.Weights.push_back({ { a, 0.5 }, { b, 0.5 } });
      splitFacesAt(cap.Faces, a, b, n + static_cast<int>(cap.Inside.size()) - 1);
      k = -1; // the face has changed: look at all of its sides again
    }
  }
}

} // namespace flattening
