# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/slab.png: the grey values of a brain MRI (ch2bet.nii.gz of Debian's package mricron-data) on
the flat map of half its surface, at the surface and at depths of 2, 4 and 8 mm.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering \\
      Utilities/pictures/slab_picture.py <file.png>
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "measurements"))

from catalogue import TEMPLATES
from paraview import simple
from surfaceflattening_volume import isosurface

SIZE = (1200, 345)  # pixels
DEPTHS = (0, 2, 4, 8)  # mm
GREY = (0, 160)


def slab():
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    recipe = isosurface(scan, 40, smoothing_mm=2, patient_space=False)
    disk = simple.SurfaceToDisk(
        Input=recipe.surface, Cut="Plane", PlaneOrigin=[90, 0, 0], Remesh=1, TargetEdgeLength=1.2
    )
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk))
    return simple.FlatMapSlab(Input=flat, Volume=scan, Depths=list(DEPTHS), StackSize=512)


def closer(view):
    simple.ResetCamera(view)
    view.CameraParallelProjection = 1
    view.CameraParallelScale *= 0.83


def main(path):
    stack = simple.OutputPort(slab(), 1)
    stack.UpdatePipeline()
    name = next(n for n in stack.PointData.keys() if n != "InVolume")
    layout = simple.CreateLayout("Slab")
    cells = [layout.SplitHorizontal(0, 0.5)]
    cells = [layout.SplitHorizontal(cells[0], 0.5), layout.SplitHorizontal(cells[0] + 1, 0.5)]
    cells = [cells[0], cells[0] + 1, cells[1], cells[1] + 1]
    for layer, (cell, depth) in enumerate(zip(cells, DEPTHS)):
        view = simple.CreateView("RenderView")
        layout.AssignView(cell, view)
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        view.OrientationAxesVisibility = 0
        view.InteractionMode = "2D"
        one = simple.ExtractSubset(Input=stack, VOI=[0, 511, 0, 511, layer, layer])
        display = simple.Show(one, view, "UniformGridRepresentation")
        display.SetRepresentationType("Slice")
        simple.ColorBy(display, ("POINTS", name))
        display.SetScalarBarVisibility(view, False)
        table = simple.GetColorTransferFunction(name)
        table.ApplyPreset("Grayscale", True)
        table.RescaleTransferFunction(*GREY)
        table.NanColor = [1.0, 1.0, 1.0]
        label = simple.Show(simple.Text(Text=f"{depth} mm"), view)
        label.WindowLocation = "Lower Center"
        label.Color = [0.1, 0.1, 0.1]
        label.FontSize = 14
        closer(view)
    layout.SetSize(*SIZE)
    simple.SaveScreenshot(path, layout, ImageResolution=SIZE, CompressionLevel="9")


if __name__ == "__main__":
    main(sys.argv[1])
