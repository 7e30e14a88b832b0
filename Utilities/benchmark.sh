#!/usr/bin/env bash
# Installs what is missing, builds, times every stage of the flattening on a hemisphere, a Gaussian bump and
# a real brain, and prints the figures as the README's tables. The JSON output of Google Benchmark stays in
# the build folder. Safe to run again. Let nothing else run meanwhile.
set -euo pipefail
cd "$(dirname "$0")/.."

Utilities/build.sh -DSURFACEFLATTENING_BENCHMARKS=ON
build=${BUILD_DIRECTORY:-build}
results=$build/Testing/benchmark.json
"$build/Testing/bin/BenchmarkFlattening" --benchmark_out="$results" --benchmark_out_format=json "$@" >/dev/null
python3 Testing/Benchmarks/markdown_table.py "$results"
