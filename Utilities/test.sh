#!/usr/bin/env bash
# Installs what is missing, builds, and runs the whole test suite on a virtual X display. Safe to run again.
# The last line says "N passed, N failed"; the exit status is 0 only if none failed.
#   Utilities/test.sh            the ParaView plugin, the module and the Python package
#   Utilities/test.sh --vtk      the module and the Python package alone, on a VTK without ParaView
# Other arguments go to ctest, e.g. Utilities/test.sh -R Core
set -euo pipefail
cd "$(dirname "$0")/.."

configure=()
if [ "${1:-}" = --vtk ]; then
  shift
  configure=(-DSURFACEFLATTENING_WITH_PARAVIEW=OFF)
  export BUILD_DIRECTORY=${BUILD_DIRECTORY:-build-vtk}
fi
Utilities/build.sh "${configure[@]}"
build=${BUILD_DIRECTORY:-build}

# pvserver listens on every interface and mpiexec looks for the host's name: give the tests a network of
# their own where that is allowed.
isolate=()
if unshare -n -u true 2>/dev/null; then
  isolate=(unshare -n -u bash -c 'hostname localhost; ip link set lo up; exec "$@"' isolated)
fi
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export UCX_LOG_LEVEL=fatal # where there is no /sys the library of Open MPI says so among what a program prints
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb

log=$build/Testing/suite.log
mkdir -p "$build/Testing"
status=0
"${isolate[@]}" xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  ctest --test-dir "$build" --output-on-failure --timeout 900 --no-tests=error "$@" 2>&1 |
  tee "$log" || status=$?

passed=$(grep -cE '^ *[0-9]+/[0-9]+ Test +#[0-9]+: .* Passed ' "$log" || true)
failed=$(grep -E '^ *[0-9]+/[0-9]+ Test +#[0-9]+: .*(\*\*\*|Not Run)' "$log" | grep -cv '\*\*\*Skipped' || true)
if [ "$passed" -eq 0 ] || { [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; }; then
  failed=$((failed + 1)) # ctest itself did not get through
  status=1
fi
echo "$passed passed, $failed failed"
exit "$status"
