# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeSurfer's volumes (.mgz, .mgh) as Scans, read by nibabel."""

import numpy as np
from surfaceflattening_orientation import Placement, fault_of
from surfaceflattening_scans import Scan, ScanError

# The byte of the header that says whether it has an orientation. Where there is none, nibabel takes a usual one and does not
# say so.
GOOD_RAS = 28


class MGHScan(Scan):
    name = "MGH"

    def __init__(self, path, volume=0):
        try:
            from nibabel.freesurfer.mghformat import MGHImage
            from nibabel.openers import ImageOpener
        except ImportError:
            raise ScanError(
                f"{path}: volumes of FreeSurfer are read by nibabel, which this Python does not have: install the package "
                "python3-nibabel"
            ) from None
        self._path, self._volume = path, volume
        self._image = self._attempt(MGHImage.from_filename, path)
        shape, header, warnings = self._image.shape, self._image.header, []
        count = shape[3] if len(shape) > 3 else 1
        if not 0 <= volume < count:
            raise ScanError(f"{path}: there is no volume {volume}, but those from 0 to {count - 1}")
        if count > 1:
            warnings.append(f"the file has {count} volumes: volume {volume} is taken")
        matrix = np.array(self._image.affine, float)
        fault = fault_of(matrix)
        with ImageOpener(path) as stream:
            stream.seek(GOOD_RAS)
            placed = stream.read(2) != b"\0\0"
        if fault or not placed:
            reason = f"the matrix is left out, because {fault}" if fault else "the file does not say how the patient lies"
            warnings.append(f"{reason}: the volume stays as it is, and its left and right are as the voxels are stored")
            matrix = None
        placement = Placement(matrix, "none" if matrix is None else "FreeSurfer, scanner RAS", warnings)
        super().__init__(shape[:3], header.get_zooms()[:3], placement)

    def load(self):
        values = self._attempt(np.asarray, self._image.dataobj)
        values = values[..., self._volume] if values.ndim > 3 else values
        return values.astype(values.dtype.newbyteorder("="))

    def _attempt(self, read, *arguments):
        try:
            return read(*arguments)
        except Exception as error:  # nibabel has no exceptions of its own for damaged files
            reason = getattr(error, "strerror", None) or error
            raise ScanError(
                f"{self._path}: cannot be read, the file may be damaged or cut short: {reason}"
            ) from None
