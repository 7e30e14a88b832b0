// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/LoopCapping.h"

#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/HoleTriangulation.h"

namespace flattening
{
namespace
{

using Polyline = std::vector<Eigen::Vector3d>;
using Faces = std::vector<std::array<int, 3>>;

TriangleMesh meshOf(const Polyline& points, const Faces& faces)
{
  return { Eigen::Map<const Points3>(points[0].data(), static_cast<Eigen::Index>(points.size()), 3),
    Eigen::Map<const FaceMatrix>(faces[0].data(), static_cast<Eigen::Index>(faces.size()), 3) };
}

// The cap of a refined mesh, with weights by the coarse triangulation that it was made from.
LoopCap capOf(const SurfaceMesh& mesh, const TriangleMesh& coarse)
{
  const TriangleMesh fine = toTriangleMesh(mesh);
  LoopCap cap;
  for (int f = 0; f < fine.faceCount(); ++f)
  {
    cap.Faces.push_back({ fine.Faces(f, 0), fine.Faces(f, 1), fine.Faces(f, 2) });
  }
  const ClosestPointTree surface(coarse);
  for (int v = coarse.vertexCount(); v < fine.vertexCount(); ++v)
  {
    cap.Inside.push_back(fine.Vertices.row(v).transpose());
    const SurfacePoint at = surface.closest(cap.Inside.back());
    cap.Weights.push_back(originOf(coarse.Faces, at.Face, at.Weights));
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
  const Faces faces = triangulatedLoop(loop);
  if (faces.empty())
  {
    return {};
  }
  const TriangleMesh coarse = meshOf(loop, faces);
  SurfaceMesh mesh = toSurfaceMesh(coarse);
  refineFaces(mesh, { mesh.faces().begin(), mesh.faces().end() });
  return capOf(mesh, coarse);
}

LoopCap coneCap(const Polyline& loop)
{
  const auto n = static_cast<int>(loop.size());
  LoopCap cap;
  cap.Inside.emplace_back(Eigen::Vector3d::Zero());
  cap.Weights.emplace_back();
  for (int i = 0; i < n; ++i)
  {
    cap.Inside.back() += loop[i] / n;
    cap.Weights.back().emplace_back(i, 1.0 / n);
    cap.Faces.push_back({ i, (i + 1) % n, n });
  }
  return cap;
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
