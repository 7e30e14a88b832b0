# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the result of Flatten Region is in a view of its own beside its input."""

from paraview import simple

region = simple.GetActiveSource()
assert region.GetXMLName() == "FlattenRegion", region
views = simple.GetRenderViews()
assert len(views) == 2, views
shown = [
    [d.Input.SMProxy for d in view.Representations if d.Visibility and hasattr(d, "Input")] for view in views
]
assert sorted(region.SMProxy in inputs for inputs in shown) == [False, True], shown
assert sorted(region.Input.SMProxy in inputs for inputs in shown) == [False, True], shown
