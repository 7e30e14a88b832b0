# SPDX-License-Identifier: GPL-3.0-or-later
"""Every property of Surface To Disk, by its name in paraview.simple, changes the result as it says."""

import math

from paraview import servermanager
from paraview.simple import (
    AppendGeometry,
    Calculator,
    Plane,
    PolyLineSource,
    Sphere,
    Superquadric,
    SurfaceToDisk,
)

tested = {"Input"}


def disk(surface, **properties):
    """The output of the filter; every property given is one that is tested."""
    tested.update(properties)
    proxy = SurfaceToDisk(Input=surface, **properties)
    for name, value in properties.items():
        if name == "SeamLines":
            continue
        was_set = proxy.GetPropertyValue(name)
        assert (list(was_set) if isinstance(value, list) else was_set) == value, (name, was_set)
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def figure(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def close(value, expected, relative):
    assert math.isclose(value, expected, rel_tol=relative), (value, expected)


ball = Sphere(Radius=10, ThetaResolution=40, PhiResolution=40)
ball_area = 4 * math.pi * 10**2
plain = disk(ball, Cut="Hole")
area = figure(plain, "SurfaceArea") + figure(plain, "RemovedArea")

# --- Cut ---------------------------------------------------------------------------------------------------
close(figure(plain, "RemovedArea"), 0.001 * area, 1e-6)
close(figure(disk(ball, Cut="Hole", HoleAreaFraction=0.02), "RemovedArea"), 0.02 * area, 1e-6)

picked = disk(ball, UseHolePoint=1, HolePoint=[0, 0, 10])  # Automatic cuts where it is told to
assert figure(picked, "ChosenCut") == 0
assert picked.GetFieldData().GetArray("HoleCentre").GetTuple3(0)[2] > 9.9
assert abs(plain.GetFieldData().GetArray("HoleCentre").GetTuple3(0)[2]) < 9.9
assert figure(disk(ball, MinimumBoundaryVertices=300), "BoundaryVertices") >= 300

seam = disk(ball, Cut="Seam", UseSeamPoints=1, SeamPoints=[10, 0, 0, 0, 10, 0, 0, 0, 10])
close(figure(seam, "SeamLength"), 10 * math.pi, 0.01)
close(figure(seam, "SurfaceArea"), area, 1e-6)
assert seam.GetPointData().GetArray("Seam").GetRange() == (0, 1)
told = disk(ball, UseSeamPoints=1, SeamPoints=[10, 0, 0, 0, 10, 0, 0, 0, 10])
assert figure(told, "ChosenCut") == 1
assert figure(told, "SeamLength") == figure(seam, "SeamLength")
half = disk(ball, Cut="Seam", UseSeamPoints=1, SeamPoints=[10, 0, 0, 0, 10, 0])
close(figure(half, "SeamLength"), 5 * math.pi, 0.01)
close(figure(half, "SurfaceArea"), figure(seam, "SurfaceArea"), 1e-12)  # nothing is lost
close(figure(disk(ball, Cut="Seam"), "SeamLength"), 10 * math.pi, 0.05)

proxy = SurfaceToDisk(Input=ball, Cut="Seam", UseSeamPoints=1, SeamPoints=[10, 0, 0, 0, 10, 0, 0, 0, 10])
proxy.UpdatePipeline()
proxy.SeamPoints = [10, 0, 0, 0, 10, 0]  # fewer than before
proxy.UpdatePipeline()
close(figure(servermanager.Fetch(proxy), "SeamLength"), 5 * math.pi, 0.01)
proxy.UseSeamPoints = 0
proxy.UpdatePipeline()
close(figure(servermanager.Fetch(proxy), "SeamLength"), 10 * math.pi, 0.05)

# Three quarters of great circles that meet: two paths of points, and three lines.
quarters = [10, 0, 0, 0, 10, 0, 0, 0, 10, 0, 10, 0, -10, 0, 0]
branched = disk(ball, Cut="Seam", UseSeamPoints=1, SeamPoints=quarters, SeamPathStarts=[3])
close(figure(branched, "SeamLength"), 15 * math.pi, 0.01)
close(figure(branched, "SurfaceArea"), figure(seam, "SurfaceArea"), 1e-12)


def arc(a, b):
    points = []
    for i in range(91):
        t = math.radians(i)
        points += [10 * (math.cos(t) * x + math.sin(t) * y) for x, y in zip(a, b)]
    return PolyLineSource(Points=points)


lines = AppendGeometry(Input=[arc((0, 1, 0), end) for end in ((1, 0, 0), (0, 0, 1), (-1, 0, 0))])
drawn = disk(ball, Cut="Seam", SeamLines=lines)
close(figure(drawn, "SeamLength"), 15 * math.pi, 0.01)
far = AppendGeometry(Input=[arc((0, 2, 0), (1, 0, 0))])
assert disk(ball, Cut="Seam", SeamLines=far).GetNumberOfCells() == 0  # an error

# A ball with a finger: the relief ends on its tip, and a lower gain makes more branches.
finger = Calculator(
    Input=Sphere(Radius=10, ThetaResolution=80, PhiResolution=80),
    CoordinateResults=1,
    Function="coords * (1 + exp(-((coordsY - 6) * (coordsY - 6) + (coordsZ - 8) * (coordsZ - 8) "
    "+ coordsX * coordsX) / 8))",
)
relief = disk(finger, Cut="Relief", ReliefGain=0.05)
strain = relief.GetFieldData().GetArray("ReliefStrain").GetTuple2(0)
assert strain[1] < 0.6 * strain[0], strain
assert figure(relief, "ReliefBranches") >= 1
close(figure(relief, "ReliefLength"), figure(relief, "SeamLength"), 1e-12)
close(figure(relief, "BoundaryLength"), 2 * figure(relief, "ReliefLength"), 1e-9)
top = max((relief.GetPoint(i) for i in range(relief.GetNumberOfPoints())), key=lambda x: 6 * x[1] + 8 * x[2])
seams = relief.GetPointData().GetArray("Seam")
on_seam = [relief.GetPoint(i) for i in range(relief.GetNumberOfPoints()) if seams.GetTuple1(i)]
assert min(math.dist(x, top) for x in on_seam) < 3.0
more = disk(finger, Cut="Relief", ReliefGain=0.001)
assert figure(more, "ReliefBranches") > figure(relief, "ReliefBranches")
shorter = disk(finger, Cut="Relief", ReliefGain=0.001, LongestRelief=0.1)
assert figure(shorter, "ReliefBranches") == 1

automatic = disk(ball)  # the default
assert SurfaceToDisk(Input=ball).Cut == "Automatic"
assert figure(automatic, "ChosenCut") == 3 and figure(automatic, "ReliefBranches") >= 1
longer = disk(ball, Cut="Relief", ReliefGain=0.001)  # for a disk, Automatic takes 0.07 at least
assert figure(automatic, "ReliefLength") < figure(longer, "ReliefLength")
close(figure(disk(ball, ReliefGain=0.001), "ReliefLength"), figure(automatic, "ReliefLength"), 1e-12)
free = disk(ball, ReliefGain=0.001, FreeOutline=1)
close(figure(free, "ReliefLength"), figure(longer, "ReliefLength"), 1e-12)

labelled = Calculator(Input=ball, ResultArrayName="Side", Function="if(coordsZ > 4, 3, 1)")
for wanted, share in ((3, 0.7), (1, 0.3)):
    rest = disk(labelled, Cut="Label", LabelArray=["POINTS", "Side"], CutLabel=wanted)
    close(figure(rest, "SurfaceArea"), share * ball_area, 0.05)
    close(figure(rest, "SurfaceArea") + figure(rest, "RemovedArea"), area, 1e-6)
assert disk(labelled, Cut="Label", LabelArray=["POINTS", "Side"], CutLabel=7).GetNumberOfCells() == 0

cap = disk(ball, Cut="Plane", PlaneOrigin=[0, 0, 4], PlaneNormal=[0, 0, 2])
close(figure(cap, "SurfaceArea"), 0.3 * ball_area, 0.01)  # Archimedes
assert cap.GetBounds()[4] > 3.999

# A point at 0 0 0 is not taken for one that was left alone.
beside = Sphere(Radius=10, Center=[5, 0, 0], ThetaResolution=40, PhiResolution=40)
beside.UpdatePipeline()
right = disk(beside, Cut="Plane", PlaneOrigin=[0, 0, 0])
close(figure(right, "SurfaceArea"), 0.75 * ball_area, 0.01)

# --- Region of interest: the half of the ball where the hole would be ------------------------------------
centre = plain.GetFieldData().GetArray("HoleCentre").GetTuple3(0)
marked = Calculator(
    Input=ball,
    ResultArrayName="Region",
    Function=f"coordsX * {centre[0]} + coordsY * {centre[1]} + coordsZ * {centre[2]} > 0",
)
for cut in ("Hole", "Seam", "Relief"):
    for array in (["POINTS", "Region"], ["POINTS", "None"]):
        kept_off = disk(
            marked, Cut=cut, UseRegionOfInterest=int(array[1] == "Region"), RegionOfInterest=array
        )
        regions = kept_off.GetPointData().GetArray("Region")
        seams = kept_off.GetPointData().GetArray("Seam")
        if cut != "Hole":
            crossed = any(
                seams.GetTuple1(i) and regions.GetTuple1(i) for i in range(regions.GetNumberOfTuples())
            )
        else:
            hole = kept_off.GetFieldData().GetArray("HoleCentre").GetTuple3(0)
            crossed = sum(a * b for a, b in zip(hole, centre)) > 0
        assert crossed == (array[1] == "None"), (cut, array)

# --- Component ---------------------------------------------------------------------------------------------
balls = AppendGeometry(Input=[ball, Sphere(Center=[30, 0, 0], Radius=5, ThetaResolution=20)])
assert disk(balls, Component="Largest").GetBounds()[1] < 11
assert disk(balls, Component="Closest To Point", ComponentPoint=[40, 0, 0]).GetBounds()[0] > 24
assert disk(balls, Component="By Index", ComponentIndex=1).GetBounds()[0] > 24

# --- Boundaries --------------------------------------------------------------------------------------------
band = Sphere(Radius=10, StartPhi=30, EndPhi=150, ThetaResolution=60, PhiResolution=30)
ends = {"FillLengthLimit": 32.0}  # their length is 31.4


def height_of_filled(data):
    filled = data.GetCellData().GetArray("Filled")
    heights = [
        data.GetCell(c).GetPoints().GetPoint(0)[2]
        for c in range(data.GetNumberOfCells())
        if filled.GetTuple1(c)
    ]
    return sum(heights) / len(heights)


below = disk(band, Boundary="Closest To Point", BoundaryPoint=[0, 0, -9], **ends)
above = disk(band, Boundary="Closest To Point", BoundaryPoint=[0, 0, 9], **ends)
assert figure(below, "FilledHoles") == figure(above, "FilledHoles") == 1
close(height_of_filled(below), 10 * math.cos(math.radians(30)), 0.01)
close(height_of_filled(above), -10 * math.cos(math.radians(30)), 0.01)
assert figure(disk(band, Boundary="Longest", **ends), "FilledHoles") == 1
assert figure(disk(band, Boundary="Fill All", **ends), "FilledHoles") == 2
assert disk(band, FillLengthLimit=31.0).GetNumberOfCells() == 0  # an error

# --- Handles -----------------------------------------------------------------------------------------------
ring = Superquadric(Toroidal=1, ThetaRoundness=1, PhiRoundness=1, ThetaResolution=48, PhiResolution=48)
merged = {"MergeTolerance": 1e-5}  # the ends of its grid differ by rounding
removed = disk(ring, Handles="Remove", **merged)
assert figure(removed, "Genus") == figure(removed, "RemovedHandles") == 1
cut_open = disk(ring, Handles="Cut", **merged)
assert figure(cut_open, "RemovedHandles") == 0
assert figure(cut_open, "SeamLength") > 0
assert figure(cut_open, "HandleAreaRemoved") == figure(cut_open, "HandleAreaAdded") == 0
assert disk(ring, Handles="Error", **merged).GetNumberOfCells() == 0

# --- Conditioning ------------------------------------------------------------------------------------------
sheet = Plane(XResolution=40, YResolution=40)
mean_edge = (2 + math.sqrt(2)) / 3 / 40
finer = disk(sheet, Remesh=1, RelativeEdgeLength=0.5)
close(figure(finer, "RemeshEdgeLength"), 0.5 * mean_edge, 0.01)
coarser = disk(sheet, Remesh=1, TargetEdgeLength=0.05)
assert figure(coarser, "RemeshEdgeLength") == 0.05
assert coarser.GetNumberOfCells() < 0.2 * finer.GetNumberOfCells()

spiked = Calculator(  # one point, the first pole, three times as far out
    Input=ball, CoordinateResults=1, Function="coords * if(coordsZ > 9.99, 3, 1)"
)
assert figure(disk(spiked, FlattenFolds=1), "RemovedSpikes") == 1
assert figure(disk(spiked, FlattenFolds=0), "RemovedSpikes") == 0

needles = Sphere(ThetaResolution=600, PhiResolution=12)
assert figure(disk(needles, SmallestAngle=0.0), "SmallestAngle") < 0.7
assert figure(disk(needles, SmallestAngle=2.0), "SmallestAngle") >= 2

t = "(2.6 * coordsX)"  # a loop: the sheet crosses itself
looped = Calculator(
    Input=sheet,
    CoordinateResults=1,
    Function=f"({t} * {t} * {t} - {t}) * iHat + coordsY * jHat + {t} * {t} * kHat",
)
assert figure(disk(looped, CountSelfIntersections=1), "SelfIntersectionsBefore") > 40
assert figure(disk(looped, CountSelfIntersections=0), "SelfIntersectionsBefore") == 0
for switch in (0, 1):
    has_curvature = disk(looped, ScaledCurvature=switch).GetPointData().HasArray("ScaledCurvature")
    assert bool(has_curvature) == bool(switch), switch

assert tested == set(proxy.ListProperties()), tested ^ set(proxy.ListProperties())
