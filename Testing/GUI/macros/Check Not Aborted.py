# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the filter that was aborted and applied again has the whole map, with its areas."""

from paraview import simple

active = simple.GetActiveSource()
flat = active.GetClientSideObject().GetOutputDataObject(0)
conformal = active.Input.GetClientSideObject().GetOutputDataObject(0)
print("After Apply:", flat.GetNumberOfPoints(), "points")
assert flat.GetNumberOfPoints() == conformal.GetNumberOfPoints() > 0, flat
assert flat.GetFieldData().GetArray("Bijective").GetTuple1(0) == 1, flat
