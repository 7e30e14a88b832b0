# SPDX-License-Identifier: GPL-3.0-or-later
"""PyVista's meshes have flatten(), which gives what surfaceflattening.flatten() gives. Skipped where PyVista is missing."""

import sys

try:
    import pyvista
except ImportError as error:
    print(f"PyVista is not there ({error}): on Debian 13 and newer, apt install python3-pyvista")
    sys.exit(77)
import numpy

if not hasattr(pyvista, "register_dataset_accessor"):  # before 0.48
    import surfaceflattening.accessors  # noqa: F401

ball = pyvista.Sphere(theta_resolution=40, phi_resolution=40)
ball["Height"] = ball.points[:, 2]
flat = ball.flatten(cut_mode="Seam")  # in newer ones the first access imports the package

import surfaceflattening  # noqa: E402

assert isinstance(flat, pyvista.PolyData), type(flat)
same = surfaceflattening.flatten(ball, cut_mode="Seam")
assert numpy.array_equal(flat.points, same.points)
assert numpy.allclose(flat["Height"], flat["SurfacePoints"][:, 2], atol=1e-6)
assert flat.field_data["FacesWithin2Percent"][0] > 99
assert numpy.abs(flat.points[:, 2]).max() == 0
try:
    pyvista.PolyData().flatten()
except surfaceflattening.FlatteningError as error:
    assert "no faces" in str(error)
else:
    raise AssertionError("no error for an empty mesh")
image = pyvista.ImageData(dimensions=(21, 21, 21), origin=(-10, -10, -10))
image["r"] = 20 - numpy.linalg.norm(image.points, axis=1)
skin = surfaceflattening.isosurface(image, 12, smoothing_mm=0)
assert isinstance(skin, pyvista.PolyData) and abs(skin.area / (4 * numpy.pi * 64) - 1) < 0.02, skin.area
