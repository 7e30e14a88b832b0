// SPDX-License-Identifier: GPL-3.0-or-later
// Times every stage of a flattening, and as a yardstick, on the same mesh in the same run, one regular
// triangulation of its sites and one Cholesky factorization of its Laplacian.
//   BenchmarkFlattening [scan] [Google Benchmark's options]
#include "AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "ConformalDisk.h"
#include "DistortionSummary.h"
#include "MeshTopology.h"
#include "Yardstick.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

using benchmarks::StopWatch;

double regularTriangulationSeconds(const Points2& sites, const Eigen::VectorXd& weights)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Weighted_point_2> points;
  for (Eigen::Index i = 0; i < sites.rows(); ++i)
  {
    points.emplace_back(Kernel::Point_2(sites(i, 0), sites(i, 1)), weights[i]);
  }
  const StopWatch watch;
  const CGAL::Regular_triangulation_2<Kernel> triangulation(points.begin(), points.end());
  const double seconds = watch.seconds();
  benchmark::DoNotOptimize(triangulation.number_of_vertices());
  return seconds;
}

double factorizationSeconds(const TriangleMesh& mesh)
{
  const SparseMatrix laplacian = benchmarks::meshLaplacian(mesh);
  const StopWatch watch;
  const SparseCholesky cholesky(laplacian);
  benchmark::DoNotOptimize(cholesky.info());
  return watch.seconds();
}

void flatten(benchmark::State& state, const std::function<benchmarks::BenchmarkSurface()>& load)
{
  const benchmarks::BenchmarkSurface surface = load();
  const TriangleMesh& mesh = surface.Mesh;
  auto& counters = state.counters;
  for (auto _ : state)
  {
    const StopWatch watch;
    const ConformalDiskMap conformal = conformalDiskMap(mesh);
    counters["conformal_seconds"] = watch.seconds();
    AreaPreservingOptions cellsAlone;
    cellsAlone.RefineFaces = false;
    const StopWatch transportWatch;
    const AreaPreservingResult flat = areaPreservingDiskMap(mesh, conformal.Positions, {}, cellsAlone);
    const double transportSeconds = transportWatch.seconds();
    const StopWatch refinementWatch;
    const FaceRefinementResult refined = refineFaces(mesh,
      { std::make_shared<UnitDisk>(),
        requireDisk(mesh),
        {},
        conformal.Positions,
        flat.Map.Positions,
        conformal.Positions },
      faceTargets(mesh, {}),
      flat.Map.TargetAreas);
    const double refinementSeconds = refinementWatch.seconds();
    state.SetIterationTime(watch.seconds());

    const double triangulation = regularTriangulationSeconds(conformal.Positions, flat.Map.PowerWeights);
    const double factorization = factorizationSeconds(mesh);
    const auto before = summariseDistortion(measureDistortion(mesh, conformal.Positions));
    const auto cells = summariseDistortion(measureDistortion(mesh, flat.Map.Positions));
    const auto faces = summariseDistortion(measureDistortion(mesh, refined.Positions));
    counters["vertices"] = mesh.vertexCount();
    counters["surface_to_disk_seconds"] = surface.SurfaceToDiskSeconds;
    counters["transport_seconds"] = transportSeconds;
    counters["triangulation_seconds"] = triangulation;
    counters["factorization_seconds"] = factorization;
    counters["transport_ratio"] = transportSeconds / (triangulation + factorization);
    counters["conformal_newton_steps"] = conformal.NewtonIterations;
    counters["curvature_error"] = conformal.MaxCurvatureError;
    counters["conformal_angle_error"] = before[Measure::AngleError].Mean;
    counters["conformal_flipped"] = conformal.FlippedFaces;
    counters["newton_steps"] = flat.Map.NewtonIterations;
    counters["power_diagrams"] = flat.Map.PowerDiagrams;
    counters["cell_error"] = flat.Map.MaxCellError;
    counters["cells_within_2_percent"] = cells.FacesWithin2Percent;
    counters["cells_area_error_percent"] = cells[Measure::AreaError].AreaWeightedMean;
    counters["cells_angle_error"] = cells[Measure::AngleError].Mean;
    counters["cells_flipped"] = flat.Map.FlippedFaces;
    counters["refinement_seconds"] = refinementSeconds;
    counters["rounds"] = refined.Rounds;
    counters["faces_within_2_percent"] = faces.FacesWithin2Percent;
    counters["area_error_percent"] = faces[Measure::AreaError].AreaWeightedMean;
    counters["area_error_p99"] = faces[Measure::AreaError].P99;
    counters["angle_error"] = faces[Measure::AngleError].Mean;
    counters["flipped"] = refined.FlippedFaces;
    counters["bijective"] = refined.Bijective;
  }
}

void add(const char* name, const std::function<benchmarks::BenchmarkSurface()>& load)
{
  benchmark::RegisterBenchmark(name, [load](benchmark::State& state) { flatten(state, load); })
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  add("hemisphere", benchmarks::hemisphere);
  add("Gaussian bump", benchmarks::gaussianSquare);
  add("half brain, remeshed", [scan] { return benchmarks::remeshedHalfBrain(scan); });
  add("half brain, raw", [scan] { return benchmarks::halfBrain(scan); });
  add("whole brain, remeshed", [scan] { return benchmarks::remeshedBrain(scan); });
  add("whole brain, raw", [scan] { return benchmarks::closedBrain(scan); });
  add("half brain, split once", [scan] { return benchmarks::subdividedHalfBrain(scan, 1); });
  add("half brain, split twice", [scan] { return benchmarks::subdividedHalfBrain(scan, 2); });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
