# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of FreeSurfer and GIFTI that nibabel wrote come in to the last bit, and those that come out nibabel reads."""

import base64
import os
import resource
import struct
import tempfile
import zlib

import nibabel
import numpy as np
from nibabel.freesurfer import io as freesurfer
from paraview import servermanager, simple
from surfaceflattening_neuro import (
    CortexError,
    add_field,
    add_points_array,
    hemisphere_of,
    hemisphere_stem,
    read_cortex,
)
from surfaceflattening_neuro_writers import write_cortex
from surfaceflattening_region_table import write_csv
from surfaceflattening_scans import place
from vtkmodules.util.numpy_support import vtk_to_numpy

NAMES = ["unknown", "precentral", "insula"]
TABLE = np.array([[25, 5, 25, 0, 0], [60, 20, 220, 0, 0], [255, 192, 32, 0, 0]])
TABLE[:, 4] = TABLE[:, 0] + (TABLE[:, 1] << 8) + (TABLE[:, 2] << 16)
INFORMATION = {
    "head": np.array([2, 0, 20]),
    "valid": "1  # volume info valid",
    "filename": "orig.mgz",
    "volume": np.array([256, 256, 256]),
    "voxelsize": np.array([1.0, 1.0, 1.0]),
    "xras": np.array([-1.0, 0.0, 0.0]),
    "yras": np.array([0.0, 0.0, -1.0]),
    "zras": np.array([0.0, 1.0, 0.0]),
    "cras": np.array([3.5, -17.25, 21.0]),
}


def sphere():
    """Points in single precision and faces of a bumpy sphere in mm."""
    source = simple.Sphere(Radius=40, ThetaResolution=30, PhiResolution=30)
    data = servermanager.Fetch(source)
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(np.float32)
    points *= (1 + 0.1 * np.sin(0.2 * points[:, :1]) * np.cos(0.15 * points[:, 1:2])).astype(np.float32)
    return points, vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int32)


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def faces_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def message(function, *arguments):
    try:
        function(*arguments)
    except CortexError as error:
        return str(error)
    raise AssertionError(f"{function.__name__}{arguments}: no error")


def matrix_of(data):
    return np.reshape(data.GetFieldData().GetArray("PatientMatrix").GetTuple(0), (4, 4))


class Files:
    """What nibabel writes, and the numbers in it."""

    def __init__(self, folder):
        self.folder = folder
        self.points, self.faces = sphere()
        random = np.random.default_rng(7)
        count = len(self.points)
        self.labels = random.integers(-1, 3, count)
        self.curvature = random.normal(size=count).astype(np.float32)
        freesurfer.write_geometry(self.path("lh.pial"), self.points, self.faces, volume_info=INFORMATION)
        freesurfer.write_annot(self.path("lh.aparc.annot"), self.labels, TABLE, NAMES, fill_ctab=True)
        freesurfer.write_morph_data(self.path("lh.curv"), self.curvature)
        self.vertices = np.flatnonzero(self.labels == 1)
        with open(self.path("lh.V1.label"), "w") as stream:
            stream.write(f"#!ascii label\n{len(self.vertices)}\n")
            stream.writelines(f"{v} 0.0 0.0 0.0 0.0\n" for v in self.vertices)

    def path(self, name):
        return os.path.join(self.folder, name)


def check_freesurfer(files):
    path = files.path
    overlays = [path(name) for name in ("lh.curv", "lh.aparc.annot", "lh.V1.label")]
    data = read_cortex(path("lh.pial"), overlays)
    assert np.array_equal(points_of(data), files.points) and np.array_equal(faces_of(data), files.faces)
    assert np.array_equal(array(data, "curv"), files.curvature)
    assert np.array_equal(array(data, "aparc"), files.labels)
    assert np.array_equal(np.flatnonzero(array(data, "V1")), files.vertices)
    names = data.GetFieldData().GetAbstractArray("aparcNames")
    assert [names.GetValue(k) for k in range(3)] == NAMES
    # c_ras is the way from FreeSurfer's space to the scanner's.
    assert np.allclose(matrix_of(data)[:3, 3], INFORMATION["cras"]) and np.allclose(matrix_of(data)[:3, :3], np.eye(3))
    assert not data.GetFieldData().GetArray("InPatientSpace")

    # And back.
    for name, chosen in (("lh.b.pial", None), ("lh.b.curv", "curv"), ("lh.b.annot", "aparc"), ("lh.b.label", "V1")):
        write_cortex(path(name), data, chosen)
    points, faces = freesurfer.read_geometry(path("lh.b.pial"))
    assert np.array_equal(points, files.points) and np.array_equal(faces, files.faces)
    assert np.array_equal(freesurfer.read_morph_data(path("lh.b.curv")), files.curvature)
    labels, table, names = freesurfer.read_annot(path("lh.b.annot"))
    assert np.array_equal(labels, files.labels) and np.array_equal(table, TABLE)
    assert [name.decode() for name in names] == NAMES
    assert np.array_equal(freesurfer.read_label(path("lh.b.label")), files.vertices)
    # An overlay alone finds the surface of its hemisphere.
    alone = read_cortex(path("lh.aparc.annot"))
    assert np.array_equal(points_of(alone), files.points) and np.array_equal(array(alone, "aparc"), files.labels)


