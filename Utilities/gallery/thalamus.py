# SPDX-License-Identifier: GPL-3.0-or-later
"""A structure that is not cortex: the left thalamus of the AAL atlas, in patient space, and its flat map."""

import os

import panels
from paraview import simple
from surfaceflattening_volume import label_surface

TITLE = "A thalamus"
PICTURE = "thalamus.png"
TEMPLATES = "/usr/share/mricron/templates"  # Debian's package mricron-data
LABEL = 77  # Thalamus_L in aal.nii.txt
SIDE = (330, 330)  # pixels
HEIGHT = "Height"  # mm above the middle of the anterior commissure, the origin of the atlas


def panel(source, direction, up, flat):
    view = panels.new_view()
    display = panels.show_flat(source, view) if flat else panels.show_solid(source, view)
    panels.colour_by(display, "POINTS", HEIGHT)
    panels.look(view, source.GetDataInformation().GetBounds(), SIDE, direction, up)
    return panels.screenshot(view, SIDE)


def make(path):
    atlas = simple.NIfTIImageReader(FileName=os.path.join(TEMPLATES, "aal.nii.gz"))
    surface = label_surface(atlas, LABEL, smoothing_mm=1.5, name="Thalamus_L").surface
    high = simple.Calculator(Input=surface, ResultArrayName=HEIGHT, Function="coordsZ")
    disk = simple.SurfaceToDisk(Input=high, Remesh=1, TargetEdgeLength=0.7)
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk), FreeOutline=1)
    metrics = simple.DistortionMetrics(Input=flat, UseRegionArray=0)
    metrics.UpdatePipeline()
    low, top = disk.PointData[HEIGHT].GetRange()
    table = simple.GetColorTransferFunction(HEIGHT)
    table.RGBPoints = [low, 0.15, 0.3, 0.6, (low + top) / 2, 0.95, 0.95, 0.9, top, 0.75, 0.3, 0.1]
    panels.compose(
        path,
        [
            [
                (panel(disk, (1, 0, 0), (0, 0, 1), False), "(a) lateral"),
                (panel(disk, (-1, 0, 0), (0, 0, 1), False), "(b) medial"),
                (panel(metrics, (0, 0, -1), (0, 1, 0), True), "(c) flat map"),
            ]
        ],
        smooth=True,
    )

    def figure(name):
        return metrics.FieldData[name].GetRange()[0]

    return [
        "The left thalamus, label 77 of `aal.nii.gz`: the voxels of the label smoothed by 1.5 mm (`label_surface(atlas, 77, "
        "smoothing_mm=1.5)`), where the patient is; blue is low, red is high. The map has the area of the surface, "
        f"{figure('SurfaceArea'):,.0f} mm\u00b2; {figure('FacesWithin2Percent'):.1f} % of the triangles have their areas "
        f"within 2 %, the mean angle error is {figure('AreaWeightedMeanAngleError'):.1f}\u00b0.",
        "",
        "In the GUI: *Calculator* on the atlas, `if(NIFTI==77,1,0)` with *Result Array Name* `NIFTI`; *Image Cast*, *Image Pad*, *Image Gaussian Smooth* with 1.5, "
        "*Contour* at 0.5, *Patient Space*, *Surface To Disk* with *Remesh*, *Conformal Disk*, *OMT Area "
        "Preserving* with *Free Outline*.",
    ]
