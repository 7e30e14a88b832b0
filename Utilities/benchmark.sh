#!/usr/bin/env bash
# Installs what is missing, builds, runs the benchmarks and writes their figures into the tables of README.md and the pages
# of docs (docs/benchmarks.md lists them). The pictures and the JSON output of Google Benchmark stay in the build folder.
# Safe to run again. Let nothing else run meanwhile.
#   Utilities/benchmark.sh                            all of it
#   Utilities/benchmark.sh --benchmark_filter=brain   arguments go to Google Benchmark; the tables are printed alone
#   Utilities/benchmark.sh --profile "half brain, raw"
#                                                     the time and the memory of every stage on the named surfaces;
#                                                     without a name, their names
set -euo pipefail
cd "$(dirname "$0")/.."

Utilities/build.sh -DSURFACEFLATTENING_BENCHMARKS=ON
build=${BUILD_DIRECTORY:-build}
if [ "${1:-}" = --profile ]; then
  shift
  exec "$build/Testing/bin/ProfileStages" /usr/share/mricron/templates "$@"
fi

results=()
for benchmark in BenchmarkSurfaceToDisk BenchmarkFlattening BenchmarkConformal BenchmarkAreaMaps BenchmarkLengths BenchmarkInteractive \
  BenchmarkFlatMap BenchmarkSaliency; do
  results+=("$build/Testing/$benchmark.json")
  "$build/Testing/bin/$benchmark" --benchmark_out="${results[-1]}" --benchmark_out_format=json "$@" >/dev/null
done
python3 Testing/Benchmarks/markdown_table.py "${results[@]}"
if [ $# -eq 0 ]; then
  python3 Testing/Benchmarks/markdown_table.py --pages . "${results[@]}"
fi

convergence=$build/Testing/BenchmarkConvergence.json
"$build/Testing/bin/BenchmarkConvergence" --benchmark_out="$convergence" --benchmark_out_format=json >/dev/null
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/pictures/convergence_picture.py \
  "$convergence" "$build/Testing/convergence.png"
echo "Picture of the convergence: $build/Testing/convergence.png"

xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/pictures/angle_weight_picture.py \
  "$build/Testing/BenchmarkAreaMaps.json" "$build/Testing/angle_weight.png"
echo "Picture of the angle weights: $build/Testing/angle_weight.png"

xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/pictures/length_picture.py \
  "$build/Testing/BenchmarkLengths.json" "$build/Testing/length_errors.png"
echo "Picture of the errors of lengths: $build/Testing/length_errors.png"

xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/pictures/time_picture.py \
  "$build/Testing/BenchmarkFlattening.json" "$build/Testing/BenchmarkAreaMaps.json" "$build/Testing/time_against_size.png" \
  "$build/Testing/memory_against_size.png"
echo "Pictures of the times and of the memory: $build/Testing/time_against_size.png, $build/Testing/memory_against_size.png"
