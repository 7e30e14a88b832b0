// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Base/Errors.h"
#include "Mesh/CoordinateFrame.h"
#include "Mesh/MeshMeasures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

TriangleMesh cap()
{
  return ringMesh(sphericalCap(1.0), 300).Mesh;
}

TriangleMesh scaled(TriangleMesh mesh, int exponent)
{
  mesh.Vertices = mesh.Vertices.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const Eigen::RowVector3d& by)
{
  mesh.Vertices.rowwise() += by;
  return mesh;
}

std::string errorOf(const TriangleMesh& mesh)
{
  try
  {
    const CoordinateFrame frame(mesh);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return {};
}

TEST(CoordinateFrame, LeavesOrdinarySurfacesAsTheyAre)
{
  for (const int exponent : { -30, 0, 30 })
  {
    const TriangleMesh mesh = scaled(moved(cap(), { 100.0, -3.0, 0.0 }), exponent);
    const CoordinateFrame frame(mesh);
    EXPECT_TRUE(frame.isIdentity());
    EXPECT_EQ(frame.normalised(mesh).Vertices, mesh.Vertices);
    EXPECT_EQ(frame.restoredArea(3.0), 3.0);
  }
}

TEST(CoordinateFrame, GivesTheSameSurfaceAtAnySize)
{
  const TriangleMesh mesh = scaled(cap(), 40);
  const Points3 normalised = CoordinateFrame(mesh).normalised(mesh).Vertices;
  for (const int exponent : { -900, -300, -64, 64, 300, 900 })
  {
    const TriangleMesh other = scaled(cap(), exponent);
    const CoordinateFrame frame(other);
    EXPECT_EQ(frame.normalised(other).Vertices, normalised);
    EXPECT_EQ(frame.restored(normalised), other.Vertices);
    EXPECT_EQ(frame.restoredLength(frame.normalisedLength(7.0)), 7.0);
  }
}

TEST(CoordinateFrame, MovesSurfacesThatAreFarAwayWithoutRounding)
{
  for (const Eigen::RowVector3d& by : { Eigen::RowVector3d(1e6, 0.0, 0.0),
         Eigen::RowVector3d(-1e6, 3e6, 0.3),
         Eigen::RowVector3d(2e8, -5e7, 1.0) })
  {
    const TriangleMesh mesh = moved(cap(), by);
    const CoordinateFrame frame(mesh);
    EXPECT_FALSE(frame.isIdentity());
    const TriangleMesh normalised = frame.normalised(mesh);
    EXPECT_LE(normalised.Vertices.cwiseAbs().maxCoeff(), 2.0);
    EXPECT_EQ(frame.restored(normalised.Vertices), mesh.Vertices);
    // Differences of coordinates are exact in both places.
    EXPECT_EQ(faceAreas(normalised.Vertices, mesh.Faces), faceAreas(mesh.Vertices, mesh.Faces));
  }
}

TEST(CoordinateFrame, TellsWhatDoublePrecisionDoesNotHold)
{
  EXPECT_NE(errorOf(scaled(cap(), -1000)).find("too few for double precision"), std::string::npos);
  TriangleMesh huge = cap();
  huge.Vertices *= std::numeric_limits<double>::max();
  EXPECT_NE(errorOf(huge).find("too many for double precision"), std::string::npos);
  EXPECT_NE(errorOf(moved(cap(), { 1e13, 0.0, 0.0 })).find("away from the origin"), std::string::npos);
  EXPECT_EQ(errorOf(moved(cap(), { 1e6, 0.0, 0.0 })), "");
}

TEST(CoordinateFrame, DoesNotCountVerticesOfNoFace)
{
  TriangleMesh mesh = cap();
  mesh.Vertices.conservativeResize(mesh.vertexCount() + 2, 3);
  mesh.Vertices.bottomRows<2>() << 1e300, 0.0, 0.0, std::nan(""), 0.0, 0.0;
  EXPECT_TRUE(CoordinateFrame(mesh).isIdentity());
}

TEST(PlaneFrame, GivesTheSameMapAtAnySize)
{
  const Points2 map = scaled(cap(), 40).Vertices.leftCols<2>();
  const Points2 tiny = scaled(cap(), -800).Vertices.leftCols<2>();
  EXPECT_EQ(PlaneFrame(map).normalised(map), PlaneFrame(tiny).normalised(tiny));
  EXPECT_EQ(PlaneFrame(tiny).restoredArea(1.0), 0.0);
}

} // namespace
