// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the methods of the conformal disk: times, as a yardstick in the same run the Cholesky
// factorization of the mesh's Laplacian, memory, and the distortion of angles. Times are processor time
// and wall clock. On surfaces of a million vertices only the default method is measured.
//   BenchmarkConformal [scan [finer scan]] [Google Benchmark's options]
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "PeakMemory.h"
#include "Yardstick.h"

#include <benchmark/benchmark.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

struct NamedMethod
{
  const char* Name;
  ConformalMethod Method;
};
constexpr std::array<NamedMethod, 3> Methods = { { { "Ricci Flow", ConformalMethod::RicciFlow },
  { "Boundary First", ConformalMethod::BoundaryFirst },
  { "Mean Value", ConformalMethod::MeanValue } } };

// Seconds of processor time.
double factorizationSeconds(const SparseMatrix& laplacian)
{
  const benchmarks::StopWatch watch;
  const SparseCholesky cholesky(laplacian);
  benchmark::DoNotOptimize(cholesky.info());
  return watch.processorSeconds();
}

void compare(benchmark::State& state, const TriangleMesh& mesh, ConformalMethod method)
{
  ConformalDiskOptions options;
  options.Method = method;
  auto& counters = state.counters;
  for (auto _ : state)
  {
    const double factorization = factorizationSeconds(benchmarks::meshLaplacian(mesh));

    benchmarks::resetPeakMemory();
    const benchmarks::StopWatch watch;
    const ConformalDiskMap map = conformalDiskMap(mesh, options);
    const double seconds = watch.processorSeconds();
    const double wallSeconds = watch.seconds();
    state.SetIterationTime(wallSeconds);
    counters["peak_memory"] = benchmarks::peakMemory();

    const auto distortion = summariseDistortion(measureDistortion(mesh, map.Positions));
    counters["vertices"] = mesh.vertexCount();
    counters["conformal_cpu_seconds"] = seconds;
    counters["conformal_wall_seconds"] = wallSeconds;
    counters["factorization_cpu_seconds"] = factorization;
    counters["conformal_ratio"] = seconds / factorization;
    counters["angle_error"] = distortion[Measure::AngleError].Mean;
    counters["angle_distortion_p95"] = distortion[Measure::AngleDistortion].P95;
    counters["repaired"] = map.Untangling.RepairedFaces;
    counters["flipped"] = map.Untangling.FlippedFaces;
    if (method == ConformalMethod::RicciFlow)
    {
      counters["curvature_error"] = map.MaxCurvatureError;
    }
  }
}

// The surface is loaded once, when the first of its benchmarks runs.
void add(const std::string& name,
  const std::function<benchmarks::BenchmarkSurface()>& load,
  std::size_t methods = Methods.size())
{
  const auto mesh = std::make_shared<TriangleMesh>();
  for (const NamedMethod& method : std::vector<NamedMethod>(Methods.begin(), Methods.begin() + methods))
  {
    benchmark::RegisterBenchmark((name + "/" + method.Name).c_str(),
      [load, mesh, method](benchmark::State& state)
      {
        if (mesh->faceCount() == 0)
        {
          *mesh = load().Mesh;
        }
        compare(state, *mesh, method.Method);
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
  const std::string fineScan = argc > 2 ? argv[2] : "/usr/share/mricron/templates/ch2better.nii.gz";
  add("hemisphere", benchmarks::hemisphere);
  add("Gaussian bump", benchmarks::gaussianSquare);
  add("half brain, remeshed", [scan] { return benchmarks::remeshedHalfBrain(scan); });
  add("half brain, raw", [scan] { return benchmarks::halfBrain(scan); });
  add(
    "other half, raw", [scan] { return benchmarks::otherHalfBrain(scan); }, 1);
  add("whole brain, closed", [scan] { return benchmarks::closedBrain(scan); });
  add(
    "half brain, a million",
    [scan] { return benchmarks::subdivided(benchmarks::halfBrain(scan), 2); },
    1);
  add(
    "whole brain, 0.5 mm", [fineScan] { return benchmarks::fineBrain(fineScan); }, 1);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
