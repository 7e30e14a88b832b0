// SPDX-License-Identifier: GPL-3.0-or-later
/// Every random surface becomes a disk or gives a known error that says what to do. One surface alone is
/// repeated by
///   RANDOM_SURFACE=<seed> TestRandomSurfaces
/// Temporary/RandomSurfaces.log names each seed before and after it runs: a seed that is named once
/// crashed or hung.
#include "Base/Errors.h"
#include "Disk/SurfaceToDisk.h"
#include "Mesh/MeshTopology.h"
#include "Support/DiskDefect.h"
#include "Support/MarchingTetrahedra.h"
#include "Support/RandomNumbers.h"
#include "Support/RandomShapes.h"
#include "Support/RandomSurfaces.h"
#include "Support/SampleSurfaces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <mutex>
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
  { "one-sided", "the surface is one-sided" },
  { "not finite", "has a coordinate that is not finite" },
  { "index out of range", "names vertex" },
  { "zero area", "the surface has zero area" },
  { "no triangles", "the surface has no triangles" },
  { "no round hole", "no round hole of share" },
  { "too long a hole", "more than the limit of" },
  { "too few faces to remesh", "would leave fewer than" },
  { "handles are errors", "set Handles to Remove or Cut" },
  { "seam point off the surface", "pick a point on the surface" },
  { "seam points coincide", "of the seam coincide" },
  { "seam off the boundary", "the seam neither starts nor ends on it" },
  { "region everywhere for a hole", "the region that the hole must avoid covers all" },
  { "region everywhere for a relief", "the region that the relief must avoid covers all" },
  { "plane misses", "the cutting plane misses the surface" },
};

// A random corner of a face; zero if it is not finite or there is no face.
Eigen::Vector3d randomCorner(RandomNumbers& random, const TriangleMesh& mesh)
{
  const int face = mesh.faceCount() > 0 ? random.integer(0, mesh.faceCount() - 1) : -1;
  const int v = face < 0 ? -1 : mesh.Faces(face, random.integer(0, 2));
  if (v < 0 || v >= mesh.vertexCount() || !mesh.Vertices.row(v).allFinite())
  {
    return Eigen::Vector3d::Zero();
  }
  return mesh.Vertices.row(v);
}

void chooseCut(RandomNumbers& random, const TriangleMesh& mesh, SurfaceToDiskOptions& options)
{
  if (random.chance(0.08))
  {
    options.Cut = CutMode::Seam;
    options.SeamPoints = { randomCorner(random, mesh), randomCorner(random, mesh) };
    options.Boundary.By = BoundaryChoice::Rule::None;
  }
  else if (random.chance(0.15))
  {
    options.Cut = CutMode::Plane;
    options.Plane.Origin =
      0.5 * (randomCorner(random, mesh) + randomCorner(random, mesh)); // it may miss the component
    options.Plane.Normal = random.point(-1.0, 1.0);
  }
  else if (random.chance(0.6))
  {
    options.Cut = CutMode::Hole;
    options.Hole.AreaFraction = random.real(1e-4, 0.2);
  }
  if (random.chance(0.15))
  {
    options.Boundary.By = random.chance(0.7) ? BoundaryChoice::Rule::None //
                                             : BoundaryChoice::Rule::ClosestToPoint;
    options.Boundary.Point = randomCorner(random, mesh);
  }
  if (random.chance(0.15))
  {
    const Eigen::RowVector3d origin = randomCorner(random, mesh);
    const Eigen::RowVector3d normal = random.point(-1.0, 1.0);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      options.RegionOfInterest.push_back((mesh.Vertices.row(v) - origin).dot(normal) > 0.0);
    }
  }
}

// The options differ from seed to seed too.
SurfaceToDiskOptions randomOptions(std::uint64_t seed, const TriangleMesh& mesh)
{
  RandomNumbers random(seed + 1'000'000);
  SurfaceToDiskOptions options;
  options.Remesh = random.chance(0.3);
  options.CountSelfIntersections = random.chance(0.3);
  if (random.chance(0.2))
  {
    options.Component.By = ComponentChoice::Rule::ClosestToPoint;
    options.Component.Point = randomCorner(random, mesh);
  }
  if (random.chance(0.4))
  {
    options.Handles = HandleMode::Keep;
  }
  else if (random.chance(0.05))
  {
    options.Handles = HandleMode::Error;
  }
  if (random.chance(0.5))
  {
    options.FillLengthLimit = 1e30;
  }
  options.FlattenFolds = random.chance(0.8);
  if (random.chance(0.2))
  {
    options.SmallestAngle = random.chance(0.5) ? 0.0 : random.real(0.0, 15.0);
  }
  chooseCut(random, mesh, options);
  return options;
}

