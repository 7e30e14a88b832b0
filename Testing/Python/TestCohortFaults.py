# SPDX-License-Identifier: GPL-3.0-or-later
"""Utilities/cohort with files that are cut short or crash, a full disk, two runs in one folder and untrue arguments."""

import contextlib
import csv
import gzip
import io
import os
import resource
import shutil
import signal
import sys
import tempfile
import time

import numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
sys.path.insert(0, os.path.join(HERE, "..", "..", "Utilities", "cohort"))

import case_pipeline
import case_process
import cohort
import VolumeFiles
from case_files import CaseError, extension, read
from case_list import Case
from case_records import CaseRecords, RunError
from child_process import in_child
from run_lock import RunLock
from shown_text import printable

folder = tempfile.mkdtemp(dir=os.environ.get("TEMPORARY_DIRECTORY"))
sphere = vtkSphereSource()
sphere.SetThetaResolution(12)
sphere.SetPhiResolution(12)
sphere.SetEndPhi(100)
sphere.Update()
SETTINGS = {
    "isovalue": None, "smoothing": 1.0, "cut": "hole", "plane_normal": [1, 0, 0], "plane_origin": None,
    "hole_area": 1e-3, "handles": "remove", "remesh": False, "edge_length": 0.0, "free_outline": False,
}
NO_LIMITS = {"seconds": None, "megabytes": None}


def path_of(name):
    return os.path.join(folder, name)


def write_surface(writer, name, kind=None):
    writer.SetInputData(sphere.GetOutput())
    writer.SetFileName(path_of(name))
    if kind:
        getattr(writer, kind)()
    assert writer.Write()
    return path_of(name)


def reading(path):
    """The number of cells, or why the file cannot be read, or that the reader crashed."""

    def work(_announce):
        try:
            return read(path, []).GetNumberOfCells()
        except CaseError as error:
            return str(error)

    ending = in_child(work, seconds=60)
    return f"signal {ending.signal}" if ending.signal else ending.value


# --- A file that is cut short anywhere is refused -----------------------------------------------------------------
grid = numpy.indices((8, 9, 10)).sum(axis=0).astype(numpy.int16)
files = {
    write_surface(vtkPolyDataWriter(), "text.vtk", "SetFileTypeToASCII"): "damaged",
    write_surface(vtkPolyDataWriter(), "binary.vtk", "SetFileTypeToBinary"): "damaged",
    write_surface(vtkXMLPolyDataWriter(), "binary.vtp", "SetDataModeToBinary"): "damaged",
    write_surface(vtkPLYWriter(), "text.ply", "SetFileTypeToASCII"): "cut short",
    write_surface(vtkPLYWriter(), "binary.ply", "SetFileTypeToBinary"): "cut short",
    write_surface(vtkSTLWriter(), "text.stl", "SetFileTypeToASCII"): "damaged",
    write_surface(vtkSTLWriter(), "binary.stl", "SetFileTypeToBinary"): "cut short",
}
for name, write in (
    ("ball.nii", VolumeFiles.write_nifti), ("ball.mha", VolumeFiles.write_metaimage), ("ball.nrrd", VolumeFiles.write_nrrd),
):
    write(path_of(name), grid, (1.0, 1.0, 1.5))
    files[path_of(name)] = "cut short"
with open(path_of("ball.nii"), "rb") as stream, open(path_of("packed.nii.gz"), "wb") as packed:
    packed.write(gzip.compress(stream.read()))
files[path_of("packed.nii.gz")] = "cut short"
for path, word in files.items():
    assert reading(path) > 100, (path, reading(path))
    for share in (1 / 2, 2 / 3, 0.97):
        cut = path_of("cut" + extension(path))
        shutil.copy(path, cut)
        os.truncate(cut, int(share * os.path.getsize(path)))
        assert word in str(reading(cut)), (path, share, reading(cut))
whole = write_surface(vtkOBJWriter(), "surface.obj")
os.truncate(whole, os.path.getsize(whole) - 2)  # within a word of the last line, or after it
warnings = []
read(whole, warnings)
assert len(warnings) == 1 and "does not end with a line break" in warnings[0], warnings
with open(path_of("packed.nii.gz"), "r+b") as stream:
    stream.seek(-7, os.SEEK_END)
    stream.write(b"\1\2\3")  # the checksum
