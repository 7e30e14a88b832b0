# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh Saliency by paraview.simple: every property, and its regions enlarged by Area Weights."""

from paraview import servermanager
from paraview.simple import AreaWeights, Calculator, MeshSaliency, Sphere

ball = Sphere(Radius=30, ThetaResolution=120, PhiResolution=120)
bumps = Calculator(
    Input=ball,
    CoordinateResults=1,
    Function="coords*(1 + 0.1*exp(80*(coordsY/30-1)) + 0.07*exp(120*(coordsX/30-1)))",
)
tested = {"Input"}


def saliency(**properties):
    """The output, and the values in its field data."""
    tested.update(properties)
    proxy = MeshSaliency(Input=bumps, **properties)
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    fields = data.GetFieldData()
    names = ("SaliencyUnit", "SaliencyThreshold", "SaliencyRegions")
    return data, {name: fields.GetArray(name).GetTuple1(0) for name in names if fields.HasArray(name)}


data, figures = saliency()
assert abs(figures["SaliencyUnit"] / (0.003 * data.GetLength()) - 1) < 1e-6
assert data.GetPointData().GetArray("SaliencyRegion").GetRange()[1] == figures["SaliencyRegions"] > 0
_, fewer = saliency(Percentile=98)
assert fewer["SaliencyThreshold"] > figures["SaliencyThreshold"]
value = {"ThresholdType": "Value", "Threshold": 0.5, "Unit": 0.8}
data, figures = saliency(MinimumRegionArea=10, **value)
assert figures["SaliencyThreshold"] == 0.5 and figures["SaliencyUnit"] == 0.8
assert figures["SaliencyRegions"] == 2
areas = data.GetFieldData().GetArray("SaliencyRegionAreas")
between = (areas.GetTuple1(0) + areas.GetTuple1(1)) / 2
_, figures = saliency(MinimumRegionArea=10, MaximumRegionArea=between, **value)
assert figures["SaliencyRegions"] == 1
data, figures = saliency(FindRegions=0, PerScaleArrays=1, NumberOfScales=3, AreaWeighted=0)
assert not data.GetPointData().HasArray("SaliencyRegion")
assert data.GetPointData().HasArray("SaliencyScale4")
assert not data.GetPointData().HasArray("SaliencyScale5")
assert saliency(Unit=100)[0].GetNumberOfPoints() == 0

regions = MeshSaliency(Input=bumps, MinimumRegionArea=10, **value)
enlarged = AreaWeights(Input=regions, WeightArray=["POINTS", "SaliencyRegion"], Label=1, Factor=4)
enlarged.UpdatePipeline()
weights = servermanager.Fetch(enlarged).GetPointData().GetArray("AreaWeight")
assert weights.GetRange() == (1, 4)

untested = set(MeshSaliency(Input=bumps).ListProperties()) - tested
assert not untested, untested
