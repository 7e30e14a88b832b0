# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: of two strips of a plane of area 1, the greater was flattened. An assertion that fails is an error."""

from paraview import simple

region = simple.GetActiveSource()
assert region.GetXMLName() == "FlattenRegion", region
area, dropped, pieces = (region.FieldData[name].GetRange()[0] for name in ("Area", "DroppedArea", "RegionPieces"))
assert pieces == 2, pieces
assert 0.05 < dropped < area < 0.6, (dropped, area)
# The strips are rows of squares with sides of a sixteenth.
assert all(abs(16 * a - round(16 * a)) < 1e-9 for a in (area, dropped)), (area, dropped)
