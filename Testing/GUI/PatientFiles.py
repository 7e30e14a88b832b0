# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the files that PatientSpace.xml and FlattenCortex.xml open, in the folder that is given: a DICOM series of a
ball with an ear on the patient's right, stored so that its columns lead to the left, and a hemisphere of FreeSurfer with
an annotation, written by nibabel."""

import os
import sys

import numpy as np
from nibabel.freesurfer import io as freesurfer

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
import VolumeFiles  # noqa: E402

LPS_OF_RAS = np.diag([-1.0, -1.0, 1.0, 1.0])


def series(folder):
    """Columns lead to the patient's left, rows to the bottom, slices to the front: a coronal series."""
    affine = np.array([[-1.0, 0, 0, 30], [0, 0, 1.5, -18], [0, -1.0, 0, 25], [0, 0, 0, 1]])
    i, j, k = np.meshgrid(*(np.arange(n) for n in (54, 50, 25)), indexing="ij")
    x, y, z = (affine[row, 0] * i + affine[row, 1] * j + affine[row, 2] * k + affine[row, 3] for row in range(3))
    ball = 13 - np.sqrt(x**2 + y**2 + z**2)
    ear = 5 - np.sqrt((x - 15) ** 2 + y**2 + z**2)
    values = np.clip(300 + 100 * np.maximum(ball, ear), -1000, 2000).astype(np.int16)
    VolumeFiles.write_dicom_series(folder, values.T, None, LPS_OF_RAS @ affine)


def hemisphere(folder):
    """An ellipsoid in rings of 24 points, with a medial wall and two regions."""
    rings, around = 20, 24
    up = np.linspace(0, np.pi, rings)[1:-1]
    turn = np.arange(around) * 2 * np.pi / around
    middle = [(np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)) for a in up for b in turn]
    points = np.array([(0, 0, 1), *middle, (0, 0, -1)]) * (30, 60, 40) - (32, 0, 0)
    last = len(points) - 1
    faces = []
    for k in range(around):
        right = (k + 1) % around
        faces.append((0, 1 + k, 1 + right))
        faces.append((last, last - around + right, last - around + k))
        for ring in range(rings - 3):
            a, b = 1 + ring * around + k, 1 + ring * around + right
            faces += [(a, a + around, b), (b, a + around, b + around)]
    labels = np.where(points[:, 1] < 0, 1, 2)
    labels[(points[:, 0] > -8) & (np.hypot(points[:, 1], points[:, 2]) < 25)] = 0
    table = np.array([[25, 5, 25, 0, 0], [60, 20, 220, 0, 0], [255, 192, 32, 0, 0]])
    os.makedirs(folder, exist_ok=True)
    freesurfer.write_geometry(os.path.join(folder, "lh.pial"), points, np.array(faces))
    freesurfer.write_annot(
        os.path.join(folder, "lh.parts.annot"), labels, table, ["unknown", "back", "front"], fill_ctab=True
    )


series(os.path.join(sys.argv[1], "series"))
hemisphere(os.path.join(sys.argv[1], "subject"))
