// SPDX-License-Identifier: GPL-3.0-or-later
/// Every random surface becomes a disk, or an error that is known and says what to do. To repeat one
/// alone:
///   RANDOM_SURFACE=<seed> TestRandomSurfaces
/// Temporary/RandomSurfaces.log names each seed before it runs, so that its last line is what crashed or
/// hung.
#include "Errors.h"
#include "MarchingTetrahedra.h"
#include "MeshTopology.h"
#include "RandomShapes.h"
#include "RandomSurfaces.h"
#include "SampleSurfaces.h"
#include "SurfaceToDisk.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numeric>

namespace
{

using namespace flattening;
using namespace flattening::samples;

constexpr int SurfaceCount = 1200;

struct KnownError
{
  const char* Name;
  const char* Text; // part of the message
};

const std::vector<KnownError> KnownErrors = {
  { "handles", "the surface has genus" },
  { "one-sided", "the surface is one-sided" },
  { "not finite", "has a coordinate that is not finite" },
  { "index out of range", "names vertex" },
  { "zero area", "the surface has zero area" },
  { "no triangles", "the surface has no triangles" },
  { "no round hole", "no round hole of share" },
  { "too few faces to remesh", "would leave fewer than" },
};

// The options take turns as well.
SurfaceToDiskOptions randomOptions(std::uint64_t seed, const TriangleMesh& mesh)
{
  RandomNumbers random(seed + 1'000'000);
  SurfaceToDiskOptions options;
  if (random.chance(0.4))
  {
    options.RemeshEdgeLength = 0.0;
  }
  if (random.chance(0.2) && mesh.vertexCount() > 0)
  {
    const Eigen::Vector3d point = mesh.Vertices.row(random.integer(0, mesh.vertexCount() - 1));
    if (point.allFinite())
    {
      options.ComponentPoint = point;
    }
  }
  if (random.chance(0.2))
  {
    options.Hole.AreaFraction = random.real(1e-4, 0.2);
  }
  return options;
}

// What is wrong with a disk, counted without the code under test; empty if nothing.
std::string defectOf(const DiskSurface& disk)
{
  const TriangleMesh& mesh = disk.Surface.Mesh;
  if (!mesh.Vertices.allFinite())
  {
    return "a coordinate is not finite";
  }
  if (!(faceAreas(mesh.Vertices, mesh.Faces).minCoeff() > 0.0))
  {
    return "a face has no area";
  }
  std::map<std::pair<int, int>, int> halfedges; // to the next corner of the face
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::pair<int, int> halfedge(mesh.Faces(f, k), mesh.Faces(f, (k + 1) % 3));
      if (!halfedges.try_emplace(halfedge, mesh.Faces(f, (k + 2) % 3)).second)
      {
        return "two faces run along an edge in one direction";
      }
    }
  }
  // Around every vertex one fan of faces, from one boundary edge to another or all around. In a manifold
  // with as many boundary edges as boundary vertices, each vertex has at most one fan that ends.
  std::map<int, int> nextOnBoundary;
  std::vector<int> facesAround(mesh.vertexCount(), 0);
  std::vector<int> start(mesh.vertexCount(), -1);
  for (const auto& [halfedge, third] : halfedges)
  {
    const auto [from, to] = halfedge;
    ++facesAround[from];
    start[from] = start[from] < 0 ? to : start[from];
    if (!halfedges.count({ to, from }))
    {
      if (!nextOnBoundary.emplace(from, to).second)
      {
        return "two boundaries meet in a vertex";
      }
      start[from] = to;
    }
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (start[v] < 0)
    {
      return "a point has no face";
    }
    int fan = 0;
    for (auto it = halfedges.find({ v, start[v] }); it != halfedges.end();)
    {
      ++fan;
      const int third = it->second;
      it = third == start[v] ? halfedges.end() : halfedges.find({ v, third });
    }
    if (fan != facesAround[v])
    {
      return "faces meet in a vertex only";
    }
  }
  if (nextOnBoundary.empty())
  {
    return "it is closed";
  }
  std::size_t length = 1;
  const int first = nextOnBoundary.begin()->first;
  for (int v = nextOnBoundary.at(first); v != first; v = nextOnBoundary.at(v))
  {
    ++length;
  }
  if (length != nextOnBoundary.size())
  {
    return "it has several boundaries";
  }
  const int edges = static_cast<int>(halfedges.size() + nextOnBoundary.size()) / 2;
  const int euler = mesh.vertexCount() - edges + mesh.faceCount();
  if (euler != 1) // with one boundary: several components or handles
  {
    return "its Euler number is " + std::to_string(euler);
  }
  return {};
}

