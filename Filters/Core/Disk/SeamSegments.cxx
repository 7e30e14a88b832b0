// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamSegments.h"

#include "Mesh/DisjointSets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace flattening
{
namespace
{

// A side of the boundary between two points. A later step may have split an edge of one bank only: such
// vertices, which have no copy on the other bank, lie inside the side.
struct BankSide
{
  std::vector<int> Vertices; // of the disk, both ends included
  int Edge = -1;             // the number of the edge of the seam, which the other bank has too; or -1
};

// An edge of the seams, between two points.
struct SeamEdge
{
  std::array<int, 2> Ends;
  double Length = 0.0;
  int Segment = -1;
};

class SegmentFinder
{
public:
  explicit SegmentFinder(const DiskSurface& disk)
    : Disk(disk)
    , Vertices(disk.Surface.Mesh.Vertices)
  {
  }

  SeamSegments find(const std::optional<Eigen::Vector3d>& start)
  {
    this->Result.SegmentOf.assign(this->Vertices.rows(), 0);
    this->Result.Distance = Eigen::VectorXd::Zero(this->Vertices.rows());
    this->makeSides();
    this->pairSides();
    this->findNodes();
    this->measureDistances(this->starts(start));
    this->nameSegments();
    this->collectBorders();
    this->describeVertices();
    return std::move(this->Result);
  }

private:
  // A point at which edges of the seams end.
  struct Node
  {
    std::vector<int> Edges;
    bool IsOnBorder = false;
    double Distance = HUGE_VAL; // from the start

    bool isInsideSegment() const { return this->Edges.size() == 2 && !this->IsOnBorder; }
  };

  int pointOf(int vertex) const
  {
    const int point = this->Disk.SeamPoint[vertex];
    return point < 0 ? vertex : point;
  }

  // Divides the boundary at all vertices but those that only one bank has.
  void makeSides()
  {
    const std::vector<int>& loop = this->Disk.Boundary;
    const std::size_t count = loop.size();
    std::map<int, int> copies;
    for (const int v : loop)
    {
      ++copies[this->pointOf(v)];
    }
    const auto isOnOneBank = [&](std::size_t i)
    {
      return this->Disk.Seam[loop[i]] && copies[this->pointOf(loop[i])] == 1 &&
             this->pointOf(loop[(i + count - 1) % count]) != this->pointOf(loop[(i + 1) % count]);
    };
    std::size_t first = 0;
    while (first + 1 < count && isOnOneBank(first))
    {
      ++first;
    }
    BankSide side{ { loop[first] } };
    for (std::size_t k = 1; k <= count; ++k)
    {
      const std::size_t i = (first + k) % count;
      side.Vertices.push_back(loop[i]);
      if (k == count || !isOnOneBank(i))
      {
        this->addSide(std::exchange(side, BankSide{ { loop[i] } }));
      }
    }
  }

  // A side that leads back to its point goes around the end of a seam, its farthest vertex.
  void addSide(BankSide&& side)
  {
    const std::vector<int>& vertices = side.Vertices;
    if (this->pointOf(vertices.front()) != this->pointOf(vertices.back()))
    {
      this->Sides.push_back(std::move(side));
      return;
    }
    const auto distanceFromFront = [&](int v)
    { return (this->Vertices.row(v) - this->Vertices.row(vertices.front())).norm(); };
    const auto end = std::max_element(vertices.begin(),
      vertices.end(),
      [&](int a, int b) { return distanceFromFront(a) < distanceFromFront(b); });
    this->Sides.push_back({ { vertices.begin(), end + 1 } });
    this->Sides.push_back({ { end, vertices.end() } });
  }

  // Two sides between the same points, in opposite directions, are the banks of one edge.
  void pairSides()
  {
    std::map<std::array<int, 2>, int> sideBetween;
    for (int s = 0; s < static_cast<int>(this->Sides.size()); ++s)
    {
      const std::array<int, 2> ends = this->endsOf(s);
      sideBetween.emplace(ends, s);
      const auto other = sideBetween.find({ ends[1], ends[0] });
      if (other != sideBetween.end() && this->Sides[other->second].Edge < 0 && ends[0] != ends[1])
      {
        this->Sides[s].Edge = static_cast<int>(this->Edges.size());
        this->Sides[other->second].Edge = this->Sides[s].Edge;
        const double length = (this->Vertices.row(ends[0]) - this->Vertices.row(ends[1])).norm();
        this->Edges.push_back({ ends, length });
      }
    }
  }

  std::array<int, 2> endsOf(int side) const
  {
    const std::vector<int>& vertices = this->Sides[side].Vertices;
    return { this->pointOf(vertices.front()), this->pointOf(vertices.back()) };
  }

  void findNodes()
  {
    for (int e = 0; e < static_cast<int>(this->Edges.size()); ++e)
    {
      for (const int end : this->Edges[e].Ends)
      {
        this->Nodes[end].Edges.push_back(e);
      }
    }
    for (int s = 0; s < static_cast<int>(this->Sides.size()); ++s)
    {
      for (const int end : this->endsOf(s))
      {
        const auto node = this->Nodes.find(end);
        if (this->Sides[s].Edge < 0 && node != this->Nodes.end())
        {
          node->second.IsOnBorder = true;
        }
      }
    }
  }

  // One start for each set of seams that are joined.
  std::vector<int> starts(const std::optional<Eigen::Vector3d>& wanted) const
  {
    DisjointSets joined(this->Vertices.rows());
    for (const SeamEdge& edge : this->Edges)
    {
      joined.join(edge.Ends[0], edge.Ends[1]);
    }
    using Rank = std::tuple<int, double, int>; // its kind, the distance from the place wanted, the point
    std::map<int, Rank> best;
    for (const auto& [point, node] : this->Nodes)
    {
      const int kind = node.IsOnBorder ? 0 : node.Edges.size() == 1 ? 1 : node.isInsideSegment() ? 3 : 2;
      const double distance = wanted ? (this->Vertices.row(point).transpose() - *wanted).norm() : 0.0;
      const Rank rank{ kind, distance, point };
      const auto [entry, isFirst] = best.emplace(joined.find(point), rank);
      entry->second = isFirst ? rank : std::min(entry->second, rank);
    }
    std::vector<int> points;
    for (const auto& [set, rank] : best)
    {
      points.push_back(std::get<2>(rank));
    }
    return points;
  }

  // Dijkstra's algorithm on the graph of the seams.
  void measureDistances(const std::vector<int>& starts)
  {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int point : starts)
    {
      this->Nodes[point].Distance = 0.0;
      queue.emplace(0.0, point);
    }
    this->Start = starts.empty() ? -1 : *std::min_element(starts.begin(), starts.end());
    while (!queue.empty())
    {
      const auto [distance, point] = queue.top();
      queue.pop();
      for (const int e : this->Nodes[point].Edges)
      {
        const SeamEdge& edge = this->Edges[e];
        const int next = edge.Ends[edge.Ends[0] == point ? 1 : 0];
        if (distance + edge.Length < this->Nodes[next].Distance)
        {
          this->Nodes[next].Distance = distance + edge.Length;
          queue.emplace(this->Nodes[next].Distance, next);
        }
      }
    }
  }

  // Walks along the boundary of the disk from the start. A piece goes on where no other one ends.
  void nameSegments()
  {
    const auto count = static_cast<int>(this->Sides.size());
    int first = 0;
    while (this->Start >= 0 && this->endsOf(first)[0] != this->Start)
    {
      ++first;
    }
    std::vector<std::vector<int>>& segments = this->Result.Segments;
    for (int k = 0; k < count; ++k)
    {
      const int s = (first + k) % count;
      const int before = this->Sides[(s + count - 1) % count].Edge;
      const std::array<int, 2> ends = this->endsOf(s);
      if (this->Sides[s].Edge < 0 || this->Edges[this->Sides[s].Edge].Segment >= 0)
      {
        continue;
      }
      SeamEdge& edge = this->Edges[this->Sides[s].Edge];
      if (k > 0 && before >= 0 && this->Nodes[ends[0]].isInsideSegment())
      {
        edge.Segment = this->Edges[before].Segment;
      }
      else
      {
        edge.Segment = static_cast<int>(segments.size());
        segments.push_back({ ends[0] });
        this->Result.Lengths.push_back(0.0);
      }
      segments[edge.Segment].push_back(ends[1]);
      this->Result.Lengths[edge.Segment] += edge.Length;
    }
    for (std::vector<int>& segment : segments)
    {
      if (this->Nodes[segment.front()].Distance > this->Nodes[segment.back()].Distance)
      {
        std::reverse(segment.begin(), segment.end());
      }
    }
  }

  void collectBorders()
  {
    const auto count = static_cast<int>(this->Sides.size());
    int first = 0;
    while (first < count && this->Sides[first].Edge < 0)
    {
      ++first;
    }
    bool continues = false;
    for (int k = 0; k < count; ++k)
    {
      const BankSide& side = this->Sides[(first + k) % count];
      if (side.Edge < 0)
      {
        if (!continues)
        {
          this->Result.Borders.push_back({ this->pointOf(side.Vertices.front()) });
        }
        for (std::size_t i = 1; i < side.Vertices.size(); ++i)
        {
          this->Result.Borders.back().push_back(this->pointOf(side.Vertices[i]));
        }
      }
      continues = side.Edge < 0;
    }
  }

  void describeVertices()
  {
    for (const BankSide& side : this->Sides)
    {
      if (side.Edge < 0)
      {
        continue;
      }
      const auto from = static_cast<Eigen::RowVector3d>(this->Vertices.row(side.Vertices.front()));
      const double start = this->Nodes[this->pointOf(side.Vertices.front())].Distance;
      const double end = this->Nodes[this->pointOf(side.Vertices.back())].Distance;
      for (const int v : side.Vertices)
      {
        const double share = (this->Vertices.row(v) - from).norm() / this->Edges[side.Edge].Length;
        this->Result.SegmentOf[v] = this->Edges[side.Edge].Segment + 1;
        this->Result.Distance[v] = start + share * (end - start);
      }
    }
    for (const int v : this->Disk.Boundary)
    {
      const auto node = this->Nodes.find(this->pointOf(v));
      if (node != this->Nodes.end())
      {
        int segment = this->Edges[node->second.Edges.front()].Segment;
        for (const int e : node->second.Edges)
        {
          segment = std::min(segment, this->Edges[e].Segment);
        }
        this->Result.SegmentOf[v] = segment + 1;
        this->Result.Distance[v] = node->second.Distance;
      }
    }
  }

  const DiskSurface& Disk;
  const Points3& Vertices;
  std::vector<BankSide> Sides; // along the boundary
  std::vector<SeamEdge> Edges;
  std::map<int, Node> Nodes; // by point
  int Start = -1;
  SeamSegments Result;
};

} // namespace

std::vector<int> pointsOfSeam(const VertexOrigins& origins, const std::vector<char>& onSeam)
{
  using Row = std::vector<std::pair<int, double>>;
  std::map<Row, int> firstCopy;
  std::vector<int> points(onSeam.size(), -1);
  for (int v = 0; v < static_cast<int>(onSeam.size()); ++v)
  {
    if (onSeam[v])
    {
      Row row;
      for (VertexOrigins::InnerIterator origin(origins, v); origin; ++origin)
      {
        row.emplace_back(static_cast<int>(origin.col()), origin.value());
      }
      points[v] = firstCopy.emplace(std::move(row), v).first->second;
    }
  }
  return points;
}

SeamSegments seamSegments(const DiskSurface& disk, const std::optional<Eigen::Vector3d>& start)
{
  return SegmentFinder(disk).find(start);
}

} // namespace flattening
