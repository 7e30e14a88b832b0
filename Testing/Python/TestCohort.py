# SPDX-License-Identifier: GPL-3.0-or-later
"""Utilities/cohort/cohort.py on one rank and on two: the same results, a bad file listed, a killed run taken up again;
Utilities/cohort/gathered_surface.py: a surface in pieces over two ranks flattened as in one."""

import csv
import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPTS = os.path.join(HERE, "..", "..", "Utilities", "cohort")
sys.path.insert(0, HERE)
sys.path.insert(0, SCRIPTS)

import case_files
import case_pipeline
from case_list import Case, CaseNameError, in_order, named_cases
from VolumeFiles import write_nifti

PVBATCH = os.environ.get("PVBATCH") or shutil.which("pvbatch")
MPIEXEC = os.environ.get("MPIEXEC") or shutil.which("mpiexec")
assert PVBATCH and MPIEXEC, "no pvbatch or mpiexec"
# pvpython is a rank of its own MPI run, which its children are not to join.
USERS = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe")
ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name in USERS or not name.startswith(("OMPI_", "PMIX_"))
}
folder = tempfile.mkdtemp(dir=os.environ.get("TEMPORARY_DIRECTORY"))


def command(ranks, script, *arguments, symmetric=()):
    # One core per rank where there are as many: one thread each.
    binding = ["--bind-to", "core" if ranks <= os.cpu_count() else "none"]
    return [MPIEXEC, "-n", str(ranks), *binding, PVBATCH, *symmetric, os.path.join(SCRIPTS, script), *arguments]


def cohort(ranks, output, files, *options):
    return command(ranks, "cohort.py", "--output", output, *options, *files, symmetric=["--symmetric"])


def run(arguments):
    done = subprocess.run(
        arguments,
        env=ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=500,
    )
    return done.returncode, done.stdout


