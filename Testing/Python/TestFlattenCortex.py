# SPDX-License-Identifier: GPL-3.0-or-later
"""A cortex in one go: the medial wall goes, areas per region agree with sums over the file's triangles, and the patch
has the map's points at the file's vertices."""

import csv
import os
import struct
import tempfile

import numpy as np
from nibabel.freesurfer import io as freesurfer
from paraview import servermanager, simple
from surfaceflattening_cortex import flatten_cortex, flatten_cortex_and_show, wall_labels
from surfaceflattening_neuro import read_cortex
from surfaceflattening_neuro_writers import write_cortex
from surfaceflattening_region_table import read_names, region_table
from vtkmodules.util.numpy_support import vtk_to_numpy

NAMES = ["unknown", "back", "front", "top"]
TABLE = np.array([[25, 5, 25, 0, 0], [60, 20, 220, 0, 0], [255, 192, 32, 0, 0], [0, 99, 7, 0, 0]])


def hemisphere(folder, resolution=140):
    """A folded ellipsoid in front of whose middle there is the medial wall. Returns points, faces and labels."""
    data = servermanager.Fetch(simple.Sphere(Radius=1, ThetaResolution=resolution, PhiResolution=resolution))
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(np.float32)
    faces = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points *= (1 + 0.08 * np.sin(9 * points[:, :1]) * np.cos(8 * points[:, 1:2] + 1)).astype(np.float32)
    points *= np.array([30, 60, 40], np.float32)
    points[:, 0] -= 32
    labels = np.where(points[:, 1] < 0, 1, np.where(points[:, 2] > 15, 3, 2))
    wall = (points[:, 0] > -8) & (np.hypot(points[:, 1], points[:, 2]) < 25)
    labels[wall] = np.where(points[wall, 2] > 0, 0, -1)
    os.makedirs(folder, exist_ok=True)
    freesurfer.write_geometry(os.path.join(folder, "lh.pial"), points, faces)
    freesurfer.write_annot(os.path.join(folder, "lh.test.parts.annot"), labels, TABLE, NAMES, fill_ctab=True)
    freesurfer.write_morph_data(os.path.join(folder, "lh.curv"), points[:, 2] / 100)
    return points, faces, labels


