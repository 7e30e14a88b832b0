# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes one volume in the formats that scans come in: NIfTI, DICOM, MetaImage, NRRD and VTK's own.

A volume is an array of int16 indexed [z, y, x], with the size of its voxels in mm along x, y and z. Every
writer but VTK's is a page of the format's standard, so that the readers are tested against that and not
against VTK's own idea of it.
"""

import base64
import io
import os
import plistlib
import struct
import tarfile


def write_nifti(path, values, spacing):
    """NIfTI-1, one file: https://nifti.nimh.nih.gov/nifti-1"""
    depth, height, width = values.shape
    header = bytearray(352)  # 348 and four bytes that say that there is no extension
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, width, height, depth, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 4, 16)  # DT_INT16, bits
    struct.pack_into("<8f", header, 76, 1, *spacing, 0, 0, 0, 0)
    struct.pack_into("<f", header, 108, 352)  # where the voxels are
    struct.pack_into("<2f", header, 112, 1, 0)  # slope and intercept
    header[123] = 2  # mm
    header[344:348] = b"n+1\0"
    with open(path, "wb") as stream:
        stream.write(header + values.astype("<i2").tobytes())


def write_metaimage(path, values, spacing, matrix=None):
    """Header and voxels in one file (.mha). @matrix: voxel index to LPS+ mm (4 x 4), instead of the spacing."""
    place = ""
    if matrix is not None:
        spacing = _lengths(matrix)
        axes = [matrix[row][axis] / spacing[axis] for axis in range(3) for row in range(3)]
        place = f"TransformMatrix = {_words(axes)}\nOffset = {_words(matrix[row][3] for row in range(3))}\n"
    header = (
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
        f"DimSize = {_words(reversed(values.shape))}\nElementSpacing = {_words(spacing)}\n{place}"
        "ElementType = MET_SHORT\nElementDataFile = LOCAL\n"
    )
    with open(path, "wb") as stream:
        stream.write(header.encode("ascii") + values.astype("<i2").tobytes())


def write_nrrd(path, values, spacing, matrix=None, space="left-posterior-superior"):
    """https://teem.sourceforge.net/nrrd/format.html, raw and attached. @matrix: voxel index to @space in mm (4 x 4),
    instead of the spacing."""
    where, origin = "space dimension: 3", "(0,0,0)"
    if matrix is not None:
        where, origin = f"space: {space}", _triple(matrix[row][3] for row in range(3))
    directions = " ".join(
        "(" + ",".join(repr(float(size)) if k == axis else "0" for k in range(3)) + ")"
        for axis, size in enumerate(spacing)
    ) if matrix is None else " ".join(_triple(matrix[row][axis] for row in range(3)) for axis in range(3))
    header = (
        f"NRRD0004\ntype: short\ndimension: 3\n{where}\nsizes: {_words(reversed(values.shape))}\n"
        f"space directions: {directions}\nspace origin: {origin}\nkinds: domain domain domain\n"
        'space units: "mm" "mm" "mm"\nendian: little\nencoding: raw\n\n'
    )
    with open(path, "wb") as stream:
        stream.write(header.encode("ascii") + values.astype("<i2").tobytes())


def write_vti(path, values, spacing):
    """VTK XML with the voxels inline, as Debian's ParaView cannot read appended ones."""
    depth, height, width = values.shape
    extent = f"0 {width - 1} 0 {height - 1} 0 {depth - 1}"
    raw = values.astype("<i2").tobytes()
    text = base64.b64encode(struct.pack("<I", len(raw)) + raw).decode("ascii")
    with open(path, "w", encoding="ascii") as stream:
        stream.write(
            '<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian" header_type="UInt32">\n'
            f'<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="{_words(spacing)}">\n'
            f'<Piece Extent="{extent}"><PointData Scalars="Intensity">\n'
            f'<DataArray type="Int16" Name="Intensity" format="binary">{text}</DataArray>\n'
            "</PointData></Piece></ImageData></VTKFile>\n"
        )


def dicom_slice_path(folder, k, depth):
    # 7 and the number of slices have no common divisor.
    return os.path.join(folder, f"slice{(k * 7 + 3) % depth:03d}.dcm")


def write_dicom_series(folder, values, spacing, matrix=None, move=None):
    """A file per slice, explicit VR little endian (DICOM PS3.5, PS3.10), as CT scanners write them. The
    names are in another order than the slices: their positions are what counts. @matrix: voxel index to LPS+
    mm (4 x 4), instead of the spacing. @move: by how many slices some lie farther along than they should."""
    os.makedirs(folder, exist_ok=True)
    depth = len(values)
    for k in range(depth):
        at = k + (move or {}).get(k, 0)
        with open(dicom_slice_path(folder, k, depth), "wb") as stream:
            stream.write(_dicom_slice(values[k], k, *_dicom_place(at, spacing, matrix)))


