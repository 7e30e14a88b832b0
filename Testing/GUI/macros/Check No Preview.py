# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the preview of a seam is gone, and the seam is drawn as a cut. An assertion that fails is an
error."""

from paraview import simple

view = simple.GetActiveView()
hidden = view.SMProxy.GetProperty("HiddenRepresentations")
displays = [hidden.GetProxy(k) for k in range(hidden.GetNumberOfProxies())]
inputs = [d.GetProperty("Input").GetProxy(0) for d in displays if d.GetProperty("Input")]
assert "SeamPreview" not in [i.GetXMLName() for i in inputs]
disk = simple.GetActiveSource()
assert disk.FieldData["SeamLength"].GetRange()[0] > 1.5, disk.FieldData["SeamLength"].GetRange()
cuts = simple.GetDisplayProperties(simple.OutputPort(disk, 1), view)
assert cuts.Visibility == 1
