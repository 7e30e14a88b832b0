#!/usr/bin/env bash
# Runs the filters on random surfaces of many classes, with random settings, and checks what they promise. A case that
# fails (a crash, a hang, a wrong certificate, a leak, ...) is made small and saved, with the command that runs it again.
#   Utilities/fuzz.sh [--release] [minutes] [seed]
# It builds with the address and undefined-behaviour sanitizers into build-asan/ and runs for so many minutes (10 by
# default) from a seed (1 by default). --release takes the release build in build/, which is ten times as fast. The table
# and the failed cases go to fuzz-output/ (or FUZZ_OUTPUT). The exit status is 0 if no case failed.
#   Utilities/fuzz.sh 20 1000               twenty minutes with the sanitizers, seeds from 1000
#   Utilities/fuzz.sh --release 120         two hours of the release build
set -euo pipefail
cd "$(dirname "$0")/.."

preset=asan
build=build-asan
if [ "${1:-}" = --release ]; then
  shift
  preset=release
  build=build
fi
build=${BUILD_DIRECTORY:-$build}
minutes=${1:-10}
seed=${2:-1}
output=${FUZZ_OUTPUT:-fuzz-output}

Utilities/setup.sh
mkdir -p "$build"
if ! cmake --preset "$preset" -B "$build" >"$build/configure.log" 2>&1 ||
  ! cmake --build "$build" --target FuzzFilters >"$build/fuzz-build.log" 2>&1; then
  tail -n 40 "$build/configure.log" "$build/fuzz-build.log" >&2 || true
  echo "fuzz.sh: the build failed; the logs are in $build" >&2
  exit 1
fi
"$build/Testing/bin/FuzzFilters" --class all --first "$seed" --count 1000000000 --minutes "$minutes" --out "$output"
