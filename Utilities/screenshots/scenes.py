# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets up a scene of screenshots.sh in the window of ParaView, which runs this script. The variable SCENE holds the name of
the scene, SCENE_READY the name of a file that is made when the scene is ready."""

import os

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip
from surfaceflattening_layout import flatten_and_compare
from surfaceflattening_volume import isosurface

SCAN = "/usr/share/mricron/templates/ch2bet.nii.gz"  # Debian's package mricron-data
ISOVALUE = 40
CORE_FILTERS = ("SurfaceToDisk", "ConformalDisk", "OMTAreaPreserving", "DistortionMetrics")
# A fold on the area-preserving map: from and to, in shares of the view's width and height.
BRUSHED = (0.42, 0.42, 0.58, 0.54)


def brain():
    surface = isosurface(simple.OpenDataFile(SCAN), ISOVALUE, smoothing_mm=2).surface
    surface.UpdatePipeline()
    return surface


def core_filter(name):
    """The pipeline up to a filter, whose panel is shown with its output."""
    proxy = brain()
    for function in CORE_FILTERS[: CORE_FILTERS.index(name) + 1]:
        settings = {"Remesh": 1, "TargetEdgeLength": 1.9} if function == "SurfaceToDisk" else {}
        proxy = getattr(simple, function)(Input=proxy, **settings)
    simple.Show(proxy)
    simple.SetActiveSource(proxy)
    simple.ResetCamera()
    simple.Render()


def linked_selection():
    """Brushes a fold on the area-preserving map, as a drag with the S key does."""
    comparison = flatten_and_compare(brain())
    view = next(
        view
        for view in simple.GetViewsInLayout(comparison.layout)
        if any(
            getattr(display, "Input", None) == comparison.area_preserving
            for display in view.Representations
        )
        and view.GetXMLName() == "RenderView"
    )
    width, height = view.ViewSize
    left, low, right, high = BRUSHED
    simple.SelectSurfaceCells(
        Rectangle=[int(left * width), int(low * height), int(right * width), int(high * height)],
        View=view,
    )
    simple.RenderAllViews()


def error_message():
    """A closed surface given to Conformal Disk."""
    simple.Show(simple.Sphere(ThetaResolution=40, PhiResolution=40))
    simple.ResetCamera()
    simple.SetActiveSource(simple.ConformalDisk())
    simple.UpdatePipeline()
    simple.Render()


scene = os.environ["SCENE"]
if scene in CORE_FILTERS:
    core_filter(scene)
else:
    {"linked_selection": linked_selection, "error_message": error_message}[scene]()
open(os.environ["SCENE_READY"], "w").close()
