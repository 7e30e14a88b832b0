# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the cuts are drawn on the disk in one colour, and the camera is where the test put it."""

from paraview import simple

view = simple.GetActiveView()
disk = simple.GetActiveSource()
assert disk.GetXMLName() == "SurfaceToDisk", disk
cuts = simple.GetDisplayProperties(simple.OutputPort(disk, 1), view)
assert cuts.Visibility == 1 and cuts.LineWidth == 4.0 and not cuts.ColorArrayName[1], cuts.ColorArrayName
assert simple.GetDisplayProperties(simple.OutputPort(disk, 0), view).Visibility == 1
assert view.InteractionMode == "3D", view.InteractionMode
x, y, z = (a - b for a, b in zip(view.CameraPosition, view.CameraFocalPoint))
assert x < 0 and abs(y) < 1e-6 and abs(z) < 1e-6, (x, y, z)  # the view from -X to +X
