# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the filter that was aborted has an empty output."""

from paraview import simple

flat = simple.GetActiveSource().GetClientSideObject().GetOutputDataObject(0)
print("After the abort:", flat.GetNumberOfPoints(), "points")
assert flat.GetNumberOfPoints() == 0, flat
