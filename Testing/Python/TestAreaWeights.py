# SPDX-License-Identifier: GPL-3.0-or-later
"""Area Weights in a pipeline of paraview.simple: every property, an active selection, what goes wrong."""

import math

from paraview import servermanager
from paraview.simple import (
    AppendAttributes,
    AreaWeights,
    Calculator,
    ConformalDisk,
    IDSelectionSource,
    OMTAreaPreserving,
    Sphere,
    SurfaceToDisk,
)

ball = Sphere(Radius=40, ThetaResolution=60, PhiResolution=60)
labelled = Calculator(
    Input=SurfaceToDisk(Input=ball, Cut="Hole", HoleAreaFraction=0.01),
    ResultArrayName="Region",
    Function="1 + 22*(coordsX > 20)",
)
tested = {"Input"}


def weights(**properties):
    """The AreaWeight of all points and the values in the field data; empty if the filter failed."""
    tested.update(properties)
    proxy = AreaWeights(Input=labelled, **properties)
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    array = data.GetPointData().GetArray("AreaWeight")
    if not array:
        return [], {}
    fields = data.GetFieldData()
    names = ("RegionPoints", "RegionArea", "RegionFlatArea", "GreatestMagnification")
    figures = {name: fields.GetArray(name).GetTuple1(0) for name in names if fields.HasArray(name)}
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())], figures


surface = servermanager.Fetch(labelled)
points = range(surface.GetNumberOfPoints())
xs = [surface.GetPoint(i)[0] for i in points]
region = {"WeightArray": ["POINTS", "Region"]}

# --- One label, and its factor's meanings and edges ----------------------------------------------------------
values, figures = weights(Label=23, Factor=4, **region)
assert values == [4 if x > 20 else 1 for x in xs]
assert figures["RegionPoints"] == sum(x > 20 for x in xs)
assert math.isclose(figures["RegionArea"], 2 * math.pi * 40 * 20, rel_tol=0.05)
values, figures = weights(Label=23, Factor=3, FactorMeaning="Magnification", **region)
assert math.isclose(figures["GreatestMagnification"], 3)
assert math.isclose(figures["RegionFlatArea"] / figures["RegionArea"], 3)
soft, _ = weights(Label=23, Factor=4, EdgeWidth=20, **region)
assert all(weight == 4 for weight, x in zip(soft, xs) if x > 20)
assert all(1 < weight < 4 for weight, x in zip(soft, xs) if 8 < x < 16)
assert all(weight == 1 for weight, x in zip(soft, xs) if x < -5)

# --- A table, a curve ----------------------------------------------------------------------------------------
table = {"WeightsFrom": "Label Table", **region}
values, _ = weights(LabelFactors=[23, 2.5, 1, 0.5], **table)
assert values == [2.5 if x > 20 else 0.5 for x in xs]
values, _ = weights(LabelFactors=[23, 2.5], **table)
assert values == [2.5 if x > 20 else 1 for x in xs]
values, _ = weights(WeightsFrom="Scalars", TransferCurve=[1, 1, 21, 5], **region)
assert values == [5 if x > 20 else 1 for x in xs]

# --- A selection, an implicit function -----------------------------------------------------------------------
selection = IDSelectionSource(IDs=[-1, 3, -1, 70], FieldType="POINT")
values, _ = weights(WeightsFrom="Selection", Selection=selection)
assert values == [2 if i in (3, 70) else 1 for i in points]
proxy = AreaWeights(Input=labelled, WeightsFrom="Implicit Function", ImplicitFunction="Sphere")
proxy.ImplicitFunction.Center = [40, 0, 0]
proxy.ImplicitFunction.Radius = 20
for outside in (0, 1):
    proxy.InsideOut = outside
    proxy.UpdatePipeline()
    array = servermanager.Fetch(proxy).GetPointData().GetArray("AreaWeight")
    for i in points:
        inside = math.dist(surface.GetPoint(i), (40, 0, 0)) <= 20
        assert array.GetValue(i) == (2 if inside != bool(outside) else 1)
for kind in ("Box", "Plane", "Cylinder"):
    proxy.ImplicitFunction = kind
    proxy.UpdatePipeline()