// Every vertex and face says where it came from.
std::string traceErrorOf(const DiskSurface& disk, const TriangleMesh& input)
{
  const DerivedMesh& derived = disk.Surface;
  if (derived.Vertices.rows() != derived.Mesh.vertexCount() ||
      derived.Vertices.cols() != input.vertexCount() ||
      static_cast<int>(derived.Faces.size()) != derived.Mesh.faceCount())
  {
    return "the origins are of another size than the mesh";
  }
  const Eigen::VectorXd sums = derived.Vertices * Eigen::VectorXd::Ones(derived.Vertices.cols());
  if (!((sums.array() - 1.0).abs().maxCoeff() < 1e-9))
  {
    return "the weights of a vertex do not sum to 1";
  }
  for (const int face : derived.Faces)
  {
    if (face < -1 || face >= input.faceCount())
    {
      return "a face comes from one that there was not";
    }
  }
  return {};
}

struct Outcome
{
  std::string Name;  // "disk", or that of a known error
  std::string Error; // if it is neither
};

Outcome outcomeOf(const TriangleMesh& mesh, const SurfaceToDiskOptions& options)
{
  try
  {
    const DiskSurface disk = surfaceToDisk(mesh, options);
    std::string error = defectOf(disk);
    return { "disk", error.empty() ? traceErrorOf(disk, mesh) : error };
  }
  catch (const FlatteningError& error)
  {
    for (const KnownError& known : KnownErrors)
    {
      if (contains(error.what(), known.Text))
      {
        return { known.Name, "" };
      }
    }
    return { "unknown error", error.what() };
  }
  catch (const std::exception& error)
  {
    return { "foreign exception", error.what() };
  }
}

TEST(RandomSurfaces, BecomeDisksOrNamedErrors)
{
  int first = 0;
  int end = SurfaceCount;
  if (const char* seed = std::getenv("RANDOM_SURFACE"))
  {
    first = std::atoi(seed);
    end = first + 1;
  }
  std::ofstream log(TEMPORARY_DIRECTORY "/RandomSurfaces.log");
  std::map<std::string, int> counts;
  std::vector<int> sizes;
  double slowest = 0.0;
  int slowestSeed = 0;
  for (int seed = first; seed < end; ++seed)
  {
    const RandomSurface surface = randomSurface(seed);
    sizes.push_back(surface.Mesh.faceCount());
    log << seed << ": " << surface.Recipe << ", " << sizes.back() << " faces" << std::flush;
    const auto began = std::chrono::steady_clock::now();
    const Outcome outcome = outcomeOf(surface.Mesh, randomOptions(seed, surface.Mesh));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
    if (seconds.count() > slowest)
    {
      slowest = seconds.count();
      slowestSeed = seed;
    }
    ++counts[outcome.Name];
    log << ": " << outcome.Name << ' ' << outcome.Error << std::endl;
    EXPECT_TRUE(outcome.Error.empty())
      << "seed " << seed << ", " << surface.Recipe << ": " << outcome.Name << ": " << outcome.Error;
  }
  std::sort(sizes.begin(), sizes.end());
  std::cout << sizes.size() << " surfaces of " << sizes.front() << " to " << sizes.back()
            << " faces, median " << sizes[sizes.size() / 2] << "; slowest " << slowest << " s, seed "
            << slowestSeed << '\n';
  for (const auto& [name, count] : counts)
  {
    std::cout << count << " x " << name << '\n';
  }
}

} // namespace
