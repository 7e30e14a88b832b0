# SPDX-License-Identifier: GPL-3.0-or-later
"""Real scans that Debian packages bring, and the isosurfaces that are taken of them."""

import os
from dataclasses import dataclass

TEMPLATES = "/usr/share/mricron/templates"  # package mricron-data
SKULL = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3"  # package invesalius-examples


@dataclass(frozen=True)
class ScanSurface:
    path: str
    isovalue: float
    smoothing: float  # mm
    what: str

    @property
    def name(self):
        scan = os.path.basename(self.path).split(".")[0]
        return f"{scan} iso {self.isovalue:g} sigma {self.smoothing:g} mm"


def _surfaces(path, *isosurfaces):
    return [ScanSurface(path, *isosurface) for isosurface in isosurfaces]


def _template(name):
    return os.path.join(TEMPLATES, name)


SURFACES = [
    *_surfaces(
        _template("ch2bet.nii.gz"),
        (40, 1, "brain"),
        (75, 1, "grey matter"),
    ),
    *_surfaces(
        _template("ch2better.nii.gz"),  # 0.5 mm
        (60, 0.5, "brain"),
    ),
    *_surfaces(
        _template("inia19-t1-brain.nii.gz"),  # macaque, 0.5 mm
        (45, 0.5, "brain"),
        (60, 0.5, "grey matter"),
        (95, 0.5, "white matter"),
    ),
    *_surfaces(
        _template("ch2.nii.gz"),
        (30, 1, "skin"),
        (60, 1, "skin and brain"),
        (100, 1, "white matter"),
    ),
    *_surfaces(
        SKULL,  # 0.957 x 0.957 x 1.5 mm, HU
        (200, 1, "spongy bone"),
        (300, 1, "bone"),
        (400, 1, "compact bone"),
    ),
]
