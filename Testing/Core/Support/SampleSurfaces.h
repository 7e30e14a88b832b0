// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces with known properties, and measurements that the tests take of them.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flattening::samples
{

inline constexpr double Pi = 3.14159265358979323846;

inline TriangleMesh meshOf(const std::vector<std::array<double, 3>>& vertices,
  const std::vector<std::array<int, 3>>& faces)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v)
  {
    mesh.Vertices.row(v) << vertices[v][0], vertices[v][1], vertices[v][2];
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.Faces.row(f) << faces[f][0], faces[f][1], faces[f][2];
  }
  return mesh;
}

/// Corner of a cube: three right angles meet at vertex 0.
inline TriangleMesh tetrahedron()
{
  return meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } });
}

inline TriangleMesh icosahedron()
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  return meshOf({ { -1, g, 0 },
                  { 1, g, 0 },
                  { -1, -g, 0 },
                  { 1, -g, 0 },
                  { 0, -1, g },
                  { 0, 1, g },
                  { 0, -1, -g },
                  { 0, 1, -g },
                  { g, 0, -1 },
                  { g, 0, 1 },
                  { -g, 0, -1 },
                  { -g, 0, 1 } },
    { { 0, 11, 5 },
      { 0, 5, 1 },
      { 0, 1, 7 },
      { 0, 7, 10 },
      { 0, 10, 11 },
      { 1, 5, 9 },
      { 5, 11, 4 },
      { 11, 10, 2 },
      { 10, 7, 6 },
      { 7, 1, 8 },
      { 3, 9, 4 },
      { 3, 4, 2 },
      { 3, 2, 6 },
      { 3, 6, 8 },
      { 3, 8, 9 },
      { 4, 9, 5 },
      { 2, 4, 11 },
      { 6, 2, 10 },
      { 8, 6, 7 },
      { 9, 8, 1 } });
}

/// Unit sphere of 10 * 4^levels + 2 vertices.
inline TriangleMesh sphere(int levels)
{
  TriangleMesh mesh = icosahedron();
  mesh.Vertices.rowwise().normalize();
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<int, int>, int> middles;
    std::vector<Eigen::RowVector3d> added;
    const int old = mesh.vertexCount();
    const auto middle = [&](int a, int b)
    {
      const auto [it, isNew] = middles.try_emplace(std::minmax(a, b), old + int(added.size()));
      if (isNew)
      {
        added.push_back((mesh.Vertices.row(a) + mesh.Vertices.row(b)).normalized());
      }
      return it->second;
    };
    FaceMatrix finer(4 * mesh.faceCount(), 3);
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      const int a = mesh.Faces(f, 0);
      const int b = mesh.Faces(f, 1);
      const int c = mesh.Faces(f, 2);
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      finer.row(4 * f) << a, ab, ca;
      finer.row(4 * f + 1) << b, bc, ab;
      finer.row(4 * f + 2) << c, ca, bc;
      finer.row(4 * f + 3) << ab, bc, ca;
    }
    mesh.Faces = finer;
    mesh.Vertices.conservativeResize(old + static_cast<Eigen::Index>(added.size()), 3);
    for (std::size_t i = 0; i < added.size(); ++i)
    {
      mesh.Vertices.row(old + static_cast<Eigen::Index>(i)) = added[i];
    }
  }
  return mesh;
}

/// A torus of n x m vertices with the radii 2 and 0.5.
inline TriangleMesh torus(int n, int m)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(n * m, 3);
  mesh.Faces.resize(2 * n * m, 3);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double u = 2 * Pi * i / n;
      const double v = 2 * Pi * j / m;
      const double r = 2.0 + 0.5 * std::cos(v);
      mesh.Vertices.row(i * m + j) << r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v);
      const int next = (i + 1) % n * m;
      const int up = (j + 1) % m;
      mesh.Faces.row(2 * (i * m + j)) << i * m + j, next + j, next + up;
      mesh.Faces.row(2 * (i * m + j) + 1) << i * m + j, next + up, i * m + up;
    }
  }
  return mesh;
}

/// Open cylinder of radius 1 about z, normals outward: n vertices around, m + 1 along the height.
inline TriangleMesh cylinder(int n, int m, double height)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(n * (m + 1), 3);
  mesh.Faces.resize(2 * n * m, 3);
  for (int i = 0; i <= m; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double u = 2 * Pi * j / n;
      mesh.Vertices.row(i * n + j) << std::cos(u), std::sin(u), height * i / m;
      if (i < m)
      {
        const int right = (j + 1) % n;
        mesh.Faces.row(2 * (i * n + j)) << i * n + j, i * n + right, (i + 1) * n + right;
        mesh.Faces.row(2 * (i * n + j) + 1) << i * n + j, (i + 1) * n + right, (i + 1) * n + j;
      }
    }
  }
  return mesh;
}

