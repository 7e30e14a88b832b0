# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten and Compare: the layout, its colours and outlines, linked and measured selections, the morph; the same again, its
undo, and bad input, after which nothing is left."""

import math

from paraview import servermanager, simple
from surfaceflattening_colours import ANATOMY, DISTORTION, switch_colours
from surfaceflattening_layout import do_again, flatten_and_compare, take_back
from surfaceflattening_outlines import label_array, label_outlines
from surfaceflattening_selection import measure_selection, percent
from surfaceflattening_views import measured_errors, nice_length


def expect_refusal(source, word):
    """An error with the word, and as many proxies as before."""
    before = len(simple.GetSources()), len(simple.GetLayouts()), len(simple.GetViews())
    try:
        flatten_and_compare(source)
        raise AssertionError(f"no error that says {word}")
    except (ValueError, RuntimeError) as error:
        assert word in str(error), error
    assert before == (len(simple.GetSources()), len(simple.GetLayouts()), len(simple.GetViews())), before


try:
    flatten_and_compare()
    raise AssertionError("no source, no error")
except ValueError as error:
    assert "pipeline browser" in str(error), error
image = simple.Wavelet()
expect_refusal(simple.Tetrahedralize(Input=image), "Extract Surface")
cloud = simple.PointSource(NumberOfPoints=100)
expect_refusal(cloud, "Surface To Disk has no output")  # a message says that there are no triangles
strip = simple.ProgrammableSource(  # a Moebius strip: the first of the filters fails
    Script="""
import math
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
points, cells = vtkPoints(), vtkCellArray()
n = 40
for i in range(n):
    a = 2 * math.pi * i / n
    for s in (-0.3, 0.3):
        r = 1 + s * math.cos(a / 2)
        points.InsertNextPoint(r * math.cos(a), r * math.sin(a), s * math.sin(a / 2))
for i in range(n):
    a, b = 2 * i, 2 * i + 1
    c, d = (2 * i + 2, 2 * i + 3) if i + 1 < n else (1, 0)
    for ids in ((a, b, c), (b, d, c)):
        cells.InsertNextCell(3, ids)
