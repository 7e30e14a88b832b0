# SPDX-License-Identifier: GPL-3.0-or-later
"""The cuts of Surface To Disk are edited: as points, and as lines of which some are left out and others are added."""

import math
import os

from paraview import servermanager, simple

simple.LoadPlugin(
    os.path.join(os.environ["PV_PLUGIN_PATH"], "SurfaceFlattening", "SurfaceFlattening.so"), ns=globals()
)
from surfaceflattening_cuts import edit_cuts, seams  # noqa: E402

SurfaceToDisk = globals()["SurfaceToDisk"]


def bump(y, z):
    return f"exp(-((coordsY - {y}) * (coordsY - {y}) + (coordsZ - {z}) * (coordsZ - {z}) + coordsX * coordsX) / 8)"


def pieces(disk):
    """The pieces of the seams as lists of points."""
    disk.UpdatePipeline()
    return list(seams(servermanager.Fetch(disk, idx=1)))


def length(line):
    return sum(math.dist(a, b) for a, b in zip(line, line[1:]))


def farthest(lines, others):
    """The greatest distance of a point of some lines from the nearest point of others."""
    to = [point for line in others for point in line]
    return max(min(math.dist(point, other) for other in to) for line in lines for point in line)


def refused(disk, words):
    try:
        edit_cuts(disk)
    except ValueError as error:
        assert words in str(error), error
    else:
        raise AssertionError(f"no error about {words}")


sphere = simple.Sphere(Radius=10, ThetaResolution=80, PhiResolution=80)
fingers = simple.Calculator(
    Input=sphere, CoordinateResults=1, Function=f"coords * (1 + {bump(6, 8)} + {bump(-6, 8)})"
)
half = simple.Clip(Input=fingers, ClipType="Plane")
half.ClipType.Origin = [0, 0, -3]
half.ClipType.Normal = [0, 0.1, 1]
half.Invert = 0
NEAR = 2.0  # an edge or two on the fingers

# --- As points ----------------------------------------------------------------------------------------------
for surface in (fingers, simple.ExtractSurface(Input=half)):
    disk = SurfaceToDisk(Input=surface, Cut="Relief", ReliefGain=0.02)
    before = pieces(disk)
    assert len(before) >= 2
    edit_cuts(disk)
    assert disk.Cut == "Seam" and disk.UseSeamPoints == 1 and len(disk.SeamPathStarts) == len(before) - 1
    assert len(disk.SeamPoints) < 3 * sum(map(len, before)) / 2
    after = pieces(disk)
    assert len(after) == len(before), (len(before), len(after))
    assert max(farthest(before, after), farthest(after, before)) < NEAR
    for old, new in zip(before, after):  # shorter where a shortest path between the points is
        assert math.dist(old[0], new[0]) < 1e-6 and math.dist(old[-1], new[-1]) < 1e-6
        assert 0.9 * length(old) < length(new) < 1.05 * length(old), (length(old), length(new))

    # The end of the last path is moved to a point away from the seams.
    end = disk.SeamPoints[-3:]
    data = servermanager.Fetch(disk)
    corners = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
    around = [x for x in corners if 2 < math.dist(x, end) < 4]
    place = max(around, key=lambda x: min(math.dist(x, point) for line in after for point in line))
    disk.SeamPoints = [*disk.SeamPoints[:-3], *place]
    moved = pieces(disk)
    assert len(moved) == len(before)
    nearest = min(math.dist(point, place) for line in moved for point in line)
    assert nearest < 1e-6, nearest

refused(sphere, "select a Surface To Disk")
refused(SurfaceToDisk(Input=sphere, Cut="Hole"), "has no seam")

# --- As lines -----------------------------------------------------------------------------------------------
relief = SurfaceToDisk(Input=fingers, Cut="Relief", ReliefGain=0.02)
before = pieces(relief)
ends = [point for line in before for point in (line[0], line[-1])]
last = max(k for k, line in enumerate(before) if ends.count(line[-1]) == 1 or ends.count(line[0]) == 1)
kept = simple.ExtractSurface(
    Input=simple.Threshold(
        Input=simple.OutputPort(relief, 1),
        Scalars=["CELLS", "SeamId"],
        ThresholdMethod="Between",
        LowerThreshold=last + 1,
        UpperThreshold=last + 1,
        Invert=1,
    )
)
without = SurfaceToDisk(Input=fingers, Cut="Seam", SeamLines=kept)
total = sum(map(length, before))
left = sum(map(length, pieces(without)))
assert math.isclose(left, total - length(before[last]), rel_tol=0.01), (left, total, length(before[last]))
# A branch is added to the place that is farthest from the cuts.
cut = [point for line in pieces(without) for point in line]
data = servermanager.Fetch(without)
corners = [data.GetPoint(k) for k in range(0, data.GetNumberOfPoints(), 7)]
far = max(corners, key=lambda corner: min(math.dist(point, corner) for point in cut))
branch = simple.PolyLineSource(Points=[*min(cut, key=lambda point: math.dist(point, far)), *far])
more = SurfaceToDisk(Input=fingers, Cut="Seam", SeamLines=simple.AppendGeometry(Input=[kept, branch]))
added = sum(map(length, pieces(more))) - left
assert added > 5.0, added
assert min(math.dist(point, far) for line in pieces(more) for point in line) < 0.5
