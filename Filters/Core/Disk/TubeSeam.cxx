// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/TubeSeam.h"

#include "Geodesics/DijkstraDistance.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshMeasures.h"
#include "Repair/HoleFilling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;

// The least length of the shorter end of a tube, as a share of the longer one. A convention: a shorter
// end would become a hole that the flat map stretches much.
constexpr double LeastEnd = 0.25;
// Rounds in which both ends move, and trials of a move, each half as long as the one before. Guards for
// time: each trial computes a geodesic. With fewer the seam may meet the ends at other than right
// angles.
constexpr int MostRounds = 5;
constexpr int MostTrials = 2;
// What a move must make the seam shorter by, as a share of its length. A guard against moves by
// rounding.
constexpr double LeastGain = 1e-6;
// The part of the seam at an end that gives its direction there, as a share of its length. A convention:
// a shorter part follows the roughness of the surface, a longer one is not the direction at the end.
constexpr double ArrivalShare = 0.05;
// The longest move of an end, as a share of its loop's length. A guard: Newton's step is too long where
// the seam is nearly tangential to the loop.
constexpr double LongestMove = 0.25;

// A boundary loop on which an end of the seam moves.
class EndLoop
{
public:
  EndLoop(const TriangleMesh& mesh, const std::vector<int>& loop)
    : Mesh(mesh)
    , Loop(loop)
    , Along(loop.size() + 1, 0.0)
  {
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const Eigen::RowVector3d edge =
        this->point(static_cast<int>(k) + 1) - this->point(static_cast<int>(k));
      this->Along[k + 1] = this->Along[k] + edge.norm();
    }
  }

  double length() const { return this->Along.back(); }
  int size() const { return static_cast<int>(this->Loop.size()); }
  int vertex(int k) const { return this->Loop[k]; }

  Eigen::RowVector3d point(int k) const
  {
    return this->Mesh.Vertices.row(this->Loop[(k + this->size()) % this->size()]);
  }

  Eigen::RowVector3d tangent(int k) const
  {
    return (this->point(k + 1) - this->point(k - 1)).normalized();
  }

  // The number of the vertex nearest to the point at this distance along the loop from vertex number k.
  int moved(int k, double distance) const
  {
    const double target = this->Along[k] + distance;
    const double wrapped = target - this->length() * std::floor(target / this->length());
    const auto after = std::lower_bound(this->Along.begin(), this->Along.end(), wrapped);
    const auto next = static_cast<int>(after - this->Along.begin());
    const bool isBefore =
      next > 0 && wrapped - this->Along[next - 1] < this->Along[std::min(next, this->size())] - wrapped;
    return (isBefore ? next - 1 : next) % this->size();
  }

private:
  const TriangleMesh& Mesh;
  const std::vector<int>& Loop;
  std::vector<double> Along;
};

class TubeSeamSearch
{
public:
  TubeSeamSearch(const TriangleMesh& mesh,
    const std::vector<int>& firstLoop,
    const std::vector<int>& secondLoop)
    : Surface(mesh)
    , Loops{ EndLoop(mesh, firstLoop), EndLoop(mesh, secondLoop) }
  {
  }

  std::vector<Eigen::Vector3d> run(const ProgressCallback& progress)
  {
    this->start();
    bool moved = true;
    for (int round = 0; moved && round < MostRounds; ++round)
    {
      report(progress, static_cast<double>(round) / MostRounds, "placing the seam");
      const bool first = this->moveEnd(0);
      moved = this->moveEnd(1) || first;
    }
    return { this->Loops[0].point(this->Ends[0]).transpose(),
      this->Loops[1].point(this->Ends[1]).transpose() };
  }

private:
  // Puts the ends where the shortest path along edges ends.
  void start()
  {
    const DijkstraDistances distances(this->Surface.mesh());
    std::vector<Vertex> sources;
    for (int k = 0; k < this->Loops[0].size(); ++k)
    {
      sources.emplace_back(this->Loops[0].vertex(k));
    }
    this->Ends[1] = this->nearestVertex(1, distances.from(sources));
    this->Ends[0] = this->nearestVertex(0, distances.from({ this->vertexAt(1) }));
    this->Path = this->pathWith(0, this->Ends[0]);
  }

  int nearestVertex(int end, const Eigen::VectorXd& distance) const
  {
    int nearest = 0;
    for (int k = 1; k < this->Loops[end].size(); ++k)
    {
      // Compared in single precision: of distances that differ by rounding the first one wins.
      if (static_cast<float>(distance[this->Loops[end].vertex(k)]) <
          static_cast<float>(distance[this->Loops[end].vertex(nearest)]))
      {
        nearest = k;
      }
    }
    return nearest;
  }

  Vertex vertexAt(int end) const { return Vertex(this->Loops[end].vertex(this->Ends[end])); }

  GeodesicPath pathWith(int end, int number) const
  {
    const Vertex here(this->Loops[end].vertex(number));
    return end == 0 ? geodesicPath(this->Surface.mesh(), here, this->vertexAt(1))
                    : geodesicPath(this->Surface.mesh(), this->vertexAt(0), here);
  }

  // Moves an end of the seam, and returns whether that made the seam shorter.
  bool moveEnd(int end)
  {
    const EndLoop& loop = this->Loops[end];
    const double cosine = this->arrival(end).dot(loop.tangent(this->Ends[end]));
    double move = -this->Path.Length * cosine / std::max(1.0 - cosine * cosine, 0.1);
    move = std::clamp(move, -LongestMove * loop.length(), LongestMove * loop.length());
    for (int trial = 0; trial < MostTrials; ++trial, move *= 0.5)
    {
      const int number = loop.moved(this->Ends[end], move);
      if (number == this->Ends[end])
      {
        return false;
      }
      GeodesicPath path = this->pathWith(end, number);
      if (path.Length < (1.0 - LeastGain) * this->Path.Length)
      {
        this->Path = std::move(path);
        this->Ends[end] = number;
        return true;
      }
    }
    return false;
  }

  // The direction in which the path arrives at the end.
  Eigen::RowVector3d arrival(int end) const
  {
    const auto& points = this->Path.Points;
    const auto fromEnd = [&](std::size_t k) -> Eigen::RowVector3d
    {
      return positionOf(this->Surface.mesh(), end == 0 ? points[k] : points[points.size() - 1 - k])
        .transpose();
    };
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      const Eigen::RowVector3d way = fromEnd(0) - fromEnd(k);
      if (way.norm() > ArrivalShare * this->Path.Length)
      {
        return way.normalized();
      }
    }
    return Eigen::RowVector3d::Zero();
  }

  EditableSurface Surface;
  EndLoop Loops[2];
  int Ends[2] = { 0, 0 }; // numbers of the vertices in their loops
  GeodesicPath Path;
};

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
  const auto longestBut = [&lengths](int other)
  {
    int longest = other == 0 ? 1 : 0;
    for (int k = 0; k < static_cast<int>(lengths.size()); ++k)
    {
      longest = k != other && lengths[k] > lengths[longest] ? k : longest;
    }
    return longest;
  };
  const int first = longestBut(-1);
  const int second = longestBut(first);
  return lengths[second] >= LeastEnd * lengths[first] ? std::vector<int>{ first, second }
                                                      : std::vector<int>{};
}

std::vector<Eigen::Vector3d> placeTubeSeam(const TriangleMesh& mesh,
  const std::vector<int>& firstLoop,
  const std::vector<int>& secondLoop,
  const ProgressCallback& progress)
{
  return TubeSeamSearch(mesh, firstLoop, secondLoop).run(progress);
}

} // namespace flattening
