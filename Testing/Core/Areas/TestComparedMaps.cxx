// SPDX-License-Identifier: GPL-3.0-or-later
/// The maps that benchmarks compare with behave as their energies say, on a hemisphere, where each has a
/// known least.
#include "AnalyticSurfaces.h"
#include "AuthalicEnergy.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/MeshTopology.h"
#include "StretchEnergy.h"
#include "SymmetricDirichlet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::benchmarks;

class ComparedMaps : public testing::Test
{
protected:
  DistortionSummary summaryOf(const Points2& flat) const
  {
    EXPECT_EQ(outlineCrossings(flat, requireDisk(this->Mesh.Mesh)), 0);
    const DistortionSummary summary = summariseDistortion(measureDistortion(this->Mesh.Mesh, flat));
    EXPECT_EQ(summary.FlippedFaces, 0);
    return summary;
  }

  const RevolutionMesh Mesh = ringMesh(sphericalCap(0.5 * EIGEN_PI), 4000);
};

// Both energies are least where all areas are kept. Published energies are in docs/benchmarks.md.
TEST_F(ComparedMaps, StretchAndAuthalicEnergyKeepAreas)
{
  const StretchEnergyMap stretched = stretchEnergyDiskMap(this->Mesh.Mesh, 100);
  EXPECT_LT(this->summaryOf(stretched.Positions).SDAreaRatio, 0.01);
  const double least =
    EIGEN_PI * EIGEN_PI / faceAreas(this->Mesh.Mesh.Vertices, this->Mesh.Mesh.Faces).sum();
  EXPECT_NEAR(stretched.Energies.back() / least, 1.0, 1e-3);
  const double start = this->summaryOf(stretchEnergyDiskMap(this->Mesh.Mesh, 5).Positions).SDAreaRatio;
  const double end = this->summaryOf(authalicEnergyDiskMap(this->Mesh.Mesh, 300)).SDAreaRatio;
  EXPECT_LT(end, 0.8 * start);
  EXPECT_LT(end, 0.004);
}

// The least radial map whose energies are equal, computed as a function of one variable with 400 steps,
// has 0.0816 of each and area ratios of standard deviation 0.161.
TEST_F(ComparedMaps, DistortionBalancingMeetsItsRadialLeast)
{
  const BalancedMap map = balancedDiskMap(this->Mesh.Mesh);
  EXPECT_NEAR(map.AuthalicEnergy / map.ConformalEnergy, 1.0, 1e-3);
  EXPECT_NEAR(map.ConformalEnergy, 0.0816, 0.0008);
  EXPECT_NEAR(this->summaryOf(map.Positions).SDAreaRatio, 0.161, 0.004);
}

// The least radial map, computed as above, has the energy 4.1409 after both are scaled to the same area,
// and area ratios of deviation 0.183.
TEST_F(ComparedMaps, SymmetricDirichletMeetsItsRadialLeast)
{
  const DistortionSummary summary = this->summaryOf(symmetricDirichletMap(this->Mesh.Mesh, 100));
  EXPECT_NEAR(summary[Measure::SymmetricDirichlet].AreaWeightedMean, 4.1409, 0.002);
  EXPECT_NEAR(summary.SDAreaRatio, 0.183, 0.006);
}

TEST(OutlineCrossings, CountsPairsOfEdges)
{
  Points2 square(4, 2);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  EXPECT_EQ(outlineCrossings(square, { 0, 1, 2, 3 }), 0);
  EXPECT_EQ(outlineCrossings(square, { 0, 2, 1, 3 }), 1);
  Points2 touching(5, 2);
  touching << 0, 0, 2, 0, 2, 1, 1, 0, 0, 1;
  EXPECT_EQ(outlineCrossings(touching, { 0, 1, 2, 3, 4 }), 2) << "a vertex on an edge, of two edges";
}

} // namespace
