# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package works in plain Python and in pvpython: a stretched square is measured."""

import math

from surfaceflattening import vtkDistortionMetrics
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

# The surface is the flat square stretched by 4 along x: Gamma / gamma = 4 everywhere.
corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
points, cells, surface = vtkPoints(), vtkCellArray(), vtkDoubleArray()
surface.SetName("SurfacePoints")
surface.SetNumberOfComponents(3)
for x, y in corners:
    points.InsertNextPoint(x, y, 0)
    surface.InsertNextTuple3(4 * x, y, 7)
for triangle in [(0, 1, 2), (0, 2, 3)]:
    cells.InsertNextCell(3, triangle)
flattened = vtkPolyData()
flattened.SetPoints(points)
flattened.SetPolys(cells)
flattened.GetPointData().AddArray(surface)

metrics = vtkDistortionMetrics()
metrics.SetInputData(flattened)
metrics.Update()
output = metrics.GetOutput()
angle = output.GetCellData().GetArray("AngleDistortion")
area = output.GetCellData().GetArray("AreaDistortion")
assert output.GetNumberOfCells() == 2
for cell in range(2):
    assert abs(angle.GetValue(cell) - math.log(4)) < 1e-14, angle.GetValue(cell)
    assert abs(area.GetValue(cell)) < 1e-14, area.GetValue(cell)
summary = metrics.GetSummary()
assert summary.GetNumberOfRows() == 1
assert summary.GetValueByName(0, "Region").ToString() == "Total"
assert summary.GetValueByName(0, "SurfaceArea").ToDouble() == 4
assert summary.GetValueByName(0, "FlatArea").ToDouble() == 1