def _dicom_place(k, spacing, matrix):
    """Sizes of the voxels, position of the slice and direction of its rows and columns."""
    if matrix is None:
        return spacing, (0.0, 0.0, k * spacing[2]), (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    sizes = _lengths(matrix)
    position = [float(matrix[row][2] * k + matrix[row][3]) for row in range(3)]
    return sizes, position, [float(matrix[row][axis] / sizes[axis]) for axis in (0, 1) for row in range(3)]


def _dicom_slice(values, k, spacing, position, directions):
    ct_image = "1.2.840.10008.5.1.4.1.1.2"
    instance = f"2.25.1234567890.{k + 1}"
    height, width = values.shape
    meta = (
        _element(0x0002, 0x0001, "OB", b"\0\1")
        + _element(0x0002, 0x0002, "UI", ct_image)
        + _element(0x0002, 0x0003, "UI", instance)
        + _element(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.1")  # explicit VR little endian
        + _element(0x0002, 0x0012, "UI", "2.25.1234567890")
    )
    data = (
        _element(0x0008, 0x0016, "UI", ct_image)
        + _element(0x0008, 0x0018, "UI", instance)
        + _element(0x0008, 0x0060, "CS", "CT")
        + _element(0x0010, 0x0010, "PN", "Phantom")
        + _element(0x0018, 0x0050, "DS", repr(float(spacing[2])))
        + _element(0x0020, 0x000D, "UI", "2.25.1234567890.100")
        + _element(0x0020, 0x000E, "UI", "2.25.1234567890.101")
        + _element(0x0020, 0x0013, "IS", str(k + 1))
        + _element(0x0020, 0x0032, "DS", "\\".join(f"{x:.10g}" for x in position))
        + _element(0x0020, 0x0037, "DS", "\\".join(f"{x:.10g}" for x in directions))
        + _element(0x0028, 0x0002, "US", struct.pack("<H", 1))
        + _element(0x0028, 0x0004, "CS", "MONOCHROME2")
        + _element(0x0028, 0x0010, "US", struct.pack("<H", height))
        + _element(0x0028, 0x0011, "US", struct.pack("<H", width))
        + _element(0x0028, 0x0030, "DS", f"{spacing[1]!r}\\{spacing[0]!r}")
        + _element(0x0028, 0x0100, "US", struct.pack("<H", 16))
        + _element(0x0028, 0x0101, "US", struct.pack("<H", 16))
        + _element(0x0028, 0x0102, "US", struct.pack("<H", 15))
        + _element(0x0028, 0x0103, "US", struct.pack("<H", 1))  # signed
        + _element(0x0028, 0x1052, "DS", "0")
        + _element(0x0028, 0x1053, "DS", "1")
        + _element(0x7FE0, 0x0010, "OW", values.astype("<i2").tobytes())
    )
    length = _element(0x0002, 0x0000, "UL", struct.pack("<I", len(meta)))
    return bytes(128) + b"DICM" + length + meta + data


def _element(group, number, representation, value):
    if isinstance(value, str):
        value = value.encode("ascii")
    if len(value) % 2:
        value += b"\0" if representation in ("UI", "OB") else b" "
    start = struct.pack("<HH2s", group, number, representation.encode("ascii"))
    if representation in ("OB", "OW"):
        return start + struct.pack("<HI", 0, len(value)) + value
    return start + struct.pack("<H", len(value)) + value


def _words(numbers):
    return " ".join(str(number) for number in numbers)


def _triple(numbers):
    return "(" + ",".join(repr(float(number)) for number in numbers) + ")"


def _lengths(matrix):
    """Of the first three columns."""
    return [float(sum(matrix[row][axis] ** 2 for row in range(3)) ** 0.5) for axis in range(3)]


def write_invesalius(path, values, spacing, mode="w", **changes):
    """@mode: of tarfile. @changes: of what the property list says of the voxels."""
    project = {
        "matrix": {"filename": "matrix.dat", "dtype": "int16", "shape": list(values.shape), **changes},
        "spacing": list(spacing),
    }
    with tarfile.open(path, mode) as archive:
        for name, content in (
            ("main.plist", plistlib.dumps(project)),
            ("matrix.dat", values.astype("<i2").tobytes()),
        ):
            member = tarfile.TarInfo("project/" + name)
            member.size = len(content)
            archive.addfile(member, io.BytesIO(content))
