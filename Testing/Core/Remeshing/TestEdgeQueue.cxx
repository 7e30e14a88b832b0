// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/EdgeQueue.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>
#include <tuple>

namespace
{

using namespace flattening;

constexpr double BandWidth = 0.0625;

// Takes edges from a queue to which others are added meanwhile, beside a sorted set of the same edges.
template <typename Order>
void expectSorted(int direction)
{
  std::mt19937 random(1);
  EdgeQueue<Order> queue(BandWidth);
  std::multiset<std::pair<int, int>> sorted; // the band, times the direction, and the edge
  const auto push = [&]
  {
    const double length = static_cast<double>(random() % 1000) / 1000.0;
    const int edge = static_cast<int>(random() % 500);
    queue.push(MeshOnSurface::Edge(static_cast<unsigned>(edge)), length);
    sorted.emplace(direction * static_cast<int>(length / BandWidth), edge);
  };
  for (int i = 0; i < 1000; ++i)
  {
    push();
  }
  for (int i = 0; !sorted.empty(); ++i)
  {
    ASSERT_EQ(queue.size(), sorted.size());
    const auto next = queue.pop();
    ASSERT_EQ(std::make_pair(direction * next.Band, static_cast<int>(next.Edge.idx())), *sorted.begin());
    EXPECT_EQ(next.Band, static_cast<int>(next.Length / BandWidth));
    sorted.erase(sorted.begin());
    if (i < 3000 && random() % 3 == 0)
    {
      push();
      push();
    }
  }
  EXPECT_TRUE(queue.empty());
}

TEST(EdgeQueue, GivesTheShortestBandFirst)
{
  expectSorted<std::less<>>(1);
}

TEST(EdgeQueue, GivesTheLongestBandFirst)
{
  expectSorted<std::greater<>>(-1);
}

// An edge is the same whichever of its half-edges it was made of.
TEST(EdgeQueue, GivesEdgesWithTheFirstHalfedgeInFront)
{
  EdgeQueue<std::less<>> queue(BandWidth);
  queue.push(MeshOnSurface::Edge(MeshOnSurface::Halfedge(6)), 1.0);
  queue.push(MeshOnSurface::Edge(MeshOnSurface::Halfedge(7)), 1.0);
  EXPECT_EQ(queue.pop().Edge.halfedge(), MeshOnSurface::Halfedge(6));
  EXPECT_EQ(queue.pop().Edge.halfedge(), MeshOnSurface::Halfedge(6));
}

} // namespace
