#!/usr/bin/env bash
# A brain MRI in, a measured flat map out. Installs what is missing, builds, flattens the left half of
# Debian's example brain and writes to demo-output/ (or the folder given):
#   flattening.png    surface, conformal and area-preserving map by AAL region, and histograms
#   flattened.vtp     the area-preserving map, with its distortion on every face
#   distortion.csv    areas and distortions of both maps, per region and overall
#   flattening.pvsm   the whole pipeline and its views, for ParaView
# Safe to run again.
#   Utilities/demo.sh [folder]
set -euo pipefail
output=$(realpath -m "${1:-$(dirname "$0")/../demo-output}")
cd "$(dirname "$0")/.."

source Utilities/demo/build_plugin.sh
build_plugin --plugin

# The screen is as large as the picture; rendering is in software, as on a server.
LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 2100x1180x24 -noreset" \
  pvpython --force-offscreen-rendering Utilities/demo/demo.py --plugin "$plugin" --output "$output"

echo "To open the scene:"
echo "  PV_PLUGIN_PATH='${plugin%/*/*}' paraview --state='$output/flattening.pvsm'"
