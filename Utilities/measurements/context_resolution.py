# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens half a brain (ch2bet.nii.gz of Debian's package mricron-data) whole and with a coarse context around its
salient regions, and compares processor time and the areas of the regions, as a table in Markdown. With a file name
also makes docs/pictures/context_resolution.png.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering \\
      Utilities/measurements/context_resolution.py [<file.png>]
"""

import os
import sys

from catalogue import TEMPLATES
from paraview import servermanager, simple
from surfaceflattening_volume import isosurface

CONTEXTS = (20000, 10000, 5000)  # faces
REGION = ["POINTS", "SaliencyRegion"]


def salient_half_brain():
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    brain = isosurface(scan, 40, smoothing_mm=2, patient_space=False).surface
    disk = simple.SurfaceToDisk(Input=brain, Cut="Plane", PlaneOrigin=[90, 0, 0])
    salient = simple.MeshSaliency(Input=disk, Percentile=95, Unit=1.5, MinimumRegionArea=30)
    salient.UpdatePipeline()
    return salient


def seconds(proxy):
    """Processor time of what is not up to date yet."""
    before = os.times()
    proxy.UpdatePipeline()
    after = os.times()
    return after.user + after.system - before.user - before.system


def flattened(surface):
    """The measured map, its regions' shares of the flat area by label, and the processor time."""
    conformal = simple.ConformalDisk(Input=surface)
    flat = simple.OMTAreaPreserving(Input=conformal)
    time = seconds(flat)
    metrics = simple.DistortionMetrics(Input=flat, UseRegionArray=1, RegionArray=REGION)
    metrics.UpdatePipeline()
    table = servermanager.Fetch(metrics, idx=1)
    areas = {
        table.GetValueByName(i, "RegionId").ToInt(): (
            table.GetValueByName(i, "FlatArea").ToDouble(),
            table.GetValueByName(i, "MeanAngleError").ToDouble(),
        )
        for i in range(table.GetNumberOfRows())
    }
    return metrics, areas, time


def row(name, surface, areas, whole, to_coarsen, time, whole_time):
    regions = [label for label in areas if label > 0]
    errors = [abs(areas[label][0] / whole[label][0] - 1) for label in regions]
    angle = sum(areas[label][1] for label in regions) / len(regions)
    cells = surface.GetDataInformation().GetNumberOfCells()
    return (
        f"| {name} | {cells:,} | {to_coarsen:.1f} | {time:.1f} | {whole_time / (time + to_coarsen):.1f} | "
        f"{100 * sum(errors) / len(errors):.2f} % | {100 * max(errors):.2f} % | {angle:.1f}° |"
    )


def main(picture):
    salient = salient_half_brain()
    _, whole, whole_time = flattened(salient)
    count = len([label for label in whole if label > 0])
    kept = None
    rows = [row("whole", salient, whole, whole, 0.0, whole_time, whole_time)]
    for faces in CONTEXTS:
        coarse = simple.ContextResolution(Input=salient, RegionArray=REGION, ContextFaces=faces)
        to_coarsen = seconds(coarse)
        kept = coarse.FieldData["KeptCells"].GetRange()[0]
        _, areas, time = flattened(coarse)
        rows.append(row(f"{faces:,}", coarse, areas, whole, to_coarsen, time, whole_time))
    print(f"{count} regions, {kept:,.0f} triangles in and around them\n")
    print("| triangles of the context | in all | coarsening (s) | flattening (s) | speed-up | "
          "area of regions: mean difference | greatest | angle error in regions |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    print("\n".join(rows))
    if picture:
        draw(salient, picture)


def draw(salient, path):
    coarse = simple.ContextResolution(Input=salient, RegionArray=REGION, ContextFaces=10000)
    marked = simple.Calculator(Input=coarse, ResultArrayName="Fine", Function="SaliencyRegion > 0")
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.ViewSize = [640, 400]
    display = simple.Show(marked, view)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.3, 0.3, 0.3]
    simple.ColorBy(display, ("POINTS", "Fine"))
    display.SetScalarBarVisibility(view, False)
    simple.GetColorTransferFunction("Fine").RGBPoints = [0, 0.85, 0.87, 0.9, 1, 0.95, 0.55, 0.2]
    view.CameraPosition = [-400, 150, 110]
    view.CameraFocalPoint = [60, 150, 60]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 30
    simple.SaveScreenshot(path, view, ImageResolution=[640, 400], CompressionLevel="9")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
