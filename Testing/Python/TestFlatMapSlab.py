# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat Map Slab by paraview.simple: every property, both outputs, on a volume whose value is known."""

import math

from paraview import servermanager
from paraview.simple import (
    Clip,
    ConformalDisk,
    ExtractSurface,
    FlatMapSlab,
    ProgrammableSource,
    Sphere,
    SurfaceToDisk,
)

# The distance to the origin, at voxels of 1. (The script brings names like "volume" into this module.)
scan = ProgrammableSource(OutputDataSetType="vtkImageData")
scan.ScriptRequestInformation = """
self.GetOutputInformation(0).Set(self.GetExecutive().WHOLE_EXTENT(), (0, 50, 0, 50, 0, 50), 6)
"""
scan.Script = """
import numpy as np
output.SetDimensions(51, 51, 51)
output.SetOrigin(-25, -25, -25)
z, y, x = np.mgrid[-25:26, -25:26, -25:26].astype(float)
output.PointData.append(np.sqrt(x * x + y * y + z * z).ravel(), "Distance")
output.PointData.append((x * x + y * y + z * z < 324).ravel().astype(np.int32), "Label")
"""

upper = Clip(Input=Sphere(Radius=20, ThetaResolution=150, PhiResolution=150), ClipType="Plane")
upper.ClipType.Normal, upper.ClipType.Origin = [0, 0, -1], [0, 0, 0]
flat = ConformalDisk(Input=SurfaceToDisk(Input=ExtractSurface(Input=upper)))
tested = {"Input", "Volume"}


def slab(**properties):
    tested.update(properties)
    proxy = FlatMapSlab(Input=flat, Volume=scan, **properties)
    proxy.UpdatePipeline()
    return proxy, servermanager.Fetch(proxy)


def point_array(data, name):
    array = data.GetPointData().GetArray(name)
    assert array is not None, name
    return array


proxy, data = slab(Depths=[0, 1.5, 3, 4.5], StackSize=64)
values = point_array(data, "DistanceSlab")
assert [values.GetComponentName(k) for k in range(4)] == ["0", "1.5", "3", "4.5"]
for i in range(data.GetNumberOfPoints()):
    for k in range(4):
        assert abs(values.GetComponent(i, k) - (20 - 1.5 * k)) < 0.03
stack = servermanager.Fetch(proxy, idx=1)
assert stack.GetDimensions() == (64, 64, 4) and math.isclose(stack.GetSpacing()[2], 1.5)
middle = stack.FindPoint((0, 0, 3))
assert abs(point_array(stack, "Distance").GetTuple1(middle) - 17) < 0.05

_, data = slab(Outwards=1)
values = point_array(data, "DistanceSlab")
assert values.GetNumberOfComponents() == 3
assert abs(values.GetComponent(9, 2) - 22) < 0.03

_, data = slab(NearestVoxel=1, Depths=[1, 3])
labels = point_array(data, "LabelSlab")
assert labels.GetRange(0) == (0, 0) or {labels.GetComponent(i, 0) for i in range(99)} <= {0, 1}
assert {labels.GetComponent(i, 1) for i in range(data.GetNumberOfPoints())} == {1}

_, data = slab(Depths=[-8], StackSize=0)
outside = data.GetFieldData().GetArray("OutsideSamples").GetTuple1(0)
assert 0 < outside < data.GetNumberOfPoints()

untested = set(FlatMapSlab(Input=flat, Volume=scan).ListProperties()) - tested
assert not untested, untested
