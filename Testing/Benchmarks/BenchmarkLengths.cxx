// SPDX-License-Identifier: GPL-3.0-or-later
/// Flat maps of other methods and ours, side by side: areas, angles, lengths, flipped faces, outlines
/// and times. The first argument that is not an option is the scan; default: ch2bet of Debian's
/// mricron-data.

#include "AuthalicEnergy.h"
#include "BenchmarkSurfaces.h"
#include "StretchEnergy.h"
#include "SymmetricDirichlet.h"
#include "Yardstick.h"

#include "Areas/AreaPreservingDisk.h"
#include "Conformal/ConformalDisk.h"
#include "Conformal/NaturalOutline.h"
#include "FlatMap/DistortionSummary.h"
#include "FlatMap/LengthDistortion.h"
#include "Mesh/MeshTopology.h"

#include <benchmark/benchmark.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

using namespace flattening;

namespace
{

struct NamedMap
{
  std::string Name;
  std::function<Points2(const TriangleMesh&)> Flatten;
};

NamedMap ours(const std::string& name, bool isFree)
{
  return { name,
    [isFree](const TriangleMesh& mesh)
    {
      AreaPreservingOptions options;
      options.FreeOutline = isFree;
      return areaPreservingDiskMap(mesh, conformalDiskMap(mesh).Positions, {}, options).Map.Positions;
    } };
}

std::vector<NamedMap> namedMaps()
{
  return { ours("ours, disk", false),
    ours("ours, free outline", true),
    { "stretch energy, 100 iterations",
      [](const TriangleMesh& mesh) { return benchmarks::stretchEnergyDiskMap(mesh, 100).Positions; } },
    { "authalic energy",
      [](const TriangleMesh& mesh) { return benchmarks::authalicEnergyDiskMap(mesh); } },
    { "distortion balancing",
      [](const TriangleMesh& mesh) { return benchmarks::balancedDiskMap(mesh).Positions; } },
    { "Boundary First, natural outline",
      [](const TriangleMesh& mesh)
      {
        const std::vector<int> loop = requireDisk(mesh);
        NaturalOutlineMap map(mesh, loop);
        return map.extended(map.outline());
      } },
    { "symmetric Dirichlet, free outline",
      [](const TriangleMesh& mesh) { return benchmarks::symmetricDirichletMap(mesh, 100); } } };
}

void setLengths(benchmark::UserCounters& counters, const TriangleMesh& mesh, const Points2& flat)
{
  const LengthDistortion lengths = measureLengths(mesh, flat);
  counters["local_length_error"] = lengths.Local.Mean;
  counters["local_length_standard_error"] = lengths.Local.StandardError;
  counters["within_map_length_error"] = lengths.WithinMap.Mean;
  counters["global_length_error"] = lengths.Global.Mean;
  counters["global_length_standard_error"] = lengths.Global.StandardError;
  counters["ring_distance_error"] = lengths.RingDistanceError;
}

void compare(benchmark::State& state, const TriangleMesh& mesh, const NamedMap& map)
{
  auto& counters = state.counters;
  for (auto _ : state)
  {
    const benchmarks::StopWatch watch;
    const Points2 flat = map.Flatten(mesh);
    const double seconds = watch.processorSeconds();
    state.SetIterationTime(watch.seconds());

    const auto faces = summariseDistortion(measureDistortion(mesh, flat));
    counters["vertices"] = mesh.vertexCount();
    counters["named_map_cpu_seconds"] = seconds;
    counters["faces_within_2_percent"] = faces.FacesWithin2Percent;
    counters["area_error_percent"] = faces[Measure::AreaError].AreaWeightedMean;
    counters["sd_area_ratio"] = faces.SDAreaRatio;
    counters["angle_error"] = faces[Measure::AngleError].Mean;
    counters["symmetric_dirichlet"] = faces[Measure::SymmetricDirichlet].AreaWeightedMean;
    counters["flipped"] = faces.FlippedFaces;
    counters["outline_crossings"] = benchmarks::outlineCrossings(flat, requireDisk(mesh));
    setLengths(counters, mesh, flat);
  }
}

// The surface is loaded once, when the first of its benchmarks runs.
void add(const std::string& name, const std::function<benchmarks::BenchmarkSurface()>& load)
{
  const auto mesh = std::make_shared<TriangleMesh>();
  for (const NamedMap& map : namedMaps())
  {
    benchmark::RegisterBenchmark((name + "/" + map.Name).c_str(),
      [load, mesh, map](benchmark::State& state)
      {
        if (mesh->faceCount() == 0)
        {
          *mesh = load().Mesh;
        }
        try
        {
          compare(state, *mesh, map);
        }
        catch (const std::exception& error)
        {
          state.SkipWithError(error.what());
        }
      })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kSecond);
  }
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  add("hemisphere", [] { return benchmarks::hemisphere(); });
  add("half brain, remeshed", [scan] { return benchmarks::remeshedHalfBrain(scan); });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
