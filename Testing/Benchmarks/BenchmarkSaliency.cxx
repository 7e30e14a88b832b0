// SPDX-License-Identifier: GPL-3.0-or-later
// Times mesh saliency with its defaults, by wall clock and by processor time, and prints how much the
// cells change it.
//   BenchmarkSaliency [scan] [Google Benchmark's options]
#include "BenchmarkSurfaces.h"
#include "Regions/MeshSaliency.h"
#include "Yardstick.h"

#include <benchmark/benchmark.h>

#include <string>

namespace
{

using namespace flattening;

void measureSaliency(benchmark::State& state, const TriangleMesh& mesh, bool compare)
{
  MeshSaliency saliency;
  for (auto _ : state)
  {
    const benchmarks::StopWatch watch;
    saliency = meshSaliency(mesh);
    state.counters["saliency_cpu_seconds"] = watch.processorSeconds();
    state.counters["saliency_seconds"] = watch.seconds();
  }
  state.counters["vertices"] = mesh.vertexCount();
  if (compare)
  {
    MeshSaliencyOptions exact;
    exact.SampleSpacing = 0.0;
    const Eigen::VectorXd reference = meshSaliency(mesh, exact).Saliency;
    const Eigen::VectorXd difference = (saliency.Saliency - reference).cwiseAbs();
    state.counters["mean_difference"] = difference.mean() / reference.maxCoeff();
    state.counters["greatest_difference"] = difference.maxCoeff() / reference.maxCoeff();
  }
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  const TriangleMesh half = benchmarks::halfBrain(scan).Mesh;
  const TriangleMesh whole = benchmarks::closedBrain(scan).Mesh;
  const TriangleMesh million = benchmarks::subdivided(benchmarks::halfBrain(scan), 2).Mesh;
  const auto add = [](const char* name, const TriangleMesh& mesh, bool compare)
  {
    benchmark::RegisterBenchmark(
      name, [&mesh, compare](benchmark::State& state) { measureSaliency(state, mesh, compare); })
      ->Unit(benchmark::kSecond)
      ->Iterations(1);
  };
  add("half brain", half, true);
  add("whole brain", whole, true);
  add("half brain, refined", million, false);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
