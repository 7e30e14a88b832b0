#!/usr/bin/env bash
# Installs the packages that are missing and builds into build/ (or BUILD_DIRECTORY). Safe to run again. Further
# arguments go to CMake's configure step. The compiler's messages are in build.log in the build folder.
#   Utilities/build.sh [-DSURFACEFLATTENING_BENCHMARKS=ON ...]
#   Utilities/build.sh --plugin [...]    builds the ParaView plugin alone, without the tests and the Python package
set -euo pipefail
cd "$(dirname "$0")/.."

targets=()
if [ "${1:-}" = --plugin ]; then
  shift
  targets=(--target SurfaceFlattening)
fi
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

# Turns Ninja's lines "[5/60] Building ..." into one line that grows over itself.
show_progress() {
  awk -F'[][/]' '/^\[[0-9]+\/[0-9]+\]/ { printf "\rBuilding into %s: %d of %d", folder, $2, $3; fflush(); shown = 1 }
    END { if (shown) print "" }' folder="$build"
}
# CGAL takes up to 2.7 GB in a compiler.
jobs=$(awk -v cores="$(nproc)" '/MemAvailable/ { n = int($2 / 2700000); print n < 1 ? 1 : n < cores ? n : cores }' /proc/meminfo)
if ! NINJA_STATUS='[%f/%t] ' cmake --build "$build" --parallel "$jobs" "${targets[@]}" 2>&1 |
  tee "$build/build.log" | show_progress; then
  grep -m1 -A40 '^FAILED' "$build/build.log" >&2 || tail -n 40 "$build/build.log" >&2
  echo "build.sh: the build failed; the whole log is $build/build.log" >&2
  exit 1
fi
