# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of the package's functions: a point, plane, label or array that is given is used, without the switch or mode
that it needs; what excludes each other, and a number that the filter would change, is an error."""

import inspect
import itertools
import math
import warnings

import surfaceflattening
from ExpectedErrors import raised
from surfaceflattening import SettingError, conformal, flatten, isosurface, region, to_disk
from surfaceflattening.functions import STEPS
from surfaceflattening.settings import MODES, SWITCHES, choices_of, defaults_of, range_of, snake_case
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkSphereSource


def ball(x=0.0, radius=0.5):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetRadius(radius)
    source.SetThetaResolution(32)
    source.SetPhiResolution(32)
    source.Update()
    label = vtkIntArray()
    label.SetName("Label")
    for i in range(source.GetOutput().GetNumberOfPoints()):
        label.InsertNextValue(int(source.GetOutput().GetPoint(i)[0] > 0.2))
    source.GetOutput().GetPointData().AddArray(label)
    return source.GetOutput()


def coordinates(mesh):
    return [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]


def datum(mesh, name):
    """The first number of an array of the field data."""
    return mesh.GetFieldData().GetArray(name).GetTuple(0)[0]


def opened(name, **settings):
    return datum(to_disk(surface, **settings), name)


surface = ball()
cuts = choices_of(surfaceflattening.vtkSurfaceToDiskFilter, "CutMode")
assert cuts == {"Hole": 0, "Seam": 1, "Plane": 2, "Relief": 3, "Label": 4, "Automatic": 5}, cuts

# The cut: a seam along a quarter of a great circle, a hole at a point, a plane, a label.
quarter = {"seam_points": [(0.5, 0, 0), (0, 0.5, 0)]}
for settings in ({}, {"cut_mode": "Seam"}, {"cut_mode": "Automatic"}, {"use_seam_points": True}):
    assert math.isclose(opened("SeamLength", **quarter, **settings), math.pi / 4, rel_tol=0.01), settings
assert opened("SeamLength", cut_mode="Seam", use_seam_points=False, **quarter) > 1.4
hole = {"hole_point": (0.5, 0, 0)}
with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of the small hole
    for settings in ({}, {"cut_mode": "Hole"}):
        assert opened("HoleCentre", **hole, **settings) > 0.49, settings
assert opened("ChosenCut", use_hole_point=False, **hole) == cuts["Relief"]
for settings in ({"plane_origin": (0.1, 0, 0)}, {"plane_normal": (0, 0, 1)}):
    assert opened("ChosenCut", **settings) == cuts["Plane"], settings
for settings in ({"label_array": "Label"}, {"label_array": "Label", "cut_label": 1}):
    assert opened("ChosenCut", **settings) == cuts["Label"], settings

# A switch that is off leaves an array unused, whether it is given before or after it.
avoided = {"region_of_interest": "Label"}
off = {"use_region_of_interest": False}
assert opened("SeamLength", **avoided) != opened("SeamLength")
for settings in ({**avoided, **off}, {**off, **avoided}):
    assert opened("SeamLength", **settings) == opened("SeamLength"), settings

# The component and the boundary that are kept.
both = vtkAppendPolyData()
both.AddInputData(surface)
both.AddInputData(ball(5.0, 0.2))
both.Update()
with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of the other component
    for settings in ({"component_point": (5, 0, 0)}, {"component_index": 1}):
        assert datum(to_disk(both.GetOutput(), **settings), "SurfaceArea") < 1, settings
tube = vtkCylinderSource()
tube.CappingOff()
tube.SetResolution(24)
tube.SetHeight(4)
tube.Update()
for end in (-2, 2):
    closed = to_disk(tube.GetOutput(), boundary_point=(0, end, 0), fill_length_limit=10)
    filled = closed.GetCellData().GetArray("Filled")
    caps = [closed.GetCell(i).GetBounds()[2] for i in range(closed.GetNumberOfCells()) if filled.GetValue(i)]
    assert caps and all(math.isclose(y, -end) for y in caps), (end, caps)

# The points that are given become the centre, the right end and the corners of the map.
half = to_disk(surface, plane_origin=(0, 0, 0))
points = coordinates(half)
spot = next(i for i, (x, y, z) in enumerate(points) if x > 0.3 and y > 0.2)
assert math.hypot(*conformal(half, center_point=points[spot]).GetPoint(spot)) < 1e-3
assert math.hypot(*conformal(half, center_point=points[spot], use_center_point=False).GetPoint(spot)) > 0.1
rim = min(range(len(points)), key=lambda i: math.dist(points[i], (0, 0.3, 0.4)))
x, y, _ = conformal(half, boundary_point=points[rim]).GetPoint(rim)
assert x > 0 and abs(y) < 1e-6 * x, (x, y)
names = ("lower_left_corner", "lower_right_corner", "upper_right_corner", "upper_left_corner")
corners = dict(zip(names, ((0, 0.5, 0), (0, 0, 0.5), (0, -0.5, 0), (0, 0, -0.5))))
assert math.isclose(datum(conformal(half, **corners), "Modulus"), 1, rel_tol=0.02)
assert datum(region(surface, label=1, label_array="Label", margin=0.1).mesh, "Margin") == 0.1

# A setting that the given mode does not use is an error, and so are settings that exclude each other.
for settings, text in (
    ({"cut_mode": "Hole", **quarter}, "set cut_mode to Seam or Automatic"),
    ({"cut_mode": "Seam", "plane_origin": (0.1, 0, 0)}, "cut_mode is Seam, which does not use it"),
    ({"component_mode": "Largest", "component_index": 1}, "set component_mode to ByIndex"),
    ({"component_point": (5, 0, 0), "component_index": 1}, "leave one of them out"),
    ({**hole, **quarter}, "hole_point and seam_points are both given"),
    ({"cut_mode": "Automatic", **hole, **quarter}, "leave one of them out"),
    ({"seam_lines": surface, **quarter}, "seam_lines and seam_points"),
):
    assert text in raised(SettingError, to_disk, surface, **settings), settings
for unused in ("center_point", "boundary_point"):
    settings = {"domain": "Rectangle", unused: points[spot]}
    assert unused in raised(SettingError, conformal, half, **settings)
    assert unused in raised(SettingError, flatten, surface, conformal=settings)

# All defaults together change nothing.
for function, data, filter_class in ((to_disk, surface, STEPS[0][1]), (conformal, half, STEPS[1][1])):
    assert coordinates(function(data, **defaults_of(filter_class))) == coordinates(function(data))

# The help says what a setting sets, for each that sets something.
functions = {"to_disk": to_disk, "conformal": conformal, "region": region}
for function, setting, text in (
    ("to_disk", "hole_point", "use_hole_point is True"),
    ("to_disk", "component_point", "component_mode is ClosestToPoint"),
    ("to_disk", "boundary_point", "boundary_mode is ClosestToPoint"),
    ("to_disk", "plane_origin", "cut_mode is Plane"),
    ("conformal", "boundary_point", "use_boundary_point is True"),
    ("conformal", "lower_left_corner", "domain is Rectangle"),
    ("region", "margin", "automatic_margin is False"),
    ("region", "selection", "region_from is Selection"),
):
    lines = inspect.getdoc(functions[function]).split(f"\n  {setting}: ")[1].split("\n")
    own = [lines[0], *itertools.takewhile(lambda line: line.startswith("      "), lines[1:])]
    assert f"If it is given, {text}." in " ".join(" ".join(own).split()), (setting, own)
known = {name for c in (*(c for _, c, _ in STEPS), surfaceflattening.vtkFlattenRegion) for name in defaults_of(c)}
assert {*SWITCHES, *MODES, *(s for s, _ in SWITCHES.values()), *(m for modes in MODES.values() for m in modes)} <= known

# A number that the filter would change, or that its documentation excludes, is an error.
for settings, text in (
    ({"cut_mode": 17}, "cut_mode is 17: it must be from 0 to 5, or one of Automatic, Hole"),
    ({"hole_area_fraction": 0.9}, "hole_area_fraction is 0.9: it must be from 1e-06 to 0.5"),
    ({"angle_weight": 2}, "angle_weight is 2: it must be from 0 to 0.99"),
    ({"points_per_site": 0}, "points_per_site is 0: it must be from 1 to 1000"),
    ({"points_per_site": 16.5}, "points_per_site is 16.5: it must be a whole number"),
    ({"relief_gain": -1}, "relief_gain is -1: it must be 0 or more"),
    ({"longest_relief": 0}, "longest_relief is 0: it must be above 0"),
    ({"merge_tolerance": math.nan}, "merge_tolerance is nan: it must be 0 or more"),
    ({"smallest_angle": 80}, "smallest_angle is 80: it must be from 0 to 15"),
    ({"minimum_boundary_vertices": -4}, "minimum_boundary_vertices is -4: it must be from 3 to 10000"),
    ({"cut_label": 10**30}, "cut_label is 1000"),
    ({"remesh": 2}, "remesh is 2: it must be True or False"),
    ({"remesh": "no"}, "remesh is 'no': it must be True or False"),
):
    step = next(name for name, c, _ in STEPS if any(snake_case(s) in settings for s in defaults_of(c)))
    assert text in raised(SettingError, getattr(surfaceflattening, step), surface, **settings), settings
    assert text in raised(SettingError, flatten, half, **settings), settings
assert "plane_normal is (1, 2)" in raised(TypeError, to_disk, surface, plane_normal=(1, 2))
assert coordinates(to_disk(half, minimum_boundary_vertices=60.0)) == coordinates(to_disk(half, minimum_boundary_vertices=60))
volume = vtkImageData()
volume.SetDimensions(3, 3, 3)
for padding in (-1, 2000, 1.5):
    assert f"padding is {padding}: it must be" in raised(SettingError, isosurface, volume, 1, padding=padding)
for bases in (surfaceflattening.FlatteningError, ValueError):
    assert issubclass(SettingError, bases)

# What takes a number below its least one sets another than was given: the range of each clamp is found.
clamped = 0
for _, filter_class, _ in STEPS:
    for setting, default in defaults_of(filter_class).items():
        if type(default) in (int, float) and hasattr(filter_class, f"Get{setting}MinValue"):
            least, most = range_of(filter_class, setting)[:2]
            assert least <= default <= most, setting
            clamped += 1
assert clamped >= 12, clamped
