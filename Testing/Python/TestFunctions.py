# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of the package: they give what the filters give, take every setting that ParaView's panels have, and
raise exceptions where the filters have errors."""

import inspect
import warnings
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import surfaceflattening
from ExpectedErrors import raised
from surfaceflattening.functions import STEPS
from surfaceflattening.running import run
from surfaceflattening.settings import apply, defaults_of, setting_named, snake_case
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource


def ball():
    source = vtkSphereSource()
    source.SetThetaResolution(32)
    source.SetPhiResolution(32)
    source.Update()
    surface = source.GetOutput()
    label = vtkIntArray()
    label.SetName("Label")
    for i in range(surface.GetNumberOfPoints()):
        label.InsertNextValue(int(surface.GetPoint(i)[0] > 0.2))
    surface.GetPointData().AddArray(label)
    return surface


def coordinates(mesh):
    return [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]


def area(mesh):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(mesh)
    measured = vtkMassProperties()
    measured.SetInputConnection(triangles.GetOutputPort())
    return measured.GetSurfaceArea()


surface = ball()

# The same map as by the filters, to the last bit.
data = surface
for name in ("vtkSurfaceToDiskFilter", "vtkConformalDiskFilter", "vtkOMTAreaPreservingFilter", "vtkDistortionMetrics"):
    filter = getattr(surfaceflattening, name)()
    filter.SetInputData(data)
    if name == "vtkSurfaceToDiskFilter":
        filter.SetCutModeToSeam()
    filter.Update()
    data = filter.GetOutput()
fractions = []
flat = surfaceflattening.flatten(surface, CutMode="Seam", progress=lambda fraction, stage: fractions.append((fraction, stage)))
assert coordinates(flat) == coordinates(data)
assert flat.GetFieldData().GetArray("FacesWithin2Percent").GetValue(0) > 99
assert [f for f, _ in fractions] == sorted(f for f, _ in fractions) and abs(fractions[-1][0] - 1) < 1e-12
assert len({stage for _, stage in fractions}) > 5

# One step after the other, and with names in the style of Python.
disk = surfaceflattening.to_disk(surface, cut_mode="seam")
measured = surfaceflattening.distortion(surfaceflattening.area_preserving(surfaceflattening.conformal(disk)))
assert coordinates(measured.mesh) == coordinates(flat)
# The map fills a polygon in a circle that has the area of the surface.
assert 1 - 1e-3 < area(flat) / area(disk) < 1, (area(flat), area(disk))
assert [row["Region"] for row in measured.table] == ["Total"]
assert measured.table[0]["Faces"] == flat.GetNumberOfCells()
for column, kind in (("RegionId", int), ("Faces", int), ("FlippedFaces", int), ("Region", str), ("SurfaceArea", float)):
    assert type(measured.table[0][column]) is kind, column
by_region = surfaceflattening.distortion(measured.mesh, region_array="Label").table
assert len(by_region) == 3, by_region
assert abs(sum(row["SurfaceArea"] for row in by_region[:-1]) / by_region[-1]["SurfaceArea"] - 1) < 1e-9
unit = surfaceflattening.flatten(surface, cut_mode="Seam", normalize_to="Unit Domain")
assert abs(max(abs(c) for point in coordinates(unit) for c in point) - 1) < 1e-3
one = surfaceflattening.region(surface, label_array="Label", label=1)
assert 0.1 < one.mesh.GetNumberOfPoints() / surface.GetNumberOfPoints() < 0.9
# The measures are those of the field data. The curves have their lengths, but for the outline with its teeth.
measures = {row["Measure"]: row for row in one.table}
assert list(measures) == ["Area", "GreatestDiameter", "ExtentAcross", "Perimeter"]
for name, row in measures.items():
    assert row["OnSurface"] == one.mesh.GetFieldData().GetArray(name).GetValue(0), name
    assert 0 < row["StandardDeviation"] < 0.1 * row["OnSurface"] and row["OnMap"] > 0 and type(row["Unit"]) is str, row
names, lengths = (one.curves.GetCellData().GetAbstractArray(name) for name in ("Measure", "Length"))
drawn = {names.GetValue(i): lengths.GetValue(i) for i in range(one.curves.GetNumberOfCells())}
assert list(drawn) == list(measures)[1:] and one.curves.GetPointData().HasArray("SurfacePoints")
for name in ("GreatestDiameter", "ExtentAcross"):
    assert abs(drawn[name] / measures[name]["OnSurface"] - 1) < 1e-9, drawn
assert drawn["Perimeter"] > measures["Perimeter"]["OnSurface"]

# Arrays in place of a mesh.
try:
    import numpy
except ImportError:
    numpy = None
if numpy is not None:
    points = numpy.array([[x, y, x * y] for y in range(5) for x in range(5)], dtype=float)
    corners = [(5 * y + x, 5 * y + x + 1, 5 * y + x + 6) for y in range(4) for x in range(4)]
    corners += [(5 * y + x, 5 * y + x + 6, 5 * y + x + 5) for y in range(4) for x in range(4)]
    saddle = surfaceflattening.flatten(points, numpy.array(corners))
    pair = surfaceflattening.flatten((points, numpy.array(corners)))
    assert coordinates(saddle) == coordinates(pair) and saddle.GetNumberOfCells() >= 32
    assert "n x 3" in raised(ValueError, surfaceflattening.flatten, points[:, :2], corners)
    assert "points 0 to 24" in raised(ValueError, surfaceflattening.flatten, points, [(0, 1, 25)])
    assert "numbers of points" in raised(ValueError, surfaceflattening.flatten, points, [(0.0, 1.0, 2.0)])

# A volume: the surface of a ball of radius 8 mm in voxels of 1 x 1 x 2 mm.
volume = vtkImageData()
volume.SetDimensions(21, 21, 11)
volume.SetSpacing(1, 1, 2)
values = vtkDoubleArray()
for k in range(11):
    for j in range(21):
        for i in range(21):
            values.InsertNextValue(20 - ((i - 10) ** 2 + (j - 10) ** 2 + (2 * k - 10) ** 2) ** 0.5)
volume.GetPointData().SetScalars(values)
skin = surfaceflattening.isosurface(volume, 12, smoothing_mm=0)
assert abs(area(skin) / (4 * 3.14159265 * 64) - 1) < 0.03, area(skin)
assert "between" in raised(surfaceflattening.FlatteningError, surfaceflattening.isosurface, volume, 99)
assert "no voxels" in raised(surfaceflattening.FlatteningError, surfaceflattening.isosurface, vtkImageData())
assert "not an image" in raised(TypeError, surfaceflattening.isosurface, surface, 1)

# Errors are exceptions with the message of the filter alone.
text = raised(surfaceflattening.FlatteningError, surfaceflattening.flatten, surface, cut_mode="Plane", plane_normal=(0, 0, 0))
assert "normal" in text and "0x" not in text and "vtk" not in text and "\n" not in text, text
for function in (surfaceflattening.flatten, *(getattr(surfaceflattening, name) for name, *_ in STEPS), surfaceflattening.region):
    assert "no faces" in raised(surfaceflattening.FlatteningError, function, vtkPolyData()), function.__name__
assert "vtkUnstructuredGrid" in raised(TypeError, surfaceflattening.flatten, vtkUnstructuredGrid())
assert "str" in raised(TypeError, surfaceflattening.flatten, "brain.vtp")
assert "did you mean cut_mode" in raised(TypeError, surfaceflattening.flatten, surface, cutmod="Seam")
assert "one of Automatic, Hole" in raised(surfaceflattening.SettingError, surfaceflattening.to_disk, surface, cut_mode="Sem")
assert "say which" in raised(TypeError, surfaceflattening.flatten, surface, boundary_point=(0, 0, 1))
text = raised(surfaceflattening.SettingError, surfaceflattening.to_disk, surface, region_of_interest="Labels")
assert "no array Labels: it has" in text, text
shown = surfaceflattening.flatten(surface, cut_mode="Seam", conformal={"tolerance": 1e-10})
assert shown.GetNumberOfPoints() == flat.GetNumberOfPoints()


# The documented defaults may be given.
for _, filter_class, _ in (*STEPS, ("region", surfaceflattening.vtkFlattenRegion, 1)):
    for setting, default in defaults_of(filter_class).items():
        apply(filter_class(), surface, setting, default)
assert coordinates(surfaceflattening.to_disk(surface, cut_mode="Seam", seam_lines=None)) == coordinates(disk)
assert coordinates(surfaceflattening.conformal(disk, domain=None)) == coordinates(surfaceflattening.conformal(disk))
region_defaults = {"label_array": "Label", "label": 1, "selection": None}
assert coordinates(surfaceflattening.region(surface, **region_defaults).mesh) == coordinates(one.mesh)

# Warnings are Python's, and name the line of the caller.
for function in (surfaceflattening.flatten, surfaceflattening.to_disk):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        here = inspect.currentframe().f_lineno + 1
        function(surface, cut_mode="Hole")
    caught = [w for w in caught if w.category is surfaceflattening.FlatteningWarning]
    assert caught and {(w.filename, w.lineno) for w in caught} == {(__file__, here)}, caught
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert str(caught[0].message) == raised(surfaceflattening.FlatteningWarning, function, surface, cut_mode="Hole")


class Complaining(vtkSphereSource):
    """Warns, and then has an error; None is a text that VTK cannot decode."""

    def AddObserver(self, event, observer):
        self.observers = {**getattr(self, "observers", {}), event: observer}

    def Update(self):
        self.observers["WarningEvent"](self, "WarningEvent", "a warning")
        self.observers["ErrorEvent"](self, "ErrorEvent", None)


with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    assert "not UTF-8" in raised(surfaceflattening.FlatteningError, run, Complaining())
assert [str(w.message) for w in caught] == ["a warning"], caught
with warnings.catch_warnings():
    warnings.simplefilter("error")
    assert "not UTF-8" in raised(surfaceflattening.FlatteningError, run, Complaining())

# An abort stops the work, and so does an exception in a callback.
calls = []
assert "abort" in raised(surfaceflattening.Cancelled, surfaceflattening.flatten, surface, abort=lambda: calls.append(0) or len(calls) > 3)
assert len(calls) < 3 + 5, len(calls)
assert "of mine" in raised(ZeroDivisionError, surfaceflattening.flatten, surface, progress=lambda f, s: (_ for _ in ()).throw(ZeroDivisionError("of mine")))

# Every setting of ParaView's panels is one of the functions, has its default, and says what it means.
plugin = Path(__file__).resolve().parents[2] / "Plugin"
panels = {"SurfaceToDisk": 0, "ConformalDisk": 1, "OMTAreaPreserving": 2, "DistortionMetrics": 3}
compared = 0
for panel, step in panels.items():
    for element in ElementTree.parse(plugin / f"{panel}.xml").getroot().iter():
        if element.tag.endswith("Property") and element.get("command", "").startswith("Set") and element.get("name") != "Input":
            assert setting_named(STEPS[step][1], element.get("name")), (panel, element.get("name"))
            compared += 1
assert compared > 50, compared
for name, filter_class, _ in STEPS:
    function = getattr(surfaceflattening, name)
    for setting in defaults_of(filter_class):
        assert snake_case(setting) in inspect.signature(function).parameters, setting
        line = next(s for s in function.__doc__.splitlines() if s.strip().startswith(snake_case(setting) + ":"))
        assert len(line.split()) > 3, line
