#!/usr/bin/env bash
# Installs what is missing, builds, times Surface To Disk on surfaces of real scans with up to 700 handles and
# every stage of the flattening on a real brain and on surfaces as in the paper, compares the methods of the
# conformal disk on the same, compares area-preserving maps on half a brain, changes the weight of a region, carries
# a million points to flat maps and back, looks up pixels there, computes mesh saliency, and prints the figures as
# Markdown tables; draws the conformal disk's error on surfaces with known maps, area error against angle error of the
# area-preserving maps, and time against size. The JSON output of Google Benchmark and the pictures stay in the build
# folder. Safe to run again. Let nothing else run meanwhile.
set -euo pipefail
cd "$(dirname "$0")/.."

Utilities/build.sh -DSURFACEFLATTENING_BENCHMARKS=ON
build=${BUILD_DIRECTORY:-build}
results=()
for benchmark in BenchmarkSurfaceToDisk BenchmarkFlattening BenchmarkConformal BenchmarkAreaMaps BenchmarkInteractive \
  BenchmarkFlatMap BenchmarkSaliency; do
  results+=("$build/Testing/$benchmark.json")
  "$build/Testing/bin/$benchmark" --benchmark_out="${results[-1]}" --benchmark_out_format=json "$@" >/dev/null
done
python3 Testing/Benchmarks/markdown_table.py "${results[@]}"

convergence=$build/Testing/BenchmarkConvergence.json
"$build/Testing/bin/BenchmarkConvergence" --benchmark_out="$convergence" --benchmark_out_format=json >/dev/null
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/convergence_picture.py \
  "$convergence" "$build/Testing/convergence.png"
echo "Picture of the convergence: $build/Testing/convergence.png"

xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/angle_weight_picture.py \
  "$build/Testing/BenchmarkAreaMaps.json" "$build/Testing/angle_weight.png"
echo "Picture of the angle weights: $build/Testing/angle_weight.png"

xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython Utilities/time_picture.py \
  "$build/Testing/BenchmarkFlattening.json" "$build/Testing/BenchmarkAreaMaps.json" "$build/Testing/time_against_size.png"
echo "Picture of the times: $build/Testing/time_against_size.png"
