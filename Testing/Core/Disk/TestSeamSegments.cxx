// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamSegments.h"
#include "Disk/SurfaceToDisk.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

using Place = std::array<long long, 3>;

// In billionths: where both banks were refined, they differ by rounding.
Place placeOf(const DiskSurface& disk, int vertex)
{
  const Eigen::RowVector3d x = 1e9 * disk.Surface.Mesh.Vertices.row(vertex);
  return { std::llround(x[0]), std::llround(x[1]), std::llround(x[2]) };
}

double edgeLength(const DiskSurface& disk, int a, int b)
{
  return (disk.Surface.Mesh.Vertices.row(a) - disk.Surface.Mesh.Vertices.row(b)).norm();
}

double lengthOf(const DiskSurface& disk, const std::vector<int>& line)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    length += edgeLength(disk, line[i], line[i + 1]);
  }
  return length;
}

// Checks what holds for every cut of a surface that has no two points in one place. Copies of a point
// are found by their coordinates here, not by what they are made of.
void expectBanks(const DiskSurface& disk, const SeamSegments& seams, const std::string& name)
{
  const std::vector<int>& loop = disk.Boundary;
  const double tolerance = 1e-12 * disk.Report.BoundaryLength;

  // The pieces are the seams, and with the rest, once more for the other bank, the boundary.
  double total = 0.0;
  for (std::size_t s = 0; s < seams.Segments.size(); ++s)
  {
    EXPECT_NEAR(seams.Lengths[s], lengthOf(disk, seams.Segments[s]), tolerance) << name << " " << s;
    total += seams.Lengths[s];
  }
  EXPECT_NEAR(total, disk.Report.SeamLength, tolerance) << name;
  for (const std::vector<int>& border : seams.Borders)
  {
    total += 0.5 * lengthOf(disk, border);
  }
  EXPECT_NEAR(2.0 * total, disk.Report.BoundaryLength, tolerance) << name;

  // Each side of the boundary with a copy elsewhere belongs to a piece, whose two banks are made of
  // copies.
  std::map<std::pair<Place, Place>, int> sides;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    ++sides[std::minmax(placeOf(disk, loop[i]), placeOf(disk, loop[(i + 1) % loop.size()]))];
  }
  std::map<std::pair<Place, Place>, int> edges;
  for (const std::vector<int>& segment : seams.Segments)
  {
    for (std::size_t i = 0; i + 1 < segment.size(); ++i)
    {
      ++edges[std::minmax(placeOf(disk, segment[i]), placeOf(disk, segment[i + 1]))];
    }
  }
  for (const auto& [side, count] : sides)
  {
    EXPECT_EQ(count, edges.count(side) + 1u) << name;
  }
  for (const auto& [edge, count] : edges)
  {
    EXPECT_EQ(count, 1) << name;
    EXPECT_EQ(sides.count(edge), 1u) << name;
  }

  // Copies have the same number and distance to the last bit, and a side is as long as its distances
  // say.
  std::map<Place, int> firstCopy;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int v = loop[i];
    const int next = loop[(i + 1) % loop.size()];
    const int copy = firstCopy.emplace(placeOf(disk, v), v).first->second;
    EXPECT_EQ(seams.SegmentOf[v], seams.SegmentOf[copy]) << name;
    EXPECT_EQ(seams.Distance[v], seams.Distance[copy]) << name;
    const bool isSeam = sides.at(std::minmax(placeOf(disk, v), placeOf(disk, next))) == 2;
    EXPECT_TRUE(!isSeam || (seams.SegmentOf[v] > 0 && seams.SegmentOf[next] > 0)) << name;
    if (isSeam && disk.Report.Genus == 0)
    {
      EXPECT_NEAR(
        std::abs(seams.Distance[v] - seams.Distance[next]), edgeLength(disk, v, next), tolerance)
        << name;
    }
  }
  std::map<int, int> smallest; // number at each point
  for (std::size_t s = 0; s < seams.Segments.size(); ++s)
  {
    const std::vector<int>& segment = seams.Segments[s];
    EXPECT_LE(seams.Distance[segment.front()], seams.Distance[segment.back()]) << name;
    for (const int point : segment)
    {
      smallest.emplace(point, static_cast<int>(s) + 1);
    }
  }
  for (const auto& [point, number] : smallest)
  {
    EXPECT_EQ(seams.SegmentOf[point], number) << name;
  }
}

