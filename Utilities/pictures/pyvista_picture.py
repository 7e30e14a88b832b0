# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/pictures/pyvista.png with PyVista alone: half a brain, its flat map with the folds, and the errors of areas.

    PYTHONPATH=build-vtk/lib/python3/dist-packages xvfb-run -a python3 Utilities/pictures/pyvista_picture.py docs/pictures/pyvista.png
"""

import sys

import pyvista as pv
from surfaceflattening import accessors, isosurface  # noqa: F401  accessors for PyVista before 0.48

scan = pv.read("/usr/share/mricron/templates/ch2bet.nii.gz")
brain = isosurface(scan, 40, smoothing_mm=2)
flat = brain.flatten(cut_mode="Plane", plane_origin=(90, 0, 0), remesh=True)
surface = flat.copy()
surface.points = flat["SurfacePoints"]

plotter = pv.Plotter(shape=(1, 3), off_screen=True, window_size=(1500, 520), border=False)
pictures = (
    (surface, "ScaledCurvature", "gray", None, "The surface, with its folds"),
    (flat, "ScaledCurvature", "gray", None, "The map, with the same folds"),
    (flat, "AreaRatio", "coolwarm", (0.98, 1.02), "Area on the map by area on the surface"),
)
for column, (mesh, array, colours, limits, title) in enumerate(pictures):
    plotter.subplot(0, column)
    plotter.add_text(title, font_size=11, position="upper_edge")
    has_bar = limits is not None
    plotter.add_mesh(
        mesh.copy(), scalars=array, cmap=colours, clim=limits, lighting=mesh is surface, show_scalar_bar=has_bar,
        scalar_bar_args={"title": "", "position_x": 0.2, "position_y": 0.01, "height": 0.08} if has_bar else None,
    )
    if mesh is surface:
        plotter.view_yz()
    else:
        plotter.view_xy()
    plotter.camera.zoom(1.3 if mesh is surface else 1.15)
plotter.screenshot(sys.argv[1])
