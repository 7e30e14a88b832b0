# SPDX-License-Identifier: GPL-3.0-or-later
"""MetaImage and NRRD in the encodings and orders of bytes that the formats allow, and files that are damaged: VTK's readers
take some of them for something else, and wait for ever for others."""

import bz2
import gzip
import os
import pathlib
import tempfile
import zlib

import numpy as np
import VolumeFiles
from surfaceflattening_invesalius import metaimage_of_invesalius
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
    "capitals.nrrd": nrrd("endian: BIG\nencoding: raw") + BIG,
    "pairs.nrrd": nrrd("endian: little\nencoding: raw\ntype:=hello\nsizes:=1 2") + LITTLE,
    "tête.mhd": metaimage(data="tête.raw"),
    "latin.mhd": metaimage(data="tête.raw").decode().encode("latin-1"),
    "tête.nhdr": nrrd("endian: little\nencoding: raw\ndata file: tête.raw"),
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
    "the order of bytes, middle": {"middle.nrrd": nrrd("endian: middle\nencoding: raw") + LITTLE},
    "encoding hex": {"hex.nrrd": nrrd("encoding: hex") + LITTLE.hex().encode()},
    "header cannot be understood": {"no.mha": b"NDims = 3\n", "no.nrrd": b"NRRD0004\n\n"},
    "6 sizes of voxels": {
        "sizes.mha": metaimage().replace(b"Spacing = 1 1 2", b"Spacing = 1 1 2 1 1 1") + LITTLE,
        "sizes.nrrd": nrrd("endian: little\nencoding: raw").replace(
            b"space directions: (1,0,0) (0, 1, 0) (0,0,2)", b"spacings: 1 1 2 1 1 1"
        )
        + LITTLE,
    },
    f"leaves out {10**20} bytes": {
        "far.mhd": metaimage(f"HeaderSize = {10**20}", data="skip.raw"),
        "far.nhdr": nrrd(f"encoding: raw\nbyte skip: {10**20}\ndata file: skip.raw"),
    },
    f"promises {2**64}": {  # a product that 64 bits cannot hold
        "wrapped.mha": metaimage(size=f"{2**31} {2**31} 4") + LITTLE,
        "wrapped.nrrd": nrrd("endian: little\nencoding: raw", f"{2**31} {2**31} 4") + LITTLE,
        "wrapped.mhd": metaimage("HeaderSize = -1", data="skip.raw", size=f"{2**31} {2**31} 4"),
    },
    "0 values of a voxel": {"channels.mha": metaimage("ElementNumberOfChannels = 0") + LITTLE},
    "in 0 files": {"no_files.mhd": metaimage(data="LIST")},
    "more than 65536": {"many.mhd": metaimage(data=f"slice%d.raw 1 {10**9} 1")},
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

# Lengths in other units than mm: the sizes of the voxels, and what is said of them.
RAW = "endian: little\nencoding: raw"
UNITS = {
    "um.nrrd": (nrrd(RAW + '\nspace units: "um" "um" "um"'), 1e-3, ""),
    "micron.nrrd": (nrrd(RAW + '\nspace units: "microns" "microns" "microns"'), 1e-3, ""),
    "cm.nrrd": (nrrd(RAW + '\nspace units: "cm" "cm" "cm"'), 10, ""),
    "m.nrrd": (nrrd(RAW + '\nspace units: "m" "m" "m"'), 1000, ""),
    "none.nrrd": (nrrd(RAW + '\nspace units: "" "" ""'), 1, ""),
    "inch.nrrd": (nrrd(RAW + '\nspace units: "inch" "inch" "inch"'), 1, "lengths in inch, a unit that is not known"),
    "two.nrrd": (nrrd(RAW + '\nspace units: "um" "um"'), 1, "2 units for 3 axes"),
    "spacings.nrrd": (
        nrrd(RAW + '\nunits: "um" "um" "um"', directions="").replace(b"space directions: ", b"spacings: 1 1 2"),
        1e-3,
        "the header has no space",
    ),
    "um.mha": (metaimage("DistanceUnits = um"), 1e-3, ""),
    "inch.mha": (metaimage("DistanceUnits = inch"), 1, "lengths in inch, a unit that is not known"),
    "unknown.mha": (metaimage("DistanceUnits = ?"), 1, ""),
}


