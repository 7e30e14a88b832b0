// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/RefinementEnergy.h"
#include "Areas/RefinementPatches.h"
#include "Areas/TargetAreas.h"
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
    , Dofs(Mesh.vertexCount(), std::make_shared<UnitDisk>(), Loop, { 0 })
    , Terms(Mesh, Loop, Dofs.domain().perimeter(), 0.001)
    , Chart(Mesh.Vertices.leftCols<2>())
    , Patches(Terms, FacesOf, Dofs, Chart)
  {
    this->Exact.Positions = Mesh.Vertices.leftCols<2>();
    this->Exact.BoundaryParameters = this->Dofs.domain().parametersOf(this->Exact.Positions, Loop);
    for (std::size_t k = 0; k < Loop.size(); ++k)
    {
      this->Exact.Positions.row(Loop[k]) = this->Dofs.domain().at(this->Exact.BoundaryParameters[k]);
    }
    this->Shaken = this->Exact;
    const double size = 0.15 / std::sqrt(static_cast<double>(Mesh.vertexCount()));
    for (int v = 0; v < Mesh.vertexCount(); ++v)
    {
      if (this->Dofs.memberOf(v) < 0)
      {
        this->Shaken.Positions(v, 0) += size * std::sin(17.0 * v);
        this->Shaken.Positions(v, 1) += size * std::cos(29.0 * v);
      }
    }
    this->Pass.Targets = signedFaceAreas(this->Exact.Positions, Mesh.Faces);
    this->Pass.AreaWeights = areaWeights(this->Pass.Targets);
    this->Pass.Counts = faceCounts(Mesh, this->Pass.Targets);
    this->Pass.Epsilon = 0.0;
    this->Pass.KeepsOrientation = true;
  }

  double shareOff(const DomainMap& map) const
  {
    const Eigen::ArrayXd ratios =
      signedFaceAreas(map.Positions, this->Mesh.Faces).array() / this->Pass.Targets.array();
    return static_cast<double>(((ratios - 1.0).abs() > 0.02).count()) / this->Mesh.faceCount();
  }

  TriangleMesh Mesh;
  VertexFaces FacesOf;
  std::vector<int> Loop;
  DegreesOfFreedom Dofs;
  RefinementTerms Terms;
  Points2 Chart;
  RefinementPatches Patches;
  RefinementPatches::Pass Pass;
  DomainMap Exact;
  DomainMap Shaken;
};

TEST_F(RefinementPatchesOfAMap, LeaveAsTheyAreThoseWhoseFacesAreRight)
{
  DomainMap map = this->Exact;
  EXPECT_EQ(this->Patches.run(this->Pass, map, {}), 0);
  EXPECT_TRUE((map.Positions.array() == this->Exact.Positions.array()).all());
}

TEST_F(RefinementPatchesOfAMap, MakeFacesRightInTwoPasses)
{
  ASSERT_EQ(countFlippedFaces(this->Shaken.Positions, this->Mesh.Faces), 0);
  ASSERT_GT(this->shareOff(this->Shaken), 0.8);
  DomainMap map = this->Shaken;
  EXPECT_GT(this->Patches.run(this->Pass, map, {}), 4);
  const double first = this->shareOff(map); // those between the patches are left
  EXPECT_LT(first, 0.2);
  EXPECT_GT(first, 0.0);
  this->Pass.Number = 1; // divides along other lines
  this->Patches.run(this->Pass, map, {});
  EXPECT_LT(this->shareOff(map), 0.1 * first);
  EXPECT_EQ(countFlippedFaces(map.Positions, this->Mesh.Faces), 0);
}

