# SPDX-License-Identifier: GPL-3.0-or-later
"""The image of the isosurface that Volume Preparation makes of voxels, and its area; images of isosurfaces for which a
step was left out differ."""

import math
import os
import tempfile

import numpy
from ImageBaseline import expect_baseline, expect_not_baseline
from paraview import simple
from surfaceflattening_volume import cast_to_float, contour, isosurface, pad, smooth
from VolumeFiles import write_nifti

NAME = "VolumePreparation"
folder = tempfile.mkdtemp(dir=os.environ.get("TEMPORARY_DIRECTORY"))

# A ball of radius 7 mm in 14 x 14 x 14 voxels of 1.5 mm, cut off by the border of the volume, in few whole numbers.
z, y, x = numpy.meshgrid(*3 * [1.5 * numpy.arange(14.0)], indexing="ij")
distance = numpy.sqrt((x - 5) ** 2 + (y - 10) ** 2 + (z - 11) ** 2)
scan = os.path.join(folder, "ball.nii")
write_nifti(scan, numpy.rint(numpy.clip(4 * (8.5 - distance), 0, 12)).astype(numpy.int16), (1.5, 1.5, 1.5))
volume = simple.OpenDataFile(scan)

view = simple.CreateView("RenderView")
view.ViewSize = [200, 200]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.UseFXAA = 0
view.CameraParallelProjection = 1
view.CameraFocalPoint = [5.0, 10.0, 11.0]
view.CameraPosition = [-45.0, -10.0, 31.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraParallelScale = 9.0


def image_of(surface, name):
    display = simple.Show(surface, view)
    display.ColorArrayName = ["POINTS", ""]
    display.SetRepresentationType("Surface With Edges")
    display.AmbientColor = display.DiffuseColor = [0.9, 0.7, 0.3]
    display.EdgeColor = [0.0, 0.0, 0.0]
    display.BackfaceRepresentation = "Cull Backface"
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    path = os.path.join(folder, name + ".png")
    simple.SaveScreenshot(path, view, ImageResolution=[200, 200])
    simple.Hide(surface, view)
    return path


def area_of(surface):
    measured = simple.IntegrateVariables(Input=surface)
    measured.UpdatePipeline()
    return measured.CellData["Area"].GetRange()[0]


surface = isosurface(volume, 6).surface
expect_baseline(image_of(surface, NAME), NAME)
area = area_of(surface)
# A Gaussian of standard deviation s moves the isosurface of a ball of radius r inwards by s^2 / r.
assert math.isclose(area, 4 * math.pi * (7.0 - 1.0 / 7.0) ** 2, rel_tol=0.03), area
bounds = surface.GetDataInformation().GetBounds()
assert bounds[0] < 0, bounds  # closed beyond the border of the volume

wrong = {
    "whole numbers": contour(smooth(pad(volume)), 6),
    "not padded": contour(smooth(cast_to_float(volume)), 6),
    "smoothed by 2 mm": isosurface(volume, 6, smoothing_mm=2).surface,
}
for name, other in wrong.items():
    expect_not_baseline(image_of(other, name.replace(" ", "_")), NAME, name)
