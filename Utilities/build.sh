#!/usr/bin/env bash
# Installs what is missing and builds into build/ (or BUILD_DIRECTORY). Safe to run again. Further arguments
# go to CMake's configure step.
#   Utilities/build.sh [-DSURFACEFLATTENING_BENCHMARKS=ON ...]
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ " $* " == *" -DSURFACEFLATTENING_WITH_PARAVIEW=OFF "* ]]; then
  Utilities/setup.sh --vtk
else
  Utilities/setup.sh
fi
build=${BUILD_DIRECTORY:-build}
mkdir -p "$build"
if ! cmake --preset release -B "$build" "$@" >"$build/configure.log" 2>&1; then
  tail -n 40 "$build/configure.log" >&2
  echo "build.sh: CMake failed; the whole log is $build/configure.log" >&2
  exit 1
fi
echo "Building into $build"
# CGAL needs about 1.5 GB for each compiler.
jobs=$(awk -v cores="$(nproc)" '/MemAvailable/ { n = int($2 / 1500000); print n < 1 ? 1 : n < cores ? n : cores }' /proc/meminfo)
cmake --build "$build" --parallel "$jobs"
