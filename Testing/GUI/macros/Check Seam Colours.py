# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the view shows the seam of the active source, whose colours are the same on both banks. An assertion
that fails is an error."""

from paraview import servermanager, simple

view, source = simple.GetActiveView(), simple.GetActiveSource()
shown = [d for d in view.Representations if getattr(d, "Visibility", 0) and hasattr(d, "ColorArrayName")]
banks = [d for d in shown if d.ColorArrayName[1] == "SeamDistance" and d.Input.Input == source]
assert len(banks) == 1 and len(shown) == 2, [d.Input for d in shown]
line = servermanager.Fetch(banks[0].Input)
along = line.GetPointData().GetArray("SeamDistance")
distances = [round(along.GetTuple1(k), 9) for k in range(line.GetNumberOfPoints())]
if source.GetXMLName() == "ConformalDisk":  # in space both banks lie in the same place
    inside = [d for d in distances if 0.0 < d < max(distances)]
    twice = [d for d in inside if inside.count(d) >= 2]
    # A point has no twin on the other bank where the triangles of its bank alone were divided.
    assert len(twice) > 0.6 * len(inside), sorted(distances)
points = banks[0].LookupTable.RGBPoints
assert points[0] == 0.0 and abs(points[-4] - max(distances)) < 1e-6, list(points)