def summary(output):
    with open(os.path.join(output, "summary.csv"), encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def results(output):
    found = {}
    for path in glob.glob(os.path.join(output, "results", "*")):
        with open(path, "rb") as stream:
            found[os.path.basename(path)] = stream.read()
    return found


# --- Names and order -------------------------------------------------------------------------------------------
assert [c.name for c in named_cases(["/a/x.nii.gz", "/a/y.vtk"])] == ["x", "y"]
assert [c.name for c in named_cases(["/a/1/x.vtk", "/a/2/x.vtk", "/a/1/x.vtk"])] == ["1__x", "2__x"]
try:
    named_cases(["/a/x.vtk", "/a/x.ply"])
    raise AssertionError("two cases of one name")
except CaseNameError as error:
    assert "rename one" in str(error)
# Names that are too long for a file are shortened, not in the middle of a letter, and stay apart.
long, other = (named_cases([f"/a/{'ä' * 120}{end}.vtk"])[0].name for end in "xy")
assert long.startswith("ä" * 91 + "-") and len(os.fsencode(long)) <= 200 and long != other, long
assert long == named_cases([f"/a/{'ä' * 120}x.vtk"])[0].name
assert named_cases([f"/a/{'x' * 200}.vtk"])[0].name == "x" * 200


class Sized(Case):
    def size(self):
        return int(self.name)


sized = [Sized(str(size), "") for size in (1, 9, 4)]
assert [case.name for case in in_order(sized)] == ["9", "4", "1"]
interruptions = {"9": 2, "4": 1, "1": 1}
assert [case.name for case in in_order(sized, lambda case: interruptions[case.name])] == ["4", "1", "9"]

# --- Eight surfaces, one of them cut off in the middle of the file ------------------------------------------------
files = []
for k in range(8):
    source = vtkSphereSource()
    source.SetRadius(10 + k)
    source.SetEndPhi(90 + 10 * k)
    source.SetThetaResolution(40 + 6 * k)
    source.SetPhiResolution(40)
    source.Update()
    files.append(os.path.join(folder, f"cap{k}.vtk"))
    writer = vtkPolyDataWriter()
    writer.SetInputData(source.GetOutput())
    writer.SetFileTypeToBinary()
    writer.SetFileName(files[-1])
    writer.Write()
os.truncate(files[3], os.path.getsize(files[3]) // 2)

serial = os.path.join(folder, "serial")
status, text = run(cohort(1, serial, files))
assert status == 1, text  # a case failed
assert "7 finished, 1 failed" in text, text
assert "failed: cap3: cannot be read, the file may be damaged" in text, text
expected = results(serial)
assert sorted(expected) == [f"cap{k}.vtp" for k in range(8) if k != 3]
rows = summary(serial)
assert [row["Status"] for row in rows] == ["finished"] * 3 + ["failed"] + ["finished"] * 4
assert all(float(row["FacesWithin2Percent"] or 100) > 99 for row in rows)
assert all(float(row["FlippedFaces"] or 0) == 0 for row in rows)
flat = case_files.read(os.path.join(serial, "results", "cap0.vtp"), [])
assert flat.GetNumberOfCells() == int(rows[0]["Faces"])

two = os.path.join(folder, "two")
status, text = run(cohort(2, two, files))
assert status == 1, text
taken = re.findall(r"^\[rank ([01])\] \d/8 (cap\d): ", text, re.MULTILINE)
assert sorted(name for _rank, name in taken) == [f"cap{k}" for k in range(8)], text
assert {rank for rank, _name in taken} == {"0", "1"}, text
assert results(two) == expected
assert summary(two) == rows

# --- Killed in the middle, and started again ------------------------------------------------------------------------
killed = os.path.join(folder, "killed")
process = subprocess.Popen(
    cohort(2, killed, files),
    env=ENVIRONMENT,
    stdout=subprocess.DEVNULL,
    stderr=subprocess.DEVNULL,
)
victim = None
deadline = time.monotonic() + 300
while victim is None:
    assert process.poll() is None and time.monotonic() < deadline, "the run ended before it was killed"
    if len(glob.glob(os.path.join(killed, "cases", "*.json"))) >= 2:
        for path in glob.glob(os.path.join(killed, "cases", "*.started")):
            try:
                with open(path, encoding="utf-8") as stream:
                    victim = int(stream.read().split()[1])
                    break
            except (OSError, IndexError):
                pass  # just finished, or just begun
    time.sleep(0.005)
os.kill(victim, signal.SIGKILL)  # as a machine without memory would; mpiexec ends the other rank
assert process.wait(timeout=100) != 0
assert not os.path.exists(os.path.join(killed, "summary.csv"))
before = {name: os.stat(os.path.join(killed, "results", name)).st_mtime_ns for name in results(killed)}
finished = [
    name
    for name in before
    if name.endswith(".vtp")
    and os.path.exists(os.path.join(killed, "cases", name.replace(".vtp", ".json")))
]
assert 1 <= len(finished) < 7, finished

status, text = run(cohort(2, killed, files))
assert status == 1, text
assert f"8 cases, {len(finished)} finished before" in text, text
assert results(killed) == expected
assert summary(killed) == rows
for name in finished:
    assert os.stat(os.path.join(killed, "results", name)).st_mtime_ns == before[name], name
assert not glob.glob(os.path.join(killed, "cases", "*.started"))

# Other settings, or another file: done again, and only then.
status, text = run(cohort(1, killed, files[:3], "--remesh"))
assert status == 0 and "3 cases, 0 finished before" in text, text
os.utime(files[1])
status, text = run(cohort(1, killed, files[:3], "--remesh"))
assert status == 0 and "3 cases, 2 finished before" in text, text

# --- Volumes: the same isosurface as by the plugin's recipe, and half of it -------------------------------------------
grid = numpy.indices((30, 40, 40)) - numpy.array([15, 20, 20]).reshape(3, 1, 1, 1)
distance = numpy.sqrt(((grid * numpy.array([1.5, 1, 1]).reshape(3, 1, 1, 1)) ** 2).sum(axis=0))
scan = os.path.join(folder, "ball.nii")
write_nifti(scan, (1000 - 50 * distance).astype(numpy.int16), (1.0, 1.0, 1.5))
image = case_files.read(scan, [])
surface = case_pipeline.isosurface(image, 400.0, 1.0)
from surfaceflattening_volume import isosurface

recipe = isosurface(simple.OpenDataFile(scan), 400, smoothing_mm=1.0).surface
reference = recipe.GetClientSideObject().GetOutputDataObject(0)
assert surface.GetNumberOfPoints() == reference.GetNumberOfPoints() > 1000
assert numpy.array_equal(
    vtk_to_numpy(surface.GetPoints().GetData()), vtk_to_numpy(reference.GetPoints().GetData())
)
volumes = os.path.join(folder, "volumes")
status, text = run(
    cohort(2, volumes, [scan, files[0]], "--isovalue", "400", "--cut", "plane", "--plane-normal", "0", "0", "1")
)
assert status == 0, text
rows = {row["Case"]: row for row in summary(volumes)}
half = 2 * numpy.pi * 12**2
assert abs(float(rows["ball"]["SurfaceArea"]) / half - 1) < 0.02, rows["ball"]
status, text = run(cohort(1, volumes, [scan], "--isovalue", "4000"))
assert status == 1 and "the isovalue 4000 is not between the least and greatest value" in text, text
status, text = run(cohort(1, volumes, [scan]))
assert status == 1 and "it is a volume: give --isovalue" in text, text

# --- A surface in pieces over two ranks ---------------------------------------------------------------------------------
status, alone = run(command(1, "gathered_surface.py"))
assert status == 0 and "SurfaceArea" in alone, alone
status, text = run(command(2, "gathered_surface.py"))
assert status == 0 and "ERR" not in text, text  # nor does the empty rank complain


def figures(text):
    return {words[0]: float(words[1]) for words in map(str.split, text.splitlines()) if len(words) == 2}


one, gathered = figures(alone), figures(text)
assert gathered["FlippedFaces"] == 0
for name in ("SurfaceArea", "FlatArea"):
    assert abs(gathered[name] / one[name] - 1) < 1e-3, (one, gathered)
