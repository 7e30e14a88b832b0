#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the picture of docs/volumes.md: slices of Debian's example brain where the patient is, with both thalami and the
cerebellum of the atlas, which is another file.

    PV_PLUGIN_PATH=build/plugins xvfb-run pvpython Utilities/pictures/scan_slices_picture.py docs/pictures/scan_slices.png
"""

import os
import sys

from paraview import simple
from surfaceflattening_scan_slices import show_scan_slices
from surfaceflattening_volume import label_surface

TEMPLATES = "/usr/share/mricron/templates"  # Debian's package mricron-data
THALAMI, CEREBELLUM = (77, 78), tuple(range(91, 117))  # in aal.nii.txt
SIZE = [600, 480]  # pixels

scan, atlas = (simple.OpenDataFile(os.path.join(TEMPLATES, name)) for name in ("ch2bet.nii.gz", "aal.nii.gz"))
view = simple.CreateView("RenderView")
view.ViewSize = SIZE
view.OrientationAxesVisibility = view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]


def show(source, colour):
    display = simple.Show(source, view)
    simple.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = colour


show(label_surface(atlas, THALAMI, name="Thalami").surface, [0.80, 0.20, 0.15])
show(label_surface(atlas, CEREBELLUM, name="Cerebellum").surface, [0.25, 0.45, 0.70])
sagittal, coronal, axial = show_scan_slices(scan, view)
axial.SliceType.Origin = [0, 0, 2]
simple.Hide(coronal, view)
view.CameraFocalPoint, view.CameraViewUp = [0, -17, 5], [0, 0, 1]
view.CameraPosition = [330, -250, 280]
view.CameraParallelProjection, view.CameraParallelScale = 1, 120
simple.SaveScreenshot(sys.argv[1], view, ImageResolution=SIZE)
