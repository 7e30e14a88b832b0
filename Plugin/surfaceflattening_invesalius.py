# SPDX-License-Identifier: GPL-3.0-or-later
"""The volume of an InVesalius project (.inv3) as a Scan."""

import tempfile

import numpy as np
from surfaceflattening_scans import ScanError
from surfaceflattening_voxel_files import MetaImageScan


class InVesaliusScan(MetaImageScan):
    """A project has no orientation of the patient, as its slices come from InVesalius's own reader."""

    def __init__(self, path):
        from surfaceflattening_volume import metaimage_of_invesalius

        self._folder = tempfile.TemporaryDirectory()
        try:
            super().__init__(metaimage_of_invesalius(path, self._folder.name))
        except (ValueError, OSError) as error:
            raise ScanError(str(error)) from None
        self.placement.warnings[:] = [
            "an InVesalius project does not say where the patient's left and right are: the volume stays as it is"
        ]

    def load(self):
        return np.array(super().load())
