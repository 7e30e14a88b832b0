# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/texture.png: one picture, a chessboard in colours, as the texture of the flat map of half
a brain (ch2bet.nii.gz of Debian's package mricron-data) and of the surface.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering \\
      Utilities/pictures/texture_picture.py <file.png>
"""

import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "measurements"))

from catalogue import TEMPLATES
from paraview import simple
from surfaceflattening_texture import surface_of
from surfaceflattening_volume import isosurface
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkIOImage import vtkPNGWriter

SIZE = (1000, 500)  # pixels
FIELDS = 16


def half_brain_map():
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    brain = isosurface(scan, 40, smoothing_mm=2, patient_space=False).surface
    disk = simple.SurfaceToDisk(
        Input=brain, Cut="Plane", PlaneOrigin=[90, 0, 0], Remesh=1, TargetEdgeLength=1.2
    )
    return simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk))


def chessboard(path, pixels=1024):
    """Red grows to the right, green upwards; every other field is light."""
    canvas = vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetNumberOfScalarComponents(3)
    canvas.SetExtent(0, pixels - 1, 0, pixels - 1, 0, 0)
    field = pixels // FIELDS
    for i in range(FIELDS):
        for j in range(FIELDS):
            light = 130 if (i + j) % 2 else 25
            canvas.SetDrawColor(
                light + 125 * i // (FIELDS - 1), light + 125 * j // (FIELDS - 1), light + 90
            )
            canvas.FillBox(field * i, field * (i + 1) - 1, field * j, field * (j + 1) - 1)
    writer = vtkPNGWriter()
    writer.SetInputConnection(canvas.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def show(source, view, texture):
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    display = simple.Show(source, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = [1.0, 1.0, 1.0]
    display.Texture = texture


def closer(view):
    simple.ResetCamera(view)
    view.CameraParallelProjection = 1
    view.CameraParallelScale *= 0.74


def main(path):
    flat = half_brain_map()
    with tempfile.TemporaryDirectory() as folder:
        pictures = [os.path.join(folder, name) for name in ("left.png", "right.png")]
        for picture in pictures:  # one each: views cannot share a texture
            chessboard(picture)
        layout = simple.CreateLayout("Texture")
        left = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view=left, layout=layout, hint=0)
        layout.SplitHorizontal(0, 0.5)
        right = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view=right, layout=layout, hint=2)
        show(flat, left, simple.CreateTexture(pictures[0]))
        show(surface_of(flat), right, simple.CreateTexture(pictures[1]))
        left.InteractionMode = "2D"
        closer(left)
        right.CameraPosition = [-400, 60, 130]
        right.CameraFocalPoint = [60, 100, 90]
        right.CameraViewUp = [0, 0, 1]
        closer(right)
        layout.SetSize(*SIZE)
        simple.SaveScreenshot(path, layout, ImageResolution=SIZE)


if __name__ == "__main__":
    main(sys.argv[1])
