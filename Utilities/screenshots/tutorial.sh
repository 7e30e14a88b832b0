#!/usr/bin/env bash
# Plays the clicks of docs/tutorial.md in ParaView's own window on a virtual display, checks what they give, and writes
# docs/pictures/tutorial/*.png. ParaView starts cold, with an empty home. Safe to run again. Needs Debian's packages
# mricron-data and invesalius-examples.
#   Utilities/screenshots/tutorial.sh [folder [session...]]
# A session is a file in Testing/GUI without its ending, such as Tutorial; by default all that have pictures.
set -euo pipefail
output=$(realpath -m "${1:-$(dirname "$0")/../../docs/pictures/tutorial}")
sessions=("${@:2}")
cd "$(dirname "$0")/../.."
if [ ${#sessions[@]} -eq 0 ]; then
  sessions=(HeadToMap BrainToMap CortexToNumber Tutorial)
fi

source Utilities/demo/build_plugin.sh
build_plugin

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$output" "$scratch/screen"

# The file that CortexToNumber opens.
python=$(command -v /usr/bin/python3 || command -v python3)
PYTHONPATH=$build/lib/python3/dist-packages "$python" Testing/GUI/CortexFile.py "$scratch/patient/cortex.ply"

play() {
  mkdir "$scratch/$1"
  # Where the session asks for a picture, ParaView saves its state, which tells this script to take one, and waits.
  local sign='  <pqevent object="pqClientMainWindow/menubar/menu_File" command="activate" arguments="actionFileSaveServerState" />\n'
  sign+='  <pqevent object="pqClientMainWindow/FileSaveServerStateDialog" command="filesSelected" arguments="SCRATCH/\1.pvsm" />'
  local wait='  <pqevent object="pqClientMainWindow" command="pause" arguments="6000" />'
  sed -E -e "s|^ *<!-- picture (\w+) -->|$sign\n$wait|" \
    -e "s|^ *<!-- picture (\w+) follows -->|$sign|" \
    -e "s|^ *<!-- it is here -->|$wait|" \
    -e "/arguments=\"Check /d" \
    -e "s|SCRATCH|$scratch|" "Testing/GUI/$1.xml" >"$scratch/session.xml"

  HOME=$scratch/$1 LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb \
    xvfb-run -a -s "-screen 0 1280x900x24 -noreset -fbdir $scratch/screen" \
    paraview --plugin-search-paths="${plugin%/*}" --plugins=SurfaceFlattening --data-directory="$PWD/Data" \
    --test-script="$scratch/session.xml" --test-directory="$scratch" --dr --exit &
  local paraview=$!
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
}

for session in "${sessions[@]}"; do
  play "$session"
done
pvpython Utilities/screenshots/tutorial_pictures.py "$output" "$scratch"/*.xwd
