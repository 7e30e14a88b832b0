# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/seams.png: the relief of a brain (ch2bet.nii.gz of Debian's package mricron-data, every second
voxel) on the surface and on the map with a free outline. The same piece of the cut has the same colour and number in
both, and dots are as far from its start.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering Utilities/pictures/seams_picture.py <folder>
"""

import colorsys
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("measurements", "gallery"):
    sys.path.insert(0, os.path.join(HERE, "..", folder))

import panels
from catalogue import TEMPLATES
from paraview import simple
from surfaceflattening_volume import isosurface

SURFACE_SIZE = (430, 400)  # pixels
MAP_SIZE = (560, 400)
DOTS = 20.0  # mm along the seams
CORTEX = (0.87, 0.84, 0.8)


def brain():
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    coarse = simple.ExtractSubset(Input=scan, VOI=[0, 180, 0, 216, 0, 180])
    coarse.SampleRateI = coarse.SampleRateJ = coarse.SampleRateK = 2
    return isosurface(coarse, 40, smoothing_mm=2, patient_space=False).surface


def dots(lines):
    """Points of the lines at every so many millimetres from the start of the seams."""
    longest = lines.PointData["SeamDistance"].GetRange()[1]
    return simple.Contour(
        Input=lines,
        ContourBy=["POINTS", "SeamDistance"],
        Isosurfaces=[DOTS * k for k in range(1, int(longest / DOTS) + 1)],
        ComputeScalars=0,
    )


def panel(solid, lines, size, direction, up, colours):
    view = panels.new_view()
    flat = direction == (0, 0, -1)
    display = panels.show_flat(solid, view) if flat else panels.show_solid(solid, view)
    panels.one_colour(display, CORTEX)
    display.Opacity = 1.0 if flat else 0.35  # the cuts on the far side are seen
    display = panels.show_flat(lines, view)
    panels.colour_by(display, "POINTS", "SeamId")
    panels.categories("SeamId", colours)
    display.LineWidth = panels.OVERSAMPLING * 4
    display.RenderLinesAsTubes = 0 if flat else 1  # tubes would hide dots
    panels.show_points(dots(lines), view, (0.0, 0.0, 0.0), 7)
    panels.look(view, solid.GetDataInformation().GetBounds(), size, direction, up)
    return panels.screenshot(view, size)


def main():
    disk = simple.SurfaceToDisk(Input=brain(), Cut="Relief", LongestRelief=1.5)
    cuts = simple.OutputPort(disk, 1)
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk), FreeOutline=1)
    banks = simple.FeatureEdges(
        Input=flat, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0
    )
    banks.UpdatePipeline()
    disk.UpdatePipeline()
    count = int(disk.PointData["SeamId"].GetRange()[1])
    colours = {k + 1: colorsys.hsv_to_rgb(k / count, 1.0, 0.65 + 0.25 * (k % 2)) for k in range(count)}
    colours[0] = (0.4, 0.4, 0.4)
    print(count, "pieces,", disk.FieldData["SeamLength"].GetRange()[0], "mm")
    panels.compose(
        os.path.join(sys.argv[1], "seams.png"),
        [
            [
                (panel(disk, cuts, SURFACE_SIZE, (1, 0.4, -0.4), (0, 0, 1), colours), "(a) Cuts on the surface"),
                (panel(flat, banks, MAP_SIZE, (0, 0, -1), (0, 1, 0), colours), "(b) Both banks on the flat map"),
            ]
        ],
        smooth=True,
    )


if __name__ == "__main__":
    main()
