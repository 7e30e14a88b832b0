# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells whether a file is as long as its header says, which VTK's readers do not all look at.

They put up with binary STL and OBJ files that are cut short, and crash on PLY files. They notice it themselves in
legacy VTK files, VTK's XML files and text STL files. Of XML files, the number of components of an array is looked at,
because with a huge one VTK's reader takes minutes until it says that the file is damaged.
"""

import mmap
import os
import re
import struct

from ply_length import check_ply
from volume_lengths import FileLengthError, check_metaimage, check_nifti, check_nrrd, require

STL_HEADER = 84  # bytes: a text and the number of triangles
STL_TRIANGLE = 50
UNKNOWN_COUNTS = (0, 0xFFFFFFFF)  # written by programs that did not know the number beforehand
STL_SAMPLE = 1024
XML_COMPONENTS = re.compile(rb'NumberOfComponents="(\d+)"')
MOST_COMPONENTS = 10_000_000  # of a tuple of an array; VTK's reader takes a second for as many


def check_length(path, extension):
    """Returns warnings about a file that may be cut short. Raises FileLengthError for one that is."""
    check = CHECKS.get(extension)
    return (check(path) if check else None) or []


def check_stl(path):
    size = os.path.getsize(path)
    with open(path, "rb") as stream:
        start = stream.read(STL_SAMPLE)
    if start.lstrip()[:5].lower() == b"solid" and b"\0" not in start:
        return
    if size < STL_HEADER:
        raise FileLengthError(f"the file has {size} bytes, too few for the header of an STL file")
    (count,) = struct.unpack_from("<I", start, STL_HEADER - 4)
    if count in UNKNOWN_COUNTS:
        if (size - STL_HEADER) % STL_TRIANGLE:
            raise FileLengthError("the file is cut short: it ends within a triangle")
        return
    promised = STL_HEADER + STL_TRIANGLE * count
    require(f"{count:,} triangles", promised, size)
    if size >= promised + STL_TRIANGLE:
        raise FileLengthError(
            f"the header promises {count:,} triangles, but the file has room for "
            f"{(size - STL_HEADER) // STL_TRIANGLE:,}: one of them is wrong"
        )


def check_obj(path):
    """OBJ files do not say how long they are; only their last line can tell."""
    last = _last_line(path)
    if last.endswith(b"\n") or not last.strip():
        return None
    words = last.split()
    uneven = len({word.count(b"/") for word in words[1:]}) > 1 or words[-1].endswith(b"/")
    if (words[0] == b"v" and len(words) < 4) or (words[0] == b"f" and (len(words) < 4 or uneven)):
        raise FileLengthError("the file is cut short: it ends within a line")
    return ["the file does not end with a line break: if it is cut short, faces are missing"]


def check_xml(path):
    with open(path, "rb") as stream:
        if not os.path.getsize(path):
            return  # which cannot be mapped
        with mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as content:
            for found in XML_COMPONENTS.finditer(content):
                if int(found[1][:30]) > MOST_COMPONENTS:
                    raise FileLengthError(f"the file is damaged: an array has {int(found[1][:30]):,} components")


def _last_line(path):
    with open(path, "rb") as stream:
        stream.seek(0, os.SEEK_END)
        stream.seek(max(0, stream.tell() - 4096))
        return (stream.read().splitlines(keepends=True) or [b""])[-1]


CHECKS = {
    ".stl": check_stl,
    ".obj": check_obj,
    ".ply": check_ply,
    ".vtp": check_xml,
    ".vti": check_xml,
    ".nii": check_nifti,
    ".nii.gz": check_nifti,
    ".mha": check_metaimage,
    ".mhd": check_metaimage,
    ".nrrd": check_nrrd,
    ".nhdr": check_nrrd,
}