// Expects correct origins of every vertex and face.
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
    const std::string error = diskDefect(disk.Surface.Mesh);
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

TEST(DiskDefect, SeesEveryKind)
{
  const TriangleMesh disk = withoutFaces(sphere(2), { 0 });
  EXPECT_EQ(diskDefect(disk), "");
  EXPECT_EQ(diskDefect({}), "it is empty");
  TriangleMesh mesh = disk;
  mesh.Vertices(5, 1) = NAN;
  EXPECT_EQ(diskDefect(mesh), "a coordinate is not finite");
  mesh = disk;
  mesh.Vertices.row(disk.Faces(0, 0)) = mesh.Vertices.row(disk.Faces(0, 1)).eval();
  EXPECT_EQ(diskDefect(mesh), "a face has no area");
  mesh = disk;
  std::swap(mesh.Faces(7, 0), mesh.Faces(7, 1));
  EXPECT_EQ(diskDefect(mesh), "two faces run along an edge in one direction");
  mesh = disk;
  mesh.Vertices.conservativeResize(mesh.vertexCount() + 1, 3);
  mesh.Vertices.bottomRows<1>() << 1, 2, 3;
  EXPECT_EQ(diskDefect(mesh), "a point has no face");

  EXPECT_EQ(diskDefect(sphere(2)), "it is closed");
  EXPECT_EQ(diskDefect(withoutFaces(sphere(2), { 0, 100 })), "it has several boundaries");
  EXPECT_EQ(diskDefect(both(disk, moved(torus(9, 9), 9, 0, 0))), "it has several components");
  EXPECT_EQ(diskDefect(withoutFaces(torus(9, 9), { 0 })), "its Euler number is -1");
  // The last vertex of a sphere becomes an inner one of the disk; or a boundary vertex that of another
  // disk.
  for (const bool closed : { true, false })
  {
    const TriangleMesh other = closed ? sphere(0) : withoutFaces(sphere(0), { 0 });
    mesh = both(disk, moved(other, 5, 0, 0));
    const int from = disk.vertexCount() + (closed ? 11 : other.Faces(0, 0));
    const int boundaryVertex = sphere(2).Faces(0, 0);
    const int to = closed ? (boundaryVertex + 50) % disk.vertexCount() : boundaryVertex;
    mesh.Faces = (mesh.Faces.array() == from).select(to, mesh.Faces).eval();
    EXPECT_NE(diskDefect(mesh), "") << closed;
  }
}

TEST(RandomShapes, AreWhatTheySay)
{
  for (int seed = 0; seed < 40; ++seed)
  {
    RandomNumbers random(seed);
    const int rings = 1 + seed % 4;
    const TriangleMesh chain = chainOfRings(random, rings);
    const MeshTopology topology =
      analyseTopology(chain.Faces, chain.vertexCount()); // throws if unoriented
    EXPECT_EQ(topology.Components, 1) << seed;
    EXPECT_EQ(topology.Genus, rings) << seed;
    EXPECT_TRUE(topology.BoundaryLoops.empty()) << seed;
    EXPECT_GT(enclosedVolume(chain), 0.0) << seed;

    const TriangleMesh noise = noiseSurface(random, seed % 3, true);
    EXPECT_TRUE(analyseTopology(noise.Faces, noise.vertexCount()).BoundaryLoops.empty()) << seed;
    EXPECT_GT(enclosedVolume(noise), 0.0) << seed;
  }
}

