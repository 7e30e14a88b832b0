# SPDX-License-Identifier: GPL-3.0-or-later
"""MetaImage and NRRD in the encodings and orders of bytes that the formats allow, and files that are damaged: VTK's readers
take some of them for something else, and wait for ever for others."""

import bz2
import gzip
import os
import tempfile
import zlib

import numpy as np
from surfaceflattening_scans import ScanError, read_scan
from vtkmodules.util.numpy_support import vtk_to_numpy

# Five voxels along the first axis, and a value whose bytes differ.
VALUES = (np.arange(210).reshape(7, 6, 5) - 100).astype(np.int16)
VALUES[0, 0, 0] = 258
LITTLE, BIG = VALUES.astype("<i2").tobytes(), VALUES.astype(">i2").tobytes()
TEXT = " ".join(map(str, VALUES.ravel())).encode()
MATRIX = "1 0 0 0 1 0 0 0 1"


def metaimage(lines="BinaryDataByteOrderMSB = False", data="LOCAL", matrix=MATRIX, size="5 6 7", count=3):
    return (
        f"ObjectType = Image\nNDims = {count}\nDimSize = {size}\nElementType = MET_SHORT\nElementSpacing = 1 1 2\n"
        f"TransformMatrix = {matrix}\nOffset = 1 2 3\n{lines}\nElementDataFile = {data}\n"
    ).encode()


def nrrd(lines, sizes="5 6 7", directions="(1,0,0) (0, 1, 0) (0,0,2)", end="\n"):
    dimension = len(sizes.split())
    return (
        f"NRRD0004\n# a comment: with a colon\ntype: short\ndimension: {dimension}\nspace: left-posterior-superior\n"
        f"sizes: {sizes}\nspace directions: {directions}\nspace origin: (1,2,3)\nkey:=value\n{lines}\n{end}"
    ).encode()


