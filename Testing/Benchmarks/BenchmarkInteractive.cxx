// SPDX-License-Identifier: GPL-3.0-or-later
// Times the map after a change of one region's weight: from the beginning, and from the map before.
//   BenchmarkInteractive [scan] [Google Benchmark's options]
#include "Areas/AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "Yardstick.h"

#include <benchmark/benchmark.h>

#include <string>

namespace
{

using namespace flattening;

constexpr double EdgeLength = 1.852; // mm: 15 thousand vertices
constexpr double RegionRadius = 20.0;

Eigen::VectorXd regionWeights(const TriangleMesh& mesh, double factor)
{
  const Eigen::RowVector3d centre = mesh.Vertices.row(mesh.vertexCount() / 2);
  const Eigen::ArrayXd distances = (mesh.Vertices.rowwise() - centre).rowwise().norm().array();
  return (distances < RegionRadius)
    .select(Eigen::ArrayXd::Constant(mesh.vertexCount(), factor), 1.0)
    .matrix();
}

struct Timed
{
  AreaPreservingMap Map;
  double Clock = 0.0;
  double Processor = 0.0;
};

Timed timed(const TriangleMesh& mesh,
  const Points2& conformal,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options = {})
{
  const benchmarks::StopWatch watch;
  Timed result;
  result.Map = areaPreservingDiskMap(mesh, conformal, weights, options).Map;
  result.Clock = watch.seconds();
  result.Processor = watch.processorSeconds();
  return result;
}

void count(benchmark::State& state,
  const std::string& name,
  const TriangleMesh& mesh,
  const Eigen::VectorXd& weights,
  const Timed& run)
{
  const auto faces = summariseDistortion(measureDistortion(mesh, run.Map.Positions, weights));
  state.counters[name + "_seconds"] = run.Clock;
  state.counters[name + "_cpu_seconds"] = run.Processor;
  state.counters[name + "_within_2_percent"] = faces.FacesWithin2Percent;
  state.counters[name + "_angle_error"] = faces[Measure::AngleError].Mean;
  state.counters[name + "_rounds"] = run.Map.RefinementRounds;
  state.counters[name + "_bijective"] = run.Map.Bijective;
}

void change(benchmark::State& state, const std::string& scan, double before, double after)
{
  const TriangleMesh mesh = benchmarks::remeshedHalfBrain(scan, EdgeLength).Mesh;
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  const AreaPreservingMap former =
    areaPreservingDiskMap(mesh, conformal, regionWeights(mesh, before)).Map;
  const Eigen::VectorXd weights = regionWeights(mesh, after);
  AreaPreservingOptions options;
  options.Start.PowerWeights = former.PowerWeights;
  options.Start.Positions = former.Positions;
  for (auto _ : state)
  {
    const Timed warm = timed(mesh, conformal, weights, options);
    state.SetIterationTime(warm.Clock);
    count(state, "warm", mesh, weights, warm);
    count(state, "cold", mesh, weights, timed(mesh, conformal, weights));
    state.counters["vertices"] = mesh.vertexCount();
    state.counters["region_vertices"] = static_cast<double>((weights.array() != 1.0).count());
    state.counters["continued"] = warm.Map.WarmStarted;
  }
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  struct Change
  {
    const char* Name;
    double Before;
    double After;
  };
  for (const Change& it : { Change{ "1 to 1.1", 1.0, 1.1 },
         Change{ "1 to 2", 1.0, 2.0 },
         Change{ "2 to 4", 2.0, 4.0 },
         Change{ "4 to 2", 4.0, 2.0 },
         Change{ "1 to 4", 1.0, 4.0 },
         Change{ "1 to 0.25", 1.0, 0.25 } })
  {
    benchmark::RegisterBenchmark(
      it.Name, [scan, it](benchmark::State& state) { change(state, scan, it.Before, it.After); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kSecond);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
