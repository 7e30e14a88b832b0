# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the geodesic between the two seam points on opposite sides of a sphere of radius 0.5 is drawn.
An assertion that fails is an error."""

import math

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

hidden = simple.GetActiveView().SMProxy.GetProperty("HiddenRepresentations")
displays = [hidden.GetProxy(k) for k in range(hidden.GetNumberOfProxies())]
inputs = [d.GetProperty("Input").GetProxy(0) for d in displays if d.GetProperty("Input")]
previews = [servermanager._getPyProxy(i) for i in inputs if i.GetXMLName() == "SeamPreview"]
assert len(previews) == 1, [i.GetXMLName() for i in inputs]
line = servermanager.Fetch(previews[0])
assert line.GetNumberOfCells() == 1, line
points = vtk_to_numpy(line.GetPoints().GetData())
length = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1).sum()
# The points on the bounding box are not vertices: the line joins the vertices nearest to them.
assert 0.95 < length / (math.pi * 0.5) < 1.0, length