self.GetOutputDataObject(0).SetPoints(points)
self.GetOutputDataObject(0).SetPolys(cells)
"""
)
expect_refusal(strip, "Surface To Disk has no output")
for source in (image, cloud, strip):
    simple.Delete(source)

RADIUS = 10.0
sphere = simple.Sphere(ThetaResolution=48, PhiResolution=24, Radius=RADIUS, EndPhi=90.0, Center=[30, 40, 50])
simple.SetActiveSource(sphere)
comparison = flatten_and_compare()

views = simple.GetViewsInLayout(comparison.layout)
kinds = sorted(view.GetXMLName() for view in views)
assert kinds == 3 * ["RenderView"] + ["SpreadSheetView"] + 2 * ["XYBarChartView"], kinds
assert len(simple.GetLayouts()) == 1

# The anatomy in all three views, by one fixed grey scale; switched to the distortion, which is centred on zero.
def coloured_by():
    maps = [comparison.morph, comparison.conformal, comparison.area_preserving]
    return [
        tuple(display.ColorArrayName)
        for view in views
        if view.GetXMLName() == "RenderView"
        for display in view.Representations
        if getattr(display, "Input", None) in maps
    ]


def colour_range(array):
    points = simple.GetColorTransferFunction(array).RGBPoints
    return points[0], points[-4]


assert coloured_by() == 3 * [ANATOMY], coloured_by()
assert colour_range(ANATOMY[1]) == (-1.5, 1.5), colour_range(ANATOMY[1])
switch_colours(views[0])
assert coloured_by() == 3 * [DISTORTION], coloured_by()
low, high = colour_range(DISTORTION[1])
assert math.isclose(low, math.log(2 / 3), rel_tol=1e-5) and math.isclose(high, math.log(1.5), rel_tol=1e-5)
annotations = list(simple.GetColorTransferFunction(DISTORTION[1]).Annotations)
for value, words in zip(annotations[::2], annotations[1::2]):
    assert math.isclose(100 * (math.exp(float(value)) - 1), float(words.split()[0]), abs_tol=0.5), words
switch_colours(views[0])
assert coloured_by() == 3 * [ANATOMY], coloured_by()
assert percent(181.2) == "181 %" and percent(0.2345) == "0.23 %", percent(181.2)
assert "e+" not in measured_errors(comparison.conformal), measured_errors(comparison.conformal)
assert [nice_length(x) for x in (0.3, 7.0, 99.0, 1.0)] == [0.2, 5.0, 50.0, 1.0]
for view in views:
    if view.GetXMLName() == "XYBarChartView":
        assert view.BottomAxisLabels[-1] == "\N{GREATER-THAN OR EQUAL TO} 1.5", list(view.BottomAxisLabels)

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


# What is selected is measured. A fifth of the hemisphere, by its cells, on the surface and on the map.
def select(source, ids, kind):
    selection = servermanager.sources.IDSelectionSource(IDs=[k for i in ids for k in (0, i)], FieldType=kind)
    appended = servermanager.filters.AppendSelections(
        Input=[selection], SelectionNames=["s0"], Expression="s0"
    )
    source.SMProxy.SetSelectionInput(0, appended.SMProxy, 0)


measured = comparison.area_preserving
data = servermanager.Fetch(measured)
total = comparison.area_preserving.FieldData["SurfaceArea"].GetRange()[0]
select(comparison.morph, range(data.GetNumberOfCells()), "CELL")
whole = measure_selection(measured)
assert whole.faces == data.GetNumberOfCells()
assert math.isclose(whole.surface_area, total, rel_tol=1e-9), (whole.surface_area, total)
flat_area = measured.FieldData["FlatArea"].GetRange()[0]  # of a polygon in the disk
assert math.isclose(whole.flat_area, flat_area, rel_tol=1e-9), (whole.flat_area, flat_area)
assert math.isclose(whole.extent[0], 2 * RADIUS, rel_tol=0.01), whole.extent
assert math.isclose(whole.centroid[2], 50 + RADIUS / 2, rel_tol=0.01), whole.centroid
mean = measured.FieldData["AreaWeightedMeanAreaError"].GetRange()[0]
assert math.isclose(whole.area_error, mean, rel_tol=1e-3), (whole.area_error, mean)
select(comparison.morph, range(data.GetNumberOfPoints()), "POINT")
points = measure_selection(measured)
assert math.isclose(points.surface_area, total, rel_tol=1e-9), points
select(comparison.conformal, range(0, data.GetNumberOfCells(), 5), "CELL")
part = measure_selection(measured)
assert part.faces == -(-data.GetNumberOfCells() // 5), part
text = simple.FindSource("Selection")
assert f"{part.surface_area:.1f} on the surface" in text.Text, text.Text
select(comparison.morph, [3], "POINT")  # a triangle counts as a third
corner = measure_selection(measured)
touching = [
    data.GetCell(c).ComputeArea()
    for c in range(data.GetNumberOfCells())
    if 3 in [data.GetCell(c).GetPointId(k) for k in range(3)]
]
assert math.isclose(corner.flat_area, sum(touching) / 3, rel_tol=1e-6), (corner, sum(touching))
assert f"Selection: {len(touching)} triangles" in text.Text, text.Text

# Outlines of labels on cells and on points: the equator between two halves, 2 pi r / 2 long on the surface.
for association, attribute in (("CELLS", "Cell Data"), ("POINTS", "Point Data")):
    labelled = simple.ProgrammableFilter(
        Input=sphere,
        Script=f"""
import numpy
at = inputs[0].Points[:, 0]
if {association == 'CELLS'}:
    faces = inputs[0].Polygons.reshape(-1, 4)[:, 1:]
    at = at[faces].mean(axis=1)
