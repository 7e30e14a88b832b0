# SPDX-License-Identifier: GPL-3.0-or-later
"""The volume of an InVesalius project (.inv3) as a Scan."""

import errno
import hashlib
import os
import plistlib
import tarfile
import tempfile

import numpy as np
from surfaceflattening_scans import ScanError
from surfaceflattening_voxel_files import MetaImageScan


class InVesaliusScan(MetaImageScan):
    """A project has no orientation of the patient, as its slices come from InVesalius's own reader."""

    def __init__(self, path):
        self._folder = tempfile.TemporaryDirectory()
        header = metaimage_of_invesalius(path, self._folder.name)
        try:
            super().__init__(header)
        except ScanError as error:
            raise _damaged(path, str(error).removeprefix(f"{header}: ")) from None
        self._path = path
        self.placement.warnings[:] = [
            "an InVesalius project does not say where the patient's left and right are: the volume stays as it is"
        ]

    def load(self):
        return np.array(super().load())


def _damaged(path, reason):
    return ScanError(f"{path}: the InVesalius project cannot be read, it may be damaged: {reason}")


def metaimage_of_invesalius(path, folder):
    """Unpacks the volume of an InVesalius project (.inv3) into @folder and writes a MetaImage header beside
    it. Returns the header's path, for OpenDataFile. Raises ScanError.

    A project is a tar archive, compressed or not, with a property list, main.plist, that names a file of
    raw voxels, their type, their number along z, y and x, and their size in mm.
    """
    try:
        return _unpacked(path, folder)
    except ScanError:
        raise
    except Exception as error:  # damage shows in tarfile, in what unpacks, in plistlib and in what the list holds
        # No permission, or no room on the disk; a damaged file may ask for a place that is an invalid argument.
        if isinstance(error, OSError) and error.errno not in (None, errno.EINVAL):
            raise ScanError(f"{error.filename or folder}: {error.strerror}") from None
        reason = str(error) or type(error).__name__
        raise _damaged(path, reason.splitlines()[0].rstrip(":")) from None  # tarfile lists what it tried


def _unpacked(path, folder):
    with tarfile.open(path) as archive:
        members = {os.path.basename(member.name): member for member in archive.getmembers()}
        try:
            with archive.extractfile(members["main.plist"]) as stream:
                project = plistlib.load(stream)
            matrix = project["matrix"]
            spacing, kind, shape = project["spacing"], matrix["dtype"], matrix["shape"]
            voxels = archive.extractfile(members[matrix["filename"]])
        except KeyError as missing:
            raise ScanError(f"{path} is no InVesalius project, or it is damaged: it has no {missing}") from None
        types = {"int16": "MET_SHORT", "uint16": "MET_USHORT", "uint8": "MET_UCHAR"}
        if kind not in types:
            raise ScanError(f"{path} has voxels of type {kind}: known are {', '.join(types)}")
        stem = os.path.splitext(os.path.basename(path))[0]
        # Headers are in ASCII, the name of a project may be long, and several projects may share the folder.
        data = f"voxels-{hashlib.sha256(os.fsencode(stem)).hexdigest()[:16]}.raw"
        os.makedirs(folder, exist_ok=True)
        with voxels, open(os.path.join(folder, data), "wb") as raw:
            while block := voxels.read(1 << 20):
                raw.write(block)
    header = os.path.join(folder, stem + ".mhd")
    with open(header, "w", encoding="ascii") as lines:
        lines.write(
            "ObjectType = Image\n"
            "NDims = 3\n"
            f"DimSize = {' '.join(str(n) for n in reversed(shape))}\n"
            f"ElementSpacing = {' '.join(repr(float(s)) for s in spacing)}\n"
            f"ElementType = {types[kind]}\n"
            "ElementByteOrderMSB = False\n"
            f"ElementDataFile = {data}\n"
        )
    return header
