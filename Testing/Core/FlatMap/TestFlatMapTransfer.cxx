// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "FlatMap/FlatMapTransfer.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// The developable wall of a cylinder: its angle and height are its exact flat map.
FlattenedSurface unrolled(TriangleMesh wall)
{
  FlattenedSurface flattened;
  flattened.Positions.resize(wall.vertexCount(), 2);
  for (int v = 0; v < wall.vertexCount(); ++v)
  {
    flattened.Positions.row(v) << std::atan2(wall.Vertices(v, 1), wall.Vertices(v, 0)),
      wall.Vertices(v, 2);
  }
  flattened.Surface = std::move(wall);
  return flattened;
}

// Half of a cylinder of radius 1, about the x axis' side, so that the angle has no jump.
TriangleMesh halfCylinder(int around, int along, double height)
{
  const TriangleMesh whole = cylinder(around, along, height);
  std::set<int> back;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (whole.Vertices(whole.Faces(f, k), 0) < -1e-9)
      {
        back.insert(f);
      }
    }
  }
  std::vector<int> kept;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    if (!back.count(f))
    {
      kept.push_back(f);
    }
  }
  return extractFaces(whole, kept).Mesh;
}

TEST(FlatMapTransfer, EveryPointOfTheSameSurfaceKeepsItsPosition)
{
  const FlattenedSurface flattened = unrolled(halfCylinder(64, 20, 3.0));
  const TransferredMap map = transferFlatMap(flattened, flattened.Surface);
  EXPECT_EQ(std::count(map.Survived.begin(), map.Survived.end(), 1), flattened.Surface.vertexCount());
  EXPECT_LT((map.Positions - flattened.Positions).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(map.LargestDistance, 1e-14);
}

TEST(FlatMapTransfer, FollowsARemeshedSurface)
{
  const TriangleMesh original = halfCylinder(128, 61, 3.0);
  const FlattenedSurface flattened = unrolled(remeshIsotropically(original, 0.08).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original);
  double greatest = 0.0;
  int lost = 0;
  for (int v = 0; v < original.vertexCount(); ++v)
  {
    const bool edge = std::abs(original.Vertices(v, 0)) < 1e-9 || original.Vertices(v, 2) == 0.0 ||
                      original.Vertices(v, 2) == 3.0;
    EXPECT_TRUE(map.Survived[v] || edge) << v;
    lost += !map.Survived[v];
    if (map.Survived[v])
    {
      const double angle = std::atan2(original.Vertices(v, 1), original.Vertices(v, 0));
      greatest = std::max(
        greatest, (map.Positions.row(v) - Eigen::RowVector2d(angle, original.Vertices(v, 2))).norm());
    }
  }
  EXPECT_LT(greatest, 0.08 * 0.08); // of second order in the edge length
  EXPECT_LT(map.LargestDistance, 0.08 * 0.08 / 4.0);
  EXPECT_LT(lost, 64);
}

TEST(FlatMapTransfer, LosesWhatLiesOverAHole)
{
  const TriangleMesh original = halfCylinder(64, 40, 3.0);
  std::vector<int> kept;
  for (int f = 0; f < original.faceCount(); ++f)
  {
    double height = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      height = std::max(height, original.Vertices(original.Faces(f, k), 2));
    }
    if (height < 2.0 + 1e-9)
    {
      kept.push_back(f);
    }
  }
  const FlattenedSurface flattened = unrolled(extractFaces(original, kept).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original, 10.0); // tolerance alone keeps all
  for (int v = 0; v < original.vertexCount(); ++v)
  {
    EXPECT_EQ(map.Survived[v] != 0, original.Vertices(v, 2) < 2.0 + 1e-9) << original.Vertices(v, 2);
  }
}

TEST(FlatMapTransfer, DoesNotJumpToTheOtherSideOfAFold)
{
  // Two parallel sheets that face each other, 0.01 apart; only the lower one was flattened.
  const TriangleMesh lower =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  const TriangleMesh upper =
    meshOf({ { 0.2, 0.2, 0.01 }, { 0.5, 0.2, 0.01 }, { 0.5, 0.6, 0.01 } }, { { 0, 2, 1 } });
  FlattenedSurface flattened{ lower, lower.Vertices.leftCols(2) };
  const TransferredMap map = transferFlatMap(flattened, both(lower, upper));
  EXPECT_EQ(map.Survived, (std::vector<char>{ 1, 1, 1, 1, 0, 0, 0 }));

  // Turned over as a whole is no reason to lose anything.
  TriangleMesh turned = lower;
  turned.Faces.col(1).swap(turned.Faces.col(2));
  EXPECT_EQ(transferFlatMap(flattened, turned).Survived, (std::vector<char>{ 1, 1, 1, 1 }));
}

TEST(FlatMapTransfer, IsTheSameAtEveryScale)
{
  const TriangleMesh original = halfCylinder(64, 30, 3.0);
  const FlattenedSurface flattened = unrolled(remeshIsotropically(original, 0.1).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original);
  for (const double scale : { 1e-9, 1e9 })
  {
    FlattenedSurface scaled = flattened;
    scaled.Surface.Vertices *= scale;
    TriangleMesh target = original;
    target.Vertices *= scale;
    const TransferredMap other = transferFlatMap(scaled, target);
    EXPECT_EQ(other.Survived, map.Survived);
    EXPECT_LT((other.Positions - map.Positions).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(FlatMapTransfer, NamesWhatIsWrong)
{
  const FlattenedSurface flattened = unrolled(halfCylinder(64, 20, 3.0));
  const TriangleMesh far = moved(flattened.Surface, 100.0, 0.0, 0.0);
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { transferFlatMap(flattened, far); }), "raise the tolerance"));
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { transferFlatMap(flattened, flattened.Surface, -1.0); }),
      "tolerance is -1"));
  EXPECT_THROW(transferFlatMap(flattened, {}), InvalidInput);
  EXPECT_THROW(
    transferFlatMap(
      flattened, flattened.Surface, 0.0, [](double fraction, const char*) { return fraction < 0.5; }),
    Cancelled);
}

} // namespace