output.{'CellData' if association == 'CELLS' else 'PointData'}.append((at > 30.0).astype(numpy.int32), "Side")
""",
    )
    labelled.UpdatePipeline()
    assert label_array(labelled) == (association, "Side"), label_array(labelled)
    outlines = label_outlines(labelled, association, "Side")
    lengths = simple.IntegrateVariables(Input=outlines)
    lengths.UpdatePipeline()
    length = servermanager.Fetch(lengths).GetCellData().GetArray("Length").GetTuple1(0)
    assert math.isclose(length, math.pi * RADIUS, rel_tol=0.1), length
assert label_array(sphere) is None

# Again, with its own names, and with outlines; then taken back.
names = set(simple.GetSources())
again = flatten_and_compare(labelled)
added = set(simple.GetSources()) - names
assert ("Surface to disk 2" in {name for name, _ in added}) and len(simple.GetLayouts()) == 2, added
assert any(name.startswith("Outlines of Side") for name, _ in added), added
assert not {name for name, _ in names} & {name for name, _ in added}, "a name twice"
again_on_disk = flatten_and_compare(again.disk)  # a disk passes unchanged
counts = [p.GetDataInformation().GetNumberOfPoints() for p in (again.disk, again_on_disk.disk)]
assert counts[0] == counts[1], counts
take_back()
take_back()
assert set(simple.GetSources()) == names, set(simple.GetSources()) ^ names
assert len(simple.GetLayouts()) == 1

# A scan: its surface is taken first. Taken back, done again and taken back, nothing of it is left, twice.
ball = simple.Calculator(Input=image, ResultArrayName="RTData", Function="if(mag(coords)<6, 100, 0)")
scanned = flatten_and_compare(ball)
surface = simple.FindSource("Surface of the scan")
isovalue = surface.FieldData["Isovalue"].GetRange()[0]
area = scanned.area_preserving.FieldData["SurfaceArea"].GetRange()[0]
assert isovalue == 50, isovalue
# The smoothing by 2 voxels moves the surface of a ball of radius 6 inwards by about 2^2 / 6.
assert math.isclose(area, 4 * math.pi * (6 - 4 / 6) ** 2, rel_tol=0.1), area
# Both banks of the seam have the same colours, in all three views.
banks = [source for (name, _id), source in simple.GetSources().items() if name.startswith("Banks of the seams")]
assert len(banks) == 3, banks
for lines in banks:
    line = servermanager.Fetch(lines)
    along = line.GetPointData().GetArray("SeamDistance")
    inner = [k for k in range(line.GetNumberOfPoints()) if along.GetTuple1(k) > 0]
    pairs = [round(along.GetTuple1(k), 9) for k in inner]
    twice = [value for value in pairs if pairs.count(value) >= 2]
    # A point has no twin on the other bank where the triangles of its bank alone were divided.
    assert len(inner) > 20 and len(twice) > 0.6 * len(pairs), (len(twice), len(pairs))
made = set(simple.GetSources())
take_back()
between = set(simple.GetSources())
assert len(between) < len(made) and simple.FindSource("Surface of the scan") is None
do_again()
assert {name for name, _ in simple.GetSources()} == {name for name, _ in made}
take_back()
assert set(simple.GetSources()) == between, set(simple.GetSources()) ^ between
assert len(simple.GetLayouts()) == 1

# The surface of a scan is moved to where the patient is first: only there the voxels, twice as high as they are broad, have
# their areas. The hemisphere becomes half of a spheroid with the half-axes 10, 10 and 20.
scanned = simple.ProgrammableFilter(
    Input=sphere,
    Script="""
from vtkmodules.vtkCommonCore import vtkDoubleArray
matrix = vtkDoubleArray()
matrix.SetName("PatientMatrix")
matrix.SetNumberOfComponents(16)
matrix.InsertNextTuple([-1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1])
output.GetFieldData().AddArray(matrix)
""",
)
in_patient = flatten_and_compare(scanned)
assert in_patient.disk.Input.GetXMLName() == "PatientSpace" and in_patient.disk.Input.Input == scanned
bounds = in_patient.morph.GetDataInformation().GetBounds()
assert math.dist(bounds, (-35, -15, 30, 50, 100, 120)) < 0.3, bounds
eccentricity = math.sqrt(1 - 0.5**2)
spheroid = math.pi * RADIUS**2 * (1 + 2 / eccentricity * math.asin(eccentricity))
measured = in_patient.area_preserving.FieldData["SurfaceArea"].GetRange()[0]
assert math.isclose(measured, spheroid, rel_tol=5e-3), (measured, spheroid)
take_back()
assert scanned in simple.GetSources().values() and len(simple.GetLayouts()) == 1
assert "PatientSpace" not in {source.GetXMLName() for source in simple.GetSources().values()}
