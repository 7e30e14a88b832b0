// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/TubeSeam.h"

#include "Base/Errors.h"
#include "Geodesics/DijkstraDistance.h"
#include "Geodesics/GeodesicSearch.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshMeasures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;

// The least length of the shorter end of a tube, as a share of the longer one. A convention: a shorter
// end would become a hole that the flat map stretches much.
constexpr double LeastEnd = 0.25;
// The least share of its length by which a move must shorten the seam. A guard against moves by
// rounding.
constexpr double LeastGain = 1e-6;

// Compared in single precision: of distances that differ by rounding the first one wins.
int nearestOf(const std::vector<int>& loop, const Eigen::VectorXd& distance)
{
  const auto isNearer = [&distance](int a, int b)
  { return static_cast<float>(distance[a]) < static_cast<float>(distance[b]); };
  return *std::min_element(loop.begin(), loop.end(), isNearer);
}

} // namespace

std::vector<int> endsOfTube(const Points3& vertices, const std::vector<std::vector<int>>& loops)
{
  if (loops.size() < 2)
  {
    return {};
  }
  std::vector<double> lengths;
  for (const std::vector<int>& loop : loops)
  {
    lengths.push_back(loopLength(vertices, loop));
  }
  std::vector<int> order(loops.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&lengths](int a, int b) { return lengths[a] > lengths[b]; });
  order.resize(2);
  return lengths[order[1]] >= LeastEnd * lengths[order[0]] ? order : std::vector<int>{};
}

std::vector<Eigen::Vector3d> placeTubeSeam(const TriangleMesh& mesh,
  const std::vector<int>& firstLoop,
  const std::vector<int>& secondLoop,
  const ProgressCallback& progress)
{
  report(progress, 0.0, "placing the seam");
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  const Eigen::VectorXd fromFirst =
    distancesAlongEdges(surface, std::vector<Vertex>(firstLoop.begin(), firstLoop.end()));
  std::array<int, 2> ends{ -1, nearestOf(secondLoop, fromFirst) };
  ends[0] = nearestOf(firstLoop, distancesAlongEdges(surface, { Vertex(ends[1]) }));
  double length = fromFirst[ends[1]];
  if (!std::isfinite(length))
  {
    throw TopologyError("no path over the surface joins the ends of the tube: they lie on parts that "
                        "are not connected");
  }
  std::vector<int> endOf(mesh.vertexCount(), -1);
  for (int end = 0; end < 2; ++end)
  {
    for (const int v : end == 0 ? firstLoop : secondLoop)
    {
      endOf[v] = end;
    }
  }
  const UnfoldableFaces faces(mesh, Seams::Open);
  GeodesicSearch search(faces);
  const auto check = [&progress] { report(progress, 0.5, "placing the seam"); };
  bool moved = true;
  for (int end = 0; moved || end == 1; end = 1 - end)
  {
    moved = false;
    for (const ReachedVertex& reached : search.within(length, ends[1 - end], check))
    {
      if (endOf[reached.Vertex] == end && reached.Distance < (1.0 - LeastGain) * length)
      {
        moved = moved || ends[end] != reached.Vertex;
        ends[end] = reached.Vertex;
        length = reached.Distance;
      }
    }
  }
  return { mesh.Vertices.row(ends[0]).transpose(), mesh.Vertices.row(ends[1]).transpose() };
}

} // namespace flattening
