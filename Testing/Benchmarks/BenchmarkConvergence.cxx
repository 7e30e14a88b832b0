// SPDX-License-Identifier: GPL-3.0-or-later
// The error of the conformal disk on surfaces of revolution, whose maps are known exactly, on finer and
// finer meshes: root mean square of the radius over the vertices. Times are wall clock.
//   BenchmarkConvergence [Google Benchmark's options]
#include "AnalyticSurfaces.h"
#include "Conformal/ConformalDisk.h"

#include <benchmark/benchmark.h>

#include <string>
#include <utility>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

void converge(benchmark::State& state, const SurfaceOfRevolution& surface, ConformalMethod method)
{
  const RevolutionMesh mesh = sunflowerMesh(surface, static_cast<int>(state.range(0)));
  ConformalDiskOptions options;
  options.Method = method;
  options.CenterVertex = 0;
  auto& counters = state.counters;
  for (auto _ : state)
  {
    const ConformalDiskMap map = conformalDiskMap(mesh.Mesh, options);
    counters["vertices"] = mesh.Mesh.vertexCount();
    counters["radius_error"] = radialError(mesh, map.Positions, surface.ConformalRadius);
    counters["flipped"] = map.Untangling.FlippedFaces;
  }
}

void add(const std::string& name, const SurfaceOfRevolution& surface)
{
  for (const auto& [method, label] : { std::pair{ ConformalMethod::RicciFlow, "Ricci Flow" },
         std::pair{ ConformalMethod::BoundaryFirst, "Boundary First" } })
  {
    benchmark::RegisterBenchmark((name + "/" + label).c_str(),
      [surface, method = method](benchmark::State& state) { converge(state, surface, method); })
      ->Arg(1000)
      ->Arg(3162)
      ->Arg(10000)
      ->Arg(31623)
      ->Arg(100000)
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kSecond);
  }
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  add("paraboloid", paraboloid(1.0));
  add("Gaussian bump", gaussianBump(1.0, 0.3));
  add("capsule of length 3", capsule(3.0));
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
