// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineCrossings.h"
#include "Mesh/OutlineGaps.h"
#include "Mesh/OutlineTriangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using namespace flattening;

std::vector<int> loopOf(const Points2& outline)
{
  std::vector<int> loop(outline.rows());
  std::iota(loop.begin(), loop.end(), 0);
  return loop;
}

// A star of arms with narrow gaps between them, whose vertices are not evenly spaced.
Points2 star(int arms, int count)
{
  Points2 outline(count, 2);
  for (int k = 0; k < count; ++k)
  {
    const double share = (k + 0.4 * std::sin(5.0 * k)) / count;
    const double angle = 2.0 * EIGEN_PI * share;
    const double radius = 1.0 + 0.95 * std::sin(arms * angle);
    outline.row(k) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return outline;
}

TEST(OutlineCrossings, AreFoundExactly)
{
  Points2 square(5, 2);
  square << 0, 0, 1, 0, 1, 1, 0.5, 1e-300, 0, 1;
  const std::vector<int> loop = loopOf(square);
  EXPECT_TRUE(isSimpleOutline(square, loop)); // the fourth vertex is just above the first edge
  square(3, 1) = 0.0;                         // on it
  EXPECT_FALSE(isSimpleOutline(square, loop));
  square(3, 1) = -1e-300;
  EXPECT_FALSE(isSimpleOutline(square, loop));
}

TEST(OutlineCrossings, TellWhichEdgesCross)
{
  Points2 outline(5, 2);
  outline << 0, 0, 4, 0, 1, 2, 2, 2, 3,
    -1; // the last edge but one passes the first, the last touches none
  EXPECT_EQ(crossingEdges(outline, outlineEdges(loopOf(outline))), std::vector<char>({ 1, 1, 0, 1, 0 }));
}

// A comb, 11 wide and 4 high, with five gaps of 1 x 3 that open upwards.
Points2 combOfGaps()
{
  Points2 comb(24, 2);
  comb.topRows(2) << 0, 0, 11, 0;
  for (int gap = 0; gap < 5; ++gap)
  {
    const double right = 10.0 - 2.0 * gap;
    comb.middleRows(3 + 4 * gap, 4) << right, 4, right, 1, right - 1.0, 1, right - 1.0, 4;
  }
  comb.row(2) << 11, 4;
  comb.row(23) << 0, 4;
  return comb;
}

TEST(OutlineGaps, FillTheConvexHull)
{
  const Points2 comb = combOfGaps();
  ASSERT_TRUE(isSimpleOutline(comb, loopOf(comb)));
  const FaceMatrix gaps = outlineGaps(comb, outlineEdges(loopOf(comb)));
  ASSERT_EQ(gaps.rows(), 10);
  for (Eigen::Index k = 0; k < gaps.rows(); ++k)
  {
    const Eigen::RowVector2d first = comb.row(gaps(k, 1)) - comb.row(gaps(k, 0));
    const Eigen::RowVector2d second = comb.row(gaps(k, 2)) - comb.row(gaps(k, 0));
    EXPECT_EQ(first.x() * second.y() - first.y() * second.x(), 3.0); // half of a gap, counter-clockwise
  }
}

TEST(OutlineGaps, AConvexOutlineHasNone)
{
  EXPECT_EQ(outlineGaps(star(0, 50), outlineEdges(loopOf(star(0, 50)))).rows(), 0);
}

TEST(OutlineCrossings, NeighboursMustNotFoldBack)
{
  Points2 outline(4, 2);
  outline << 0, 0, 2, 0, 1, 0, 1, 1; // from (2, 0) back to (1, 0)
  EXPECT_FALSE(isSimpleOutline(outline, loopOf(outline)));
  outline.row(2) << 3, 0; // straight on
  EXPECT_TRUE(isSimpleOutline(outline, loopOf(outline)));
  outline.row(2) << 2, 0; // an edge without length
  EXPECT_FALSE(isSimpleOutline(outline, loopOf(outline)));
}

TEST(OutlineCrossings, OfSomeEdgesCountOnlyTheirs)
{
  Points2 cross(4, 2);
  cross << -1, 0, 1, 0, 0, -1, 0, 1;
  EXPECT_TRUE(edgesCross(cross, { { 0, 1 }, { 2, 3 } }));
  EXPECT_FALSE(edgesCross(cross, { { 0, 2 }, { 1, 3 } }));
  EXPECT_FALSE(edgesCross(cross, { { 0, 1 } }));
  EXPECT_FALSE(edgesCross(cross, {}));
}

// The triangles of a comb with a vertex in its first tooth.
TEST(OutlineTriangulation, HasBothSidesOfTheOutline)
{
  Points2 comb = combOfGaps();
  const std::vector<FlatEdge> edges = outlineEdges(loopOf(comb));
  comb.conservativeResize(25, 2);
  comb.row(24) << 0.5, 2.0;
  OutlineTriangulation triangulation(comb, edges, { 24 });
  EXPECT_NEAR(signedFaceAreas(comb, triangulation.inside()).sum(), 44.0 - 15.0, 1e-12);
  EXPECT_NEAR(signedFaceAreas(comb, triangulation.outside()).sum(), 15.0, 1e-12);
  EXPECT_GT(signedFaceAreas(comb, triangulation.inside()).minCoeff(), 0.0);
  const int faces = static_cast<int>(triangulation.inside().rows());
  for (int face = 0; face < faces; ++face)
  {
    const Eigen::RowVector3i corners = triangulation.inside().row(face);
    const Eigen::Vector2d centroid =
      (comb.row(corners[0]) + comb.row(corners[1]) + comb.row(corners[2])).transpose() / 3.0;
    for (int near = 0; near < faces; ++near)
    {
      EXPECT_EQ(triangulation.insideAt(centroid, near), face);
      const int atCorner = triangulation.insideAt(comb.row(corners[0]), near);
      ASSERT_GE(atCorner, 0);
      EXPECT_TRUE((triangulation.inside().row(atCorner).array() == corners[0]).any());
    }
    EXPECT_EQ(triangulation.insideAt({ 1.5, 3.0 }, face), -1); // in a gap
    EXPECT_EQ(triangulation.insideAt({ 20.0, 3.0 }, face), -1);
    EXPECT_EQ(triangulation.insideAt({ -20.0, 3.0 }, face), -1);
  }
}

TEST(OutlineTriangulation, DoesNotDependOnTheOrderOfThePoints)
{
  Points2 square(44, 2);
  square.topRows(4) << 0, 0, 1, 0, 1, 1, 0, 1;
  std::vector<int> inner;
  for (int v = 4; v < square.rows(); ++v)
  {
    square.row(v) << 0.5 + 0.4 * std::sin(1.7 * v), 0.5 + 0.4 * std::cos(2.9 * v);
    inner.push_back(v);
  }
  const std::vector<FlatEdge> edges = outlineEdges({ 0, 1, 2, 3 });
  const OutlineTriangulation forward(square, edges, inner);
  std::reverse(inner.begin(), inner.end());
  const OutlineTriangulation backward(square, edges, inner);
  EXPECT_EQ(forward.inside().rows(), 2 * 40 + 2);
  EXPECT_EQ(forward.inside(), backward.inside());
}

// An arc of many vertices that bends inward by a little is one shallow bay, and the gap of a comb is
// none.
TEST(OutlineGaps, ShallowBaysCanBeLeftOut)
{
  Points2 bay(12, 2);
  for (int k = 0; k < 10; ++k)
  {
    const double x = 1.0 - k / 9.0;
    bay.row(k) << x, 1.0 - 0.4 * x * (1.0 - x);
  }
  bay.bottomRows(2) << 0, 0, 1, 0;
  const std::vector<FlatEdge> edges = outlineEdges(loopOf(bay));
  const FaceMatrix gaps = outlineGaps(bay, edges);
  EXPECT_EQ(gaps.rows(), 8);
  EXPECT_EQ(withoutShallowBays(gaps, bay, edges).rows(), 0);
  const Points2 comb = combOfGaps();
  const std::vector<FlatEdge> combEdges = outlineEdges(loopOf(comb));
  const FaceMatrix deep = outlineGaps(comb, combEdges);
  EXPECT_EQ(withoutShallowBays(deep, comb, combEdges), deep);
}

} // namespace
