# SPDX-License-Identifier: GPL-3.0-or-later
"""A saved state, as .pvsm and as Python, brings the points and tables of the panels back, and the same numbers."""

import os

from paraview import servermanager, simple, smstate

folder = os.environ["TEMPORARY_DIRECTORY"]
SEAM = [-0.5, 0, 0, 0, 0.5, 0, 0.5, 0, 0]
FACTORS = [2, 3.0, 3, 0.5]
DEPTHS = [0.1, 0.2, 0.35]


def table(name):
    proxy = simple.FindSource(name)
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy, idx=1)
    return [
        [data.GetColumnName(c)] + [data.GetValue(r, c).ToString() for r in range(data.GetNumberOfRows())]
        for c in range(data.GetNumberOfColumns())
    ]


def memory():
    """The state of the session: settings with more than one value, and the results of the filters."""
    weights, slab = simple.FindSource("weights"), simple.FindSource("slab")
    weights.UpdatePipeline()
    slab.UpdatePipeline()
    return {
        "seam": list(simple.FindSource("disk").SeamPoints),
        "length": simple.FindSource("disk").FieldData["SeamLength"].GetRange(),
        "factors": list(weights.LabelFactors),
        "weight": weights.PointData["AreaWeight"].GetRange(),
        "depths": list(slab.Depths),
        "samples": slab.PointData["RTDataSlab"].GetRange(1),
        "summary": table("metrics"),
        "region": table("region"),
    }


ball = simple.Sphere(ThetaResolution=30, PhiResolution=30)
disk = simple.SurfaceToDisk(registrationName="disk", Input=ball, Cut="Seam", UseSeamPoints=1, SeamPoints=SEAM)
labelled = simple.Calculator(
    Input=disk,
    ResultArrayName="Label",
    ResultArrayType="Int",
    Function="if(coordsX > 0.3, 2, if(coordsX > 0.1, 3, 1))",
)
label = ["POINTS", "Label"]
weights = simple.AreaWeights(registrationName="weights", Input=labelled, WeightArray=label, WeightsFrom="Label Table")
weights.LabelFactors = FACTORS
flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=weights), UseAreaWeight=1)
simple.DistortionMetrics(registrationName="metrics", Input=flat, UseRegionArray=1, RegionArray=label)
simple.FlattenRegion(registrationName="region", Input=labelled, LabelArray=label, Label=2)
simple.FlatMapSlab(registrationName="slab", Input=flat, Volume=simple.Wavelet(), Depths=DEPTHS)

before = memory()
assert (before["seam"], before["factors"], before["depths"]) == (SEAM, FACTORS, DEPTHS), before
assert before["weight"][1] / before["weight"][0] > 5.9, before["weight"]
assert len(before["summary"][0]) == 5, before["summary"]  # a name, three regions, the total

state = os.path.join(folder, "tables.pvsm")
simple.SaveState(state)
script = smstate.get_state()

simple.ResetSession()
assert simple.FindSource("disk") is None
simple.LoadState(state)
assert memory() == before

simple.ResetSession()
assert simple.FindSource("disk") is None
exec(compile(script, "state.py", "exec"), {})
assert memory() == before
