// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HalfedgeSurface.h"
#include "Handles/HomologyLabels.h"
#include "Support/SampleSurfaces.h"

#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

TEST(HomologyLabels, AreCocyclesThatTellMeridianFromLongitude)
{
  HalfedgeSurface surface(torus(12, 8));
  HomologyLabels labels(surface);
  EXPECT_EQ(labels.genus(), 1);
  int labelled = 0;
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    EXPECT_EQ(labels.hash(3 * f) ^ labels.hash(3 * f + 1) ^ labels.hash(3 * f + 2), 0u);
    EXPECT_TRUE(labels.classOf({ 3 * f, 3 * f + 1, 3 * f + 2 }).none());
    labelled += labels.hash(3 * f) != 0;
  }
  EXPECT_GT(labelled, 0);
  const auto around = [&surface](int begin, int step, int count)
  {
    std::vector<int> loop;
    for (int i = 0; i < count; ++i)
    {
      loop.push_back(surface.edgeBetween(begin + i * step, begin + (i + 1) % count * step));
    }
    return loop;
  };
  const auto meridian = labels.classOf(around(0, 1, 8));
  const auto longitude = labels.classOf(around(0, 8, 12));
  EXPECT_FALSE(meridian.none());
  EXPECT_FALSE(longitude.none());
  EXPECT_NE(meridian, longitude);
  // Parallel curves are homologous.
  EXPECT_EQ(meridian, labels.classOf(around(40, 1, 8)));
  EXPECT_EQ(longitude, labels.classOf(around(5, 8, 12)));
}

TEST(HomologyLabels, CountABoundaryAsClosed)
{
  const TriangleMesh tube = cylinder(12, 6, 2.0);
  const HalfedgeSurface surface(tube);
  const HomologyLabels labels(surface);
  EXPECT_EQ(labels.genus(), 0);
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    EXPECT_EQ(labels.hash(h), 0u); // nothing to tell
  }
  const TriangleMesh pierced = withoutFaces(torus(20, 10), { 0, 1, 100, 101, 102 });
  EXPECT_EQ(HomologyLabels(HalfedgeSurface(pierced)).genus(), 1);
}

} // namespace
