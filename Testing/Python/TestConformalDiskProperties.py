# SPDX-License-Identifier: GPL-3.0-or-later
"""Every property of Conformal Disk, by its name in paraview.simple, changes the result as it says."""

import math

from paraview import servermanager
from paraview.simple import ConformalDisk, Plane, Sphere, SurfaceToDisk

tested = {"Input"}


def flat(surface, **properties):
    """The proxy; every property given is one that is tested."""
    tested.update(properties)
    proxy = ConformalDisk(Input=surface, **properties)
    for name, value in properties.items():
        was_set = proxy.GetPropertyValue(name)
        assert (list(was_set) if isinstance(value, list) else was_set) == value, (name, was_set)
    proxy.UpdatePipeline()
    return proxy


def figures(proxy):
    data = servermanager.Fetch(proxy).GetFieldData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): array.GetTuple(0)[0] for array in arrays if array and array.GetNumberOfTuples() == 1}


# A part of a ball.
ball = Sphere(Radius=10, ThetaResolution=80, PhiResolution=80)
disk = SurfaceToDisk(Input=ball, Cut="Plane", PlaneOrigin=[1, 0, 0], PlaneNormal=[1, 0, 0.5])
surface = servermanager.Fetch(disk)
radius = math.sqrt(surface.GetFieldData().GetArray("SurfaceArea").GetTuple1(0) / math.pi)

# --- Method ------------------------------------------------------------------------------------------------
flow = flat(disk, Method="Ricci Flow")
assert figures(flow)["MaxCurvatureError"] <= 1e-10
boundary_first = flat(disk, Method="Boundary First")
assert 3 <= figures(boundary_first)["BoundaryIterations"] < 60
mean_value = flat(disk, Method="Mean Value")
for proxy in (boundary_first, mean_value):
    assert "MaxCurvatureError" not in figures(proxy) and "NewtonIterations" not in figures(proxy)
for proxy in (flow, boundary_first, mean_value):
    assert figures(proxy)["FlippedFaces"] == 0
    assert math.isclose(proxy.GetDataInformation().GetBounds()[1], radius, rel_tol=1e-3)
assert ConformalDisk(Input=disk).Method == "Ricci Flow"
right = {"UseBoundaryPoint": 1, "BoundaryPoint": [0.0, 10.0, 0.0]}  # the surface has no direction of its own
one = servermanager.Fetch(flat(disk, **right))
other = servermanager.Fetch(flat(disk, Method="Boundary First", **right))
for point in range(0, one.GetNumberOfPoints(), 7):
    distance = math.dist(one.GetPoint(point), other.GetPoint(point))
    assert distance < 0.01 * radius, (point, distance)

# --- Size, centre, rotation: the same for all methods ------------------------------------------------------
for method in ("Ricci Flow", "Boundary First", "Mean Value"):
    unit = flat(disk, Method=method, NormalizeTo="Unit Domain")
    assert math.isclose(unit.GetDataInformation().GetBounds()[1], 1, rel_tol=1e-3)

    inner = surface.GetNumberOfPoints() // 2
    turned = flat(
        disk,
        Method=method,
        UseCenterPoint=1,
        CenterPoint=list(surface.GetPoint(inner)),
        **right,
    )
    points = servermanager.Fetch(turned)
    centre = min(range(points.GetNumberOfPoints()), key=lambda i: math.hypot(*points.GetPoint(i)))
    assert points.GetPoint(centre) == (0, 0, 0)
    assert math.dist(surface.GetPoint(centre), surface.GetPoint(inner)) < 1e-12
    end = max(range(points.GetNumberOfPoints()), key=lambda i: points.GetPoint(i)[0])
    assert math.isclose(points.GetPoint(end)[0], radius, rel_tol=1e-12)
    assert math.dist(surface.GetPoint(end), (0, 10, 0)) < 2

# --- Domain: a rectangle, whose corners follow each other counter-clockwise ---------------------------------
plane = Plane(Origin=[0, 0, 0], Point1=[3, 0, 0], Point2=[0, 1, 0], XResolution=30, YResolution=10)
sheet = SurfaceToDisk(Input=plane)
corners = {
    "LowerLeftCorner": [3.0, 0.0, 0.0],
    "LowerRightCorner": [3.0, 1.0, 0.0],
    "UpperRightCorner": [0.0, 1.0, 0.0],
    "UpperLeftCorner": [0.0, 0.0, 0.0],
}
assert math.isclose(figures(flat(sheet, Domain="Rectangle", UseCorners=0))["Modulus"], 3, rel_tol=1e-6)
standing = flat(sheet, Domain="Rectangle", UseCorners=1, **corners)
assert math.isclose(figures(standing)["Modulus"], 1 / 3, rel_tol=1e-6)
bounds = standing.GetDataInformation().GetBounds()
assert math.isclose(bounds[1], 1, rel_tol=1e-6) and math.isclose(bounds[3], 3, rel_tol=1e-6), bounds
for method in ("Boundary First", "Mean Value"):  # an error
    assert flat(sheet, Domain="Rectangle", Method=method).GetDataInformation().GetNumberOfCells() == 0

# --- Tolerance ---------------------------------------------------------------------------------------------
loose = figures(flat(disk, Tolerance=1e-10))["NewtonIterations"]
assert figures(flat(disk, Tolerance=1e-14))["NewtonIterations"] >= loose

proxy = ConformalDisk(Input=disk)
assert tested == set(proxy.ListProperties()), tested ^ set(proxy.ListProperties())
