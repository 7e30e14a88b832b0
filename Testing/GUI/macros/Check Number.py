# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the view of the surface shows the measures of what is selected. An assertion that fails is an
error."""

import re

from paraview import simple
from surfaceflattening_selection import measure_selection

flat = simple.FindSource("Area-preserving map, measured")
measures = measure_selection(flat)
whole = flat.FieldData["SurfaceArea"].GetRange()[0]
assert measures is not None and 0.01 * whole < measures.surface_area < 0.5 * whole, (measures, whole)
assert abs(measures.flat_area / measures.surface_area - 1) < 0.02, measures
text = next(source for (name, _id), source in simple.GetSources().items() if name.startswith("Selection"))
shown = float(re.search(r"area: ([\d.]+) on the surface", text.Text).group(1))
assert abs(shown - measures.surface_area) < 0.06, (text.Text, measures)
