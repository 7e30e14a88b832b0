// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/SurfaceDefects.h"

#include "Mesh/MeshMeasures.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace flattening::samples
{
namespace
{

int addPoint(TriangleMesh& mesh, const Eigen::RowVector3d& point)
{
  mesh.Vertices.conservativeResize(mesh.vertexCount() + 1, 3);
  mesh.Vertices.bottomRows<1>() = point;
  return mesh.vertexCount() - 1;
}

void addFace(TriangleMesh& mesh, const Eigen::RowVector3i& face)
{
  mesh.Faces.conservativeResize(mesh.faceCount() + 1, 3);
  mesh.Faces.bottomRows<1>() = face;
}

// Diagonal of the bounding box of the faces; isolated points may be anywhere.
double sizeOf(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const int v : mesh.Faces.reshaped())
  {
    box.extend(mesh.Vertices.row(v).transpose());
  }
  return box.diagonal().norm();
}

int anyFace(const TriangleMesh& mesh, RandomNumbers& random)
{
  return random.integer(0, mesh.faceCount() - 1);
}

Eigen::RowVector3d corner(const TriangleMesh& mesh, int face, int k)
{
  return mesh.Vertices.row(mesh.Faces(face, k));
}

Eigen::RowVector3d centroid(const TriangleMesh& mesh, int face)
{
  return (corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2)) / 3.0;
}

void pierce(TriangleMesh& mesh, RandomNumbers& random)
{
  const double size = sizeOf(mesh);
  for (int hole = random.integer(1, 5); hole > 0; --hole)
  {
    const Eigen::RowVector3d centre = centroid(mesh, anyFace(mesh, random));
    const double radius = size * random.real(0.0, 0.2);
    std::set<int> within;
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      if ((centroid(mesh, f) - centre).norm() <= radius)
      {
        within.insert(f);
      }
    }
    if (static_cast<int>(within.size()) < mesh.faceCount())
    {
      mesh = withoutFaces(mesh, within);
    }
  }
}

void addFragments(TriangleMesh& mesh, RandomNumbers& random)
{
  const double size = sizeOf(mesh);
  const Eigen::RowVector3d low = mesh.Vertices.colwise().minCoeff();
  for (int count = random.integer(1, 6); count > 0; --count)
  {
    const int kind = random.integer(0, 2);
    TriangleMesh fragment = kind == 0 ? tetrahedron() : kind == 1 ? icosahedron() : moebiusStrip(7);
    fragment.Vertices *= size * std::pow(10.0, random.real(-6.0, -2.0));
    fragment.Vertices.rowwise() += low + size * random.point(0.0, 1.0);
    mesh = both(mesh, fragment);
  }
}

// One of two neighbouring faces is split at a point of their edge, the other is not.
void addTJunctions(TriangleMesh& mesh, RandomNumbers& random)
{
  for (int count = random.integer(1, 8); count > 0; --count)
  {
    const int f = anyFace(mesh, random);
    const double share = random.real(0.0, 1.0);
    const int middle = addPoint(mesh, share * corner(mesh, f, 0) + (1.0 - share) * corner(mesh, f, 1));
    addFace(mesh, { middle, mesh.Faces(f, 1), mesh.Faces(f, 2) });
    mesh.Faces(f, 1) = middle;
  }
}

// Moves corners nearly, or exactly, onto a neighbour.
void addSlivers(TriangleMesh& mesh, RandomNumbers& random)
{
  for (int count = random.integer(1, 1 + mesh.faceCount() / 10); count > 0; --count)
  {
    const int f = anyFace(mesh, random);
    const double rest = random.chance(0.2) ? 0.0 : std::pow(10.0, random.real(-16.0, -1.0));
    mesh.Vertices.row(mesh.Faces(f, 0)) =
      (corner(mesh, f, 1) + rest * (corner(mesh, f, 0) - corner(mesh, f, 1))).eval();
  }
}

void collapseFaces(TriangleMesh& mesh, RandomNumbers& random)
{
  for (int count = random.integer(1, 4); count > 0; --count)
  {
    const int f = anyFace(mesh, random);
    addFace(mesh, { mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, random.integer(0, 2)) });
  }
}

void flipFaces(TriangleMesh& mesh, RandomNumbers& random)
{
  const double share = random.chance(0.2) ? 1.0 : random.real(0.0, 0.5);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if (random.chance(share))
    {
      std::swap(mesh.Faces(f, 0), mesh.Faces(f, 1));
    }
  }
}

void duplicateFaces(TriangleMesh& mesh, RandomNumbers& random)
{
  for (int count = random.integer(1, 10); count > 0; --count)
  {
    const int f = anyFace(mesh, random);
    const int first = random.integer(0, 2);
    const int step = random.integer(1, 2); // 2: the other way around
    addFace(mesh,
      { mesh.Faces(f, first),
        mesh.Faces(f, (first + step) % 3),
        mesh.Faces(f, (first + 2 * step) % 3) });
  }
}

