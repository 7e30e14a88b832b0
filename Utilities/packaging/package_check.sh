#!/usr/bin/env bash
# Checks whether ParaView's programs find the plugin by themselves.
#   Utilities/packaging/package_check.sh installed    they do: it loads by itself in pvpython, pvbatch, pvserver and ParaView's
#                                           window, has the version of cmake/SurfaceFlatteningVersion.cmake, and flattens
#   Utilities/packaging/package_check.sh removed      they do not, and no file is left
set -euo pipefail
expected=$1
version=$(sed -n 's/^set(SURFACEFLATTENING_VERSION \(.*\))$/\1/p' "$(dirname "$0")/../../cmake/SurfaceFlatteningVersion.cmake")
unset PV_PLUGIN_PATH PYTHONPATH
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
export UCX_LOG_LEVEL=fatal # where there is no /sys the library of Open MPI says so among what a program prints
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" # Python looks here first

fail() {
  echo "package_check.sh: $*" >&2
  exit 1
}

cat >check.py <<'EOF'
from paraview import servermanager, simple

plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
for i in range(plugins.GetNumberOfPlugins()):
    if plugins.GetPluginName(i) == "SurfaceFlattening":
        print("plugin", plugins.GetPluginVersion(i), "loaded" if plugins.GetPluginLoaded(i) else "known")
if hasattr(simple, "SurfaceToDisk"):
    ball = simple.Sphere(ThetaResolution=40, PhiResolution=40)
    disk = simple.SurfaceToDisk(Input=ball, HoleAreaFraction=0.02)
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk))
    flat.UpdatePipeline()
    print("flat", flat.GetDataInformation().GetNumberOfCells() > 1000, flat.FieldData["FlippedFaces"].GetRange()[0])
EOF
for program in pvpython pvbatch; do
  found=$("$program" check.py | tr '\n' ' ')
  echo "$program: $found"
  if [ "$expected" = installed ]; then
    [ "$found" = "plugin $version loaded flat True 0.0 " ] || fail "$program does not have the plugin"
  else
    [ -z "$found" ] || fail "$program still has the plugin"
  fi
done

# The client loads nothing that the server lacks: without the plugin on the server it could make no proxy.
cat >client.py <<'EOF'
import sys
from paraview import simple

simple.Connect("localhost", int(sys.argv[1]))
simple._add_functions(vars(simple))
print("server", hasattr(simple, "SurfaceToDisk"))
if hasattr(simple, "SurfaceToDisk"):
    disk = simple.SurfaceToDisk(Input=simple.Sphere(), HoleAreaFraction=0.02)
    disk.UpdatePipeline()
    print(disk.GetDataInformation().GetNumberOfCells() > 0)
EOF
port=$((20000 + RANDOM % 20000))
pvserver --server-port=$port >server.log 2>&1 &
server=$!
for _ in $(seq 100); do
  grep -q "Accepting connection" server.log && break
  sleep 0.2
done
found=$(timeout 60 pvpython client.py $port | tr '\n' ' ')
kill $server 2>/dev/null || true
wait $server 2>/dev/null || true
echo "pvserver: $found"
if [ "$expected" = installed ]; then
  [ "$found" = "server True True " ] || fail "pvserver does not have the plugin"
else
  [ "$found" = "server False " ] || fail "pvserver still has the plugin"
fi

cat >window.py <<'EOF'
from paraview import simple

with open("window.txt", "w") as stream:
    stream.write(f"window {hasattr(simple, 'SurfaceToDisk')}\n")
EOF
timeout 120 xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" paraview --script="$scratch/window.py" >window.log 2>&1 &
window=$!
for _ in $(seq 300); do
  [ -s window.txt ] && break
  sleep 0.3
done
found=$(cat window.txt 2>/dev/null || true)
kill $window 2>/dev/null || true
wait $window 2>/dev/null || true
echo "paraview: $found"
[ "$found" = "window $([ "$expected" = installed ] && echo True || echo False)" ] || fail "ParaView's window: '$found'"

found=$(/usr/bin/python3 -c 'import surfaceflattening; print(surfaceflattening.vtkConformalDiskFilter().GetClassName())' 2>/dev/null || true)
echo "python3: $found"
if [ "$expected" = installed ]; then
  [ "$found" = vtkConformalDiskFilter ] || fail "python3 does not have the package surfaceflattening"
else
  [ -z "$found" ] || fail "python3 still has the package surfaceflattening"
  left=$(find /usr -iname '*surfaceflattening*' -not -path '/usr/src/*' 2>/dev/null || true)
  left+=$(find /usr/bin/paraview.conf /usr/lib/*/paraview-*/paraview.conf.distrib 2>/dev/null || true)
  left+=$(grep -ls surfaceflattening /usr/lib/*/paraview-*/paraview.conf || true)
  [ -z "$left" ] || fail "left behind: $left"
fi