PACKED = zlib.compress(LITTLE)
COMPRESSED = f"BinaryDataByteOrderMSB = False\nCompressedData = True\nCompressedDataSize = {len(PACKED)}"
GOOD = {
    "little.mha": metaimage() + LITTLE,
    "big.mha": metaimage("BinaryDataByteOrderMSB = True") + BIG,
    "big_element.mha": metaimage("ElementByteOrderMSB = True") + BIG,
    "compressed.mha": metaimage(COMPRESSED) + PACKED,
    "text.mha": metaimage("BinaryData = False") + TEXT,
    "detached.mhd": metaimage(data="values.raw"),
    "skipped.mhd": metaimage("HeaderSize = 5", data="skip.raw"),
    "from_the_end.mhd": metaimage("HeaderSize = -1", data="skip.raw"),
    "list.mhd": metaimage(data="LIST") + b"".join(b"slice%d.raw\n" % k for k in range(7)),
    "pattern.mhd": metaimage(data="slice%d.raw 0 6 1"),
    "little.nrrd": nrrd("endian: little\nencoding: raw") + LITTLE,
    "big.nrrd": nrrd("endian: big\nencoding: raw") + BIG,
    "gzip.nrrd": nrrd("endian: little\nencoding: gzip") + gzip.compress(LITTLE),
    "bzip2.nrrd": nrrd("endian: big\nencoding: bzip2") + bz2.compress(BIG),
    "text.nrrd": nrrd("encoding: ascii") + TEXT,
    "detached.nhdr": nrrd("endian: little\nencoding: raw\ndata file: values.raw"),
    "skipped.nhdr": nrrd("endian: little\nencoding: raw\nbyte skip: 5\ndata file: skip.raw"),
    "from_the_end.nhdr": nrrd("endian: little\nencoding: raw\nbyte skip: -1\ndata file: skip.raw"),
    "list.nhdr": nrrd("endian: little\nencoding: raw\ndata file: LIST 2", end="") + b"".join(b"slice%d.raw\n" % k for k in range(7)),
    "colours.nrrd": nrrd("endian: little\nencoding: raw", "3 5 6 7", "none (1,0,0) (0,1,0) (0,0,2)")
    + np.repeat(VALUES[..., None], 3, axis=3).astype("<i2").tobytes(),
}
BAD = {
    "cut short": {
        "cut.mha": metaimage() + LITTLE[:200],
        "cut_compressed.mha": metaimage(COMPRESSED) + PACKED[:60],
        "cut.nrrd": nrrd("endian: little\nencoding: raw") + LITTLE[:200],
        "cut_gzip.nrrd": nrrd("endian: little\nencoding: gzip") + gzip.compress(LITTLE)[:70],
        "cut_text.nrrd": nrrd("encoding: ascii") + TEXT[:90],
    },
    "gone.raw": {"gone.mhd": metaimage(data="gone.raw"), "gone.nhdr": nrrd("encoding: raw\ndata file: gone.raw")},
    "4 dimensions, 5 x 6 x 7 x 2": {
        "times.mha": metaimage(size="5 6 7 2", count=4) + LITTLE + LITTLE,
        "times.nrrd": nrrd("endian: little\nencoding: raw", "5 6 7 2", "(1,0,0) (0,1,0) (0,0,2) none") + LITTLE + LITTLE,
    },
    "encoding hex": {"hex.nrrd": nrrd("encoding: hex") + LITTLE.hex().encode()},
    "header cannot be understood": {"no.mha": b"NDims = 3\n", "no.nrrd": b"NRRD0004\n\n"},
    "6 sizes of voxels": {
        "sizes.mha": metaimage().replace(b"Spacing = 1 1 2", b"Spacing = 1 1 2 1 1 1") + LITTLE,
        "sizes.nrrd": nrrd("endian: little\nencoding: raw").replace(
            b"space directions: (1,0,0) (0, 1, 0) (0,0,2)", b"spacings: 1 1 2 1 1 1"
        )
        + LITTLE,
    },
    "line skip": {"lines.nrrd": nrrd("encoding: raw\nline skip: 2") + LITTLE},
}
# Read as they are stored, with a warning.
WITHOUT_PLACE = {
    "singular": {
        "singular.mha": metaimage(matrix="1 0 0 1 0 0 0 0 1") + LITTLE,
        "singular.nrrd": nrrd("endian: little\nencoding: raw", directions="(1,0,0) (2,0,0) (0,0,2)") + LITTLE,
    },
    "not finite": {"nan.mha": metaimage(matrix="nan 0 0 0 1 0 0 0 1") + LITTLE},
}


def write(name, content):
    with open(name, "wb") as stream:
        stream.write(content)


def values_of(name, warnings):
    volume = read_scan(name, patient_space=False, warn=warnings.append)
    assert volume.GetDimensions() == (5, 6, 7), (name, volume.GetDimensions())
    scalars = volume.GetPointData().GetScalars()
    values = vtk_to_numpy(scalars).reshape(7, 6, 5, -1)
    assert all(np.array_equal(values[..., k], VALUES) for k in range(values.shape[3])), name
    return volume, values.shape[3]


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    write("values.raw", LITTLE)
    write("skip.raw", b"12345" + LITTLE)
    for k in range(7):
        write(f"slice{k}.raw", LITTLE[60 * k : 60 * k + 60])
    for name, content in GOOD.items():
        write(name, content)
        said = []
        volume, components = values_of(name, said)
        assert volume.GetSpacing() == (1, 1, 2) and not said and components == (3 if "colours" in name else 1), name
        matrix = read_scan(name).GetFieldData().GetArray("PatientMatrix")
        # Left and back become right and front, so that the first voxel is the one that was last along both.
        assert [matrix.GetValue(k) for k in (3, 7, 11)] == [-5.0, -7.0, 3.0], name
    for words, files in BAD.items():
        for name, content in files.items():
            write(name, content)
            try:
                read_scan(name)
                raise AssertionError(f"{name} was read")
            except ScanError as error:
                assert words in str(error) and str(error).startswith(name), (name, error)
                print(error)
    for words, files in WITHOUT_PLACE.items():
        for name, content in files.items():
            write(name, content)
            said = []
            values_of(name, said)
            assert words in said[0], (name, said)
    os.chdir("/")
