// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthPairs.h"
#include "Support/HubDisk.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using namespace flattening;
using namespace flattening::samples;

namespace
{

// The unit square, itself its map.
class LengthPairsOfSquare : public ::testing::Test
{
protected:
  std::vector<LocalLengths> local(int samples, double radius)
  {
    return LengthPairs(this->Square, this->Flat).local(samples, radius, {});
  }

  const TriangleMesh Square =
    liftedGrid(30, [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); });
  const Points2 Flat = this->Square.Vertices.leftCols<2>();
};

// Circles of these radii have 1, 8, 26, and 72 percent of the square's area; those of sources near the
// boundary lose a part of it.
TEST_F(LengthPairsOfSquare, FewerSourcesAreLeftTheFartherTheyReach)
{
  EXPECT_EQ(this->local(300, 0.06).size(), 300);
  EXPECT_EQ(this->local(300, 0.16).size(), 150);
  EXPECT_EQ(this->local(300, 0.29).size(), 75);
  EXPECT_EQ(this->local(300, 0.48).size(), 38);
  EXPECT_EQ(this->local(300, 2.0).size(), 19);
}

TEST_F(LengthPairsOfSquare, TwoSourcesAreLeftAlways)
{
  for (const int samples : { 2, 3, 4, 31, 32, 33 })
  {
    const std::size_t count = this->local(samples, 2.0).size();
    EXPECT_GE(count, 2) << samples;
    EXPECT_LE(count, 4) << samples;
  }
  EXPECT_EQ(this->local(1000000, 0.06).size(), this->Square.vertexCount());
}

// Each of the sources that are left has its own pairs: all other vertices.
TEST_F(LengthPairsOfSquare, SourcesOverTheWholeSurfaceReachAllVertices)
{
  const int n = this->Square.vertexCount();
  const std::vector<LocalLengths> sources = this->local(100, 2.0);
  std::vector<int> missing;
  for (const LocalLengths& source : sources)
  {
    ASSERT_EQ(source.Vertices.size(), n - 1);
    EXPECT_EQ(source.Local.Ratios.size(), n - 1);
    EXPECT_EQ(source.WithinMap.Ratios.size(), n - 1);
    EXPECT_GT(source.Rings.Ratios.size(), 50);
    int own = 0; // the vertex that the others lack
    while (own < n - 1 && source.Vertices[own] == own)
    {
      ++own;
    }
    missing.push_back(own);
  }
  // They are spread over the surface, whose vertices are in rows.
  for (std::size_t i = 1; i < missing.size(); ++i)
  {
    EXPECT_NEAR(missing[i] - missing[i - 1], 0.16 * n, 0.02 * n);
  }
}

// Rings count edges: how far the radius reaches is nothing to them.
TEST_F(LengthPairsOfSquare, RingsDoNotDependOnTheRadius)
{
  const std::vector<LocalLengths> small = this->local(2, 0.04);
  const std::vector<LocalLengths> large = this->local(2, 2.0);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_GT(small[i].Rings.Ratios.size(), small[i].Local.Ratios.size());
    EXPECT_EQ(small[i].Rings.Ratios, large[i].Rings.Ratios);
  }
}

// Three circles of points around a vertex that has an edge to each point of the first: seven rings of
// edges are the whole disk, and a search of it meets a million windows.
TEST(LengthPairs, RingsThroughAHubEndAtTheRadius)
{
  const TriangleMesh disk = hubDisk(500, 3);
  const Points2 flat = disk.Vertices.leftCols<2>();
  LengthPairs pairs(disk, flat);
  for (const double radius : { 0.05, 0.2 })
  {
    const std::vector<LocalLengths> sources = pairs.local(100, radius, {});
    EXPECT_GT(sources.size(), 40);
    for (const LocalLengths& source : sources)
    {
      EXPECT_EQ(source.Rings.Ratios, source.Local.Ratios);
    }
  }
}

// With fewer edges the rings have fewer points than a thousand, and all of them count.
TEST(LengthPairs, RingsThroughASmallHubAreWhole)
{
  const TriangleMesh disk = hubDisk(50, 3);
  const Points2 flat = disk.Vertices.leftCols<2>();
  for (const LocalLengths& source : LengthPairs(disk, flat).local(10, 0.05, {}))
  {
    EXPECT_EQ(source.Rings.Ratios.size(), disk.vertexCount() - 1);
  }
}

} // namespace
