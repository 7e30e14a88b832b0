// SPDX-License-Identifier: GPL-3.0-or-later
// Times Surface To Disk on isosurfaces of real scans with many handles: the removal of handles alone,
// and the whole filter with and without remeshing.
//   BenchmarkSurfaceToDisk [folder of scans] [Google Benchmark's options]
#include "Disk/SurfaceToDisk.h"
#include "Handles/HandleRemoval.h"
#include "Mesh/SurfaceComponents.h"
#include "Repair/SurfaceRepair.h"
#include "ScanSurface.h"
#include "Yardstick.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <string>

namespace
{

using namespace flattening;

double secondsOf(const std::function<void()>& work)
{
  const benchmarks::StopWatch watch;
  work();
  return watch.seconds();
}

TriangleMesh largestComponentOf(const TriangleMesh& soup)
{
  const RepairedSurface repaired = repairTriangleSoup(soup);
  const SurfaceComponents components = connectedComponents(repaired.Surface.Mesh);
  return extractFaces(
    repaired.Surface.Mesh, components.faces(chooseComponent(repaired.Surface.Mesh, components, {})))
    .Mesh;
}

void toDisk(benchmark::State& state, const benchmarks::NamedScan& scan)
{
  const TriangleMesh soup =
    benchmarks::meshOf(benchmarks::scanSurface(scan.File, scan.Sigma, scan.Isovalue));
  const TriangleMesh component = largestComponentOf(soup);
  auto& counters = state.counters;
  for (auto _ : state)
  {
    HandleRemovalReport handles;
    counters["handles_seconds"] = secondsOf([&] { handles = removeHandles(component).Report; });
    SurfaceToDiskOptions options;
    SurfaceToDiskReport raw;
    const double rawSeconds = secondsOf([&] { raw = surfaceToDisk(soup, options).Report; });
    options.Remesh = true;
    SurfaceToDiskReport remeshed;
    const double remeshedSeconds = secondsOf([&] { remeshed = surfaceToDisk(soup, options).Report; });
    state.SetIterationTime(rawSeconds);

    counters["vertices"] = component.vertexCount();
    counters["genus"] = handles.Handles;
    counters["raw_seconds"] = rawSeconds;
    counters["remeshed_seconds"] = remeshedSeconds;
    counters["longest_loop"] =
      handles.LoopLengths.empty()
        ? 0.0
        : *std::max_element(handles.LoopLengths.begin(), handles.LoopLengths.end());
    const double area = faceAreas(component.Vertices, component.Faces).sum();
    counters["area_added_percent"] = 100.0 * handles.AddedArea / area;
    counters["displacement"] = handles.GreatestDisplacement;
    counters["intersections"] = raw.SelfIntersections;
    counters["remeshed_intersections"] = remeshed.SelfIntersections;
    counters["smallest_angle"] = remeshed.SmallestAngle;
  }
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string folder = argc > 1 ? argv[1] : "/usr/share/mricron/templates";
  for (const benchmarks::NamedScan& scan : benchmarks::scansWithHandles(folder))
  {
    const std::string name = scan.name();
    benchmark::RegisterBenchmark(name.c_str(), [scan](benchmark::State& state) { toDisk(state, scan); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kSecond);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
