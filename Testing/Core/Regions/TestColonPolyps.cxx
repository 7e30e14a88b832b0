// SPDX-License-Identifier: GPL-3.0-or-later
// Polyps of a generated colon among the regions of high saliency.
#include "ColonSurface.h"
#include "Mesh/MeshTopology.h"
#include "Regions/MeshSaliency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <set>

namespace
{

using namespace flattening;
using namespace flattening::phantom;

struct Detection
{
  std::set<int> Regions; // on the polyp, and not much larger than it
  double Area = 0.0;
};

TEST(ColonPolyps, TheGeneratedColonIsATube)
{
  const Colon colon = generateColon();
  const MeshTopology topology = analyseTopology(colon.Mesh.Faces, colon.Mesh.vertexCount());
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.BoundaryLoops.size(), 2u);
  EXPECT_EQ(colon.Polyps.size(), 15u);
  for (const Polyp& polyp : colon.Polyps) // the surface passes half a diameter from the centre, inward
  {
    const double nearest = (colon.Mesh.Vertices.rowwise() - polyp.Centre).rowwise().norm().minCoeff();
    EXPECT_NEAR(nearest, 0.5 * polyp.Diameter, 0.3);
  }
}

TEST(ColonPolyps, AllOfSixMillimetresAreFound)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    SCOPED_TRACE(seed);
    const Colon colon = generateColon(1.0, seed);
    const MeshSaliency saliency = meshSaliency(colon.Mesh);
    const double threshold = areaPercentile(colon.Mesh, saliency.Saliency, 0.9);
    const std::vector<int> regions = salientRegions(
      colon.Mesh, saliency.Saliency, threshold, 5.0, std::numeric_limits<double>::infinity());
    const int count = *std::max_element(regions.begin(), regions.end());
    const Eigen::VectorXd areas = vertexAreas(colon.Mesh);
    std::vector<double> areaOf(count + 1, 0.0);
    for (int v = 0; v < colon.Mesh.vertexCount(); ++v)
    {
      areaOf[regions[v]] += areas[v];
    }

    std::set<int> onPolyps;
    int found = 0;
    int small = 0;
    for (const Polyp& polyp : colon.Polyps)
    {
      const double radius = 0.5 * polyp.Diameter;
      std::set<int> here;
      for (int v = 0; v < colon.Mesh.vertexCount(); ++v)
      {
        const double distance = (colon.Mesh.Vertices.row(v) - polyp.Centre).norm();
        if (regions[v] > 0 && distance < radius + 0.5)
        {
          here.insert(regions[v]);
        }
      }
      // A region that is a fold with a polyp on it would be of no use.
      const double polypArea = 2.0 * EIGEN_PI * radius * radius;
      const bool isFound = std::any_of(
        here.begin(), here.end(), [&](int region) { return areaOf[region] < 3.0 * polypArea; });
      onPolyps.insert(here.begin(), here.end());
      if (polyp.Diameter >= 6.0)
      {
        EXPECT_TRUE(isFound) << "of " << polyp.Diameter << " mm at " << polyp.Centre;
        found += isFound;
      }
      else
      {
        small += isFound;
      }
    }
    std::printf("seed %u, %d points: found %d of 12 polyps of 6 mm or more, %d of 3 of 4 mm; "
                "%d regions, %d of them false\n",
      seed,
      colon.Mesh.vertexCount(),
      found,
      small,
      count,
      count - static_cast<int>(onPolyps.size()));
  }
}

} // namespace
