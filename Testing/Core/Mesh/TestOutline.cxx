// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineCrossings.h"
#include "Mesh/OutlineGaps.h"
#include "Mesh/OutlineReach.h"
#include "Support/RandomNumbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

std::vector<FlatEdge> edgesOf(const std::vector<int>& loop)
{
  std::vector<FlatEdge> edges;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    edges.push_back({ loop[k], loop[(k + 1) % loop.size()] });
  }
  return edges;
}

TEST(OutlineCrossings, TellWhichEdgesCross)
{
  Points2 outline(5, 2);
  outline << 0, 0, 4, 0, 1, 2, 2, 2, 3,
    -1; // the last edge but one passes the first, the last touches none
  EXPECT_EQ(crossingEdges(outline, edgesOf(loopOf(outline))), std::vector<char>({ 1, 1, 0, 1, 0 }));
}

// A comb, 11 wide and 4 high, with five gaps of 1 x 3 that open upwards.
TEST(OutlineGaps, FillTheConvexHull)
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
  ASSERT_TRUE(isSimpleOutline(comb, loopOf(comb)));
  const FaceMatrix gaps = outlineGaps(comb, edgesOf(loopOf(comb)));
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
  EXPECT_EQ(outlineGaps(star(0, 50), edgesOf(loopOf(star(0, 50)))).rows(), 0);
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

// The worst that the reach allows: every vertex goes to the end of its reach, in a random direction.
TEST(OutlineReach, MovesWithinItDoNotCross)
{
  samples::RandomNumbers random(7);
  for (int arms = 2; arms < 30; ++arms)
  {
    const Points2 outline = star(arms, 40 * arms);
    const std::vector<int> loop = loopOf(outline);
    ASSERT_TRUE(isSimpleOutline(outline, loop)) << arms;
    const std::vector<double> reach = outlineReach(outline, loop, std::vector<int>(loop.size(), -1));
    EXPECT_GT(*std::min_element(reach.begin(), reach.end()), 0.0);
    for (int trial = 0; trial < 20; ++trial)
    {
      Points2 moved = outline;
      for (std::size_t k = 0; k < loop.size(); ++k)
      {
        const double angle = random.real(0.0, 2.0 * EIGEN_PI);
        moved.row(k) += reach[k] * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
      }
      EXPECT_TRUE(isSimpleOutline(moved, loop)) << arms << " arms";
    }
  }
}

TEST(OutlineReach, OfASquareIsNearlyHalfOfItsSide)
{
  Points2 square(4, 2);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  for (const double reach : outlineReach(square, loopOf(square), { -1, -1, -1, -1 }))
  {
    EXPECT_DOUBLE_EQ(reach, 0.49);
  }
}

// Edges of one group are left to the group: the gap between the two long edges counts only if they
// belong to different ones.
TEST(OutlineReach, LeavesOutEdgesOfOneGroup)
{
  Points2 slot(4, 2);
  slot << 0, 0, 1, 0, 1, 0.01, 0, 0.01;
  const std::vector<int> loop = loopOf(slot);
  EXPECT_NEAR(outlineReach(slot, loop, { 0, -1, 1, -1 })[0], 0.0049, 1e-12);
  EXPECT_NEAR(outlineReach(slot, loop, { 2, 2, 2, 2 })[0], 0.49, 1e-12);
}

} // namespace
