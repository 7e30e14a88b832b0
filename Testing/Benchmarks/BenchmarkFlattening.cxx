// SPDX-License-Identifier: GPL-3.0-or-later
// Times every stage of a flattening, and as a yardstick, on the same mesh in the same run, one regular
// triangulation of its sites and one Cholesky factorization of its Laplacian. Times are by the clock
// and, with _cpu_ in their names, processor time of all threads.
//   BenchmarkFlattening [scan] [Google Benchmark's options]
#include "Areas/AreaPreservingDisk.h"
#include "BenchmarkSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "LieAdvection.h"
#include "MinimalFlow.h"
#include "PaperSurfaces.h"
#include "PeakMemory.h"
#include "PlainNewton.h"
#include "Transport/TransportSites.h"
#include "Yardstick.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

using benchmarks::StopWatch;

// On larger meshes the transport of every vertex takes minutes.
constexpr int MostSites = 150000;
// Processor time that the plain Newton iteration is given.
constexpr double MostPlainSeconds = 60.0;
// The flows get as much time, and end when the mean relative error of the vertices' areas is below this.
constexpr double MostFlowSeconds = 60.0;
constexpr double FlowTolerance = 0.01;

struct Time
{
  double Clock;
  double Processor;
};

Time regularTriangulationTime(const Points2& sites, const Eigen::VectorXd& weights)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Weighted_point_2> points;
  for (Eigen::Index i = 0; i < sites.rows(); ++i)
  {
    points.emplace_back(Kernel::Point_2(sites(i, 0), sites(i, 1)), weights[i]);
  }
  const StopWatch watch;
  const CGAL::Regular_triangulation_2<Kernel> triangulation(points.begin(), points.end());
  const Time time{ watch.seconds(), watch.processorSeconds() };
  benchmark::DoNotOptimize(triangulation.number_of_vertices());
  return time;
}

Time factorizationTime(const TriangleMesh& mesh)
{
  const SparseMatrix laplacian = benchmarks::meshLaplacian(mesh);
  const StopWatch watch;
  const SparseCholesky cholesky(laplacian);
  benchmark::DoNotOptimize(cholesky.info());
  return { watch.seconds(), watch.processorSeconds() };
}

// The transport of every vertex, as without refinement.
void transportAll(benchmark::State& state, const TriangleMesh& mesh, const Points2& conformal)
{
  auto& counters = state.counters;
  AreaPreservingOptions options;
  options.RefineFaces = false;
  const StopWatch watch;
  const AreaPreservingResult flat = areaPreservingDiskMap(mesh, conformal, {}, options);
  const double seconds = watch.seconds();
  counters["transport_cpu_seconds"] = watch.processorSeconds();
  const Time triangulation = regularTriangulationTime(conformal, flat.Map.PowerWeights);
  const Time factorization = factorizationTime(mesh);
  const auto cells = summariseDistortion(measureDistortion(mesh, flat.Map.Positions));
  counters["transport_seconds"] = seconds;
  counters["triangulation_seconds"] = triangulation.Clock;
  counters["factorization_seconds"] = factorization.Clock;
  counters["yardstick_cpu_seconds"] = triangulation.Processor + factorization.Processor;
  counters["transport_ratio"] = seconds / (triangulation.Clock + factorization.Clock);
  counters["newton_steps"] = flat.Map.NewtonIterations;
  counters["power_diagrams"] = flat.Map.PowerDiagrams;
  counters["cell_error"] = flat.Map.MaxCellError;
  counters["cells_within_2_percent"] = cells.FacesWithin2Percent;
  counters["cells_area_error_percent"] = cells[Measure::AreaError].AreaWeightedMean;
  counters["cells_angle_error"] = cells[Measure::AngleError].Mean;
  counters["cells_flipped"] = flat.Map.FlippedFaces;
}

// The same transport by the plain Newton iteration, without the accelerations.
void transportPlainly(benchmark::State& state, const TriangleMesh& mesh, const Points2& conformal)
{
  auto& counters = state.counters;
  const TransportSites sites = distinctSites(conformal);
  const Eigen::VectorXd targets = sites.sums(targetAreas(mesh, {}));
  const StopWatch watch;
  PowerDiagram diagram(sites.Positions);
  const benchmarks::PlainNewtonResult plain =
    benchmarks::plainNewton(diagram, targets, TransportOptions().Tolerance, MostPlainSeconds);
  counters["plain_newton_seconds"] = watch.seconds();
  counters["plain_newton_cpu_seconds"] = watch.processorSeconds();
  counters["plain_newton_steps"] = plain.Steps;
  counters["plain_newton_power_diagrams"] = diagram.updates();
  counters["plain_newton_cell_error"] = plain.CellError;
  counters["plain_newton_converged"] = plain.Converged;
}

