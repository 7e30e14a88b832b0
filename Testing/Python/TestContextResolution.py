# SPDX-License-Identifier: GPL-3.0-or-later
"""Context Resolution by paraview.simple: every property, and the original points brought to the coarse map."""

import math

from paraview import servermanager
from paraview.simple import (
    Calculator,
    Clip,
    ConformalDisk,
    ContextResolution,
    ExtractSurface,
    FlatMapTransfer,
    OMTAreaPreserving,
    Sphere,
    SurfaceToDisk,
)


def fetched(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


upper = Clip(Input=Sphere(Radius=20, ThetaResolution=120, PhiResolution=120), ClipType="Plane")
upper.ClipType.Normal, upper.ClipType.Origin = [0, 0, -1], [0, 0, 0]
disk = SurfaceToDisk(Input=ExtractSurface(Input=upper))
labelled = Calculator(Input=disk, ResultArrayName="Region", Function="coordsX > 12")
region = {"RegionArray": ["POINTS", "Region"]}
tested = {"Input", "RegionArray", "ContextFaces"}

proxy = ContextResolution(Input=labelled, ContextFaces=1000, **region)
coarse = fetched(proxy)
figures = coarse.GetFieldData()
assert abs(figures.GetArray("ContextCells").GetTuple1(0) - 1000) < 50
assert coarse.GetNumberOfCells() < fetched(labelled).GetNumberOfCells() / 2
inside = [coarse.GetPoint(i) for i in range(coarse.GetNumberOfPoints()) if coarse.GetPoint(i)[0] > 12.5]
before = fetched(labelled)
points = {before.GetPoint(i) for i in range(before.GetNumberOfPoints())}
assert len(inside) > 500 and all(point in points for point in inside)

# All original points are on the map of the coarse surface, and the area of the region is right.
flat = OMTAreaPreserving(Input=ConformalDisk(Input=proxy))
whole = fetched(FlatMapTransfer(Input=flat, Original=labelled, Tolerance=1))
assert whole.GetNumberOfPoints() > 0.98 * before.GetNumberOfPoints()


def area(data, position):
    """The area of the triangles with all corners in the region."""
    inside = data.GetPointData().GetArray("Region")
    total = 0.0
    for c in range(data.GetNumberOfCells()):
        corners = [data.GetCell(c).GetPointId(k) for k in range(3)]
        if all(inside.GetTuple1(i) for i in corners):
            a, b, c = (position(i) for i in corners)
            u, v = ([end - start for end, start in zip(corner, a)] for corner in (b, c))
            total += 0.5 * math.hypot(
                u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
            )
    return total


in_space = area(whole, whole.GetPointData().GetArray("SurfacePoints").GetTuple3)
on_map = area(whole, whole.GetPoint)
print(f"area of the region: {in_space:.2f} on the surface, {on_map:.2f} on the map")
assert in_space > 400 and math.isclose(on_map, in_space, rel_tol=0.01)

# Without an array there is a message and no output.
assert fetched(ContextResolution(Input=labelled, RegionArray=["POINTS", "None"])).GetNumberOfCells() == 0
untested = set(ContextResolution(Input=labelled).ListProperties()) - tested
assert not untested, untested
