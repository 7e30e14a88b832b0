# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells whether a file with a volume has all the voxels that its header promises."""

import gzip
import math
import os
import struct
import zlib

import plugin_modules  # noqa: F401
from surfaceflattening_orientation import is_true, named_file

MAXIMUM_HEADER = 1 << 20  # bytes of a MetaImage or NRRD header
PIECE = 1 << 20
GZIP = zlib.MAX_WBITS + 16
NIFTI_VERSIONS = {348: ("h", 40, 70, 108, "f"), 540: ("q", 16, 12, 168, "q")}
METAIMAGE_BYTES = {"CHAR": 1, "UCHAR": 1, "SHORT": 2, "USHORT": 2, "INT": 4, "UINT": 4, "LONG": 4, "ULONG": 4,
                   "LONG_LONG": 8, "ULONG_LONG": 8, "FLOAT": 4, "DOUBLE": 8}  # after MET_
NRRD_BYTES = {"char": 1, "int8": 1, "short": 2, "int16": 2, "int": 4, "int32": 4, "longlong": 8, "int64": 8,
              "float": 4, "double": 8}


class FileLengthError(Exception):
    """In which way a file is not as long as its header says, in a sentence."""


def require(content, promised, found):
    if found < promised:
        raise FileLengthError(
            f"the file is cut short: its header promises {content}, {promised:,} bytes in all, but it has {found:,}"
        )


def check_nifti(path):
    """https://nifti.nimh.nih.gov: the header has fixed places; .nii.gz is the same, compressed."""
    compressed = path.lower().endswith(".gz")
    length = _unpacked_length(path, 0, GZIP) if compressed else os.path.getsize(path)
    with (gzip.open if compressed else open)(path, "rb") as stream:
        header = stream.read(540)
    for order in "<>":
        version = NIFTI_VERSIONS.get(struct.unpack(order + "i", header[:4].ljust(4, b"\0"))[0])
        if version and len(header) >= 348:
            break
    else:
        raise FileLengthError("the file does not begin with the header of a NIfTI file")
    kind, dimensions, bits, offset, offset_kind = version
    count, *sizes = struct.unpack_from(f"{order}8{kind}", header, dimensions)
    (bits,) = struct.unpack_from(order + "h", header, bits + 2)
    (offset,) = struct.unpack_from(order + offset_kind, header, offset)
    if not 1 <= count <= 7 or min(sizes[:count]) < 1 or bits < 1 or not 0 <= offset < 1 << 62:
        raise FileLengthError("the header is damaged: it promises no voxels")
    require(_times(sizes[:count]), int(offset) + math.prod(sizes[:count]) * bits // 8, length)


def check_metaimage(path):
    """https://itk.org/Wiki/ITK/MetaIO/Documentation: lines of name = value, the voxels after them or in a file."""
    fields, end = _fields(path, b"=", lambda line: line.startswith(b"ElementDataFile"))
    data = fields.get("elementdatafile", "")
    kind = fields.get("elementtype", "").removeprefix("MET_").removesuffix("_ARRAY")
    if kind not in METAIMAGE_BYTES:
        raise FileLengthError("the header is damaged: it has no ElementType of numbers")
    if data.startswith("LIST") or "%" in data or not is_true(fields.get("binarydata", "True")):
        return  # voxels in several files, or as text
    sizes = _integers(fields.get("dimsize", ""))
    channels = _integers(fields.get("elementnumberofchannels", "1")) or [1]
    file, start = (path, end) if data.upper() == "LOCAL" else (named_file(os.path.dirname(path), data), 0)
    _require_voxels(file, start, sizes, METAIMAGE_BYTES[kind] * channels[0],
                    zlib.MAX_WBITS if is_true(fields.get("compresseddata", "False")) else None)


def check_nrrd(path):
    """https://teem.sourceforge.net/nrrd/format.html: lines of name: value up to an empty one, then the voxels."""
    detached = path.lower().endswith(".nhdr")
    fields, end = _fields(path, b":", lambda line: not line.strip(), may_end=detached)
    data = fields.get("data file", fields.get("datafile", ""))
    kind = fields.get("type", "").removesuffix("_t").replace("unsigned ", "").replace("signed ", "")
    kind = kind.removesuffix(" int").removeprefix("u").replace("long long", "longlong")
    encoding = fields.get("encoding", "raw").lower()
    sizes = _integers(fields.get("sizes", ""))
    if kind not in NRRD_BYTES or str(len(sizes)) != fields.get("dimension"):
        raise FileLengthError("the header is damaged: it lacks the type of numbers, or as many sizes as dimensions")
    if fields.get("space dimension", fields["dimension"]) != fields["dimension"]:
        # VTK's reader takes the one for the other and reads a part of the volume, or without end.
        raise FileLengthError("the dimension of the space differs from that of the voxels, which VTK cannot read")
    if data.startswith("LIST") or len(data.split()) > 1:
        return  # voxels in several files
    packings = {"raw": None, "gzip": GZIP, "gz": GZIP}
    if encoding in packings:
        file, start = (named_file(os.path.dirname(path), data), 0) if data else (path, end)
        _require_voxels(file, start, sizes, NRRD_BYTES[kind], packings[encoding])


def _require_voxels(path, start, sizes, voxel_bytes, packing):
    """@packing: as of _unpacked_length(); None: the voxels are not compressed."""
    if not sizes or min(sizes) < 1 or voxel_bytes < 1:
        raise FileLengthError("the header is damaged: it promises no voxels")
    if not os.path.isfile(path):
        raise FileLengthError(f"there is no file {path}, which the header names")
    found = os.path.getsize(path) if packing is None else start + _unpacked_length(path, start, packing)
    require(_times(sizes), start + math.prod(sizes) * voxel_bytes, found)


def _times(sizes):
    return " x ".join(map(str, sizes)) + " voxels"


def _integers(text):
    try:
        return [int(word) for word in text.split()]
    except ValueError:
        return []


def _fields(path, separator, is_last, may_end=False):
    """The fields of a text header, with small letters, and where it ends.

    @may_end: the file may be a header alone, without the line that ends it.
    """
    fields = {}
    with open(path, "rb") as stream:
        while stream.tell() < MAXIMUM_HEADER:
            line = stream.readline(MAXIMUM_HEADER)
            if b"\0" in line:
                break
            if not line and not may_end:
                break
            name, _separator, value = line.partition(separator)
            if not value.startswith(b"="):  # a pair key:=value of a NRRD, whatever the key is
                text = value.decode("utf-8", "surrogateescape")  # as names of files are
                fields[name.decode("utf-8", "surrogateescape").strip().lower()] = text.strip()
            if not line or is_last(line):
                return fields, stream.tell()
    raise FileLengthError("the header has no end: the file is cut short or damaged")


def _unpacked_length(path, start, packing):
    """The number of bytes in compressed data. Raises FileLengthError if these are damaged or cut short.

    @packing: zlib's wbits.
    """
    total = 0
    unpacker = zlib.decompressobj(packing)
    try:
        with open(path, "rb") as stream:
            stream.seek(start)
            while piece := stream.read(PIECE):
                while piece:
                    total += len(unpacker.decompress(piece, PIECE))
                    piece = unpacker.unconsumed_tail
                    if unpacker.eof:
                        piece = unpacker.unused_data
                        if not piece.startswith(b"\x1f\x8b"):  # no further member of a .gz file
                            return total
                        unpacker = zlib.decompressobj(packing)
    except zlib.error as error:
        raise FileLengthError(f"the compressed data are damaged: {error}") from None
    raise FileLengthError("the file is cut short: its compressed data do not end")
