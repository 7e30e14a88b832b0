# SPDX-License-Identifier: GPL-3.0-or-later
"""Composite data sets, a surface per time step, and states that are reopened, by paraview.simple."""

import math
import os
import tempfile

from paraview import servermanager, simple
from paraview.simple import (
    ConformalDisk,
    DistortionMetrics,
    GroupDatasets,
    LegacyVTKReader,
    OMTAreaPreserving,
    SaveData,
    Sphere,
    SurfaceToDisk,
    Transform,
)


def cap(angle):
    return Sphere(Radius=10, EndPhi=angle, ThetaResolution=40, PhiResolution=30)


def figure(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def flattened(surface):
    """The proxies from a surface to its measured flat map."""
    disk = SurfaceToDisk(Input=surface)
    conformal = ConformalDisk(Input=disk)
    area_preserving = OMTAreaPreserving(Input=conformal)
    return disk, conformal, area_preserving, DistortionMetrics(Input=area_preserving)


def fetch(proxy, port=0):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, idx=port)


def output(proxy, port=0):
    """The output itself: Fetch of ParaView 5.11 does not fetch partitioned collections."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def points(data):
    return [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


def leaves(data):
    iterator = data.NewIterator()
    iterator.SkipEmptyNodesOff()
    iterator.InitTraversal()
    found = []
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


# --- Blocks: every one as on its own, in a multiblock data set and in a partitioned collection ------------
first, second = cap(90), cap(140)
bad = Transform(Input=Sphere(Radius=10))
bad.Transform.Scale = [1, 0, 0]  # a line: no triangle has an area
expected = [fetch(flattened(surface)[-1]) for surface in (first, second)]
for combined in ("vtkMultiBlockDataSet", "vtkPartitionedDataSetCollection"):
    blocks = GroupDatasets(
        Input=[first, bad, second], BlockNames=["left", "crushed", "right"], OutputType=combined
    )
    pipeline = flattened(blocks)
    data = output(pipeline[-1])
    assert data.GetClassName() == combined
    assert data.GetFieldData().GetArray("FailedBlocks").GetTuple1(0) == 1, combined
    errors = data.GetFieldData().GetAbstractArray("BlockErrors")
    assert errors.GetNumberOfValues() == 1
    assert errors.GetValue(0).startswith('block "crushed": '), errors.GetValue(0)
    left, crushed, right = leaves(data)
    assert not crushed or crushed.GetNumberOfPoints() == 0
    for found, alone in zip((left, right), expected):
        assert points(found) == points(alone)
        for name in ("SurfaceArea", "FacesWithin2Percent", "MaxCellAreaError"):
            assert figure(found, name) == figure(alone, name), (combined, name)
    tables = leaves(output(pipeline[-1], 1))
    assert [t.GetNumberOfRows() if t else 0 for t in tables] == [1, 0, 1]
    diagrams = leaves(output(pipeline[2], 1))
    assert diagrams[0].GetNumberOfCells() == figure(left, "Sites")

# --- A surface per time step ---------------------------------------------------------------------------------
folder = tempfile.mkdtemp(dir=os.environ.get("TEMPORARY_DIRECTORY"))
files = [os.path.join(folder, f"heart{k}.vtk") for k in range(3)]
surfaces = [cap(angle) for angle in (80, 110, 140)]
for path, surface in zip(files, surfaces):
    SaveData(path, surface, FileType="Ascii")
series = LegacyVTKReader(FileNames=files)
measured = flattened(series)[-1]
series.UpdatePipelineInformation()
assert list(series.TimestepValues) == [0, 1, 2], series.TimestepValues


def at(time):
    measured.UpdatePipeline(time)
    return servermanager.Fetch(measured)


areas = []
for time in (0, 1, 2):
    alone = fetch(flattened(LegacyVTKReader(FileNames=[files[time]]))[-1])
    step = at(time)
    assert points(step) == points(alone), time
    areas.append(figure(step, "SurfaceArea"))
for area, angle in zip(areas, (80, 110, 140)):
    assert math.isclose(area, 200 * math.pi * (1 - math.cos(math.radians(angle))), rel_tol=0.01)
assert figure(at(0), "SurfaceArea") == areas[0]  # back to the first

# A time step without a surface that can be flattened, followed by one that has a surface.
with open(files[1], "w", encoding="ascii") as stream:
    stream.write(
        "# vtk DataFile Version 3.0\nnothing\nASCII\nDATASET POLYDATA\n"
        "POINTS 3 float\n0 0 0 1 0 0 2 0 0\nPOLYGONS 1 4\n3 0 1 2\n"
    )
series.FileNames = files
assert at(1).GetNumberOfCells() == 0
assert figure(at(2), "SurfaceArea") == areas[2]

# --- A state, reopened in a new session after the plugin is loaded again ---------------------------------------
simple.ResetSession()


def load_plugin():
    for folder_of_plugins in os.environ["PV_PLUGIN_PATH"].split(os.pathsep):
        path = os.path.join(folder_of_plugins, "SurfaceFlattening", "SurfaceFlattening.so")
        if os.path.exists(path):
            simple.LoadPlugin(path, remote=False, ns=vars(simple))
            return
    raise RuntimeError("no plugin in PV_PLUGIN_PATH")


load_plugin()
surface = cap(120)
disk = simple.SurfaceToDisk(
    registrationName="disk", Input=surface, Remesh=1, RelativeEdgeLength=1.3
)
conformal = simple.ConformalDisk(registrationName="conformal", Input=disk, UseCenterPoint=1, CenterPoint=[1, 2, 3])
weights = simple.AreaWeights(
    registrationName="weights",
    Input=conformal,
    WeightsFrom="Implicit Function",
    Factor=3.0,
    EdgeWidth=0.5,
)
area_preserving = simple.OMTAreaPreserving(
    registrationName="flat", Input=weights, UseAreaWeight=1, AngleWeight=0.2, NormalizeTo="Unit Domain"
)
metrics = simple.DistortionMetrics(registrationName="metrics", Input=area_preserving, UseTargetArea=1)
before = points(fetch(metrics))
assert before
proxies = [disk, conformal, weights, area_preserving, metrics]
values = [
    {
        name: repr(p.GetPropertyValue(name))
        for name in p.ListProperties()
        if isinstance(p.GetPropertyValue(name), (int, float, str, list))
    }
    for p in proxies
]
names = ["disk", "conformal", "weights", "flat", "metrics"]
state = os.path.join(folder, "flattening.pvsm")
simple.SaveState(state)
simple.ResetSession()
assert simple.FindSource("metrics") is None
load_plugin()
simple.LoadState(state)
for name, remembered in zip(names, values):
    proxy = simple.FindSource(name)
    assert proxy, name
    for property_name, value in remembered.items():
        assert repr(proxy.GetPropertyValue(property_name)) == value, (name, property_name)
assert points(fetch(simple.FindSource("metrics"))) == before
