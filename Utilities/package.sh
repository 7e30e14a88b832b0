#!/usr/bin/env bash
# Builds a Debian package of the plugin, the module and the Python package. Safe to run again. The last line is the
# package's name.
#   Utilities/package.sh           build-package/paraview-surfaceflattening_<version>_<architecture>.deb
#   Utilities/package.sh --test    then installs it, has ParaView load and use the plugin, and removes it; needs root
set -euo pipefail
cd "$(dirname "$0")/.."

Utilities/setup.sh --package
build=${BUILD_DIRECTORY:-build-package}
jobs=$(awk -v cores="$(nproc)" '/MemAvailable/ { n = int($2 / 1500000); print n < 1 ? 1 : n < cores ? n : cores }' /proc/meminfo)
cmake --preset package -B "$build" >/dev/null
cmake --build "$build" --parallel "$jobs"
rm -f "$build"/*.deb
(cd "$build" && cpack >cpack.log) || { cat "$build/cpack.log" >&2; exit 1; }
package=$(realpath "$build"/*.deb)

if [ "${1:-}" = --test ]; then
  name=$(dpkg-deb -f "$package" Package)
  dpkg-deb -c "$package" | awk '{ print $6 }'
  dpkg-deb -f "$package"
  env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "$package"
  Utilities/packaging/package_check.sh installed
  env DEBIAN_FRONTEND=noninteractive apt-get -q -y purge "$name"
  Utilities/packaging/package_check.sh removed
fi
echo "$package"
