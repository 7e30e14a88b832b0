# SPDX-License-Identifier: GPL-3.0-or-later
"""Planar Warp by paraview.simple: a magnifier for lines and for an image, every property, an error."""

import math

from paraview import servermanager
from paraview.simple import (
    AreaWeights,
    ConformalDisk,
    Contour,
    Line,
    OMTAreaPreserving,
    Plane,
    PlanarWarp,
    Transform,
    Triangulate,
    Wavelet,
)

sheet = Triangulate(
    Input=Plane(Origin=[0, 0, 0], Point1=[40, 0, 0], Point2=[0, 20, 0], XResolution=80, YResolution=40)
)
weights = AreaWeights(
    Input=ConformalDisk(
        Input=sheet,
        Domain="Rectangle",
        UseCorners=1,
        LowerLeftCorner=[0, 0, 0],
        LowerRightCorner=[40, 0, 0],
        UpperRightCorner=[40, 20, 0],
        UpperLeftCorner=[0, 20, 0],
    ),
    WeightsFrom="Implicit Function",
    ImplicitFunction="Sphere",
    PositionArray=["POINTS", "SurfacePoints"],
    FactorMeaning="Magnification",
    Factor=4,
)
weights.ImplicitFunction.Center = [20, 10, 0]
weights.ImplicitFunction.Radius = 5
flat = OMTAreaPreserving(Input=weights, UseAreaWeight=1, AreaWeightArray=["POINTS", "AreaWeight"])
across = Line(Point1=[0, 10, 0], Point2=[40, 10, 0], Resolution=1)
tested = {"Input", "Carried"}


def warped(data, **properties):
    tested.update(properties)
    proxy = PlanarWarp(Input=flat, Carried=data, **properties)
    proxy.UpdatePipeline()
    return proxy, servermanager.Fetch(proxy)


def field(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


# A line through the middle of the lens has its part in the lens, from 15 to 25, about twice as long.
proxy, line = warped(across)
assert line.GetNumberOfCells() == 1 and line.GetNumberOfPoints() > 80
assert field(line, "InsertedPoints") == line.GetNumberOfPoints() - 2
ends = []
for i in range(line.GetNumberOfPoints()):
    before = line.GetPointData().GetArray("SurfacePoints").GetTuple(i)
    if 15 <= before[0] <= 25:
        ends.append(line.GetPoint(i)[0])
assert math.isclose(max(ends) - min(ends), 20, rel_tol=0.15), (min(ends), max(ends))
assert line.GetBounds()[1] == 40.0 and ends[0] < ends[-1]

straight, data = warped(across, SubdivideLines=0)
assert data.GetNumberOfPoints() == 2
coarse, data = warped(across, SubdivideLines=1, MaximumSegmentLength=10)
assert data.GetNumberOfPoints() == 5

# Half of a line that is longer than the mesh.
outside = Line(Point1=[-40, 10, 0], Point2=[40, 10, 0], Resolution=8)
removed, data = warped(outside)
assert field(data, "OutsidePoints") == 4 and data.GetBounds()[0] == 0.0
left, data = warped(outside, OutsidePoints="Leave Unmoved")
assert field(data, "OutsidePoints") == 4 and data.GetBounds()[0] == -40.0
assert data.GetPointData().GetArray("InMap").GetRange() == (0, 1)

# An image, moved over the mesh; its magnified middle fills four times the pixels.
wavelet = Wavelet(WholeExtent=[0, 40, 0, 20, 0, 0])
image, data = warped(wavelet, ImageSize=[400, 200], NearestPixel=1)
assert data.GetClassName() == "vtkImageData" and data.GetDimensions() == (400, 200, 1)
assert data.GetPointData().GetArray("InMap").GetRange() == (1, 1)
values = [wavelet.PointData[0].GetRange(), data.GetPointData().GetArray("RTData").GetRange()]
assert values[0][0] <= values[1][0] < values[1][1] <= values[0][1]
# Downstream of the image, extents are known.
lines = Contour(Input=image, ContourBy=["POINTS", "RTData"], Isosurfaces=[sum(values[1]) / 2])
lines.UpdatePipeline()
assert lines.GetDataInformation().GetNumberOfCells() > 100
same, data = warped(wavelet)
assert data.GetDimensions() == (41, 21, 1)
textured, data = warped(wavelet, ImageOutput="Textured Mesh")
assert data.GetClassName() == "vtkPolyData" and data.GetPointData().GetTCoords()

# Nothing on the mesh: an error, and an empty output.
away = Transform(Input=across)
away.Transform.Translate = [0, 500, 0]
failed, data = warped(away)
assert data.GetNumberOfPoints() == 0

untested = set(PlanarWarp(Input=flat, Carried=across).ListProperties()) - tested
assert not untested, untested
