// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SpreadVertices.h"

#include "Mesh/VertexFaces.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace flattening
{
namespace
{

// The distance that is asked for near the boundary, in distances from it. A choice: from one ring of
// triangles to the next, sides grow by half.
constexpr double SpacingPerDistance = 0.7;
constexpr int VerticesPerReport = 10000;

class EdgeDistances
{
public:
  explicit EdgeDistances(const TriangleMesh& mesh)
    : Mesh(mesh)
    , FacesOf(mesh.Faces, mesh.vertexCount())
  {
  }

  double edge(int a, int b) const
  {
    return (this->Mesh.Vertices.row(a) - this->Mesh.Vertices.row(b)).norm();
  }

  Eigen::VectorXd none() const
  {
    return Eigen::VectorXd::Constant(this->Mesh.vertexCount(), std::numeric_limits<double>::infinity());
  }

  // Lowers distances to those from the sources where these are below the limit (Dijkstra's algorithm).
  void lower(Eigen::VectorXd& distances, const std::vector<int>& sources, double limit) const
  {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (const int source : sources)
    {
      distances[source] = 0.0;
      queue.emplace(0.0, source);
    }
    while (!queue.empty())
    {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (distance > distances[v])
      {
        continue;
      }
      for (const int face : this->FacesOf[v])
      {
        for (const int other : this->Mesh.Faces.row(face))
        {
          const double there = distance + this->edge(v, other);
          if (there < limit && there < distances[other])
          {
            distances[other] = there;
            queue.emplace(there, other);
          }
        }
      }
    }
  }

private:
  const TriangleMesh& Mesh;
  VertexFaces FacesOf;
};

} // namespace

std::vector<int> spreadVertices(const TriangleMesh& disk,
  const std::vector<int>& loop,
  double spacing,
  const ProgressCallback& progress)
{
  const EdgeDistances along(disk);
  Eigen::VectorXd fromBoundary = along.none();
  along.lower(fromBoundary, loop, std::numeric_limits<double>::infinity());
  double length = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    length += along.edge(loop[k], loop[(k + 1) % loop.size()]);
  }
  const double meanEdge = length / static_cast<double>(loop.size());
  std::vector<int> chosen = loop;
  Eigen::VectorXd fromChosen = along.none(); // infinite where it is as great as was asked for
  along.lower(fromChosen, loop, std::min(spacing, SpacingPerDistance * meanEdge));
  for (int v = 0; v < disk.vertexCount(); ++v)
  {
    if (v % VerticesPerReport == 0)
    {
      report(progress, static_cast<double>(v) / disk.vertexCount(), "Spreading vertices");
    }
    if (std::isinf(fromChosen[v]))
    {
      chosen.push_back(v);
      along.lower(fromChosen, { v }, std::min(spacing, SpacingPerDistance * fromBoundary[v]));
    }
  }
  return chosen;
}

} // namespace flattening
