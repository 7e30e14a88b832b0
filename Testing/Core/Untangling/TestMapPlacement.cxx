// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Untangling/MapPlacement.h"

#include <gtest/gtest.h>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

// A map of a flat disk in which one inner vertex lies so near to the opposite side of one of its faces
// that the face is positively oriented by the last digits only.
struct ThinMap
{
  TriangleMesh Mesh = ringMesh(flatDisk(), 300).Mesh;
  Points2 Positions = Mesh.Vertices.leftCols<2>();

  ThinMap()
  {
    const int v = 10;
    for (int f = 0; f < this->Mesh.faceCount(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (this->Mesh.Faces(f, k) == v)
        {
          this->moveTo(v, this->Mesh.Faces(f, (k + 1) % 3), this->Mesh.Faces(f, (k + 2) % 3));
          return;
        }
      }
    }
  }

  void moveTo(int v, int a, int b)
  {
    const Eigen::RowVector2d side = 0.4 * this->Positions.row(a) + 0.6 * this->Positions.row(b);
    const Eigen::RowVector2d inward = this->Positions.row(v) - side;
    this->Positions.row(v) = side;
    for (double share = 1e-17; countFlippedFaces(this->Positions, this->Mesh.Faces) > 0; share *= 1.5)
    {
      this->Positions.row(v) = side + share * inward;
    }
  }
};

TEST(MapPlacement, LeavesNoFaceThatRoundingFlips)
{
  const ThinMap map;
  ASSERT_EQ(countFlippedFaces(map.Positions, map.Mesh.Faces), 0);
  const std::vector<int> loop = requireDisk(map.Mesh);
  int flippedByRounding = 0;
  for (int i = 1; i <= 200; ++i)
  {
    const Placement placement{ 0.1 + 0.37 * i, { 3.0 * i, 1.0 / i } };
    const Points2 rounded = (placement.Scale * map.Positions).rowwise() + placement.Centre;
    flippedByRounding += countFlippedFaces(rounded, map.Mesh.Faces) > 0;
    const PlacedMap placed = placeMap(map.Mesh, loop, map.Positions, placement);
    EXPECT_EQ(placed.FlippedFaces, 0);
    EXPECT_EQ(countFlippedFaces(placed.Positions, map.Mesh.Faces), 0);
    EXPECT_LE((placed.Positions - rounded).cwiseAbs().maxCoeff(), 0.1 * placement.Scale);
    for (const int v : loop)
    {
      EXPECT_EQ(placed.Positions.row(v), rounded.row(v));
    }
  }
  EXPECT_GT(flippedByRounding, 20); // or this test shows nothing
}

TEST(MapPlacement, CountsTheFacesThatAreFlippedInTheEnd)
{
  ThinMap map;
  map.Positions.row(0) = map.Positions.row(200); // the star of the centre is turned inside out
  const int before = countFlippedFaces(map.Positions, map.Mesh.Faces);
  ASSERT_GT(before, 0);
  const PlacedMap placed =
    placeMap(map.Mesh, requireDisk(map.Mesh), map.Positions, { 7.7, { 1.0, 2.0 } });
  EXPECT_EQ(placed.FlippedFaces, countFlippedFaces(placed.Positions, map.Mesh.Faces));
  EXPECT_GE(placed.FlippedFaces, before - 2);
}

} // namespace
