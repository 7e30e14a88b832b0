# SPDX-License-Identifier: GPL-3.0-or-later
"""The four filters by paraview.simple: numbers, weights, the power diagram, and filters out of order."""

import math

from paraview import servermanager
from paraview.simple import (
    Calculator,
    ConformalDisk,
    DistortionMetrics,
    OMTAreaPreserving,
    OutputPort,
    Plane,
    PolyLineSource,
    Sphere,
    SurfaceToDisk,
)


def fetch(proxy, port=0):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, idx=port)


def figure(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def total(data, name, attributes):
    array = attributes.GetArray(name)
    return math.fsum(array.GetTuple1(i) for i in range(array.GetNumberOfTuples()))


ball = Sphere(Radius=40, ThetaResolution=60, PhiResolution=60)
stretched = Calculator(
    Input=ball,
    CoordinateResults=1,
    Function="coordsX * iHat + 1.5 * coordsY * jHat + (0.8 + 0.004 * coordsX) * coordsZ * kHat",
)

# --- Out of order: nothing is raised, the output is empty, and the pipeline can be put right --------------
conformal = ConformalDisk(Input=stretched)  # a closed surface
area_preserving = OMTAreaPreserving(Input=conformal)
metrics = DistortionMetrics(Input=area_preserving)
metrics.UpdatePipeline()
for proxy in (conformal, area_preserving, metrics):
    assert proxy.GetDataInformation().GetNumberOfCells() == 0

disk = SurfaceToDisk(Input=stretched, Cut="Hole", HoleAreaFraction=0.01)
area_preserving.Input = disk  # no SurfacePoints
metrics.UpdatePipeline()
assert metrics.GetDataInformation().GetNumberOfCells() == 0

# --- In order ----------------------------------------------------------------------------------------------
conformal.Input = disk
area_preserving.Input = conformal
surface = fetch(disk)
cells = surface.GetNumberOfCells()
assert figure(surface, "Genus") == 0
assert figure(surface, "BoundaryVertices") >= 128

flat = fetch(conformal)
assert flat.GetNumberOfCells() == cells
assert figure(flat, "MaxCurvatureError") <= 1e-10
radius = math.sqrt(figure(surface, "SurfaceArea") / math.pi)
xmin, xmax, ymin, ymax, zmin, zmax = flat.GetBounds()
for extent in (-xmin, xmax, -ymin, ymax):
    assert math.isclose(extent, radius, rel_tol=1e-3), (extent, radius)
assert zmin == zmax == 0

flat = fetch(area_preserving)
assert flat.GetNumberOfCells() == cells
assert figure(flat, "MaxCellAreaError") <= 1e-6
area = total(flat, "CellArea", flat.GetPointData())
assert math.isclose(area, figure(surface, "SurfaceArea"), rel_tol=1e-9)
for point in range(0, flat.GetNumberOfPoints(), 97):
    assert flat.GetPointData().GetArray("SurfacePoints").GetTuple3(point) == surface.GetPoint(point)

diagram = fetch(area_preserving, 1)
assert diagram.GetNumberOfCells() == figure(flat, "Sites") < flat.GetNumberOfPoints()
assert math.isclose(total(diagram, "CellArea", diagram.GetCellData()), area, rel_tol=1e-12)
assert OutputPort(area_preserving, 1).GetDataInformation().GetNumberOfCells() == diagram.GetNumberOfCells()

area_preserving.PointsPerSite = 1
assert fetch(area_preserving, 1).GetNumberOfCells() == flat.GetNumberOfPoints()
area_preserving.PointsPerSite = 16

measured = fetch(metrics)
assert measured.GetNumberOfCells() == cells
assert measured.GetCellData().GetArray("AreaDistortion")
table = fetch(metrics, 1)
assert table.GetNumberOfRows() == 1
assert table.GetValueByName(0, "Faces").ToInt() == cells
error = table.GetValueByName(0, "AreaWeightedMeanAreaError").ToDouble()
before = DistortionMetrics(Input=conformal)
conformal_error = fetch(before, 1).GetValueByName(0, "AreaWeightedMeanAreaError").ToDouble()
assert error < 0.2 * conformal_error, (error, conformal_error)

# --- Weights: the upper half gets three times its area, relative to the lower -----------------------------
weighted = Calculator(
    Input=conformal, ResultArrayName="Importance", Function="1 + 2 * (SurfacePoints_Z > 0)"
)
focus = OMTAreaPreserving(
    Input=weighted, UseAreaWeight=1, AreaWeightArray=["POINTS", "Importance"]
)


def ratio(proxy):
    data = fetch(proxy)
    points = data.GetPointData()
    halves = [0.0, 0.0]
    for i in range(data.GetNumberOfPoints()):
        upper = points.GetArray("SurfacePoints").GetComponent(i, 2) > 0
        halves[upper] += points.GetArray("CellArea").GetTuple1(i)
    return halves[1] / halves[0]


assert math.isclose(ratio(focus) / ratio(area_preserving), 3, rel_tol=1e-5)

# A weight of 0 is refused; the next Apply works.
weighted.Function = "SurfacePoints_Z > 0"
focus.UpdatePipeline()
assert focus.GetDataInformation().GetNumberOfCells() == 0
weighted.Function = "1"
focus.UpdatePipeline()
assert focus.GetDataInformation().GetNumberOfCells() == cells

# --- Domain: a polygon is filled, its corners too --------------------------------------------------------------
square = Plane(Origin=[1, 2, 0], Point1=[2, 2, 0], Point2=[1, 3, 0])
wide = ConformalDisk(Input=SurfaceToDisk(Input=stretched, Cut="Hole", HoleAreaFraction=0.05))
into_square = OMTAreaPreserving(Input=wide, Domain=square, FixCorners=1, NormalizeTo="Unit Domain")
data = fetch(into_square)
assert data.GetNumberOfCells() == fetch(wide).GetNumberOfCells() > 0
for bound, expected in zip(data.GetBounds(), (1, 2, 2, 3, 0, 0)):
    assert math.isclose(bound, expected, abs_tol=1e-12), data.GetBounds()
assert math.isclose(total(data, "CellArea", data.GetPointData()), 1, rel_tol=1e-12)
assert figure(data, "Bijective") == 1 and figure(data, "FlippedFaces") == 0
assert data.GetFieldData().GetArray("CornerPointIds").GetNumberOfTuples() == 4
measured = fetch(DistortionMetrics(Input=into_square))
assert figure(measured, "FacesWithin2Percent") > 98, figure(measured, "FacesWithin2Percent")
assert math.isclose(figure(measured, "FlatArea"), 1, rel_tol=1e-12)
dart = PolyLineSource(Points=[0, 0, 0, 2, 0, 0, 0.5, 0.5, 0, 0, 2, 0], Closed=1)
into_square.Domain = dart
into_square.UpdatePipeline()
assert into_square.GetDataInformation().GetNumberOfCells() == 0
into_square.Domain = None
assert fetch(into_square).GetNumberOfCells() == data.GetNumberOfCells()
