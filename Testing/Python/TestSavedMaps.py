# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps that are saved can be read again, with all defaults and by Save Flat Map, and its tables are CSV."""

import csv
import math
import os
import tempfile

from paraview import simple
from surfaceflattening_files import save_flat_map

folder = tempfile.mkdtemp(dir=os.environ.get("TEMPORARY_DIRECTORY"))
sphere = simple.Sphere(ThetaResolution=32, PhiResolution=16, EndPhi=90.0)
disk = simple.SurfaceToDisk(Input=sphere)
flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk))
measured = simple.DistortionMetrics(Input=flat)


def same(path):
    read = simple.OpenDataFile(path)
    read.UpdatePipeline()
    theirs, ours = read.GetDataInformation(), measured.GetDataInformation()
    assert theirs.GetNumberOfCells() == ours.GetNumberOfCells() > 0, theirs.GetNumberOfCells()
    assert read.PointData.keys() == measured.PointData.keys(), read.PointData.keys()
    assert read.PointData["ScaledCurvature"].GetRange() == measured.PointData["ScaledCurvature"].GetRange()


path = os.path.join(folder, "by_default.vtp")
simple.SaveData(path, proxy=measured)
with open(path, "rb") as stream:
    assert b'format="appended"' not in stream.read()
same(path)

path = os.path.join(folder, "flat.vtp")
paths = save_flat_map(measured, path)
assert paths == [path, os.path.join(folder, "flat_Summary.csv")], paths
same(path)
with open(paths[1], encoding="utf-8") as stream:
    (row,) = csv.DictReader(stream)
total = measured.FieldData["SurfaceArea"].GetRange()[0]
assert math.isclose(float(row["SurfaceArea"]), total, rel_tol=1e-8), row

os.makedirs(os.path.join(folder, "folder.vtp"))
for source, place, error, words in (
    (None, path, ValueError, "no source is selected"),
    (simple.ProgrammableSource(), path, ValueError, "is empty"),
    (measured, os.path.join(folder, "missing", "flat.vtp"), OSError, "cannot be written (No such file or directory)"),
    (measured, os.path.join(folder, "folder.vtp"), OSError, "cannot be written (Is a directory)"),
    (measured, os.path.join(folder, "n" * 300 + ".vtp"), OSError, "cannot be written (File name too long)"),
    (measured, os.path.join(folder, "flat"), ValueError, "flat: the name does not end as a format"),
    (measured, os.path.join(folder, "flat.xyz"), ValueError, "flat.xyz: the name does not end as a format"),
):
    try:
        save_flat_map(source, place)
        raise AssertionError(f"no {error}")
    except error as raised:
        assert words in str(raised), raised

# A file that is replaced, and a format of several files; nothing else is left behind.
assert save_flat_map(measured, path) == paths
same(path)
save_flat_map(measured, os.path.join(folder, "series.pvd"))
expected = ["by_default.vtp", "flat.vtp", "flat_Summary.csv", "folder.vtp"]
expected += ["series", "series.pvd", "series_Summary.csv"]
assert sorted(os.listdir(folder)) == expected, os.listdir(folder)
assert os.listdir(os.path.join(folder, "series")) == ["series_0.vtp"]
assert os.listdir(os.path.join(folder, "folder.vtp")) == []