// The numbers of the pieces that meet at each place where pieces end.
std::map<int, std::set<int>> piecesAtEnds(const SeamSegments& seams)
{
  std::map<int, std::set<int>> pieces;
  for (int s = 0; s < static_cast<int>(seams.Segments.size()); ++s)
  {
    pieces[seams.Segments[s].front()].insert(s);
    pieces[seams.Segments[s].back()].insert(s);
  }
  return pieces;
}

int tipCount(const SeamSegments& seams)
{
  int tips = 0;
  for (const auto& [point, pieces] : piecesAtEnds(seams))
  {
    tips += pieces.size() == 1 ? 1 : 0;
  }
  return tips;
}

DiskSurface seamThrough(const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& points,
  const std::vector<int>& starts = {})
{
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Seam;
  options.SeamPoints = points;
  options.SeamPathStarts = starts;
  return surfaceToDisk(mesh, options);
}

DiskSurface cutBy(const TriangleMesh& mesh, CutMode cut, HandleMode handles = HandleMode::Remove)
{
  SurfaceToDiskOptions options;
  options.Cut = cut;
  options.Handles = handles;
  options.Relief.Gain = 0.01;
  options.Plane.Normal = Eigen::Vector3d(0.1, 0.2, 1.0);
  return surfaceToDisk(mesh, options);
}

TriangleMesh sphereWithFingers()
{
  TriangleMesh mesh = sphere(4);
  const std::vector<Eigen::Vector3d> directions{ { 0.0, 0.0, 1.0 },
    Eigen::Vector3d(1.0, 0.3, -0.2).normalized(),
    Eigen::Vector3d(-0.6, 0.8, -0.3).normalized(),
    Eigen::Vector3d(-0.3, -0.8, -0.5).normalized() };
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Eigen::Vector3d x = mesh.Vertices.row(v).transpose();
    for (const Eigen::Vector3d& direction : directions)
    {
      const double angle = std::acos(std::clamp(x.dot(direction), -1.0, 1.0));
      mesh.Vertices.row(v) += 0.8 * std::exp(-angle * angle / 0.09) * x.transpose();
    }
  }
  return mesh;
}

TEST(SeamSegments, OfOneSeamIsOnePieceFromItsStart)
{
  const std::vector<Eigen::Vector3d> ends{ { 1.0, 0.1, 0.0 }, { 0.1, -0.2, 1.0 } };
  const DiskSurface disk = seamThrough(sphere(4), { ends[0].normalized(), ends[1].normalized() });
  for (const int first : { 0, 1 })
  {
    const SeamSegments seams = seamSegments(disk, ends[first]);
    expectBanks(disk, seams, "one seam");
    ASSERT_EQ(seams.Segments.size(), 1u);
    EXPECT_TRUE(seams.Borders.empty());
    const std::vector<int>& line = seams.Segments[0];
    EXPECT_EQ(2 * line.size() - 2, disk.Boundary.size());
    EXPECT_LT(
      (disk.Surface.Mesh.Vertices.row(line.front()) - ends[first].transpose().normalized()).norm(),
      0.02);
    EXPECT_EQ(seams.Distance[line.front()], 0.0);
    EXPECT_NEAR(seams.Distance[line.back()], disk.Report.SeamLength, 1e-12);
  }
}

