# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: a flat map is seen from above, with its folds. An assertion that fails is an error."""

from paraview import simple

view = simple.GetActiveView()
assert view.InteractionMode == "2D", view.InteractionMode
position, focus = list(view.CameraPosition), list(view.CameraFocalPoint)
assert position[:2] == focus[:2] and position[2] > focus[2], (position, focus)
display = simple.GetDisplayProperties(simple.GetActiveSource(), view)
assert tuple(display.ColorArrayName) == ("POINTS", "ScaledCurvature"), display.ColorArrayName
points = display.LookupTable.RGBPoints
assert (points[0], points[-4]) == (-1.5, 1.5), list(points)
shown = [d for d in view.Representations if getattr(d, "Visibility", 0) and hasattr(d, "ColorArrayName")]
assert len(shown) == 1, shown  # the cuts of the surface in space are hidden with it
