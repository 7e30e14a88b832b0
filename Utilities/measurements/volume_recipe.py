# SPDX-License-Identifier: GPL-3.0-or-later
"""Leaves out each step from image to isosurface in turn and prints what comes of it, as the Markdown table in
docs/volumes.md. Needs Debian's package mricron-data:

    PV_PLUGIN_PATH=build/plugins pvpython Utilities/measurements/volume_recipe.py
"""

import os

from catalogue import TEMPLATES
from paraview import simple
from surface_checks import measure
from surfaceflattening_volume import cast_to_float, contour, isosurface, pad, smooth


def rows():
    """Yields a description of the steps and the surface."""
    brain = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    yield "brain, the whole recipe", isosurface(brain, 40).surface
    yield "brain, not cast to float", contour(smooth(pad(brain)), 40)
    yield "brain, not smoothed", isosurface(brain, 40, smoothing_mm=0).surface
    yield "brain, not smoothed, isovalue on voxel values", contour(pad(cast_to_float(brain)), 40)
    yield "brain, smoothed by 2 mm", isosurface(brain, 40, smoothing_mm=2).surface
    head = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2.nii.gz"))
    yield "head, the whole recipe", isosurface(head, 30).surface
    yield "head, not padded", isosurface(head, 30, padding=0).surface


print("| | points | components | Euler number | handles | boundaries | smallest angle |")
print("|" + " --- |" * 7)
for what, surface in rows():
    surface.UpdatePipeline()
    found = measure(surface.GetClientSideObject().GetOutput())
    handles = f"{found.genus:,}" if found.manifold else "not a manifold"
    print(
        f"| {what} | {found.vertices:,} | {found.components:,} | {found.euler_number:,} | {handles} "
        f"| {found.boundary_loops:,} | {found.smallest_angle:.2g}° |",
        flush=True,
    )
