# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/refinement.png: half a brain (ch2bet.nii.gz of Debian's package mricron-data) after the
conformal map, after the transport alone and after face refinement, coloured by area distortion on one scale.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering \\
      Utilities/pictures/refinement_picture.py <file.png>
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "measurements"))

from catalogue import TEMPLATES
from paraview import simple
from surfaceflattening_volume import isosurface

SIZE = (1500, 580)  # pixels
RANGE = 0.2
ARRAY = "AreaDistortion"


def half_brain():
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    brain = isosurface(scan, 40, smoothing_mm=2, patient_space=False).surface
    return simple.SurfaceToDisk(
        Input=brain, Cut="Plane", PlaneOrigin=[90, 0, 0], Remesh=1, TargetEdgeLength=1.2
    )


def measured(flat):
    metrics = simple.DistortionMetrics(Input=flat)
    metrics.UpdatePipeline()
    return metrics


def caption(title, metrics):
    within = metrics.FieldData["FacesWithin2Percent"].GetRange()[0]
    flipped = metrics.FieldData["FlippedFaces"].GetRange()[0]
    return f"{title}: {within:.1f} % of the faces\nwithin 2 % of their area, {flipped:.0f} flipped"


def colours():
    table = simple.GetColorTransferFunction(ARRAY)
    table.ApplyPreset("Cool to Warm", True)
    table.RescaleTransferFunction(-RANGE, RANGE)
    return table


def show(metrics, view, text, with_bar):
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = "2D"
    display = simple.Show(metrics, view)
    simple.ColorBy(display, ("CELLS", ARRAY))
    display.SetScalarBarVisibility(view, with_bar)
    label = simple.Show(simple.Text(Text=text), view)
    label.WindowLocation = "Lower Center"
    label.Color = [0.1, 0.1, 0.1]
    label.FontSize = 13
    if with_bar:
        bar = simple.GetScalarBar(colours(), view)
        bar.Title = "log of surface over flat area"
        bar.ComponentTitle = ""
        bar.Orientation = "Horizontal"
        bar.WindowLocation = "Upper Center"
        bar.ScalarBarLength = 0.5
        bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
        bar.TitleFontSize = bar.LabelFontSize = 13
        bar.RangeLabelFormat = "%.1f"
    radius = metrics.GetDataInformation().GetBounds()[1]
    view.CameraParallelProjection = 1
    view.CameraPosition = [0, 0, 10]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 1.62 * radius


def main(path):
    conformal = simple.ConformalDisk(Input=half_brain(), NormalizeTo="Surface Area")
    maps = (
        ("Conformal", conformal),
        ("Transport alone", simple.OMTAreaPreserving(Input=conformal, FaceRefinement=0)),
        ("Refined", simple.OMTAreaPreserving(Input=conformal)),
    )
    layout = simple.CreateLayout()
    layout.SetSize(*SIZE)
    left = layout.SplitHorizontal(0, 1 / 3)
    middle = layout.SplitHorizontal(left + 1, 0.5)
    colours()
    for number, (cell, (title, flat)) in enumerate(zip((left, middle, middle + 1), maps)):
        view = simple.CreateView("RenderView")
        layout.AssignView(cell, view)
        metrics = measured(flat)
        show(metrics, view, caption(title, metrics), number == 1)
    colours()  # showing a map rescales them
    simple.SaveScreenshot(path, layout, ImageResolution=SIZE, CompressionLevel="9")


if __name__ == "__main__":
    main(sys.argv[1])
