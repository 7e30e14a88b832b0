// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/RefinementEnergy.h"
#include "Areas/RefinementPatches.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace
{

using namespace flattening;

// The flat map of a flat disk with its vertices shaken.
class RefinementPatchesOfAMap : public testing::Test
{
protected:
  RefinementPatchesOfAMap()
    : Mesh(analytic::sunflowerMesh(analytic::flatDisk(), 12000).Mesh)
    , FacesOf(Mesh.Faces, Mesh.vertexCount())
    , Loop(requireDisk(Mesh))
    , Unknowns(Mesh.vertexCount(), std::make_shared<UnitDisk>(), Loop, { 0 })
    , Terms(Mesh, Loop, Unknowns.domain().perimeter(), 0.001)
    , Patches(Terms, FacesOf, Unknowns)
  {
    this->Exact.Positions = Mesh.Vertices.leftCols<2>();
    this->Exact.Places.resize(static_cast<Eigen::Index>(Loop.size()));
    double last = -10.0;
    for (std::size_t k = 0; k < Loop.size(); ++k)
    {
      double place = this->Unknowns.domain().placeOf(this->Exact.Positions.row(Loop[k]).transpose());
      place += place < last ? 2.0 * EIGEN_PI : 0.0;
      this->Exact.Places[k] = place;
      this->Exact.Positions.row(Loop[k]) = this->Unknowns.domain().at(place);
      last = place;
    }
    this->Shaken = this->Exact;
    const double size = 0.15 / std::sqrt(static_cast<double>(Mesh.vertexCount()));
    for (int v = 0; v < Mesh.vertexCount(); ++v)
    {
      if (this->Unknowns.memberOf(v) < 0)
      {
        this->Shaken.Positions(v, 0) += size * std::sin(17.0 * v);
        this->Shaken.Positions(v, 1) += size * std::cos(29.0 * v);
      }
    }
    this->Pass.Targets = signedFaceAreas(this->Exact.Positions, Mesh.Faces);
    this->Pass.Epsilon = 0.0;
    this->Pass.KeepsOrientation = true;
  }

  double shareOff(const FlatState& state) const
  {
    const Eigen::ArrayXd ratios =
      signedFaceAreas(state.Positions, this->Mesh.Faces).array() / this->Pass.Targets.array();
    return static_cast<double>(((ratios - 1.0).abs() > 0.02).count()) / this->Mesh.faceCount();
  }

  TriangleMesh Mesh;
  VertexFaces FacesOf;
  std::vector<int> Loop;
  DegreesOfFreedom Unknowns;
  RefinementTerms Terms;
  RefinementPatches Patches;
  RefinementPatches::Pass Pass;
  FlatState Exact;
  FlatState Shaken;
};

TEST_F(RefinementPatchesOfAMap, LeaveAsTheyAreThoseWhoseFacesAreRight)
{
  FlatState state = this->Exact;
  EXPECT_EQ(this->Patches.run(this->Pass, state, {}), 0);
  EXPECT_TRUE((state.Positions.array() == this->Exact.Positions.array()).all());
}

TEST_F(RefinementPatchesOfAMap, MakeFacesRightInTwoPasses)
{
  ASSERT_EQ(countFlippedFaces(this->Shaken.Positions, this->Mesh.Faces), 0);
  ASSERT_GT(this->shareOff(this->Shaken), 0.8);
  FlatState state = this->Shaken;
  EXPECT_GT(this->Patches.run(this->Pass, state, {}), 4);
  const double first = this->shareOff(state); // those between the patches are left
  EXPECT_LT(first, 0.2);
  EXPECT_GT(first, 0.0);
  this->Patches.run(this->Pass, state, {});
  EXPECT_LT(this->shareOff(state), 0.1 * first);
  EXPECT_EQ(countFlippedFaces(state.Positions, this->Mesh.Faces), 0);
}

TEST_F(RefinementPatchesOfAMap, BoundaryVerticesSlideAndACornerStays)
{
  FlatState state = this->Shaken;
  this->Patches.run(this->Pass, state, {});
  EXPECT_EQ(state.Places[0], this->Shaken.Places[0]);
  EXPECT_EQ(state.Positions.row(this->Loop[0]), this->Shaken.Positions.row(this->Loop[0]));
  int moved = 0;
  for (std::size_t k = 0; k < this->Loop.size(); ++k)
  {
    EXPECT_NEAR(state.Positions.row(this->Loop[k]).norm(), 1.0, 1e-14);
    EXPECT_TRUE(state.Positions.row(this->Loop[k])
                  .transpose()
                  .isApprox(this->Unknowns.domain().at(state.Places[k]), 1e-14));
    moved += state.Places[k] != this->Shaken.Places[k] ? 1 : 0;
  }
  EXPECT_GT(moved, static_cast<int>(this->Loop.size()) / 2);
}

TEST_F(RefinementPatchesOfAMap, CanBeCancelled)
{
  FlatState state = this->Shaken;
  EXPECT_THROW(
    this->Patches.run(this->Pass, state, [](double, const char*) { return false; }), Cancelled);
}

} // namespace