flat = ConformalDisk(Input=labelled)
on_map = AreaWeights(Input=flat, WeightsFrom="Implicit Function", ImplicitFunction="Sphere")
on_map.PositionArray = ["POINTS", "SurfacePoints"]
on_map.ImplicitFunction.Center = [40, 0, 0]
on_map.ImplicitFunction.Radius = 20
on_map.UpdatePipeline()
array = servermanager.Fetch(on_map).GetPointData().GetArray("AreaWeight")
assert sum(array.GetValue(i) == 2 for i in points) == sum(
    math.dist(surface.GetPoint(i), (40, 0, 0)) <= 20 for i in points
)
tested.update({"ImplicitFunction", "InsideOut", "PositionArray"})

# --- OMT Area Preserving takes the weights without a choice of array ------------------------------------------
weighted = AreaWeights(Input=labelled, WeightArray=["POINTS", "Region"], Label=23, Factor=4)
disk = ConformalDisk(Input=weighted)
area_preserving = OMTAreaPreserving(Input=disk, UseAreaWeight=1)
area_preserving.UpdatePipeline()
data = servermanager.Fetch(area_preserving).GetPointData()
kept = OMTAreaPreserving(Input=disk, UseAreaWeight=0)
kept.UpdatePipeline()
plain = servermanager.Fetch(kept).GetPointData()


def share(arrays):
    cells = arrays.GetArray("CellArea")
    inside = math.fsum(cells.GetTuple1(i) for i in points if xs[i] > 20)
    return inside / (math.fsum(cells.GetTuple1(i) for i in points) - inside)


assert math.isclose(share(data) / share(plain), 4, rel_tol=1e-6)

# --- Without the array, neither the active nor the first of the others is taken for it ------------------------------
bare = ConformalDisk(Input=labelled)
arrays = bare.PointData.keys()
assert "AreaWeight" not in arrays and "ConformalFactor" in arrays, arrays
without = OMTAreaPreserving(Input=bare, UseAreaWeight=1)
assert without.AreaWeightArray[1] == "None", without.AreaWeightArray
without.UpdatePipeline()
assert without.GetDataInformation().GetNumberOfPoints() == bare.GetDataInformation().GetNumberOfPoints()


def weights_in_use(proxy):
    proxy.UpdatePropertyInformation()
    field = servermanager.Fetch(proxy).GetFieldData().GetAbstractArray("WeightsInUse").GetValue(0)
    assert proxy.WeightsInUse == field, (proxy.WeightsInUse, field)
    return field


assert weights_in_use(without) == "none"
assert weights_in_use(area_preserving) == "AreaWeight, 1 to 4"
assert weights_in_use(kept) == "none"
automatic = OMTAreaPreserving(Input=disk)  # with all defaults, the array is used because it is there
automatic.UpdatePipeline()
assert weights_in_use(automatic) == "AreaWeight, 1 to 4"
without.AreaWeightArray = ["POINTS", "AreaWeight"]  # asked for by name, and missing
without.UpdatePipeline()
assert without.GetDataInformation().GetNumberOfPoints() == 0

# --- After a change of the factor, from the map before -----------------------------------------------------------
conformal = ConformalDisk(Input=labelled)
once = OMTAreaPreserving(Input=conformal)
factor = AreaWeights(Input=AppendAttributes(Input=[conformal, once]), Label=23, Factor=2, **region)
again = OMTAreaPreserving(Input=factor, UseAreaWeight=1)
for value in (1.1, 1.2):
    factor.Factor = value
    again.UpdatePipeline()
    output = servermanager.Fetch(again)
    assert output.GetFieldData().GetArray("WarmStart").GetTuple1(0) == 1
    assert output.GetFieldData().GetArray("Bijective").GetTuple1(0) == 1
    grown = share(output.GetPointData()) / share(plain)
    assert math.isclose(grown, value, rel_tol=4e-6), grown  # each of four areas to 1e-6

# --- What is wrong leaves an empty output ----------------------------------------------------------------------
for properties in (
    {"Label": 99, **region},
    {"Label": 23, "Factor": -1, **region},
    {"Label": 23, "Factor": 50, "FactorMeaning": "Magnification", **region},
    {"WeightsFrom": "Selection"},
    {"LabelFactors": [], **table},
    {"LabelFactors": [23, 2.5, 1, 0.5], "FactorMeaning": "Magnification", **table},  # no rest
):
    values, _ = weights(**properties)
    assert values == [], properties

untested = set(AreaWeights(Input=labelled).ListProperties()) - tested
assert not untested, untested
