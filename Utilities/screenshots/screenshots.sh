#!/usr/bin/env bash
# Pictures of ParaView's window with the plugin, for docs/pictures: the panels of the four filters, the layout of
# Flatten and Compare with a linked selection, an error message. Needs a build and Debian's packages xvfb, xdotool,
# x11-apps, libqt5svg5 (icons), python3-pil and mricron-data. Takes three minutes.
#   Utilities/screenshots/screenshots.sh [folder of the pictures]
set -euo pipefail
cd "$(dirname "$0")/../.."
pictures=$(realpath "${1:-docs/pictures}")
plugins=$PWD/${BUILD_DIRECTORY:-build}/plugins
here=$PWD/Utilities/screenshots

scratch=$(mktemp -d)
Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp -noreset 3>"$scratch/display" 2>/dev/null &
server=$!
window_process=
trap 'kill $window_process $server 2>/dev/null || true; rm -rf "$scratch"' EXIT
while [ ! -s "$scratch/display" ]; do sleep 0.1; done
DISPLAY=:$(cat "$scratch/display")
export DISPLAY PV_PLUGIN_PATH=$plugins
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb

still_screen() { # waits until the screen has been the same for five seconds
  local before='' now='' same=0
  while [ $same -lt 5 ]; do
    sleep 1
    now=$(xwd -root -silent | md5sum)
    if [ "$now" = "$before" ]; then same=$((same + 1)); else same=0; fi
    before=$now
  done
}

scene() { # scene <name>: its window, and a dump of the screen
  SCENE=$1 SCENE_READY=$scratch/$1.ready paraview --dr --script="$here/scenes.py" >"$scratch/$1.log" 2>&1 &
  window_process=$!
  local window=''
  while [ -z "$window" ]; do
    sleep 0.5
    window=$(xdotool search --onlyvisible --name '^ParaView 5' 2>/dev/null | head -n 1) || true
  done
  xdotool windowmove "$window" 0 0 windowsize "$window" 1600 1000
  while [ ! -e "$scratch/$1.ready" ]; do
    kill -0 "$window_process" || { cat "$scratch/$1.log" >&2; exit 1; }
    sleep 0.5
  done
  still_screen
  if [ "$1" != error_message ]; then # messages, as of dropped components, would cover a part of the picture
    xdotool search --onlyvisible --name '^Output Messages' windowunmap 2>/dev/null || true
    still_screen
  fi
  if [ "$1" != linked_selection ]; then # a wider panel
    xdotool mousemove 296 750 sleep 0.3 mousedown 1 sleep 0.3 mousemove 350 750 sleep 0.3 mousemove 440 750 sleep 0.3 mouseup 1
    still_screen
  fi
  xwd -root -silent >"$scratch/$1.xwd"
  kill "$window_process"
  wait "$window_process" 2>/dev/null || true
  window_process=
}

picture() { # picture <file> <left,top,right,bottom> <scene>...
  local file=$1 box=$2
  shift 2
  (cd "$scratch" && /usr/bin/python3 "$here/grab.py" "$pictures/$file" "$box" "${@/%/.xwd}")
  echo "$pictures/$file"
}

for name in SurfaceToDisk ConformalDisk OMTAreaPreserving DistortionMetrics linked_selection error_message; do
  scene "$name"
done
picture panels.png 0,440,440,960 SurfaceToDisk ConformalDisk OMTAreaPreserving DistortionMetrics
picture flatten_and_compare.png 0,0,1600,1000 linked_selection
picture linked_selection.png 300,200,1600,605 linked_selection
picture error_message.png 0,0,1100,760 error_message