def write(name, content):
    with open(name, "wb") as stream:
        stream.write(content)


def refused(name):
    """Why a file is not read."""
    try:
        read_scan(name, warn=print)
    except ScanError as error:
        return str(error)
    raise AssertionError(f"{name} was read")


def check_invesalius(name, mode):
    """A project is read; one that is cut short or has wrong bytes is read or refused, with its name."""
    VolumeFiles.write_invesalius(name, VALUES, (2.0, 1.0, 1.0), mode)
    values_of(name, [])
    with open(name, "rb") as stream:
        content = stream.read()
    reasons = set()
    for k in range(0, len(content), max(1, len(content) // 150)):
        damaged = bytearray(content)
        damaged[k] ^= 0xFF
        for part in (content[:k], bytes(damaged)):
            write(name, part)
            try:
                read_scan(name, warn=list)
            except ScanError as error:
                assert str(error).startswith(name) and tempfile.gettempdir() not in str(error), error
                reasons.add(str(error).split("damaged: ")[-1])
    assert reasons and not any("\n" in reason for reason in reasons), reasons
    print(mode, reasons)


def check_units():
    """Sizes and the matrix are in mm, in patient space and without it."""
    for name, (header, unit, words) in UNITS.items():
        write(name, header + LITTLE)
        said = []
        for patient_space in (False, True):
            volume = read_scan(name, patient_space, warn=said.append)
            assert np.allclose(volume.GetSpacing(), np.array([1, 1, 2]) * unit, rtol=1e-12), (name, volume.GetSpacing())
        matrix = volume.GetFieldData().GetArray("PatientMatrix")
        # The place of the first voxel, as below.
        expected = None if name == "spacings.nrrd" else [-5.0 * unit, -7.0 * unit, 3.0 * unit]
        found = matrix and [matrix.GetValue(k) for k in (3, 7, 11)]
        assert (found is None and expected is None) or np.allclose(found, expected, rtol=1e-12), (name, found)
        assert all(words and words in text for text in said) and len(said) == (2 if words else 0), (name, said)


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
    write("tête.raw", LITTLE)
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
            said = refused(name)
            assert words in said and said.startswith(name), (name, said)
            print(said)
    for words, files in WITHOUT_PLACE.items():
        for name, content in files.items():
            write(name, content)
            said = []
            values_of(name, said)
            assert words in said[0], (name, said)
    check_units()
    for packing in ("", ":gz", ":bz2", ":xz"):
        check_invesalius("phantom.inv3", "w" + packing)
    check_invesalius("Schädel 脳.inv3", "w")
    VolumeFiles.write_invesalius(80 * "脳" + ".inv3", VALUES, (2.0, 1.0, 1.0))
    values_of(80 * "脳" + ".inv3", [])
    other = VALUES + np.int16(1)
    VolumeFiles.write_invesalius("first.inv3", VALUES, (2.0, 1.0, 1.0))
    VolumeFiles.write_invesalius("second.inv3", other, (2.0, 1.0, 1.0))
    headers = [metaimage_of_invesalius(name, "shared") for name in ("first.inv3", "second.inv3")]
    values_of(headers[0], [])  # the other one lies beside it
    os.mkdir("folder.mha")
    assert "cannot be read" in refused("folder.mha")
    os.mkdir("folder.inv3")
    assert refused("folder.inv3") == "folder.inv3: Is a directory"
    assert read_scan(pathlib.Path("little.mha")).GetDimensions() == (5, 6, 7)
    for changes in ({"shape": 3}, {"shape": [7, 6]}, {"shape": [7, 6, "x"]}, {"dtype": []}, {"filename": "project"}):
        VolumeFiles.write_invesalius("odd.inv3", VALUES, (2.0, 1.0, 1.0), **changes)
        said = refused("odd.inv3")
        assert said.startswith("odd.inv3") and "damaged" in said, (changes, said)
    os.chdir("/")
