# SPDX-License-Identifier: GPL-3.0-or-later
"""Setters of every filter: wrong types raise TypeError, a number beyond the choices becomes the nearest one, and what
is not a number is an error with an empty output, or changes nothing as the setting is not in use. So are infinite
coordinates; an infinite number becomes the end of the range where there is one."""

import math
import re

import surfaceflattening
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPlane
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

POINTS = vtkDataObject.FIELD_ASSOCIATION_POINTS


def ball():
    source = vtkSphereSource()
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    source.Update()
    surface = source.GetOutput()
    label = vtkIntArray()
    label.SetName("Label")
    height = vtkDoubleArray()
    height.SetName("Height")
    for i in range(surface.GetNumberOfPoints()):
        x = surface.GetPoint(i)[0]
        label.InsertNextValue(x > 0.2)
        height.InsertNextValue(x)
    surface.GetPointData().AddArray(label)
    surface.GetPointData().AddArray(height)
    return surface


def applied(name, data, **settings):
    filter = getattr(surfaceflattening, name)()
    filter.SetInputData(data)
    for setting, value in settings.items():
        getattr(filter, "Set" + setting)(*value if isinstance(value, tuple) else (value,))
    return filter


def output(filter):
    filter.Update()
    return filter.GetOutput()


def volume():
    image = vtkImageData()
    image.SetDimensions(11, 11, 11)
    image.SetOrigin(-1, -1, -1)
    image.SetSpacing(0.2, 0.2, 0.2)
    image.AllocateScalars(10, 1)
    image.GetPointData().GetScalars().SetName("Grey")
    image.GetPointData().GetScalars().Fill(1.0)
    return image


def field():
    image = volume()
    for i in range(image.GetNumberOfPoints()):
        image.GetPointData().GetScalars().SetValue(i, 0.7 - math.dist(image.GetPoint(i), (0, 0, 0)))
    return image


def grid():
    source = vtkPlaneSource()
    source.SetResolution(16, 16)
    source.Update()
    return source.GetOutput()


surface = ball()
disk = output(applied("vtkSurfaceToDiskFilter", surface, CutMode=2, PlaneOrigin=(0.05, 0, 0)))
conformal = output(applied("vtkConformalDiskFilter", disk))
flat = output(applied("vtkOMTAreaPreservingFilter", conformal))
plane = output(applied("vtkSurfaceToDiskFilter", grid()))
flat_plane = output(applied("vtkConformalDiskFilter", plane))
label = {"InputArrayToProcess": (0, 0, 0, POINTS, "Label")}
height = {"InputArrayToProcess": (0, 0, 0, POINTS, "Height")}


def with_function(filter):
    filter.SetImplicitFunction(vtkPlane())
    return filter


def with_second(filter, data):
    filter.SetInputData(1, data)
    return filter


