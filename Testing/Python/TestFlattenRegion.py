# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten Region by paraview.simple: every property, its three outputs, and a region that is not a disk."""

import math

from paraview import servermanager
from paraview.simple import Calculator, FlattenRegion, IDSelectionSource, OutputPort, Sphere
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

ball = Sphere(Radius=20, ThetaResolution=120, PhiResolution=120)
labelled = Calculator(Input=ball, ResultArrayName="Region", Function="1 + 6*(coordsX > 12) - (coordsX > 19.5)")
tested = {"Input"}
region = {"LabelArray": ["POINTS", "Region"], "Label": 7}


def flat(**properties):
    """The filter and its table as {measure: (on surface, error, on map, unit)}."""
    tested.update(properties)
    proxy = FlattenRegion(Input=labelled, **properties)
    proxy.UpdatePipeline()
    table = servermanager.Fetch(proxy, idx=1)
    columns = ("OnSurface", "StandardDeviation", "OnMap", "Unit")
    rows = {}
    for i in range(table.GetNumberOfRows()):
        values = [table.GetValueByName(i, name) for name in columns]
        rows[table.GetValueByName(i, "Measure").ToString()] = [
            *(value.ToDouble() for value in values[:3]),
            values[3].ToString(),
        ]
    return proxy, rows


# The cap beyond x = 12, with a hole around its pole where the label is another.
proxy, rows = flat(**region)
angle = math.acos(12 / 20)
assert math.isclose(rows["Area"][0], 2 * math.pi * 400 * (1 - 0.6), rel_tol=0.02)
assert math.isclose(rows["Area"][2], rows["Area"][0], rel_tol=0.005)
assert math.isclose(rows["GreatestDiameter"][0], 40 * angle, rel_tol=0.03)
assert math.isclose(rows["Perimeter"][0], 2 * math.pi * 16, rel_tol=0.03)
assert rows["Area"][3] == "" and rows["Perimeter"][3] == ""
data = servermanager.Fetch(proxy)
assert data.GetFieldData().GetArray("FilledHoles").GetTuple1(0) == 1
assert data.GetCellData().GetArray("InRegion").GetRange() == (0, 1)
assert 0 < data.GetFieldData().GetArray("Margin").GetTuple1(0) < 10
assert OutputPort(proxy, 2).GetDataInformation().GetNumberOfCells() == 3
bare, _ = flat(AutomaticMargin=0, **region)
assert servermanager.Fetch(bare).GetCellData().GetArray("InRegion").GetRange() == (1, 1)
wide, _ = flat(AutomaticMargin=0, Margin=5, LengthUnit="cm", **region)
assert servermanager.Fetch(wide, idx=1).GetValueByName(0, "Unit").ToString() == "cm^2"
cells = servermanager.Fetch(wide).GetCellData().GetArray("InRegion")
assert cells.GetRange() == (0, 1)

surface = servermanager.Fetch(labelled)
behind = [i for i in range(surface.GetNumberOfPoints()) if surface.GetPoint(i)[0] < -12]
selection = IDSelectionSource(IDs=[v for i in behind for v in (-1, i)], FieldType="POINT")
chosen, rows = flat(RegionFrom="Selection", Selection=selection)
assert math.isclose(rows["Area"][0], 2 * math.pi * 400 * (1 - 0.6), rel_tol=0.02)

# A selection that is not connected: the largest piece is flattened, and one message says so.
ahead = [i for i in range(surface.GetNumberOfPoints()) if surface.GetPoint(i)[0] > 15]
selection = IDSelectionSource(IDs=[v for i in behind + ahead for v in (-1, i)], FieldType="POINT")
window, messages = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
vtkOutputWindow.SetInstance(messages)
apart, rows = flat(RegionFrom="Selection", Selection=selection)
vtkOutputWindow.SetInstance(window)
assert math.isclose(rows["Area"][0], 2 * math.pi * 400 * (1 - 0.6), rel_tol=0.02)
assert apart.FieldData["RegionPieces"].GetRange()[0] == 2
dropped = apart.FieldData["DroppedArea"].GetRange()[0]
assert math.isclose(dropped, 2 * math.pi * 400 * (1 - 0.75), rel_tol=0.04), dropped
text = messages.GetOutput()
assert text.count("the region is not connected") == 1 and f"1 piece with an area of {dropped:.6g} was left out" in text, text

# A region that is not a disk: the message names the remedy, which works.
failed, rows = flat(LargestHoles=0, **region)
assert rows == {} and failed.GetDataInformation().GetNumberOfCells() == 0

untested = set(FlattenRegion(Input=labelled).ListProperties()) - tested
assert not untested, untested