// Paths from one point: as many tips as pieces. A path that begins on the inside of another one divides
// it.
TEST(SeamSegments, ATreeHasOnePieceLessThanEnds)
{
  const std::vector<Eigen::Vector3d> star{
    { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 }
  };
  const DiskSurface disk = seamThrough(sphere(4), star, { 3, 5 });
  const SeamSegments seams = seamSegments(disk, star.front());
  expectBanks(disk, seams, "star");
  EXPECT_EQ(seams.Segments.size(), 4u);
  EXPECT_EQ(tipCount(seams), 4);
  for (int s = 0; s < 4; ++s)
  {
    // The first piece leads to the centre of the star, the others away from it.
    EXPECT_NEAR(seams.Distance[seams.Segments[s].back()], (s == 0 ? 0.5 : 1.0) * Pi, 0.02) << s;
    EXPECT_NEAR(seams.Lengths[s], 0.5 * Pi, 0.01) << s;
  }

  for (const CutMode cut : { CutMode::Relief, CutMode::Automatic, CutMode::Seam })
  {
    const DiskSurface fingers = cutBy(sphereWithFingers(), cut);
    const SeamSegments pieces = seamSegments(fingers);
    expectBanks(fingers, pieces, "fingers");
    const auto ends = piecesAtEnds(pieces);
    EXPECT_EQ(ends.size(), pieces.Segments.size() + 1);
    EXPECT_GE(tipCount(pieces), 2);
    EXPECT_LE(tipCount(pieces), cut == CutMode::Seam ? 2 : fingers.Report.ReliefBranches + 1);
  }
}

TEST(SeamSegments, OfOpenSurfacesStartAtTheBorder)
{
  TriangleMesh cup = cutBy(sphereWithFingers(), CutMode::Plane).Surface.Mesh;
  const DiskSurface plane = cutBy(cup, CutMode::Hole);
  const SeamSegments none = seamSegments(plane);
  expectBanks(plane, none, "no seam");
  EXPECT_TRUE(none.Segments.empty());
  ASSERT_EQ(none.Borders.size(), 1u);
  EXPECT_EQ(none.Borders[0].size(), plane.Boundary.size() + 1);
  EXPECT_EQ(none.Borders[0].front(), none.Borders[0].back());

  const DiskSurface disk = cutBy(cup, CutMode::Relief);
  const SeamSegments seams = seamSegments(disk);
  expectBanks(disk, seams, "relief of an open surface");
  ASSERT_GE(seams.Segments.size(), 2u);
  std::set<int> starts;
  for (const std::vector<int>& segment : seams.Segments)
  {
    if (seams.Distance[segment.front()] == 0.0)
    {
      starts.insert(segment.front());
    }
  }
  EXPECT_EQ(starts.size(), seams.Borders.size()); // the seams divide the border where they start
  for (const std::vector<int>& border : seams.Borders)
  {
    EXPECT_EQ(starts.count(border.front()) + starts.count(border.back()), 2u);
  }
}

TEST(SeamSegments, OfATubeRunsFromEndToEnd)
{
  const DiskSurface disk = cutBy(cylinder(40, 20, 3.0), CutMode::Seam);
  for (const double end : { 0.0, 3.0 })
  {
    const SeamSegments seams = seamSegments(disk, Eigen::Vector3d(1.0, 0.0, end));
    expectBanks(disk, seams, "tube");
    ASSERT_EQ(seams.Segments.size(), 1u);
    ASSERT_EQ(seams.Borders.size(), 2u);
    EXPECT_NEAR(seams.Lengths[0], 3.0, 1e-12);
    EXPECT_EQ(disk.Surface.Mesh.Vertices(seams.Segments[0].front(), 2), end);
    EXPECT_NEAR(seams.Distance.maxCoeff(), 3.0, 1e-12);
  }
}