// Half a ball of radius 4: its volume to the accuracy of a linear interpolation, its rim open.
TEST(MarchingTetrahedra, EnclosesTheValuesAboveZero)
{
  Volume volume({ 13, 13, 7 });
  for (int z = 0; z < 7; ++z)
  {
    for (int y = 0; y < 13; ++y)
    {
      for (int x = 0; x < 13; ++x)
      {
        volume.at(x, y, z) = 4.1 - std::hypot(std::hypot(x - 6.0, y - 6.0), z);
      }
    }
  }
  const TriangleMesh half = marchingTetrahedra(volume);
  EXPECT_EQ(diskDefect(half), "");
  EXPECT_NEAR(enclosedVolume(half), 2.0 / 3.0 * Pi * std::pow(4.1, 3), 0.05 * 144.0);
  for (const int v : requireDisk(half))
  {
    EXPECT_EQ(half.Vertices(v, 2), 0.0);
  }
}

TEST(RandomSurfaces, AreTheSameForTheSameSeed)
{
  const RandomSurface one = randomSurface(5);
  EXPECT_EQ(one.Mesh.Faces, randomSurface(5).Mesh.Faces);
  EXPECT_EQ(one.Mesh.Vertices, randomSurface(5).Mesh.Vertices);
  EXPECT_NE(one.Mesh.faceCount(), randomSurface(6).Mesh.faceCount());
}

// The result of a seed.
struct SeedRecord
{
  std::string Recipe;
  int Faces = 0;
  double Seconds = 0.0;
  Outcome Result;
};

// Logs the seeds in work: one that crashes or hangs is logged without a result.
class SeedLog
{
public:
  void begin(int seed, const SeedRecord& record)
  {
    this->write(seed, record.Recipe + ", " + std::to_string(record.Faces) + " faces");
  }
  void end(int seed, const SeedRecord& record)
  {
    this->write(
      seed, std::to_string(record.Seconds) + " s: " + record.Result.Name + ' ' + record.Result.Error);
  }

private:
  void write(int seed, const std::string& text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->File << seed << ": " << text << std::endl;
  }

  std::mutex Mutex;
  std::ofstream File{ TEMPORARY_DIRECTORY "/RandomSurfaces.log" };
};

SeedRecord recordOf(int seed, SeedLog& log)
{
  SeedRecord record;
  const RandomSurface surface = randomSurface(seed);
  record.Recipe = surface.Recipe;
  record.Faces = surface.Mesh.faceCount();
  log.begin(seed, record);
  const auto began = std::chrono::steady_clock::now();
  record.Result = outcomeOf(surface.Mesh, randomOptions(seed, surface.Mesh));
  record.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  log.end(seed, record);
  return record;
}

// The seeds are shared out to all threads; each has its record, so that the order does not matter. A
// thread that waits inside a surface must not take up another one: its time would count twice.
std::vector<SeedRecord> recordsOf(int first, int end)
{
  std::vector<SeedRecord> records(end - first);
  SeedLog log;
  tbb::parallel_for(
    tbb::blocked_range<int>(first, end, 1),
    [&](const tbb::blocked_range<int>& seeds)
    {
      for (int seed = seeds.begin(); seed < seeds.end(); ++seed)
      {
        tbb::this_task_arena::isolate([&] { records[seed - first] = recordOf(seed, log); });
      }
    },
    tbb::simple_partitioner());
  return records;
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
  const std::vector<SeedRecord> records = recordsOf(first, end);
  std::map<std::string, int> counts;
  std::vector<int> sizes;
  int slowest = first;
  for (int seed = first; seed < end; ++seed)
  {
    const SeedRecord& record = records[seed - first];
    sizes.push_back(record.Faces);
    ++counts[record.Result.Name];
    slowest = record.Seconds > records[slowest - first].Seconds ? seed : slowest;
    EXPECT_TRUE(record.Result.Error.empty()) << "seed " << seed << ", " << record.Recipe << ": "
                                             << record.Result.Name << ": " << record.Result.Error;
  }
  std::sort(sizes.begin(), sizes.end());
  std::cout << sizes.size() << " surfaces of " << sizes.front() << " to " << sizes.back()
            << " faces, median " << sizes[sizes.size() / 2] << "; slowest "
            << records[slowest - first].Seconds << " s, seed " << slowest << '\n';
  for (const auto& [name, count] : counts)
  {
    std::cout << count << " x " << name << '\n';
  }
}

} // namespace
