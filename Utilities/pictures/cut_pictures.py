# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/cuts.png and docs/pictures/cut_maps.png: what the ways to cut in Surface To Disk do to a
brain (ch2bet.nii.gz of Debian's package mricron-data, every second voxel), and what flattening makes of each.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering Utilities/pictures/cut_pictures.py <folder>
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "measurements"))

from catalogue import TEMPLATES
from paraview import simple
from surfaceflattening_volume import isosurface

SIZE = (920, 260)  # pixels
INK = (0.1, 0.1, 0.1)
CUTS = {
    "Cut = Automatic": {},
    "Cut = Hole": {"Cut": "Hole"},
    "Cut = Seam": {"Cut": "Seam"},
    "Cut = Plane": {"Cut": "Plane", "PlaneOrigin": [90, 0, 0], "PlaneNormal": [-1, 0, 0]},
}
FROM = [(-0.5, 0.3, 1), (-1, 0.5, 0), (-1, 1, 1), (1, 0.3, 0.3)]  # where each is looked at from


def brain():
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    coarse = simple.ExtractSubset(Input=scan, VOI=[0, 180, 0, 216, 0, 180])
    coarse.SampleRateI = coarse.SampleRateJ = coarse.SampleRateK = 2
    return isosurface(coarse, 40, smoothing_mm=2, patient_space=False).surface


def titled_view(layout, cell, title):
    view = simple.CreateView("RenderView")
    layout.AssignView(cell, view)
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    text = simple.Show(simple.Text(Text=title), view)
    text.WindowLocation = "Lower Center"
    text.Color = INK
    text.FontSize = 11
    return view


def show(data, view, colour):
    display = simple.Show(data, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = colour
    return display


def views_in_a_row():
    layout = simple.CreateLayout()
    layout.SetSize(*SIZE)
    cells = [0]
    for rest in range(len(CUTS), 1, -1):
        left = layout.SplitHorizontal(cells[-1], 1 / rest)
        cells[-1:] = [left, left + 1]
    return layout, cells


def picture_of_cuts(disks, path):
    layout, cells = views_in_a_row()
    for cell, (title, disk), direction in zip(cells, disks.items(), FROM):
        view = titled_view(layout, cell, title)
        show(disk, view, (0.85, 0.8, 0.75))
        edge = simple.FeatureEdges(
            Input=disk, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0
        )
        line = show(edge, view, (0.9, 0.1, 0.1))
        line.LineWidth = 3
        line.RenderLinesAsTubes = 1
        view.CameraPosition = [90 + 300 * x for x in direction]
        view.CameraFocalPoint = [90, 108, 80]
        view.CameraViewUp = [0, 0, 1]
        view.CameraParallelScale = 100
    simple.SaveScreenshot(path, layout, ImageResolution=SIZE, CompressionLevel="9")


def picture_of_maps(disks, path):
    layout, cells = views_in_a_row()
    for cell, (title, disk) in zip(cells, disks.items()):
        metrics = simple.DistortionMetrics(Input=simple.ConformalDisk(Input=disk))
        metrics.UpdatePipeline()
        mean = metrics.FieldData["AreaWeightedMeanAreaDistortion"].GetRange()[0]
        view = titled_view(layout, cell, f"{title}: mean {mean:.2g}")
        display = simple.Show(metrics, view)
        simple.ColorBy(display, ("CELLS", "AreaDistortion"))
        display.SetScalarBarVisibility(view, False)
        simple.GetColorTransferFunction("AreaDistortion").RescaleTransferFunction(-4.0, 4.0)
        view.ResetCamera()
    simple.SaveScreenshot(path, layout, ImageResolution=SIZE, CompressionLevel="9")


folder = sys.argv[1]
surface = brain()
made = {title: simple.SurfaceToDisk(Input=surface, **settings) for title, settings in CUTS.items()}
picture_of_cuts(made, os.path.join(folder, "cuts.png"))
picture_of_maps(made, os.path.join(folder, "cut_maps.png"))