ENCODINGS = ("ASCII", "Base64Binary", "GZipBase64Binary", "ExternalFileBinary")


def gifti_array(path, values, intent, encoding, endian="LittleEndian", order="RowMajorOrder"):
    """A DataArray by the description of GIFTI 1.0, which nibabel's own writer covers in part: it writes its machine's
    order of bytes, six digits in ASCII, and no external files. External data have 20 bytes before them."""
    kinds = {"f": ("NIFTI_TYPE_FLOAT32", "f4"), "i": ("NIFTI_TYPE_INT32", "i4")}
    name, kind = kinds[values.dtype.kind]
    values = values if order == "RowMajorOrder" else values.T
    content = np.ascontiguousarray(values, (">" if endian == "BigEndian" else "<") + kind).tobytes()
    external, offset, text = "", "", ""
    if encoding == "ASCII":
        text = " ".join(repr(value.item()) for value in values.ravel())
    elif encoding == "Base64Binary":
        text = base64.b64encode(content).decode()
    elif encoding == "GZipBase64Binary":
        text = base64.b64encode(zlib.compress(content)).decode()
    else:
        external, offset = f"{os.path.basename(path)}.{intent}.bin", "20"
        with open(os.path.join(os.path.dirname(path), external), "wb") as stream:
            stream.write(b"something before it!" + content)
    shape = values.shape if order == "RowMajorOrder" else values.T.shape
    sizes = " ".join(f'Dim{k}="{size}"' for k, size in enumerate(shape))
    return (
        f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="{name}" ArrayIndexingOrder="{order}" '
        f'Dimensionality="{len(shape)}" {sizes} Encoding="{encoding}" Endian="{endian}" '
        f'ExternalFileName="{external}" ExternalFileOffset="{offset}"><Data>{text}</Data></DataArray>'
    )


def write_gifti(path, *arrays):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(f'<?xml version="1.0"?><GIFTI Version="1.0" NumberOfDataArrays="{len(arrays)}">')
        stream.write("".join(arrays) + "</GIFTI>")


def check_gifti_encodings(files):
    """All that the format allows, to the last bit, written by this test and read by this plugin and by nibabel."""
    for encoding in ENCODINGS:
        for endian in ("LittleEndian", "BigEndian"):
            for order in ("RowMajorOrder", "ColumnMajorOrder"):
                settings = (encoding, endian, order)
                path = files.path("lh." + "-".join(settings) + ".surf.gii")
                arrays = (files.points, "POINTSET"), (files.faces, "TRIANGLE")
                write_gifti(path, *(gifti_array(path, values, intent, *settings) for values, intent in arrays))
                data = read_cortex(path)
                assert points_of(data).dtype == np.float32 and np.array_equal(points_of(data), files.points), settings
                assert np.array_equal(faces_of(data), files.faces), settings
                if encoding != "ASCII" and order == "RowMajorOrder":  # which nibabel alone gets right
                    assert np.array_equal(nibabel.load(path).agg_data("pointset"), files.points), settings
            values = files.path(f"lh.{encoding}.{endian}.shape.gii")
            write_gifti(values, gifti_array(values, files.curvature, "SHAPE", encoding, endian))
            data = read_cortex(files.path("lh.pial"), [values])
            assert np.array_equal(array(data, f"{encoding}.{endian}"), files.curvature), (encoding, endian)
    os.remove(files.path("lh.ExternalFileBinary-BigEndian-RowMajorOrder.surf.gii.POINTSET.bin"))
    text = message(read_cortex, files.path("lh.ExternalFileBinary-BigEndian-RowMajorOrder.surf.gii"))
    assert "POINTSET.bin" in text, text


