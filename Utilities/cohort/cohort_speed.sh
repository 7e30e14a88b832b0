#!/usr/bin/env bash
# Times a cohort of eight surfaces, of 53 to 68 thousand vertices, and a ninth one that is cut off in the middle of its
# file, on one rank and on two, one thread each, and compares the results byte by byte. Let nothing else run meanwhile.
#   PYTHONPATH=build/lib/python3/dist-packages Utilities/cohort/cohort_speed.sh
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
PYTHONPATH=$(cd "${PYTHONPATH:?the folder of the package surfaceflattening}" && pwd)
export PYTHONPATH OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
cat >surfaces.py <<'EOF'
import os
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

for k in range(9):
    cap = vtkSphereSource()
    cap.SetEndPhi(100 + 7 * k)
    cap.SetThetaResolution(230 + 8 * k)
    cap.SetPhiResolution(230)
    cap.Update()
    writer = vtkPolyDataWriter()
    writer.SetInputData(cap.GetOutput())
    writer.SetFileTypeToBinary()
    writer.SetFileName(f"cap{k}.vtk")
    writer.Write()
os.truncate("cap3.vtk", os.path.getsize("cap3.vtk") // 2)
EOF
pvpython surfaces.py
for ranks in 1 2; do
  began=$(date +%s.%N)
  mpiexec -n $ranks --bind-to core pvbatch --symmetric "$here/cohort.py" --output flat$ranks cap*.vtk >log$ranks 2>&1 || true
  grep "processor time\|failed" log$ranks
  seconds[ranks]=$(echo "$(date +%s.%N) $began" | awk '{ print $1 - $2 }')
done
for result in flat1/results/*; do
  cmp "$result" "flat2/results/${result##*/}"
done
echo "${seconds[1]} ${seconds[2]}" | awk '{ printf "one rank %.1f s, two ranks %.1f s: %.2f times as long\n", $1, $2, $2 / $1 }'