TEST_F(RefinementPatchesOfAMap, BoundaryVerticesSlideAndACornerStays)
{
  DomainMap map = this->Shaken;
  this->Patches.run(this->Pass, map, {});
  EXPECT_EQ(map.BoundaryParameters[0], this->Shaken.BoundaryParameters[0]);
  EXPECT_EQ(map.Positions.row(this->Loop[0]), this->Shaken.Positions.row(this->Loop[0]));
  int moved = 0;
  for (std::size_t k = 0; k < this->Loop.size(); ++k)
  {
    EXPECT_NEAR(map.Positions.row(this->Loop[k]).norm(), 1.0, 1e-14);
    EXPECT_TRUE(map.Positions.row(this->Loop[k])
                  .transpose()
                  .isApprox(this->Dofs.domain().at(map.BoundaryParameters[k]), 1e-14));
    moved += map.BoundaryParameters[k] != this->Shaken.BoundaryParameters[k] ? 1 : 0;
  }
  EXPECT_GT(moved, static_cast<int>(this->Loop.size()) / 2);
}

// Two groups of vertices far from each other move, each in a patch of its own, and no other vertex does.
TEST_F(RefinementPatchesOfAMap, MoveTheVerticesThatMay)
{
  this->Pass.Moving.assign(this->Mesh.vertexCount(), 0);
  const auto isIn = [&](int v, double x)
  { return (this->Exact.Positions.row(v) - Eigen::RowVector2d(x, 0.0)).norm() < 0.2; };
  for (int v = 0; v < this->Mesh.vertexCount(); ++v)
  {
    this->Pass.Moving[v] = isIn(v, -0.5) || isIn(v, 0.5) ? 1 : 0;
  }
  DomainMap map = this->Shaken;
  EXPECT_EQ(this->Patches.run(this->Pass, map, {}), 2);
  const Eigen::ArrayXd ratios =
    signedFaceAreas(map.Positions, this->Mesh.Faces).array() / this->Pass.Targets.array();
  int wrong = 0;
  int inside = 0;
  for (int f = 0; f < this->Mesh.faceCount(); ++f)
  {
    const Eigen::Vector3i corners = this->Mesh.Faces.row(f);
    if (corners.unaryExpr([&](int v) { return static_cast<int>(this->Pass.Moving[v]); }).minCoeff() > 0)
    {
      ++inside;
      wrong += std::abs(ratios[f] - 1.0) > 0.02 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 1500);
  EXPECT_LT(wrong, 0.01 * inside);
  for (int v = 0; v < this->Mesh.vertexCount(); ++v)
  {
    const bool moved = map.Positions.row(v) != this->Shaken.Positions.row(v);
    EXPECT_EQ(moved, this->Pass.Moving[v] != 0) << v;
  }
}

// A group of more vertices than a patch may have is divided, and other lines leave other vertices.
TEST_F(RefinementPatchesOfAMap, DivideLargeGroupsThatMayMove)
{
  this->Pass.Moving.resize(this->Mesh.vertexCount());
  for (int v = 0; v < this->Mesh.vertexCount(); ++v)
  {
    this->Pass.Moving[v] = this->Exact.Positions(v, 0) > 0.0 ? 1 : 0;
  }
  DomainMap first = this->Shaken;
  const int patches = this->Patches.run(this->Pass, first, {});
  EXPECT_GE(patches, 4); // 6,000 vertices in patches of at most 2,000
  EXPECT_LE(patches, 8);
  this->Pass.Number = 1;
  DomainMap second = this->Shaken;
  this->Patches.run(this->Pass, second, {});
  int stay = 0;
  for (int v = 0; v < this->Mesh.vertexCount(); ++v)
  {
    const auto moves = [&](const DomainMap& map)
    { return map.Positions.row(v) != this->Shaken.Positions.row(v); };
    EXPECT_FALSE((moves(first) || moves(second)) && !this->Pass.Moving[v]) << v;
    stay += this->Pass.Moving[v] && !moves(first) && !moves(second) ? 1 : 0;
  }
  EXPECT_LE(stay, 10); // where the lines cross
}

TEST_F(RefinementPatchesOfAMap, CanBeCancelled)
{
  DomainMap map = this->Shaken;
  EXPECT_THROW(this->Patches.run(this->Pass, map, [](double, const char*) { return false; }), Cancelled);
}

} // namespace