def areas_of(points, faces):
    a, b, c = (points[faces[:, k]].astype(float) for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def read_patch(path):
    with open(path, "rb") as stream:
        content = stream.read()
    version, count = struct.unpack(">2i", content[:8])
    assert version == -1 and len(content) == 8 + 16 * count
    rows = [struct.unpack(">i3f", content[8 + 16 * k : 24 + 16 * k]) for k in range(count)]
    return {abs(row[0]) - 1: (row[0] < 0, np.array(row[1:], np.float32)) for row in rows}


def read_rows(path):
    with open(path, encoding="utf-8-sig", newline="") as stream:
        return list(csv.DictReader(stream))


def message(function, *arguments, **settings):
    try:
        function(*arguments, **settings)
    except ValueError as error:
        return str(error)
    raise AssertionError(f"{function.__name__}: no error")


with tempfile.TemporaryDirectory() as scratch:
    surface = os.path.join(scratch, "lh.pial")
    annotation = os.path.join(scratch, "lh.test.parts.annot")
    points, faces, labels = hemisphere(scratch)
    result = flatten_cortex(
        surface, annotation, curvature=os.path.join(scratch, "lh.curv"), folder=os.path.join(scratch, "flat")
    )
    assert wall_labels(result.surface, "test.parts") == [-1, 0]
    cortex = faces[(labels[faces] > 0).all(axis=1)]
    assert servermanager.Fetch(result.cortex).GetNumberOfCells() == len(cortex)

    # Areas per region: sums over the triangles of the file, by the label that two of the corners have.
    a, b, c = labels[cortex].T
    majority = np.where(b == c, b, a)
    areas = areas_of(points, cortex)
    rows = {row["Name"]: row for row in read_rows(result.csv)}
    assert set(rows) == {"back", "front", "top", "Total"}, rows.keys()
    for label, name in ((1, "back"), (2, "front"), (3, "top")):
        row = rows[name]
        expected = areas[majority == label].sum()
        assert row["Hemisphere"] == "left" and int(row["Label"]) == label
        # Surface To Disk moves points where it opens small angles beside the cuts.
        assert abs(float(row["SurfaceArea"]) / expected - 1) < 1e-3, (row, expected)
        assert abs(float(row["FlatAreaErrorPercent"])) < 0.5, row
        corners = points[np.unique(cortex[majority == label])]
        extents = [float(row[f"Extent{axis}"]) for axis in "XYZ"]
        assert np.allclose(extents, np.ptp(corners, axis=0), atol=0.5), (row, np.ptp(corners, axis=0))
    heights = points[cortex, 2].mean(axis=1) / 100
    expected = (areas * heights)[majority == 3].sum() / areas[majority == 3].sum()
    assert abs(float(rows["top"]["MeanCurvature"]) - expected) < 2e-3, (rows["top"], expected)
    # The same table in the pipeline, and the one of Distortion Metrics.
    table = servermanager.Fetch(result.table)
    assert table.GetNumberOfRows() == 4 and table.GetValueByName(0, "Name").ToString() == "back"
    summary = servermanager.Fetch(result.measured, idx=1)
    by_name = {summary.GetValueByName(k, "Region").ToString(): k for k in range(summary.GetNumberOfRows())}
    for name in ("back", "front", "top"):
        for column in ("SurfaceArea", "FlatArea"):
            found = summary.GetValueByName(by_name[name], column).ToDouble()
            assert abs(found / float(rows[name][column]) - 1) < 1e-9, (name, column)

    # The patch: each vertex once, where the map has it; cuts and the medial wall are left out.
    patch = read_patch(result.patch)
    flat = servermanager.Fetch(result.measured)
    numbers = vtk_to_numpy(flat.GetPointData().GetArray("VertexNumber"))
    original = vtk_to_numpy(flat.GetPointData().GetArray("vtkOriginalPointIds"))
    in_space = vtk_to_numpy(flat.GetPointData().GetArray("SurfacePoints"))
    on_map = vtk_to_numpy(flat.GetPoints().GetData()).astype(np.float32)
    checked = 0
    for k, number in enumerate(numbers):
        if original[k] >= 0 and number in patch:
            assert np.array_equal(patch[number][1], on_map[k]) and np.allclose(in_space[k], points[number], atol=1e-4)
            checked += 1
    assert checked == len(patch) > 0.9 * (labels > 0).sum(), (checked, len(patch))
    assert all(labels[number] > 0 for number in patch)
    assert 0 < sum(border for border, _position in patch.values()) < 0.3 * len(patch)

    # Without an annotation, the whole surface.
    whole = flatten_cortex(surface)
    assert servermanager.Fetch(whole.measured).GetNumberOfCells() >= len(faces) - 10 and whole.table is None
    assert "no such file" in message(flatten_cortex, surface, os.path.join(scratch, "none.annot"))
    assert "there is no region nowhere" in message(flatten_cortex, surface, annotation, medial_wall="nowhere")
    assert "no regions" in message(flatten_cortex_and_show, simple.Sphere())

    # GIFTI by names of the HCP: the arrays have names of their own, and the files of each hemisphere others.
    small, gifti = os.path.join(scratch, "small"), os.path.join(scratch, "gifti")
    os.makedirs(gifti)
    hemisphere(small, 40)
    overlays = [os.path.join(small, name) for name in ("lh.test.parts.annot", "lh.curv")]
    data = read_cortex(os.path.join(small, "lh.pial"), overlays)
    files = [os.path.join(gifti, f"100307.R.{end}") for end in ("pial.surf.gii", "aparc.label.gii", "bend.shape.gii")]
    for path, array in zip(files, (None, "test.parts", "curv")):
        write_cortex(path, data, array)
    right = flatten_cortex(*files, folder=os.path.join(gifti, "flat"))
    assert sorted(os.listdir(os.path.join(gifti, "flat"))) == ["100307.R.flat.patch.3d", "100307.R.regions.csv"]
    assert [row["Name"] for row in read_rows(right.csv)] == ["back", "front", "top", "Total"]
    assert {row["Hemisphere"] for row in read_rows(right.csv)} == {"right"}
    assert (right.regions, right.curvature) == ("test.parts", "curv")
    assert "no point array none" in message(flatten_cortex, right.surface, "none")

    # The command, with an annotation that is opened, and a folder that cannot be written: the map is shown.
    os.makedirs(os.path.join(small, "surf"))
    os.makedirs(os.path.join(small, "label"))
    os.rename(os.path.join(small, "lh.pial"), os.path.join(small, "surf", "lh.pial"))
    opened = os.path.join(small, "label", "lh.test.parts.annot")
    os.rename(overlays[0], opened)
    reader = simple.CortexReader(FileName=opened)
    with open(os.path.join(small, "surf", "flat"), "w"):  # even root makes no folder in place of a file
        pass
    views = len(simple.GetViews())
    try:
        flatten_cortex_and_show(reader)
        raise AssertionError("a folder was made in place of a file")
    except OSError as error:
        assert f"the folder {os.path.join(small, 'surf', 'flat')} cannot be written (File exists)" in str(error), error
        assert "File > Save Data" in str(error), error
    assert len(simple.GetViews()) == views + 3 and os.listdir(os.path.join(small, "label")) == ["lh.test.parts.annot"]

    # A surface with both hemispheres has a row for each of them.
    ball = simple.Sphere(Radius=20, ThetaResolution=40, PhiResolution=40)
    data = servermanager.Fetch(simple.Calculator(Input=ball, ResultArrayName="Part", Function="if(coordsZ>0,1,2)"))
    from surfaceflattening_scans import place

    place(data, np.diag([1.0, 1, 1, 1]), "test")
    rows = region_table(data, "Part", names={1: "top", 2: "bottom"})
    assert [(row["Name"], row["Hemisphere"]) for row in rows] == [
        ("top", "left"), ("top", "right"), ("bottom", "left"), ("bottom", "right"), ("Total", "left"), ("Total", "right")
    ]
    quarter = np.pi * 20**2
    assert all(abs(row["SurfaceArea"] / quarter - 1) < 0.06 for row in rows[:4]), rows
    assert all(abs(row["MeanCurvature"] * 20 - 1) < 0.05 for row in rows), rows
    names = os.path.join(scratch, "names.txt")
    with open(names, "w") as stream:
        stream.write("1 Precentral_L 2001\n2 Precentral_R 2002\n")
    assert read_names(names) == {1: "Precentral_L", 2: "Precentral_R"}
    with open(names, "w", encoding="utf-8-sig") as stream:  # with the mark that some editors put before the first line
        stream.write("17 Superior frontal gyrus\n18 Left-Thalamus  0 118 14 0\n")
        stream.write("44 Area 44\n45\tArea 45\n-1 7\n# 3 none\n")
    expected = {17: "Superior frontal gyrus", 18: "Left-Thalamus", 44: "Area 44", 45: "Area 45", -1: "7"}
    assert read_names(names) == expected, read_names(names)
    print("Flatten Cortex: passed")
