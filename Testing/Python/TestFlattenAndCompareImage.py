# SPDX-License-Identifier: GPL-3.0-or-later
"""The image of the layout of Flatten and Compare, with the shares of faces that keep their area; the image differs if the
colours have another range or two views change places."""

import os
import tempfile

from ImageBaseline import expect_baseline, expect_not_baseline
from paraview import simple
from surfaceflattening_colours import ANATOMY
from surfaceflattening_layout import flatten_and_compare

NAME = "FlattenAndCompare"
SIZE = [600, 400]
folder = tempfile.mkdtemp(dir=os.environ.get("TEMPORARY_DIRECTORY"))

# A hill whose top is off the centre of a rectangle, so that there is no doubt how its map is turned.
plane = simple.Plane(
    Origin=[-1.2, -1.0, 0.0], Point1=[1.2, -1.0, 0.0], Point2=[-1.2, 1.0, 0.0], XResolution=30, YResolution=25
)
hill = simple.Calculator(
    Input=simple.Triangulate(Input=plane),
    CoordinateResults=1,
    Function="coordsX*iHat + coordsY*jHat + exp(-4*((coordsX-0.3)^2 + (coordsY-0.2)^2))*kHat",
)
comparison = flatten_and_compare(hill)
views = simple.GetViewsInLayout(comparison.layout)
for view in views:
    if view.GetXMLName() == "RenderView":
        view.UseFXAA = 0
        view.UseColorPaletteForBackground = 0  # ParaView 6 has another colour
        view.Background = [0.32, 0.34, 0.43]


def screenshot(name):
    path = os.path.join(folder, name + ".png")
    simple.SaveScreenshot(path, comparison.layout, ImageResolution=SIZE)
    return path


expect_baseline(screenshot(NAME), NAME)
conformal, transported = (
    flat.FieldData["FacesWithin2Percent"].GetRange()[0]
    for flat in (comparison.conformal, comparison.area_preserving)
)
assert conformal < 20 < 80 < transported, (conformal, transported)

colours = simple.GetColorTransferFunction(ANATOMY[1])
colours.RescaleTransferFunction(-4.5, 4.5)
expect_not_baseline(screenshot("range"), NAME, "another range of colours")
colours.RescaleTransferFunction(-1.5, 1.5)

exchanged = [view for view in views if view.GetXMLName() == "RenderView"][1:]
comparison.layout.SwapCells(*(comparison.layout.GetViewLocation(view) for view in exchanged))
expect_not_baseline(screenshot("swapped"), NAME, "two views that have changed places")
