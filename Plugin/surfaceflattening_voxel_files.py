# SPDX-License-Identifier: GPL-3.0-or-later
"""MetaImage and NRRD as Scans: a header of text lines, and voxels behind it or in files of their own.

The voxels are read here and not by VTK's readers, which wait for ever for a compressed MetaImage that was cut short, fill
an uncompressed one with what was in memory, and take the first axis of a NRRD with nine voxels or less for colours.
"""

import bz2
import gzip
import math
import os
import sys
import zlib

import numpy as np
import surfaceflattening_orientation as orientation
from surfaceflattening_scans import Scan, ScanError, true_values

METAIMAGE_TYPES = {
    "MET_CHAR": "i1",
    "MET_UCHAR": "u1",
    "MET_SHORT": "i2",
    "MET_USHORT": "u2",
    "MET_INT": "i4",
    "MET_UINT": "u4",
    "MET_LONG": "i4",
    "MET_ULONG": "u4",
    "MET_LONG_LONG": "i8",
    "MET_ULONG_LONG": "u8",
    "MET_FLOAT": "f4",
    "MET_DOUBLE": "f8",
}

NRRD_TYPES = {
    "i1": ("signed char", "int8", "int8_t"),
    "u1": ("uchar", "unsigned char", "uint8", "uint8_t"),
    "i2": ("short", "short int", "signed short", "signed short int", "int16", "int16_t"),
    "u2": ("ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"),
    "i4": ("int", "signed int", "int32", "int32_t"),
    "u4": ("uint", "unsigned int", "uint32", "uint32_t"),
    "i8": ("longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"),
    "u8": ("ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"),
    "f4": ("float",),
    "f8": ("double",),
}

UNPACK = {
    "raw": lambda content: content,
    "gzip": gzip.decompress,
    "gz": gzip.decompress,
    "bzip2": bz2.decompress,
    "bz2": bz2.decompress,
    "zlib": zlib.decompress,
}
MOST_FILES = 65536  # of voxels that a header may name: far more than a scan has slices
TEXT = ("ascii", "txt", "text")


