// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/RefinementRounds.h"
#include "Areas/WrongFaces.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace
{

using namespace flattening;

DomainMap identity(const TriangleMesh& mesh, const std::vector<int>& loop, const ConvexDomain& domain)
{
  const Points2 positions = mesh.Vertices.leftCols<2>();
  return { positions, domain.parametersOf(positions, loop) };
}

// One face in a hundred is wrong, all of them in one place. Vertices far from there stay to the last
// bit; a patch of 2,000 vertices would reach farther.
TEST(RefinementRounds, MoveOnlyWhatIsNearFewWrongFaces)
{
  const TriangleMesh mesh = analytic::sunflowerMesh(analytic::flatDisk(), 12000).Mesh;
  const VertexFaces facesOf(mesh.Faces, mesh.vertexCount());
  const std::vector<int> loop = requireDisk(mesh);
  const DegreesOfFreedom dofs(mesh.vertexCount(), std::make_shared<UnitDisk>(), loop, {});
  const RefinementTerms terms(mesh, loop, dofs.domain().perimeter(), 0.001);
  const DomainMap exact = identity(mesh, loop, dofs.domain());
  const Points2 chart = exact.Positions;
  const Eigen::VectorXd targets = signedFaceAreas(exact.Positions, mesh.Faces);

  const Eigen::RowVector2d place(-0.4, 0.1);
  const auto distance = [&](int v) { return (exact.Positions.row(v) - place).norm(); };
  DomainMap map = exact;
  const double size = 0.15 / std::sqrt(static_cast<double>(mesh.vertexCount()));
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (distance(v) < 0.1)
    {
      map.Positions.row(v) += size * Eigen::RowVector2d(std::sin(17.0 * v), std::cos(29.0 * v));
    }
  }
  ASSERT_EQ(countFlippedFaces(map.Positions, mesh.Faces), 0);
  const double before = shareOfWrongFaces(map.Positions, mesh.Faces, targets, 0.02);
  ASSERT_GT(before, 0.008);
  ASSERT_LT(before, 0.03);

  RefinementRounds rounds(mesh, terms, facesOf, dofs, chart, targets, RefinementStart::WarmStart, true);
  rounds.setStage(targets, 0.0);
  rounds.run(map, 4, RefinementRounds::Until::AllRounds, {});
  EXPECT_LT(shareOfWrongFaces(map.Positions, mesh.Faces, targets, 0.02), 0.1 * before);
  int moved = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const bool stays = map.Positions.row(v) == exact.Positions.row(v);
    moved += stays ? 0 : 1;
    EXPECT_TRUE(stays || distance(v) < 0.3) << v << " at " << distance(v);
  }
  EXPECT_GT(moved, 150);
}

} // namespace