/// A Moebius strip of radius 2 and width 1: 2 n vertices, and n quads of two triangles each.
inline TriangleMesh moebiusStrip(int n)
{
  TriangleMesh strip;
  strip.Vertices.resize(2 * n, 3);
  strip.Faces.resize(2 * n, 3);
  for (int i = 0; i < n; ++i)
  {
    const double u = 2 * Pi * i / n;
    for (const int side : { 0, 1 })
    {
      const double r = 2.0 + (side - 0.5) * std::cos(0.5 * u);
      strip.Vertices.row(2 * i + side) << r * std::cos(u), r * std::sin(u),
        (side - 0.5) * std::sin(0.5 * u);
    }
    const int nextLow = i + 1 < n ? 2 * i + 2 : 1; // the sides change places once around
    const int nextHigh = i + 1 < n ? 2 * i + 3 : 0;
    strip.Faces.row(2 * i) << 2 * i, 2 * i + 1, nextHigh;
    strip.Faces.row(2 * i + 1) << 2 * i, nextHigh, nextLow;
  }
  return strip;
}

/// One mesh of two that share no vertices.
inline TriangleMesh both(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(a.vertexCount() + b.vertexCount(), 3);
  mesh.Vertices << a.Vertices, b.Vertices;
  mesh.Faces.resize(a.faceCount() + b.faceCount(), 3);
  mesh.Faces << a.Faces, (b.Faces.array() + a.vertexCount()).matrix();
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, double x, double y, double z)
{
  mesh.Vertices.rowwise() += Eigen::RowVector3d(x, y, z);
  return mesh;
}

inline TriangleMesh withoutFaces(TriangleMesh mesh, const std::set<int>& removed)
{
  Eigen::Index kept = 0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if (!removed.count(f))
    {
      mesh.Faces.row(kept++) = mesh.Faces.row(f).eval();
    }
  }
  mesh.Faces.conservativeResize(kept, 3);
  return mesh;
}

/// Every face with three vertices of its own, as STL files have it.
inline TriangleMesh soupOf(const TriangleMesh& mesh)
{
  TriangleMesh soup;
  soup.Vertices.resize(3 * mesh.faceCount(), 3);
  soup.Faces.resize(mesh.faceCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      soup.Vertices.row(3 * f + k) = mesh.Vertices.row(mesh.Faces(f, k));
      soup.Faces(f, k) = 3 * f + k;
    }
  }
  return soup;
}
/// A grid on a rectangle of this width and area pi around the origin, vertex j * columns + i in column i
/// and row j.
inline TriangleMesh rectangleGrid(int columns, int rows, double width)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(columns * rows, 3);
  mesh.Faces.resize(2 * (columns - 1) * (rows - 1), 3);
  int face = 0;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int v = j * columns + i;
      mesh.Vertices.row(v) << width * (i / (columns - 1.0) - 0.5), Pi / width * (j / (rows - 1.0) - 0.5),
        0.0;
      if (i + 1 < columns && j + 1 < rows)
      {
        mesh.Faces.row(face++) << v, v + 1, v + columns + 1;
        mesh.Faces.row(face++) << v, v + columns + 1, v + columns;
      }
    }
  }
  return mesh;
}

/// A grid of (n + 1)^2 vertices on [0, 1]^2, by columns of x, whose inner vertices are moved at random,
/// so little that no face is flipped; @p place lifts it into space.
inline TriangleMesh liftedGrid(int n, const std::function<Eigen::Vector3d(double, double)>& place)
{
  std::mt19937 generator(7);
  const auto moved = [&generator] { return 0.4 * (std::ldexp(generator(), -32) - 0.5); };
  TriangleMesh mesh;
  mesh.Vertices.resize((n + 1) * (n + 1), 3);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const bool inner = i % n != 0 && j % n != 0;
      const double x = (i + (inner ? moved() : 0.0)) / n;
      const double y = (j + (inner ? moved() : 0.0)) / n;
      mesh.Vertices.row(i * (n + 1) + j) = place(x, y);
    }
  }
  mesh.Faces.resize(2 * n * n, 3);
  for (int i = 0, f = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int a = i * (n + 1) + j;
      mesh.Faces.row(f++) << a, a + n + 1, a + n + 2;
      mesh.Faces.row(f++) << a, a + n + 2, a + 1;
    }
  }
  return mesh;
}

inline double totalArea(const TriangleMesh& mesh)
{
  return faceAreas(mesh.Vertices, mesh.Faces).sum();
}

/// Volume enclosed by a closed mesh; positive if its normals point outward.
inline double enclosedVolume(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::Vector3d a = mesh.Vertices.row(mesh.Faces(f, 0));
    const Eigen::Vector3d b = mesh.Vertices.row(mesh.Faces(f, 1));
    const Eigen::Vector3d c = mesh.Vertices.row(mesh.Faces(f, 2));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

/// The message of the exception of the given type that the body throws.
template <typename Error, typename Body>
std::string messageOf(const Body& body)
{
  try
  {
    body();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  ADD_FAILURE() << "no exception of the expected type";
  return {};
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace flattening::samples
