# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: the file that was opened again holds the map in the layout, and the CSV file beside it its area. An
assertion that fails is an error."""

import csv
import math
import os
import time

from paraview import simple

read = simple.GetActiveSource()
flat = simple.FindSource("Area-preserving map, measured")
assert read.PointData.keys() == flat.PointData.keys(), read.PointData.keys()
for name in ("ScaledCurvature", "SurfacePoints"):
    assert read.PointData[name].GetRange() == flat.PointData[name].GetRange(), name
assert read.GetDataInformation().GetBounds() == flat.GetDataInformation().GetBounds()
path = list(read.FileName)[0]
table = path.replace(".vtp", "_Summary.csv")
# Both were written a moment ago, and not by an earlier run.
assert time.time() - 120 < os.path.getmtime(path) <= os.path.getmtime(table), (path, table)
with open(table, encoding="utf-8") as stream:
    (row,) = csv.DictReader(stream)
for name in ("SurfaceArea", "FlatArea", "FacesWithin2Percent"):
    figure = flat.FieldData[name].GetRange()[0]
    assert figure > 1 and math.isclose(float(row[name]), figure, rel_tol=1e-6), (name, row, figure)