def check_gifti(files):
    path = files.path
    data = read_cortex(path("lh.pial"), [path("lh.curv"), path("lh.aparc.annot")])
    write_cortex(path("lh.y.surf.gii"), data)
    write_cortex(path("lh.y.shape.gii"), data, "curv")
    write_cortex(path("lh.y.label.gii"), data, "aparc")
    surface = nibabel.load(path("lh.y.surf.gii"))
    assert np.array_equal(surface.agg_data("pointset"), files.points)
    assert np.array_equal(surface.agg_data("triangle"), files.faces)
    assert np.array_equal(nibabel.load(path("lh.y.shape.gii")).agg_data(), files.curvature)
    labels = nibabel.load(path("lh.y.label.gii"))
    assert np.array_equal(labels.agg_data(), files.labels)
    assert labels.labeltable.get_labels_as_dict() == dict(enumerate(NAMES))
    again = read_cortex(path("lh.y.surf.gii"), [path("lh.y.shape.gii"), path("lh.y.label.gii")])
    assert np.array_equal(points_of(again), files.points)
    assert np.array_equal(array(again, "curv"), files.curvature)
    assert np.array_equal(array(again, "aparc"), files.labels)


def check_bad_files(files):
    path = files.path
    freesurfer.write_morph_data(path("lh.short.curv"), files.curvature[:-5])
    text = message(read_cortex, path("lh.pial"), [path("lh.short.curv")])
    assert f"{len(files.points) - 5} values, and the surface {len(files.points)}" in text, text
    whole = open(path("lh.pial"), "rb").read()
    with open(path("lh.cut.pial"), "wb") as stream:
        stream.write(whole[: len(whole) // 2])
    assert "cut short" in message(read_cortex, path("lh.cut.pial"))
    annotation = open(path("lh.aparc.annot"), "rb").read()
    with open(path("lh.cut.annot"), "wb") as stream:
        stream.write(annotation[: len(annotation) // 3])
    assert "cut short" in message(read_cortex, path("lh.pial"), [path("lh.cut.annot")])
    gifti = open(path("lh.y.surf.gii"), "rb").read()
    with open(path("lh.cut.surf.gii"), "wb") as stream:
        stream.write(gifti[: len(gifti) // 2])
    assert "cut short" in message(read_cortex, path("lh.cut.surf.gii"))
    with open(path("lh.nothing"), "wb") as stream:
        stream.write(b"nothing")
    assert "no file of FreeSurfer" in message(read_cortex, path("lh.nothing"))
    assert "No such file" in message(read_cortex, path("lh.absent"))
    assert "no surface" in message(read_cortex, path("rh.aparc.annot"))
    # Scanner RAS instead of surface RAS: the footer begins with 2, 1, 20.
    with open(path("lh.scanner.pial"), "wb") as stream:
        stream.write(whole.replace(struct.pack(">3i", 2, 0, 20) + b"valid", struct.pack(">3i", 2, 1, 20) + b"valid"))
    scanner = read_cortex(path("lh.scanner.pial"))
    assert scanner.GetFieldData().GetArray("InPatientSpace").GetTuple1(0) == 1
    # No footer: it says so.
    freesurfer.write_geometry(path("lh.bare.pial"), files.points, files.faces)
    said = []
    bare = read_cortex(path("lh.bare.pial"), warn=said.append)
    assert "c_ras" in said[0] and not bare.GetFieldData().GetArray("PatientMatrix")


def check_hemispheres():
    """Names of files, the side that they tell, and the beginning that tells it."""
    for name, side, stem in (
        ("lh.pial", "left", "lh"),
        ("rh.white.surf.gii", "right", "rh"),
        ("100307.L.pial.surf.gii", "left", "100307.L"),
        ("100307.R.midthickness.32k_fs_LR.surf.gii", "right", "100307.R"),
        ("sub-01_hemi-L_pial.surf.gii", "left", "sub-01_hemi-L_pial"),
        ("sub-r_hemi-L_pial.surf.gii", "left", "sub-r_hemi-L_pial"),
        ("patient_r_lh.pial", "left", "patient_r_lh"),
        ("l_study.100307.R.pial.surf.gii", "right", "l_study.100307.R"),
        ("study.lh.pial", "left", "study.lh"),
        ("lh.r.pial", "left", "lh"),
        ("brain_r.ply", "right", "brain_r"),
        ("brain.surf.gii", None, "brain"),
        ("brain", None, "brain"),
    ):
        path = os.path.join("rh.folder", name)
        found = hemisphere_of(path), hemisphere_stem(path)
        assert found == (side, stem), (name, found)


def turned():
    """A turn about an oblique axis, and a shift."""
    axis, angle = np.array([1.0, 2, 3]) / np.sqrt(14), 0.7
    cross = np.cross(np.eye(3), -axis)
    matrix = np.eye(4)
    matrix[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    matrix[:3, 3] = 12.5, -30.25, 7.125
    return matrix


def in_scanner_space(path):
    """The points of a file where its footer or header has them in the scanner, without this plugin's readers."""
    if path.endswith(".gii"):
        array = nibabel.load(path).get_arrays_from_intent("NIFTI_INTENT_POINTSET")[0]
        assert array.coordsys.xformspace == 1, array.coordsys.xformspace
        return array.data @ array.coordsys.xform[:3, :3].T + array.coordsys.xform[:3, 3]
    points, _faces, footer = freesurfer.read_geometry(path, read_metadata=True)
    assert list(footer["head"]) == [2, 0, 20] and footer["valid"].startswith("1"), footer
    half = np.array(footer["volume"]) * footer["voxelsize"] / 2
    voxels = np.column_stack([half[0] - points[:, 0], half[1] - points[:, 2], half[2] + points[:, 1]])  # in mm
    return (voxels - half) @ np.array([footer["xras"], footer["yras"], footer["zras"]]) + footer["cras"]


def check_places(files):
    """A surface that is written lies where it did in the patient, to this plugin and to others."""
    path, said = files.path, []
    data = read_cortex(path("lh.pial"))
    mirror = np.diag([-1.0, 1, 1, 1])
    for matrix in (matrix_of(data), turned(), turned() @ mirror):
        place(data, matrix, "test")
        expected = files.points @ matrix[:3, :3].T + matrix[:3, 3]
        for name in ("lh.placed.pial", "lh.placed.surf.gii"):
            write_cortex(path(name), data, warn=said.append)
            again = read_cortex(path(name), warn=said.append)
            assert np.array_equal(points_of(again), files.points), name
            assert np.allclose(matrix_of(again), matrix, atol=1e-6), (name, matrix_of(again))
            assert np.abs(in_scanner_space(path(name)) - expected).max() < 1e-3, name

    # In the scanner's space already. nibabel does not know FreeSurfer's tag, but the points.
    add_field(data, "InPatientSpace", 1)
    for name in ("lh.real.pial", "lh.real.surf.gii"):
        write_cortex(path(name), data, warn=said.append)
        again = read_cortex(path(name), warn=said.append)
        assert np.array_equal(points_of(again), files.points), name
        assert again.GetFieldData().GetArray("InPatientSpace").GetTuple1(0) == 1, name
    assert np.array_equal(freesurfer.read_geometry(path("lh.real.pial"))[0], files.points)
    assert np.array_equal(in_scanner_space(path("lh.real.surf.gii")), files.points)
    with open(path("lh.real.pial"), "rb") as stream:
        footer = stream.read().partition(struct.pack(">3i", 2, 1, 20))[2].decode().splitlines()
    # To programs that do not look at the tag surface RAS are scanner RAS.
    assert footer[0].startswith("valid = 1") and footer[4:] == [
        "xras   = -1 0 0", "yras   = 0 0 -1", "zras   = 0 1 0", "cras   = 0 0 0"], footer
    assert not said, said

    # A shear cannot be told in a footer, and a flat map lies nowhere in the patient.
    data = read_cortex(path("lh.pial"))
    place(data, np.diag([1.0, 1, 1.2, 1]), "test")
    write_cortex(path("lh.sheared.pial"), data, warn=said.append)
    assert len(said) == 1 and "lh.sheared.pial: the place" in said[0] and "Patient Space" in said[0], said
    write_cortex(path("lh.sheared.surf.gii"), data, warn=said.append)
    assert np.allclose(matrix_of(read_cortex(path("lh.sheared.surf.gii"))), np.diag([1.0, 1, 1.2, 1]))
    add_points_array(data, "SurfacePoints", files.points)
    for name in ("lh.map.pial", "lh.map.surf.gii"):
        write_cortex(path(name), data, warn=said.append)
        again = read_cortex(path(name), warn=lambda text: None).GetFieldData()
        assert not again.GetArray("PatientMatrix") and not again.GetArray("InPatientSpace"), name
    assert len(said) == 1, said


def check_annotation_colours(files):
    """In an annotation a vertex has the colour of its region and no number: regions of one colour would become one, and
    black ones none."""
    path, said = files.path, []
    data = read_cortex(path("lh.pial"))
    numbers = np.array([256, 11101, 11357, 512, 0, 1])  # equal modulo 256, and divisible by it
    add_points_array(data, "numbers", numbers[np.arange(len(files.points)) % 6])
    write_cortex(path("lh.numbers.annot"), data, "numbers", said.append)
    labels, _table, names = freesurfer.read_annot(path("lh.numbers.annot"))
    assert [int(names[label]) for label in labels[:6]] == list(numbers) and not said, (labels[:6], names, said)

    # A table of labels without colours, which is black to nibabel.
    table = "".join(f'<Label Key="{k}"><![CDATA[{name}]]></Label>' for k, name in enumerate(NAMES))
    kept = np.where(files.labels < 0, 0, files.labels).astype(np.int32)
    values = gifti_array(path("lh.black.label.gii"), kept, "LABEL", "ASCII")
    write_gifti(path("lh.black.label.gii"), f"<LabelTable>{table}</LabelTable>{values}")
    data = read_cortex(path("lh.pial"), [path("lh.black.label.gii"), path("lh.aparc.annot")])
    write_cortex(path("lh.black.annot"), data, "black", said.append)
    labels, table, names = freesurfer.read_annot(path("lh.black.annot"))
    assert np.array_equal(labels, kept) and [name.decode() for name in names] == NAMES
    assert len(set(table[:, 4])) == 3 and (table[:, 3] == 0).all(), table  # nor are they transparent
    assert len(said) == 1 and "3 of 3 regions are black" in said[0] and "lh.black.annot" in said[0], said

    # Names without colours.
    data.GetFieldData().RemoveArray("aparcColours")
    write_cortex(path("lh.plain.annot"), data, "aparc", said.append)
    assert np.array_equal(freesurfer.read_annot(path("lh.plain.annot"))[0], files.labels) and len(said) == 1
    # Two regions of one colour: the first keeps it, and all others theirs.
    colours = np.array([TABLE[1, :3], TABLE[1, :3], TABLE[2, :3]], np.uint8)
    add_field(data, "aparcColours", np.column_stack([colours, [255] * 3]).astype(np.uint8))
    write_cortex(path("lh.twice.annot"), data, "aparc", said.append)
    labels, table, _names = freesurfer.read_annot(path("lh.twice.annot"))
    assert np.array_equal(labels, files.labels) and np.array_equal(table[[0, 2], :3], colours[[0, 2]]), table
    assert "1 of 3 regions" in said[1] and "precentral is one" in said[1], said
    add_points_array(data, "none", np.full(len(files.points), -1))
    assert "no point has a region" in message(write_cortex, path("lh.none.annot"), data, "none")


def check_full_disk(files):
    """A file that does not fit on the disk leaves the earlier one as it was, and says so."""
    path = files.path
    data = read_cortex(path("lh.pial"), [path("lh.curv"), path("lh.aparc.annot")])
    arrays = {"pial": None, "annot": "aparc", "curv": "curv", "surf.gii": None, "shape.gii": "curv"}
    writes = {
        f"lh.z.{end}": lambda end=end, array=array: write_cortex(path(f"lh.z.{end}"), data, array)
        for end, array in arrays.items()
    }
    writes["lh.z.csv"] = lambda: write_csv(path("lh.z.csv"), 20 * [{"Label": 1, "Name": "precentral"}])
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    for name, write in writes.items():
        write()
        with open(path(name), "rb") as stream:
            before = stream.read()
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
        try:
            write()
            raise AssertionError(f"{name}: no error")
        except OSError as error:
            assert f"{path(name)} cannot be written" in str(error), error
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        with open(path(name), "rb") as stream:
            assert stream.read() == before, name
    assert not [name for name in os.listdir(files.folder) if name.startswith(".part")]


def check_quads(files):
    """Old surfaces have quadrangles, which are two triangles each: here a cube with coordinates in hundredths."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    three = lambda number: struct.pack(">i", number)[1:]  # noqa: E731
    with open(files.path("lh.quad.orig"), "wb") as stream:
        stream.write(b"\xff\xff\xff" + three(8) + three(6) + (corners * 125).astype(">i2").tobytes())
        stream.write(b"".join(three(number) for quad in quads for number in quad))
    data = read_cortex(files.path("lh.quad.orig"))
    assert np.array_equal(points_of(data), corners * 1.25) and data.GetNumberOfCells() == 12


def read_patch(path):
    """FreeSurfer's patch by its description: see the writer."""
    with open(path, "rb") as stream:
        version, count = struct.unpack(">ii", stream.read(8))
        assert version == -1
        rows = [struct.unpack(">i3f", stream.read(16)) for _ in range(count)]
        assert stream.read() == b""
    numbers = np.array([row[0] for row in rows])
    return np.abs(numbers) - 1, numbers < 0, np.array([row[1:] for row in rows], np.float32)


def check_patch(files):
    reader = simple.OpenDataFile(files.path("lh.pial"))
    reader.Overlays = [files.path("lh.aparc.annot"), files.path("lh.curv")]
    half = simple.Clip(Input=reader, ClipType="Plane")
    half.ClipType.Origin, half.ClipType.Normal = [0, 0, 0.3], [0, 0, 1]
    half.Crinkleclip = 1
    surface = simple.ExtractSurface(Input=half)
    disk = simple.SurfaceToDisk(Input=surface, Remesh=1)
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk))
    assert "Flat Map Transfer" in message(write_cortex, files.path("lh.no.patch.3d"), flat)
    transferred = simple.FlatMapTransfer(Input=flat, Original=surface)
    simple.SaveData(files.path("lh.flat.patch.3d"), transferred)
    data = servermanager.Fetch(transferred)
    numbers, border, positions = read_patch(files.path("lh.flat.patch.3d"))
    expected = {int(n): p for n, p in zip(array(data, "VertexNumber"), points_of(data).astype(np.float32))}
    assert len(numbers) == len(expected) > 300
    assert all(np.array_equal(expected[n], p) for n, p in zip(numbers, positions))
    # The vertices lie in space where those of the file with the same numbers do.
    back = dict(zip(array(data, "VertexNumber"), array(data, "SurfacePoints")))
    assert all(np.array_equal(files.points[n], back[n].astype(np.float32)) for n in numbers)
    assert 20 < border.sum() < 0.4 * len(border) and (files.points[numbers[border], 2] < 15).all()
    write_cortex(files.path("lh.flat.surf.gii"), transferred)
    image = nibabel.load(files.path("lh.flat.surf.gii"))
    points, faces = image.agg_data("pointset"), image.agg_data("triangle")
    assert len(points) == len(files.points) and len(faces) == data.GetNumberOfCells()
    assert np.array_equal(points[numbers], positions)
    known = {tuple(sorted(face)) for face in files.faces}
    assert all(tuple(sorted(face)) in known for face in faces)
    write_cortex(files.path("lh.flat.annot"), transferred, "aparc")
    labels, _table, _names = freesurfer.read_annot(files.path("lh.flat.annot"))
    assert np.array_equal(labels[numbers], files.labels[numbers])
    # A seam has two banks, on which a vertex lies twice.
    cut = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=simple.SurfaceToDisk(Input=reader)))
    whole = simple.FlatMapTransfer(Input=cut, Original=reader)
    assert "are there twice" in message(write_cortex, files.path("lh.twice.surf.gii"), whole)
    write_cortex(files.path("lh.twice.patch.3d"), whole)
    assert len(read_patch(files.path("lh.twice.patch.3d"))[0]) < len(files.points)


with tempfile.TemporaryDirectory() as scratch:
    made = Files(scratch)
    check_freesurfer(made)
    check_gifti_encodings(made)
    check_gifti(made)
    check_bad_files(made)
    check_hemispheres()
    check_places(made)
    check_annotation_colours(made)
    check_full_disk(made)
    check_quads(made)
    check_patch(made)
    print("FreeSurfer and GIFTI: passed")
