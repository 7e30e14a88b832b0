# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of Area Weights filled from the labels in the data: more labels than a colour map takes, of points
and of cells, and none where there are no labels."""

import os
import sys

from paraview import simple

simple.LoadPlugin(
    os.path.join(os.environ["PV_PLUGIN_PATH"], "SurfaceFlattening", "SurfaceFlattening.so"), ns=globals()
)
from surfaceflattening_regions import fill_region_factors  # noqa: E402


def refused(weights, words):
    try:
        fill_region_factors(weights)
    except ValueError as error:
        assert words in str(error), error
    else:
        raise AssertionError(f"no error about {words}")


sphere = simple.Sphere(ThetaResolution=80, PhiResolution=20, EndPhi=120)
# 40 stripes with the labels 3, 5, 7, ..., 81.
stripes = "3+2*floor(39.999*(coordsX+0.5))"
points = simple.Calculator(Input=sphere, ResultArrayName="Stripe", Function=stripes)
both = simple.Calculator(
    Input=simple.PointDatatoCellData(Input=points, ProcessAllArrays=1, PassPointData=1),
    AttributeType="Cell Data",
    ResultArrayName="Half",
    Function="floor(Stripe/42)",
)
both.UpdatePipeline()

weights = AreaWeights(Input=both, WeightArray=["POINTS", "Stripe"])  # noqa: F821
fill_region_factors(weights)
found = [round(label) for label in weights.LabelFactors[0::2]]
stripe = both.PointData["Stripe"]
assert found[0] == stripe.GetRange()[0] and found[-1] == stripe.GetRange()[1], found
assert len(found) > 32 and all(label % 2 == 1 for label in found), found
assert set(weights.LabelFactors[1::2]) == {1.0}
assert weights.WeightsFrom == "Label Table"

# A factor that was typed in stays, and the filter takes the table.
table = list(weights.LabelFactors)
table[2 * found.index(41) + 1] = 4.0
weights.LabelFactors = table
fill_region_factors(weights)
assert list(weights.LabelFactors) == table
weights.UpdatePipeline()
low, high = weights.PointData["AreaWeight"].GetRange()
assert abs(high / low - 4) < 1e-12, (low, high)

cells = AreaWeights(Input=both, WeightArray=["CELLS", "Half"])  # noqa: F821
fill_region_factors(cells, factor=2.0)
assert list(cells.LabelFactors) == [0.0, 2.0, 1.0, 2.0], list(cells.LabelFactors)

refused(sphere, "select an Area Weights")
refused(AreaWeights(Input=both), "choose the Weight Array")  # noqa: F821
values = simple.Calculator(Input=sphere, ResultArrayName="Height", Function="coordsX")
refused(AreaWeights(Input=values, WeightArray=["POINTS", "Height"]), "whole numbers")  # noqa: F821
sys.exit(0)