# Each filter, set so that as many of its settings as possible are in use.
MAKERS = (
    lambda: applied("vtkSurfaceToDiskFilter", surface, Remesh=True),
    lambda: applied("vtkSurfaceToDiskFilter", surface, UseHolePoint=True, HolePoint=(0.5, 0, 0)),
    lambda: applied("vtkSurfaceToDiskFilter", surface, CutMode=1, ComponentMode=1),
    lambda: applied("vtkSurfaceToDiskFilter", surface, CutMode=2, PlaneOrigin=(0.05, 0, 0), BoundaryMode=1),
    lambda: applied("vtkSurfaceToDiskFilter", surface, CutMode=3),
    lambda: applied("vtkSurfaceToDiskFilter", surface, CutMode=4, InputArrayToProcess=(1, 0, 0, POINTS, "Label")),
    lambda: applied("vtkConformalDiskFilter", disk, UseCenterPoint=True, CenterPoint=(0.5, 0, 0)),
    lambda: applied("vtkConformalDiskFilter", disk, UseBoundaryPoint=True, BoundaryPoint=(0, 0.5, 0)),
    lambda: applied(
        "vtkConformalDiskFilter",
        disk,
        Domain=1,
        UseCorners=True,
        LowerLeftCorner=(0, 0.5, 0),
        LowerRightCorner=(0, 0, 0.5),
        UpperRightCorner=(0, -0.5, 0),
        UpperLeftCorner=(0, 0, -0.5),
    ),
    lambda: applied("vtkOMTAreaPreservingFilter", conformal),
    lambda: applied("vtkDistortionMetrics", flat, **label),
    lambda: applied("vtkDistortionMetrics", flat, MeasureLengths=True, **label),
    lambda: applied("vtkMeshSaliency", disk, FindRegions=True, ThresholdType=1),
    lambda: applied("vtkMeshSaliency", disk, FindRegions=True, ThresholdType=0),
    lambda: applied("vtkContextResolution", disk, **label),
    lambda: applied("vtkAreaWeights", disk, WeightsFrom=0, Label=1, EdgeWidth=0.1, **label),
    lambda: applied("vtkAreaWeights", disk, WeightsFrom=2, **height),
    lambda: with_function(applied("vtkAreaWeights", disk, WeightsFrom=4, EdgeWidth=0.1)),
    lambda: applied("vtkFlattenRegion", disk, Label=1, AutomaticMargin=False, **label),
    lambda: applied("vtkFlatMapImage", flat, Size=40),
    lambda: with_second(applied("vtkFlatMapSlab", flat, StackSize=20), volume()),
    lambda: with_second(applied("vtkFlatMapTransfer", flat), disk),
    lambda: applied(
        "vtkVolumeToSurface",
        field(),
        AutomaticIsovalue=False,
        Isovalue=0.1,
        AutomaticSmoothing=False,
        Smoothing=0.1,
        AutomaticAir=False,
        Air=-1.0,
    ),
    lambda: applied("vtkVolumeToSurface", field(), ComponentMode=0),
    lambda: with_second(applied("vtkPlanarWarp", flat_plane, SubdivideLines=True), plane),
)


def setters(filter):
    """(name, types of the arguments) of the setters that the filter's own class has."""
    for name, method in vars(type(filter)).items():
        signature = re.match(rf"{name}\(self(.*?)\)", method.__doc__ or "", re.S)
        if name.startswith("Set") and signature:
            yield name, re.findall(r":\s*(\w+)", signature.group(1))


def run(filter):
    """The bytes of the points of the output, and the errors."""
    errors = []
    for observed in (filter, filter.GetExecutive()):
        observed.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    result = output(filter)
    points = result.GetPointData()
    arrays = [points.GetArray(i) for i in range(points.GetNumberOfArrays())]
    data = [bytes(memoryview(a)) for a in arrays if a is not None]
    if hasattr(result, "GetPoints") and result.GetPoints():
        data.append(bytes(memoryview(result.GetPoints().GetData())))
    return (data if result.GetNumberOfPoints() else None), errors


def raises(call, *arguments):
    try:
        call(*arguments)
    except TypeError:
        return True
    return False


tried = 0
for make in MAKERS:
    kind = type(make()).__name__
    expected, errors = run(make())
    assert expected and not errors, kind
    for name, types in setters(make()):
        if types in (["float"], ["int"]):
            assert raises(getattr(make(), name), "text"), (kind, name)
            assert raises(getattr(make(), name), 1, 2), (kind, name)
        if types == ["int"]:
            assert raises(getattr(make(), name), 1.5), (kind, name)
        choices = [m for m in dir(make()) if m.startswith(name + "To")]
        if choices and types == ["int"]:
            filter = make()
            getter = getattr(filter, "G" + name[1:])
            getattr(filter, name)(-1)
            assert getter() == 0, (kind, name)
            getattr(filter, name)(99)
            assert getter() == len(choices) - 1, (kind, name, getter())
        if types and all(t == "float" for t in types):
            for value in (math.nan, math.inf) if len(types) > 1 else (math.nan,):
                filter = make()
                getattr(filter, name)(*[value] * len(types))
                result, errors = run(filter)
                tried += 1
                assert (result is None) == (len(errors) > 0), (kind, name, value, errors)
                assert result is None or result == expected, (kind, name, value)
        if types == ["float"]:
            filter = make()
            getattr(filter, name)(math.inf)
            result, errors = run(filter)
            assert (result is None) == (len(errors) > 0), (kind, name, errors)
assert tried > 60, tried