assert "compressed data are damaged" in reading(path_of("packed.nii.gz"))
with open(path_of("binary.vtp"), "rb") as stream, open(path_of("many.vtp"), "wb") as many:
    many.write(stream.read().replace(b'NumberOfComponents="3"', b'NumberOfComponents="4294967295"', 1))
assert "an array has 4,294,967,295 components" in reading(path_of("many.vtp"))
with open(path_of("cut.nrrd"), "wb") as stream, open(path_of("ball.nrrd"), "rb") as source:
    stream.write(source.read().replace(b"type: short", b"\0: short"))  # VTK's reader does not end with such files
assert "header has no end" in reading(path_of("cut.nrrd"))
for dimension in (b"2", b"3", b"inf"):  # VTK's reader takes 2 for that of the voxels, and does not end with infinity
    with open(path_of("space.nrrd"), "wb") as stream, open(path_of("ball.nrrd"), "rb") as source:
        stream.write(source.read().replace(b"space dimension: 3", b"space dimension: " + dimension))
    found = reading(path_of("space.nrrd"))
    assert (found > 100) if dimension == b"3" else ("dimension of the space differs" in str(found)), (dimension, found)
image = read(path_of("ball.mha"), [])
image.SetSpacing(1.0, 0.0, 1.0)
try:
    case_pipeline.isosurface(image, 10.0, 1.0)
    raise AssertionError("voxels without size")
except CaseError as error:
    assert str(error).startswith("a voxel has the size 0 along axis 2: set the Spacing"), error

# --- Whatever ends the process of a case, there is a sentence, and the next case is done --------------------------
case = Case("surface", path_of("binary.vtk"))
records = CaseRecords(path_of("output"), SETTINGS)
records.make_folders()


def ended_by(action, stage=case_process.READING, limits=NO_LIMITS):
    def flatten(_path, _settings, announce):
        announce(stage)
        action()

    genuine, case_process.flatten = case_process.flatten, flatten
    try:
        return case_process.flattened(case, records, SETTINGS, limits)["reason"]
    finally:
        case_process.flatten = genuine


def endless():
    while True:
        pass


def crash():
    os.kill(os.getpid(), signal.SIGSEGV)


assert ended_by(crash) == "the reader crashed (SIGSEGV): the file may be damaged"
assert "Conformal Disk crashed (SIGSEGV), which is a fault of the program" in ended_by(crash, "Conformal Disk")
assert "was killed in the reader" in ended_by(lambda: os.kill(os.getpid(), signal.SIGKILL))
assert "exit status 3" in ended_by(lambda: os._exit(3))
given_up = ended_by(endless, "Conformal Disk", {"seconds": 0.5, "megabytes": None})
assert given_up == "it was given up in Conformal Disk after 0.5 s, as --case-time asks", given_up
assert "not enough memory" in ended_by(lambda: bytearray(10**9), limits={"seconds": None, "megabytes": 50})
case_process.READING_SECONDS = 0
assert "did not end within 0 s of processor time" in ended_by(endless)
case_process.READING_SECONDS = 600
pid = in_child(lambda announce: os.getpid()).value
assert pid != os.getpid() and not os.path.exists(f"/proc/{pid}")

# --- A disk that is full while the result or the row is written ---------------------------------------------------
assert records.take(case)


def trouble(size, action):
    """What a RunError says if files cannot be larger than so many bytes."""

    def work(_announce):
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        try:
            action()
        except RunError as error:
            return str(error)
        return "no trouble"

    return in_child(work).value


text = trouble(100, lambda: records.write_result(case, sphere.GetOutput()))
assert text.startswith("cannot write") and text.endswith("surface.vtp: File too large"), text
assert "surface.json: File too large" in trouble(100, lambda: records.fail(case, "none"))
assert os.listdir(path_of("output/results")) == [] and os.listdir(path_of("output/cases")) == ["surface.started"]
records.write_result(case, vtkPolyData())
records.finish(case, {"Faces": 0}, {}, [])
assert records.is_finished(case)
os.truncate(records.result_path(case), 10)
assert not records.is_finished(case)