// The cuts of handles form a graph: the disk around it has Euler number 1, so that the graph has 2 g - 1
// pieces more than ends.
TEST(SeamSegments, OfHandlesFormAGraph)
{
  const TriangleMesh ring = torus(60, 30);
  for (const CutMode cut : { CutMode::Hole, CutMode::Relief, CutMode::Automatic })
  {
    const DiskSurface disk = cutBy(ring, cut, HandleMode::Keep);
    const SeamSegments seams = seamSegments(disk);
    expectBanks(disk, seams, "ring");
    EXPECT_EQ(disk.Report.Genus, 1);
    EXPECT_EQ(seams.Segments.size(), piecesAtEnds(seams).size() + 1);
  }
  // A coarse one, whose boundary is refined after the cut, and one with a seam through points, too.
  const DiskSurface coarse = cutBy(torus(9, 6), CutMode::Hole, HandleMode::Keep);
  expectBanks(coarse, seamSegments(coarse), "coarse ring");
  for (const int n : { 12, 60 })
  {
    SurfaceToDiskOptions options;
    options.Cut = CutMode::Seam;
    options.Handles = HandleMode::Keep;
    options.SeamPoints = { { 2.5, 0.0, 0.0 }, { 2.3, 1.0, 0.0 } };
    const DiskSurface disk = surfaceToDisk(torus(n, n / 2), options);
    const SeamSegments seams = seamSegments(disk);
    expectBanks(disk, seams, "ring and seam " + std::to_string(n));
    EXPECT_EQ(seams.Segments.size(), piecesAtEnds(seams).size() + 1);
  }
}

// The vertex that a later step puts on one bank alone lies on the other bank's edge.
TEST(SeamSegments, OneBankMayHaveMoreVertices)
{
  // A square around a seam of two edges, from vertex 8, the centre, to 1 on the border and beyond it to
  // none: corners 0, 2, 4, 6, middles of sides 1, 3, 5, 7; 9 is the other copy of 1.
  DiskSurface disk;
  disk.Surface.Mesh = meshOf({ { -1, -1, 0 },
                               { 0, -1, 0 },
                               { 1, -1, 0 },
                               { 1, 0, 0 },
                               { 1, 1, 0 },
                               { 0, 1, 0 },
                               { -1, 1, 0 },
                               { -1, 0, 0 },
                               { 0, 0, 0 },
                               { 0, -1, 0 },
                               { 0, -0.25, 0 } },
    { { 0, 1, 10 } });
  disk.Boundary = { 0, 1, 10, 8, 9, 2, 3, 4, 5, 6, 7 };
  disk.Seam = { 0, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1 };
  disk.SeamPoint = { -1, 1, -1, -1, -1, -1, -1, -1, 8, 1, 10 };
  const SeamSegments seams = seamSegments(disk);
  ASSERT_EQ(seams.Segments.size(), 1u);
  EXPECT_EQ(seams.Segments[0], (std::vector<int>{ 1, 8 }));
  EXPECT_EQ(seams.Lengths[0], 1.0);
  EXPECT_EQ(seams.SegmentOf[10], 1);
  EXPECT_EQ(seams.Distance[10], 0.75);
  ASSERT_EQ(seams.Borders.size(), 1u);
  EXPECT_EQ(seams.Borders[0], (std::vector<int>{ 1, 2, 3, 4, 5, 6, 7, 0, 1 }));
}

// Far from the origin and in other units, where the disk is made in a frame of its own.
TEST(SeamSegments, DoNotDependOnTheUnit)
{
  const TriangleMesh mesh = sphereWithFingers();
  TriangleMesh large = mesh;
  large.Vertices *= std::ldexp(1.0, 300);
  const DiskSurface first = cutBy(mesh, CutMode::Relief);
  const DiskSurface second = cutBy(large, CutMode::Relief);
  const SeamSegments seams = seamSegments(first);
  const SeamSegments inUnits = seamSegments(second);
  EXPECT_EQ(seams.Segments, inUnits.Segments);
  EXPECT_EQ(seams.SegmentOf, inUnits.SegmentOf);
  EXPECT_LT((inUnits.Distance * std::ldexp(1.0, -300) - seams.Distance).cwiseAbs().maxCoeff(), 1e-12);
}

} // namespace
