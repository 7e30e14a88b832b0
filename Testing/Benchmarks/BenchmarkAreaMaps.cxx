// SPDX-License-Identifier: GPL-3.0-or-later
// Compares area-preserving maps of the half brain: ours with several angle weights, stretch-energy
// minimisation, CGAL's iterative authalic map, and our conformal maps. Times are processor time of all
// threads, from the surface to the map.
//   BenchmarkAreaMaps [scan] [Google Benchmark's options]
#include "Areas/AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "IterativeAuthalic.h"
#include "StretchEnergy.h"
#include "Yardstick.h"

#include <benchmark/benchmark.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

struct AreaMap
{
  std::string Name;
  std::function<Points2(const TriangleMesh&)> Flatten;
  double AngleWeight = -1.0; // of ours
};

AreaMap conformal(const char* name, ConformalMethod method)
{
  return { name,
    [method](const TriangleMesh& mesh)
    {
      ConformalDiskOptions options;
      options.Method = method;
      return conformalDiskMap(mesh, options).Positions;
    } };
}

AreaMap stretchEnergy(int iterations)
{
  return { "stretch energy, " + std::to_string(iterations) + " iterations",
    [iterations](const TriangleMesh& mesh)
    { return benchmarks::stretchEnergyDiskMap(mesh, iterations).Positions; } };
}

AreaMap ours(const std::string& weight)
{
  AreaPreservingOptions options;
  options.Refinement.AngleWeight = std::stod(weight);
  return { "Angle Weight " + weight,
    [options](const TriangleMesh& mesh)
    { return areaPreservingDiskMap(mesh, conformalDiskMap(mesh).Positions, {}, options).Map.Positions; },
    options.Refinement.AngleWeight };
}

std::vector<AreaMap> areaMaps()
{
  std::vector<AreaMap> maps;
  for (const char* weight : { "0", "0.1", "0.3", "0.5", "0.7", "0.9" })
  {
    maps.push_back(ours(weight));
  }
  maps.push_back(stretchEnergy(10));
  maps.push_back(stretchEnergy(100));
  maps.push_back({ "CGAL iterative authalic", benchmarks::iterativeAuthalicDiskMap });
  maps.push_back(conformal("Boundary First", ConformalMethod::BoundaryFirst));
  maps.push_back(conformal("Ricci Flow", ConformalMethod::RicciFlow));
  return maps;
}

void compare(benchmark::State& state, const TriangleMesh& mesh, const AreaMap& map)
{
  auto& counters = state.counters;
  for (auto _ : state)
  {
    const benchmarks::StopWatch watch;
    const Points2 flat = map.Flatten(mesh);
    const double seconds = watch.processorSeconds();
    const double wallSeconds = watch.seconds();
    state.SetIterationTime(wallSeconds);

    const FaceDistortion distortion = measureDistortion(mesh, flat);
    const auto faces = summariseDistortion(distortion);
    counters["vertices"] = mesh.vertexCount();
    counters["map_cpu_seconds"] = seconds;
    counters["map_wall_seconds"] = wallSeconds;
    counters["faces_within_2_percent"] = faces.FacesWithin2Percent;
    counters["area_error_percent"] = faces[Measure::AreaError].AreaWeightedMean;
    counters["angle_error"] = faces[Measure::AngleError].Mean;
    counters["flipped"] = faces.FlippedFaces;
    if (map.AngleWeight >= 0.0)
    {
      counters["angle_weight"] = map.AngleWeight;
    }
  }
}

// The surface is loaded once, when the first of its benchmarks runs.
void add(const std::string& name, const std::function<benchmarks::BenchmarkSurface()>& load)
{
  const auto mesh = std::make_shared<TriangleMesh>();
  for (const AreaMap& map : areaMaps())
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
  add("half brain, remeshed", [scan] { return benchmarks::remeshedHalfBrain(scan); });
  add("half brain, raw", [scan] { return benchmarks::halfBrain(scan); });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
