// SPDX-License-Identifier: GPL-3.0-or-later
// A million random points of a surface, looked up there and on its flat map and carried back: how far
// off they are, as a share of the diagonal, and how many are lost; then the pixels of an image of the
// map.
//   BenchmarkFlatMap [scan] [Google Benchmark's options]
#include "Areas/AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/FlatMapPixels.h"
#include "Yardstick.h"

#include "../AnalyticSurfaces.h"
#include "../Core/Support/RandomNumbers.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace
{

using namespace flattening;

constexpr int Points = 1000000;
constexpr int Pixels = 1024; // a side

struct Flattened
{
  TriangleMesh Surface;
  Points2 Positions;
};

Flattened flattened(TriangleMesh surface)
{
  Points2 positions = areaPreservingDiskMap(surface, conformalDiskMap(surface).Positions).Map.Positions;
  return { std::move(surface), std::move(positions) };
}

void thereAndBack(benchmark::State& state, const Flattened& flat)
{
  const Points3& vertices = flat.Surface.Vertices;
  const double diagonal = (vertices.colwise().maxCoeff() - vertices.colwise().minCoeff()).norm();
  const FlatMapLocation location(flat.Surface, flat.Positions);
  samples::RandomNumbers random(1);
  double greatest = 0.0;
  int lost = 0;
  for (int i = 0; i < Points; ++i)
  {
    MapPlace place{ random.integer(0, flat.Surface.faceCount() - 1), {}, 0.0, true };
    const double a = std::sqrt(random.real(0.0, 1.0));
    const double b = random.real(0.0, 1.0);
    place.Weights = { 1.0 - a, a * (1.0 - b), a * b };
    const Eigen::RowVector3d start = location.surfacePoint(place);
    const MapPlace onSurface = location.onSurface(start);
    const MapPlace onMap = location.onMap(location.mapPoint(onSurface));
    lost += !onSurface.Inside || !onMap.Inside;
    greatest = std::max(greatest, (location.surfacePoint(onMap) - start).norm() / diagonal);
  }
  state.counters["points"] = Points;
  state.counters["lost"] = lost;
  state.counters["greatest_error"] = greatest;
}

void lookUpPixels(benchmark::State& state, const Flattened& flat)
{
  const benchmarks::StopWatch watch;
  const FlatMapLocation location(flat.Surface, flat.Positions);
  const double length = 2.0 / Pixels; // of the unit disk's square
  const PixelGrid grid{ Eigen::RowVector2d::Constant(0.5 * length - 1.0), length, Pixels, Pixels };
  const std::vector<MapPlace> places = placesOfPixels(location, grid, 2.0 * length);
  state.counters["pixels_cpu_seconds"] = watch.processorSeconds();
  state.counters["pixels"] = Pixels * Pixels;
  const auto inside = std::count_if(
    places.begin(), places.end(), [](const MapPlace& place) { return place.Face >= 0 && place.Inside; });
  state.counters["share_of_disk"] = 4.0 * static_cast<double>(inside) / Pixels / Pixels / EIGEN_PI;
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  const auto add = [](const std::string& name, const std::function<TriangleMesh()>& load)
  {
    benchmark::RegisterBenchmark(name.c_str(),
      [load](benchmark::State& state)
      {
        const Flattened flat = flattened(load());
        for (auto _ : state)
        {
          lookUpPixels(state, flat);
          thereAndBack(state, flat);
        }
        state.counters["faces"] = flat.Surface.faceCount();
      })
      ->Unit(benchmark::kSecond)
      ->Iterations(1);
  };
  add("Gaussian bump",
    [] { return analytic::sunflowerMesh(analytic::gaussianBump(3.0, 0.2), 10000).Mesh; });
  add("half brain, raw", [scan] { return benchmarks::halfBrain(scan).Mesh; });
  add("whole brain, raw, hole 0.1 %", [scan] { return benchmarks::closedBrain(scan).Mesh; });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
