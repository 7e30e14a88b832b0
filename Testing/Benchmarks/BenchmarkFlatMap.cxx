// SPDX-License-Identifier: GPL-3.0-or-later
// A million random points of a brain's surface, looked up there and on its flat map and carried back:
// how far off they are, as a share of the diagonal, and how many are lost; then the pixels of an image
// of the map.
//   BenchmarkFlatMap [scan] [Google Benchmark's options]
#include "AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "ConformalDisk.h"
#include "FlatMapPixels.h"

#include "../Core/RandomNumbers.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
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
  double greatest = 0.0;
  int lost = 0;
  for (auto _ : state)
  {
    const FlatMapLocation location(flat.Surface, flat.Positions);
    samples::RandomNumbers random(1);
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
  }
  state.counters["faces"] = flat.Surface.faceCount();
  state.counters["points"] = Points;
  state.counters["lost"] = lost;
  state.counters["greatest_error"] = greatest;
}

void lookUpPixels(benchmark::State& state, const Flattened& flat)
{
  long inside = 0;
  for (auto _ : state)
  {
    const FlatMapLocation location(flat.Surface, flat.Positions);
    const double length = 2.0 / Pixels; // of the unit disk's square
    const PixelGrid grid{ Eigen::RowVector2d::Constant(0.5 * length - 1.0), length, Pixels, Pixels };
    const std::vector<MapPlace> places = placesOfPixels(location, grid, 2.0 * length);
    inside = std::count_if(places.begin(),
      places.end(),
      [](const MapPlace& place) { return place.Face >= 0 && place.Inside; });
  }
  state.counters["pixels"] = Pixels * Pixels;
  state.counters["share_of_disk"] = 4.0 * static_cast<double>(inside) / Pixels / Pixels / EIGEN_PI;
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  const Flattened half = flattened(benchmarks::halfBrain(scan).Mesh);
  const Flattened whole = flattened(benchmarks::closedBrain(scan).Mesh);
  const auto add = [](const std::string& name, auto measure, const Flattened& flat)
  {
    benchmark::RegisterBenchmark(
      name.c_str(), [measure, &flat](benchmark::State& state) { measure(state, flat); })
      ->Unit(benchmark::kSecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime()
      ->Iterations(1);
  };
  add("half brain, there and back", thereAndBack, half);
  add("half brain, pixels", lookUpPixels, half);
  add("whole brain, there and back", thereAndBack, whole);
  add("whole brain, pixels", lookUpPixels, whole);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
