# SPDX-License-Identifier: GPL-3.0-or-later
"""The lenses of the gallery: factors from 0.25 to 8, one in the other, exact on cells and to 1 % on faces, and an
affine part of a map carried exactly."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Utilities/gallery"))

import meshes
import plane_lens
from paraview import simple

plane = plane_lens.conformal_disk(plane_lens.disk(1.0, 40), 1.0)
before = meshes.fetched(plane)
assert np.abs(before.Points - before.PointData["SurfacePoints"]).max() < 0.002, "the disk maps to itself, as it lies"


def between(inner, outer):
    def within(points):
        radius = np.hypot(points[:, 0], points[:, 1])
        return (radius >= inner) & (radius <= outer)

    return within


def expect(flat, region, factor):
    cells, faces = plane_lens.cell_factor(flat, region), plane_lens.face_factor(flat, region)
    assert abs(cells / factor - 1) < 1e-6, (factor, cells)
    assert abs(faces / factor - 1) < 0.01, (factor, faces)


RADIUS = 0.2625  # between rings
for factor in (0.25, 1, 2, 4, 8):
    flat = plane_lens.transport(plane_lens.magnify(plane, [0, 0, 0], RADIUS, factor))
    expect(flat, between(0, RADIUS), factor)

# Two, four and eight times, one within the other.
radii, factors = (0.3625, 0.2125, 0.1125), (2, 4, 8)
level = " + ".join(f"(mag(SurfacePoints) < {radius})" for radius in radii)
weights = simple.AreaWeights(
    Input=simple.Calculator(Input=plane, ResultArrayName="Level", ResultArrayType="Int", Function=level),
    WeightsFrom="Label Table",
    WeightArray=["POINTS", "Level"],
    FactorMeaning="Magnification",
    LabelFactors=[x for k, factor in enumerate(factors) for x in (k + 1, factor)],
)
flat = plane_lens.transport(weights)
for outer, inner, factor in zip(radii, (*radii[1:], 0), factors):
    expect(flat, between(inner, outer), factor)

# A ring of points goes where the area within says: radius 0.1 becomes sqrt(8) times as large.
angles = 2 * np.pi * np.arange(60) / 60
ring = np.column_stack([0.1 * np.cos(angles), 0.1 * np.sin(angles), 0 * angles])
carried = plane_lens.carried(flat, meshes.source_of(meshes.poly_data(ring, vertices=True)))
radius = np.linalg.norm(np.asarray(meshes.fetched(carried).Points), axis=1)
assert np.abs(radius / (0.1 * 8**0.5) - 1).max() < 0.02, radius
