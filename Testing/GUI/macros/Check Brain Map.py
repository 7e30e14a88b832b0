# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the brain was found, and is flat, with its anatomy in all three views. An assertion that fails is an error."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

surface = simple.FindSource("Surface of the scan")
isovalue, area = surface.FieldData["Isovalue"].GetRange()[0], simple.GetActiveSource().FieldData["SurfaceArea"].GetRange()[0]
assert 40 < isovalue < 50, isovalue
assert 84000 < area < 94000, area
flat = simple.GetActiveSource()
assert flat.FieldData["FacesWithin2Percent"].GetRange()[0] > 99.0, flat.FieldData["FacesWithin2Percent"].GetRange()
assert flat.FieldData["FlippedFaces"].GetRange()[0] == 0
shown = [
    display
    for view in simple.GetRenderViews()
    for display in view.Representations
    if getattr(display, "Visibility", 0) and getattr(display, "ColorArrayName", [None, None])[1] == "ScaledCurvature"
]
assert len(shown) == 3, shown
# The anatomy has contrast: of a blank map one value would be everywhere.
curvature = vtk_to_numpy(servermanager.Fetch(flat).GetPointData().GetArray("ScaledCurvature"))
assert numpy.percentile(curvature, 95) - numpy.percentile(curvature, 5) > 0.5, numpy.percentile(curvature, [5, 95])