class VoxelFileScan(Scan):
    """What the two formats have in common. A subclass reads the header in describe(), which sets shape, sizes,
    placement, kind (a type of numpy, with the order of bytes), components, encoding, files, and skip, the bytes before
    the voxels of a file; -1: the voxels are the end of the file."""

    SEPARATOR = None

    def __init__(self, path):
        self._path, self.components, self.skip = path, 1, 0
        fields, lines, end = orientation.header_fields(path, self.SEPARATOR)
        try:
            placement, shape, sizes = self.describe(fields, lines, end)
        except ScanError:
            raise
        except (KeyError, ValueError, IndexError, TypeError, OverflowError) as error:
            raise ScanError(f"{path}: the header cannot be understood: {error}") from None
        if len(shape) != 3 or min(shape) < 1:
            raise ScanError(
                f"{path}: the file has {len(shape)} dimensions, {' x '.join(map(str, shape))}: a volume has three; save "
                "one of its volumes in a file of its own"
            )
        if len(sizes) != len(shape):
            raise ScanError(
                f"{path}: the header has {len(sizes)} sizes of voxels for {len(shape)} dimensions: it may be damaged"
            )
        if self.components < 1 or not self.files:
            raise ScanError(
                f"{path}: the header has {self.components} values of a voxel in {len(self.files)} files: it may be damaged"
            )
        super().__init__(shape, sizes, placement)

    def describe(self, fields, lines, end):
        raise NotImplementedError

    def load(self):
        count = self._count()
        values = np.concatenate([self._values_of(file) for file in self.files])
        if len(values) < count:
            raise ScanError(
                f"{self._path}: there are {len(values)} values, and the header promises {count}: the file may be cut short"
            )
        values = values[:count].astype(self.kind.newbyteorder("="), copy=False)
        parts = () if self.components == 1 else (self.components,)
        return values.reshape(*reversed(self.shape), *parts).swapaxes(0, 2)

    def _values_of(self, file):
        if self.encoding not in UNPACK and self.encoding not in TEXT:
            raise ScanError(f"{self._path}: the encoding {self.encoding} is not known")
        try:
            size = os.path.getsize(file)
            with open(file, "rb") as stream:
                stream.seek(self._start(size))
                content = stream.read()
            if self.encoding in TEXT:
                return np.array(content.split(), self.kind)
            content = UNPACK[self.encoding](content)
        except (OSError, EOFError, zlib.error, ValueError, OverflowError) as error:
            reason = getattr(error, "strerror", None) or error
            raise ScanError(
                f"{self._path}: the voxels in {file} cannot be read, the file may be damaged or cut short: {reason}"
            ) from None
        return np.frombuffer(content, self.kind, len(content) // self.kind.itemsize)

    def _count(self):
        """The number of values, by integers of Python: those of numpy would wrap with a damaged header."""
        return math.prod(self.shape) * self.components

    def _start(self, size):
        if self.skip > size:
            raise ValueError(f"the header leaves out {self.skip} bytes before the voxels, and the file has {size}")
        if self.skip >= 0:
            return self.skip
        each = self._count() * self.kind.itemsize // len(self.files)
        return max(size - each, 0)

    def _files_of(self, text, lines):
        """The files of a name, of a list in the lines behind it, or of a pattern with its first and last number and the
        step, such as slice%03d.raw 1 10 1."""
        words = text.split()
        names = [text]
        if words[0] == "LIST":
            names = lines
        elif len(words) >= 4 and "%" in words[0]:
            first, last, step = (int(word) for word in words[1:4])
            numbers = range(first, last + 1, step)
            if len(numbers) > MOST_FILES:
                raise ScanError(f"{self._path}: names {len(numbers)} files of voxels, more than {MOST_FILES}")
            names = [words[0] % number for number in numbers]
        folder = os.path.dirname(os.path.abspath(self._path))
        return [orientation.named_file(folder, name) for name in names]


class MetaImageScan(VoxelFileScan):
    """https://itk.org/Wiki/ITK/MetaIO/Documentation"""

    name = "MetaImage"
    SEPARATOR = "="

    def describe(self, fields, lines, end):
        most_first = orientation.is_true(fields.get("binarydatabyteordermsb", fields.get("elementbyteordermsb", "False")))
        if fields["elementtype"] not in METAIMAGE_TYPES:
            raise ScanError(f"{self._path}: the type of the voxels, {fields['elementtype']}, is not known")
        self.kind = np.dtype((">" if most_first else "<") + METAIMAGE_TYPES[fields["elementtype"]])
        self.components = int(fields.get("elementnumberofchannels", 1))
        self.encoding = "zlib" if orientation.is_true(fields.get("compresseddata", "False")) else "raw"
        if not orientation.is_true(fields.get("binarydata", "True")):
            self.encoding = "ascii"
        if fields["elementdatafile"].lower() == "local":
            self.files, self.skip = [self._path], end
        else:
            self.files = self._files_of(fields["elementdatafile"], lines)
            self.skip = int(fields.get("headersize", 0))
        shape = [int(word) for word in fields["dimsize"].split()]
        sizes = fields.get("elementspacing", fields.get("elementsize", "1 1 1")).split()
        self._slope = float(fields.get("elementtointensityfunctionslope", 1))
        self._offset = float(fields.get("elementtointensityfunctionoffset", 0))
        (unit,), warnings = orientation.units_of(fields.get("distanceunits", ""), 1)
        placement = orientation.metaimage_placement(fields, unit)
        placement.warnings += warnings
        return placement, shape, [float(word) * unit for word in sizes]

    def load(self):
        return true_values(super().load(), self._slope, self._offset)


class NRRDScan(VoxelFileScan):
    """https://teem.sourceforge.net/nrrd/format.html"""

    name = "ImageFile"
    SEPARATOR = ":"

    def describe(self, fields, lines, end):
        types = {name: kind for kind, names in NRRD_TYPES.items() for name in names}
        if fields["type"] not in types:
            raise ScanError(f"{self._path}: the type of the voxels, {fields['type']}, is not known")
        order = fields.get("endian", sys.byteorder).lower()
        if order not in ("big", "little"):
            raise ScanError(f"{self._path}: the order of bytes, {order}, is not known: big or little is")
        most_first = order == "big"
        self.kind = np.dtype((">" if most_first else "<") + types[fields["type"]])
        self.encoding = fields["encoding"].lower()
        detached = fields.get("data file", fields.get("datafile"))
        self.files = self._files_of(detached, lines) if detached else [self._path]
        self.skip = int(fields.get("byte skip", fields.get("byteskip", 0)))
        if int(fields.get("line skip", fields.get("lineskip", 0))) != 0:
            raise ScanError(f"{self._path}: lines before the voxels cannot be left out (line skip)")
        if not detached and self.skip >= 0:
            self.skip += end
        shape = [int(word) for word in fields["sizes"].split()]
        directions = orientation.nrrd_directions(fields)
        along = [k for k, axis in enumerate(directions) if axis is not None] if directions else list(range(len(shape)))
        sizes, warnings = self._sizes(fields, directions, len(shape))
        if len(shape) == 4 and along == [1, 2, 3]:  # values of one voxel, such as colours
            self.components = shape[0]
            shape, sizes = shape[1:], sizes[1:]
        placement = orientation.nrrd_placement(fields)
        placement.warnings += warnings
        return placement, shape, sizes

    def _sizes(self, fields, directions, count):
        """The sizes of a voxel in mm along @count axes, and what is odd about their units."""
        if directions:
            in_space = max(len(axis or []) for axis in directions)
            _units, warnings = orientation.units_of(fields.get("space units", ""), in_space)
            return [1.0 if axis is None else float(np.linalg.norm(axis)) for axis in directions], warnings
        units, warnings = orientation.units_of(fields.get("units", ""), count)
        sizes = [float(word) for word in fields.get("spacings", "").split()] or [1.0] * count
        # A number of sizes other than that of the axes is refused later.
        return [size * unit for size, unit in zip(sizes, units)] if len(sizes) == count else sizes, warnings