# --- Two runs in one folder, and how often a case was interrupted --------------------------------------------------
assert not records.take(case)
records.release(case)
for times in (1, 2):
    assert records.take(case)
    records.release(case)  # as the next run does if this one is killed now
    assert records.interruptions(case) == times
one, two = RunLock(path_of("output")), RunLock(path_of("output"))
one.take_alone()
one.share()
RunLock(path_of("output")).share()
began = time.monotonic()
import run_lock

run_lock.PATIENCE = 0.2
try:
    two.take_alone()
    raise AssertionError("two runs in one folder")
except RunError as error:
    assert "another run is at work" in str(error) and time.monotonic() - began < 5

# --- Sentences instead of Python's stack --------------------------------------------------------------------------
with open(path_of("file"), "w", encoding="utf-8"):
    pass


def answer(*arguments):
    """The exit status and what is said."""
    said = io.StringIO()
    genuine, sys.argv = sys.argv, ["cohort.py", *arguments]
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            cohort.main()
    except SystemExit as end:
        return end.code, said.getvalue()
    finally:
        sys.argv = genuine
    return 0, said.getvalue()


status, text = answer("--output", path_of("other"), "/a/x.vtk", "/a/x.ply")
assert status == 2 and "error: two files would both be the case x" in text, text
status, text = answer("--output", path_of("file"), path_of("binary.vtk"))
assert status == 2 and "error: cannot make the folder" in text and "Not a directory" in text, text
status, text = answer("--output", path_of("other"), "--list", path_of("none"))
assert status == 2 and "No such file or directory" in text, text
with open(path_of("utf16"), "w", encoding="utf-16") as stream:
    stream.write("x.vtk\n")
status, text = answer("--output", path_of("other"), "--list", path_of("utf16"))
assert status == 2 and "save it in UTF-8" in text, text
for option in ("isovalue", "smoothing", "hole-area", "edge-length", "case-memory", "case-time"):
    for value in ("nan", "inf", "1e999", "two"):
        status, text = answer("--output", path_of("other"), f"--{option}", value, "x.vtk")
        words = f"--{option}: '{value}' is not allowed: give a finite number"
        assert status == 2 and words in text, (option, value, text)
for option in ("plane-normal", "plane-origin"):
    status, text = answer("--output", path_of("other"), f"--{option}", "0", "nan", "1", "--", "x.vtk")
    assert status == 2 and f"--{option}: 'nan' is not allowed" in text, text
for option in ("case-memory", "case-time"):
    for value in ("0", "-1", "1e19"):
        status, text = answer("--output", path_of("other"), f"--{option}", value, "x.vtk")
        words = f"--{option}: '{value}' is not allowed: give a number more than 0 and at most 1e+09"
        assert status == 2 and words in text, (option, value, text)
for value in ("7", "0", "-1e-3"):
    status, text = answer("--output", path_of("other"), "--hole-area", value, "x.vtk")
    words = f"--hole-area: '{value}' is not allowed: give a share of the area from 1e-06 to 0.5"
    assert status == 2 and words in text, (value, text)
# Numbers with a sign and an exponent, and a list with the mark that some editors put before the first name.
with open(path_of("marked"), "w", encoding="utf-8-sig") as stream:
    stream.write(path_of("binary.vtk") + "\n")
numbers = ("--isovalue", "-4e2", "--plane-origin", "-.1e1", "-2E+0", "-3.5", "--plane-normal", "1", "-1e-3", "0")
status, text = answer("--output", path_of("marked output"), "--list", path_of("marked"), *numbers)
assert status == 0 and "1 finished, 0 failed" in text, text
status, text = answer("--output", path_of("other"), path_of("binary.vtk"), path_of("cut.ply"))
assert status == 1 and "1 finished, 1 failed" in text and "failed: cut: the file is cut short" in text, text

# --- The voxels beside a header are changed: the case is done again -----------------------------------------------


