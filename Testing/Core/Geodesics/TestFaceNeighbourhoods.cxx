// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/FaceNeighbourhoods.h"
#include "Geodesics/GeodesicPath.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

using namespace flattening;
using namespace flattening::samples;

namespace
{

constexpr int Size = 20;

// A unit square of Size x Size squares of two triangles.
SurfaceMesh unitSquare()
{
  return toSurfaceMesh(liftedGrid(Size, [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); }));
}

} // namespace

// A face is in the ball if one of its corners is, and it is not if it lies beyond the radius by more
// than its longest side.
TEST(FaceNeighbourhoods, TheFacesInABallAreThoseWithinItsRadius)
{
  const SurfaceMesh mesh = unitSquare();
  double side = 0.0;
  for (const auto h : mesh.halfedges())
  {
    side = std::max(
      side, std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))));
  }
  const SurfaceMesh::Vertex_index centre(mesh.number_of_vertices() / 2);
  const SurfaceMesh::Face_index start = mesh.face(mesh.halfedge(centre));
  const double extent = std::sqrt(CGAL::squared_distance(
    mesh.point(SurfaceMesh::Vertex_index(0)), mesh.point(SurfaceMesh::Vertex_index(Size))));
  for (const double radius : { 0.1 * extent, 0.25 * extent, 0.4 * extent })
  {
    const std::vector<SurfaceMesh::Face_index> found =
      facesInBall(mesh, start, mesh.point(centre), radius);
    const std::set<SurfaceMesh::Face_index> inBall(found.begin(), found.end());
    EXPECT_EQ(inBall.size(), found.size());
    for (const auto f : mesh.faces())
    {
      double nearest = HUGE_VAL;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      {
        nearest =
          std::min(nearest, std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(centre))));
      }
      if (nearest < radius)
      {
        EXPECT_EQ(inBall.count(f), 1u) << f << ", radius " << radius;
      }
      else if (nearest > radius + side)
      {
        EXPECT_EQ(inBall.count(f), 0u) << f << ", radius " << radius;
      }
    }
  }
}

// All faces are split at random, and the nearest part of each is that which a search of all faces finds.
TEST(FaceNeighbourhoods, TheNearestPartOfAFaceIsAmongThoseConnectedToIt)
{
  const TriangleMesh mesh = sphere(1);
  EditableSurface surface(mesh);
  std::mt19937 random(3);
  for (int split = 0; split < 2000; ++split)
  {
    const auto edge = random() % surface.mesh().number_of_halfedges();
    surface.splitEdge(SurfaceMesh::Halfedge_index(static_cast<SurfaceMesh::size_type>(edge)), 0.5);
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::Vector3d p = faceCorners(mesh, f).transpose() * Eigen::Vector3d(0.5, 0.3, 0.2);
    const Kernel::Point_3 point(p.x(), p.y(), p.z());
    SurfaceMesh::Face_index nearest;
    double distance = HUGE_VAL;
    for (const auto face : surface.mesh().faces())
    {
      if (surface.origin(face) == f && squaredDistance(surface.mesh(), face, point) < distance)
      {
        distance = squaredDistance(surface.mesh(), face, point);
        nearest = face;
      }
    }
    EXPECT_EQ(partAt(surface, f, point), nearest) << f;
  }
}

TEST(GeodesicPath, APointOfAnEdgeLiesAtItsFraction)
{
  const SurfaceMesh mesh = unitSquare();
  for (const SurfaceMesh::Halfedge_index edge : mesh.halfedges())
  {
    PathPoint point;
    point.Vertex = SurfaceMesh::null_vertex();
    point.Edge = edge;
    point.Fraction = 0.25;
    const auto from = mesh.point(mesh.source(edge));
    const auto to = mesh.point(mesh.target(edge));
    const Eigen::Vector3d position = positionOf(mesh, point);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(position[k], from[k] + 0.25 * (to[k] - from[k]), 1e-15);
    }
  }
}