// The map as the filter makes it: the transport of groups of vertices, then the refinement.
void refineAll(benchmark::State& state, const TriangleMesh& mesh, const Points2& conformal)
{
  auto& counters = state.counters;
  const StopWatch watch;
  double transportSeconds = 0.0;
  double transportProcessorSeconds = 0.0;
  const auto noteStage = [&](double, const char* stage)
  {
    if (transportSeconds == 0.0 && std::string(stage) == "Face refinement")
    {
      transportSeconds = watch.seconds();
      transportProcessorSeconds = watch.processorSeconds();
    }
    return true;
  };
  const AreaPreservingResult flat = areaPreservingDiskMap(mesh, conformal, {}, {}, noteStage);
  const double seconds = watch.seconds();
  const double processorSeconds = watch.processorSeconds();
  const auto faces = summariseDistortion(measureDistortion(mesh, flat.Map.Positions));
  counters["sites"] = flat.Map.Sites;
  counters["sites_seconds"] = transportSeconds;
  counters["refinement_seconds"] = seconds - transportSeconds;
  counters["area_preserving_seconds"] = seconds;
  counters["sites_cpu_seconds"] = transportProcessorSeconds;
  counters["refinement_cpu_seconds"] = processorSeconds - transportProcessorSeconds;
  counters["rounds"] = flat.Map.RefinementRounds;
  counters["faces_within_2_percent"] = faces.FacesWithin2Percent;
  counters["area_error_percent"] = faces[Measure::AreaError].AreaWeightedMean;
  counters["area_error_p99"] = faces[Measure::AreaError].P99;
  counters["angle_error"] = faces[Measure::AngleError].Mean;
  counters["angle_error_by_area"] = faces[Measure::AngleError].AreaWeightedMean;
  counters["flipped"] = flat.Map.FlippedFaces;
  counters["bijective"] = flat.Map.Bijective;
}

void countFlow(benchmark::State& state,
  const std::string& name,
  const TriangleMesh& mesh,
  const benchmarks::FlowResult& flow,
  double processorSeconds)
{
  auto& counters = state.counters;
  const auto faces = summariseDistortion(measureDistortion(mesh, flow.Positions));
  counters[name + "_cpu_seconds"] = processorSeconds;
  counters[name + "_steps"] = flow.Steps;
  counters[name + "_converged"] = flow.Converged;
  counters[name + "_faces_within_2_percent"] = faces.FacesWithin2Percent;
  counters[name + "_area_error_percent"] = faces[Measure::AreaError].AreaWeightedMean;
  counters[name + "_angle_error"] = faces[Measure::AngleError].Mean;
}

// The two methods that the paper is compared with. The minimal flow starts from the map of the other
// method, whose time counts for both.
void flowFrom(benchmark::State& state, const TriangleMesh& mesh, const Points2& conformal)
{
  const StopWatch watch;
  const benchmarks::FlowResult lie =
    benchmarks::lieAdvection(mesh, conformal, FlowTolerance, MostFlowSeconds);
  const double lieSeconds = watch.processorSeconds();
  countFlow(state, "lie", mesh, lie, lieSeconds);
  if (!lie.Converged)
  {
    return;
  }
  const benchmarks::FlowResult minimal =
    benchmarks::minimalFlow(mesh, conformal, lie.Positions, MostFlowSeconds);
  countFlow(state, "minimal_flow", mesh, minimal, watch.processorSeconds());
}

void flatten(benchmark::State& state,
  const std::function<benchmarks::BenchmarkSurface()>& load,
  bool withFlows = false)
{
  const benchmarks::BenchmarkSurface surface = load();
  const TriangleMesh& mesh = surface.Mesh;
  auto& counters = state.counters;
  for (auto _ : state)
  {
    benchmarks::resetPeakMemory();
    const StopWatch watch;
    const ConformalDiskMap conformal = conformalDiskMap(mesh);
    counters["conformal_seconds"] = watch.seconds();
    counters["conformal_cpu_seconds"] = watch.processorSeconds();
    refineAll(state, mesh, conformal.Positions);
    state.SetIterationTime(watch.seconds());
    counters["peak_memory"] = benchmarks::peakMemory();
    if (mesh.vertexCount() <= MostSites)
    {
      transportAll(state, mesh, conformal.Positions);
      transportPlainly(state, mesh, conformal.Positions);
    }
    if (withFlows && conformal.Untangling.FlippedFaces == 0)
    {
      flowFrom(state, mesh, conformal.Positions);
    }
    const auto before = summariseDistortion(measureDistortion(mesh, conformal.Positions));
    counters["vertices"] = mesh.vertexCount();
    counters["surface_to_disk_seconds"] = surface.SurfaceToDiskSeconds;
    counters["conformal_newton_steps"] = conformal.NewtonIterations;
    counters["curvature_error"] = conformal.MaxCurvatureError;
    counters["conformal_angle_error"] = before[Measure::AngleError].Mean;
    counters["conformal_flipped"] = conformal.Untangling.FlippedFaces;
  }
}

template <typename Run>
void add(const std::string& name, const Run& run)
{
  benchmark::RegisterBenchmark(name.c_str(), run)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);
}

void addPaperSurface(const benchmarks::PaperSurface& surface)
{
  add("paper: " + surface.Name,
    [surface](benchmark::State& state)
    {
      flatten(state, surface.Load, true);
      state.counters["paper_vertices"] = surface.Vertices;
      state.counters["paper_seconds"] = surface.Seconds;
      if (surface.MinimalFlowSeconds > 0.0)
      {
        state.counters["paper_minimal_flow_seconds"] = surface.MinimalFlowSeconds;
        state.counters["paper_lie_advection_seconds"] = surface.LieAdvectionSeconds;
      }
    });
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::string scan = argc > 1 ? argv[1] : "/usr/share/mricron/templates/ch2bet.nii.gz";
  for (const benchmarks::NamedSurface& surface : benchmarks::flattenedSurfaces(scan))
  {
    add(surface.Name, [surface](benchmark::State& state) { flatten(state, surface.Load); });
  }
  for (const benchmarks::PaperSurface& surface : benchmarks::paperSurfaces(scan))
  {
    addPaperSurface(surface);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
