# SPDX-License-Identifier: GPL-3.0-or-later
"""The cuts of a Surface To Disk as points that can be moved.

    from surfaceflattening_cuts import edit_cuts

    disk = SurfaceToDisk(Input=brain, Cut="Relief")
    edit_cuts(disk)  # the same cut, with Cut Seam and Use Seam Points
    disk.SeamPoints, disk.SeamPathStarts

The module comes with the plugin. The macro "Edit Cuts" calls it for the Surface To Disk that is selected in the
pipeline browser; then its points are moved in the view.
"""

import math

from paraview import servermanager, simple

# The distance of neighbouring points along a seam, as a share of the diagonal of the surface's bounding box. A
# convention: closer points follow the cut better and are more work to move.
SPACING = 0.08


def edit_cuts(disk=None, spacing=SPACING):
    """Makes the seams that @disk, a Surface To Disk (by default the active source), has cut its Seam Points: the
    ends of each piece and points between them, about @spacing apart in diagonals of the surface. The pieces are
    paths, so that a point where pieces meet has a row for each of them.

    @raise ValueError if there is no Surface To Disk or it has no seam.
    """
    disk = disk or simple.GetActiveSource()
    if disk is None or disk.GetXMLName() != "SurfaceToDisk":
        raise ValueError("select a Surface To Disk in the pipeline browser first")
    disk.UpdatePipeline()
    bounds = disk.GetDataInformation().GetBounds()
    distance = spacing * math.dist(bounds[0::2], bounds[1::2])
    points, starts = [], []
    for piece in seams(servermanager.Fetch(disk, idx=1)):
        starts.append(len(points))
        points += thinned(piece, distance)
    if not points:
        raise ValueError("this Surface To Disk has no seam: set Cut to Relief or Seam, and apply it")
    disk.Cut = "Seam"
    disk.SeamLines = None
    disk.UseSeamPoints = 1
    disk.SeamPoints = [coordinate for point in points for coordinate in point]
    disk.SeamPathStarts = starts[1:]


def seams(cuts):
    """The points of each piece of the seams, without the borders of the surface."""
    ids = cuts.GetCellData().GetArray("SeamId")
    for number in range(cuts.GetNumberOfCells() if ids else 0):
        if ids.GetTuple1(number) > 0:
            line = cuts.GetCell(number).GetPoints()
            yield [line.GetPoint(k) for k in range(line.GetNumberOfPoints())]


def thinned(line, distance):
    """The ends of a line, and points between them at about equal distances."""
    along = [0.0]
    for before, after in zip(line, line[1:]):
        along.append(along[-1] + math.dist(before, after))
    steps = max(1, round(along[-1] / distance))
    kept = [line[0]]
    for step in range(1, steps):
        wanted = along[-1] * step / steps
        nearest = min(range(len(line)), key=lambda k: abs(along[k] - wanted))
        if line[nearest] not in (kept[-1], line[-1]):
            kept.append(line[nearest])
    return [*kept, line[-1]]