def split(name, text, voxels):
    """Writes a volume with its header and its voxels in two files; returns that of the header."""
    with open(path_of(name), "w", encoding="ascii") as stream:
        stream.write(text)
    with open(path_of("voxels.raw"), "wb") as stream:
        stream.write(voxels.astype("<i2").tobytes())
    return path_of(name)


METAIMAGE = "NDims = 3\nDimSize = 20 20 20\nElementType = MET_SHORT\nElementDataFile = voxels.raw\n"
NRRD = "NRRD0004\ntype: short\ndimension: 3\nsizes: 20 20 20\nendian: little\nencoding: raw\ndata file: voxels.raw\n\n"
away = numpy.indices((20, 20, 20)) - 9.5
distance = numpy.sqrt((away**2).sum(axis=0))
for name, text in (("split.mhd", METAIMAGE), ("split.nhdr", NRRD)):
    header = split(name, text, 100 - 10 * distance)
    assert Case("split", header).size() == os.path.getsize(header) + 2 * 20**3
    arguments = ("--output", path_of(f"output of {name}"), "--isovalue", "50", header)
    areas = []
    for radius in (5, 7):
        split(name, text, 50 + 10 * (radius - distance))
        os.utime(header, ns=(0, 0))
        status, text_of_run = answer(*arguments)
        assert status == 0 and "1 cases, 0 finished before" in text_of_run, text_of_run
        with open(path_of(f"output of {name}/summary.csv"), encoding="utf-8", newline="") as stream:
            areas += [float(row["SurfaceArea"]) for row in csv.DictReader(stream)]
    assert 1.5 < areas[1] / areas[0] < 2.5, areas  # (7 / 5)^2
    status, text_of_run = answer(*arguments)
    assert status == 0 and "1 finished before" in text_of_run, text_of_run

# --- A long name --------------------------------------------------------------------------------------------------
long = path_of("n" * 250 + ".vtk")
shutil.copy(path_of("binary.vtk"), long)
for before in (0, 2):
    status, text = answer("--output", path_of("long"), long, path_of("binary.vtk"))
    assert status == 0 and f"2 cases, {before} finished before" in text, text

# --- Names that are not UTF-8 -------------------------------------------------------------------------------------
ODD = os.fsdecode(b"b\xff\xe4")
names = [path_of(name) for name in (f"{ODD}.vtk", f"{ODD}_ball.nii", f"{ODD}_damaged.vtk", f"{ODD}_cut.nii", f"{ODD}_gone.ply")]
for source, name in zip(("binary.vtk", "ball.nii", "utf16", "utf16"), names):
    shutil.copy(path_of(source), name)
with open(path_of("names"), "wb") as stream:
    stream.write(os.fsencode("\n".join(names)))
arguments = ("--output", path_of(f"output {ODD}"), "--isovalue", "12", "--list", path_of("names"))
status, text = answer(*arguments)
assert status == 1 and "2 finished, 3 failed" in text and r"failed: b\udcff\udce4_gone: there is no file" in text, text
assert text.count(": there is no file") == 2, text
with open(path_of(f"output {ODD}/summary.csv"), encoding="utf-8", errors="surrogateescape", newline="") as stream:
    rows = list(csv.DictReader(stream))
assert [os.path.basename(name).rpartition(".")[0] for name in names] == [row["Case"] for row in rows], rows
assert sorted(os.listdir(path_of(f"output {ODD}/results"))) == [f"{ODD}.vtp", f"{ODD}_ball.vtp"]
status, text = answer(*arguments)
assert status == 1 and "5 cases, 2 finished before" in text, text
assert printable("ä 脳 \udcff") == "ä 脳 \\udcff"

# A null character in a message, which pvbatch's standard output does not take.
with open(path_of("null.ply"), "wb") as stream:
    stream.write(b"ply\nformat ascii 1.0\nelement vertex 1\nproperty \0loat x\nend_header\n0\n")
status, text = answer("--output", path_of("output null"), path_of("null.ply"))
assert status == 1 and r"failed: null: the header is damaged: property \x00loat x" in text, text
with open(path_of("output null/summary.csv"), encoding="utf-8", newline="") as stream:
    assert [row["Reason"] for row in csv.DictReader(stream)] == [r"the header is damaged: property \x00loat x"]