// Adds faces that stand on an edge or reach from it to another part of the surface.
void addFins(TriangleMesh& mesh, RandomNumbers& random)
{
  const double size = sizeOf(mesh);
  for (int count = random.integer(1, 5); count > 0; --count)
  {
    const int f = anyFace(mesh, random);
    const int k = random.integer(0, 2);
    const Eigen::RowVector3d reach = size * random.point(-0.1, 0.1);
    const int tip = random.chance(0.5) ? addPoint(mesh, centroid(mesh, f) + reach)
                                       : mesh.Faces(anyFace(mesh, random), 0);
    addFace(mesh, { mesh.Faces(f, k), mesh.Faces(f, (k + 1) % 3), tip });
  }
}

void renamePoint(TriangleMesh& mesh, int from, int to)
{
  mesh.Faces = (mesh.Faces.array() == from).select(to, mesh.Faces).eval();
}

// Pulls an edge or a point of one face onto one of another face.
void sharePoints(TriangleMesh& mesh, RandomNumbers& random)
{
  for (int count = random.integer(1, 3); count > 0; --count)
  {
    const int f = anyFace(mesh, random);
    const int g = anyFace(mesh, random);
    for (int k = random.integer(0, 1); k >= 0; --k)
    {
      renamePoint(mesh, mesh.Faces(f, k), mesh.Faces(g, 1 - k));
    }
  }
}

void addIsolatedPoints(TriangleMesh& mesh, RandomNumbers& random)
{
  const double size = sizeOf(mesh);
  for (int count = random.integer(1, 10); count > 0; --count)
  {
    addPoint(mesh, size * random.point(-10.0, 10.0));
  }
  if (random.chance(0.2)) // of no face, so that it harms nobody
  {
    addPoint(mesh, Eigen::RowVector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
}

void separateFaces(TriangleMesh& mesh, RandomNumbers&)
{
  mesh = soupOf(mesh);
}

void addNoise(TriangleMesh& mesh, RandomNumbers& random)
{
  const double amplitude = meanEdgeLength(mesh) * std::pow(10.0, random.real(-4.0, -0.5));
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    mesh.Vertices.row(v) += amplitude * random.point(-1.0, 1.0);
  }
}

template <typename Rows>
std::vector<int> shuffleRows(Rows& rows, RandomNumbers& random)
{
  std::vector<int> newPlace(rows.rows());
  for (int i = 0; i < rows.rows(); ++i)
  {
    newPlace[i] = i;
    std::swap(newPlace[i], newPlace[random.integer(0, i)]);
  }
  const Rows old = rows;
  for (int i = 0; i < rows.rows(); ++i)
  {
    rows.row(newPlace[i]) = old.row(i);
  }
  return newPlace;
}

} // namespace

const std::vector<SurfaceDefect>& surfaceDefects()
{
  static const std::vector<SurfaceDefect> defects = {
    { "noise", addNoise },
    { "holes", pierce },
    { "T-junctions", addTJunctions },
    { "slivers", addSlivers },
    { "shared edges and points", sharePoints },
    { "fins", addFins },
    { "fragments", addFragments },
    { "collapsed faces", collapseFaces },
    { "duplicated faces", duplicateFaces },
    { "flipped faces", flipFaces },
    { "separate faces", separateFaces },
    { "isolated points", addIsolatedPoints },
  };
  return defects;
}

void shuffleAndScale(TriangleMesh& mesh, RandomNumbers& random)
{
  shuffleRows(mesh.Faces, random);
  const std::vector<int> newPlace = shuffleRows(mesh.Vertices, random);
  mesh.Faces = mesh.Faces.unaryExpr([&newPlace](int v) { return newPlace[v]; }).eval();
  const double scale = std::pow(10.0, random.integer(-9, 9));
  const double distance = random.chance(0.5) ? 0.0 : std::pow(10.0, random.real(0.0, 3.0));
  mesh.Vertices.rowwise() += distance * random.point(-1.0, 1.0);
  mesh.Vertices *= scale;
}

std::string damage(TriangleMesh& mesh, RandomNumbers& random)
{
  const int f = anyFace(mesh, random);
  switch (random.integer(0, 4))
  {
    case 0:
      mesh.Vertices(mesh.Faces(f, 0), random.integer(0, 2)) = std::numeric_limits<double>::quiet_NaN();
      return "not a number";
    case 1:
      mesh.Vertices(mesh.Faces(f, 0), random.integer(0, 2)) = std::numeric_limits<double>::infinity();
      return "infinite";
    case 2:
      mesh.Faces(f, random.integer(0, 2)) = random.chance(0.5) ? -1 : mesh.vertexCount();
      return "index out of range";
    case 3: {
      TriangleMesh strip = moebiusStrip(random.integer(5, 40));
      strip.Vertices *= 10.0 * sizeOf(mesh);
      mesh = both(mesh, strip);
      return "one-sided";
    }
    default:
      mesh.Vertices.rowwise() = corner(mesh, f, 0).eval();
      return "all points in one place";
  }
}

} // namespace flattening::samples
