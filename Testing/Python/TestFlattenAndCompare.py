# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten and Compare: the layout, one colour scale, linked selections and the morph."""

import math

from paraview import servermanager, simple
from surfaceflattening_layout import COLOURED_BY, COLOUR_RANGE, flatten_and_compare

try:
    flatten_and_compare()
    raise AssertionError("no source, no error")
except ValueError as error:
    assert "pipeline browser" in str(error), error
image = simple.Wavelet()
try:
    flatten_and_compare(image)
    raise AssertionError("an image is no surface")
except ValueError as error:
    assert "Contour" in str(error), error
simple.Delete(image)

RADIUS = 10.0
sphere = simple.Sphere(ThetaResolution=48, PhiResolution=24, Radius=RADIUS, EndPhi=90.0, Center=[30, 40, 50])
simple.SetActiveSource(sphere)
comparison = flatten_and_compare()

views = simple.GetViewsInLayout(comparison.layout)
kinds = sorted(view.GetXMLName() for view in views)
assert kinds == 3 * ["RenderView"] + ["SpreadSheetView"] + 2 * ["XYBarChartView"], kinds
assert len(simple.GetLayouts()) == 1

# One colour scale, centred on zero, for all three views.
colours = simple.GetColorTransferFunction(COLOURED_BY)
assert (colours.RGBPoints[0], colours.RGBPoints[-4]) == COLOUR_RANGE, list(colours.RGBPoints)
for view in views:
    if view.GetXMLName() == "RenderView":
        tables = [r.LookupTable for r in view.Representations if r.GetProperty("LookupTable")]
        assert any(t is not None and t.SMProxy == colours.SMProxy for t in tables)

# A hemisphere: 2 pi r^2 in space and on the disk; the conformal map does not keep that.
figure = {
    name: flat.FieldData["FacesWithin2Percent"].GetRange()[0]
    for name, flat in (("conformal", comparison.conformal), ("transported", comparison.area_preserving))
}
assert figure["conformal"] < 20 < 95 < figure["transported"], figure
low_x, high_x, *_ = comparison.area_preserving.GetDataInformation().GetBounds()
assert math.isclose(high_x - low_x, 2 * math.sqrt(2) * RADIUS, rel_tol=0.01), (low_x, high_x)

# The morph: the surface at the start, flat at the end and at the surface's place.
morph = comparison.morph
scene = simple.GetAnimationScene()
bounds = morph.GetDataInformation().GetBounds()
assert math.isclose(bounds[5], 60.0, rel_tol=1e-6) and math.isclose(bounds[4], 50.0, abs_tol=1e-5), bounds
scene.GoToLast()
morph.UpdatePipeline()
bounds = morph.GetDataInformation().GetBounds()
assert math.isclose(bounds[4], bounds[5], abs_tol=1e-6), bounds
assert math.isclose((bounds[0] + bounds[1]) / 2, 30.0, rel_tol=1e-2), bounds
scene.GoToFirst()


# A selection in one view is a selection in all.
def selected(source):
    extracted = simple.ExtractSelection(Input=source)
    extracted.UpdatePipeline()
    count = extracted.GetDataInformation().GetNumberOfCells()
    simple.Delete(extracted)
    return count


sources = (comparison.morph, comparison.conformal, comparison.area_preserving)
ids = [cell for k in range(12) for cell in (0, 3 * k)]
for source in sources:
    selection = servermanager.sources.IDSelectionSource(IDs=ids, FieldType="CELL")
    appended = servermanager.filters.AppendSelections(
        Input=[selection], SelectionNames=["s0"], Expression="s0"
    )
    source.SMProxy.SetSelectionInput(0, appended.SMProxy, 0)
    counts = [selected(other) for other in sources]
    assert counts == [12, 12, 12], counts
    ids = ids[:-2] + [0, 100 + len(ids)]
