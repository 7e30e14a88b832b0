#!/usr/bin/env bash
# Plays the clicks of docs/tutorial.md in ParaView's own window on a virtual display, checks the region's area
# in the spreadsheet, and writes docs/pictures/tutorial/*.png. ParaView starts cold, with an empty home.
# Safe to run again. Needs Debian's package mricron-data.
#   Utilities/screenshots/tutorial.sh [folder]
set -euo pipefail
output=$(realpath -m "${1:-$(dirname "$0")/../../docs/pictures/tutorial}")
cd "$(dirname "$0")/../.."

source Utilities/demo/build_plugin.sh
build_plugin

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$output" "$scratch/home" "$scratch/screen"

# Where the script asks for a picture, ParaView saves its state, which tells this script to take one, and waits.
sign='  <pqevent object="pqClientMainWindow/menubar/menu_File" command="activate" arguments="actionFileSaveServerState" />\n'
sign+='  <pqevent object="pqClientMainWindow/FileSaveServerStateDialog" command="filesSelected" arguments="SCRATCH/\1.pvsm" />'
wait='  <pqevent object="pqClientMainWindow" command="pause" arguments="6000" />'
sed -E -e "s|^ *<!-- picture (\w+) -->|$sign\n$wait|" \
  -e "s|^ *<!-- picture (\w+) follows -->|$sign|" \
  -e "s|^ *<!-- it is here -->|$wait|" \
  -e "s|SCRATCH|$scratch|" Testing/GUI/Tutorial.xml >"$scratch/tutorial.xml"

HOME=$scratch/home LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb \
  xvfb-run -a -s "-screen 0 1280x900x24 -noreset -fbdir $scratch/screen" \
  paraview --plugin-search-paths="${plugin%/*}" --plugins=SurfaceFlattening \
  --test-script="$scratch/tutorial.xml" --test-directory="$scratch" --dr --exit &
paraview=$!
while kill -0 "$paraview" 2>/dev/null; do
  sleep 0.2
  for state in "$scratch"/*.pvsm; do
    [ -s "$state" ] || continue
    sleep 3
    cp "$scratch/screen/Xvfb_screen0" "$scratch/$(basename "$state" .pvsm).xwd"
    rm "$state"
  done
done
wait "$paraview"
pvpython Utilities/screenshots/tutorial_pictures.py "$output" "$scratch"/*.xwd
