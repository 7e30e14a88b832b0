# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/free_outline.png: a whole brain (ch2bet.nii.gz of Debian's package mricron-data), opened along its
relief, with its map in the disk and its map with a free outline, by AAL region and with the sulci dark.

    PV_PLUGIN_PATH=build/plugins \\
      xvfb-run -a -s "-screen 0 1280x1024x24" pvpython --force-offscreen-rendering \\
      Utilities/pictures/free_outline_picture.py <folder>
"""

import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "demo"))

from aal_atlas import UNLABELLED, colour_of, read_names
from figure import INK, look, region_colour_map, render_view, shade_map, show_regions
from flattening_pipeline import ISOVALUE, LABEL_REACH, REGION, SHADE, SMOOTHING, with_shade
from paraview import simple
from surfaceflattening_views import measured_errors, split
from surfaceflattening_volume import cast_to_float, contour, pad, smooth

TEMPLATES = "/usr/share/mricron/templates"
SIZE = (2000, 660)  # pixels
WIDTHS = (0.25, 0.3, 0.45)  # shares of the surface, the disk and the map with a free outline
MAP_HEIGHT = 450.0  # mm that a view of a map shows, the same for both
SCALE_BAR = 50.0  # mm
CUT_COLOUR = (0.8, 0.0, 0.0)


def labelled(surface):
    """Adds the point array Region: the label of the nearest voxel that has one; 0 where none is near."""
    atlas = simple.NIfTIImageReader(FileName=os.path.join(TEMPLATES, "aal.nii.gz"))
    atlas.UpdatePipeline()
    label = atlas.PointData.keys()[0]
    voxels = simple.Threshold(
        Input=simple.Calculator(Input=atlas, ResultArrayName="NearestRegion", Function=label),
        Scalars=["POINTS", "NearestRegion"],
        ThresholdMethod="Above Upper Threshold",
        UpperThreshold=0.5,
    )
    positions = simple.Calculator(Input=voxels, ResultArrayName="LabelPosition", Function="coords")
    nearest = simple.PointDatasetInterpolator(
        Input=positions, Source=surface, Kernel="VoronoiKernel", PassPointArrays=1
    )
    return simple.Calculator(
        Input=nearest,
        ResultArrayName=REGION,
        ResultArrayType="Int",
        Function=f"if(mag(coords-LabelPosition) < {LABEL_REACH:g}, NearestRegion, 0)",
    )


def outlined(source, view):
    """Draws the boundary, which is where the surface is cut."""
    edges = simple.FeatureEdges(
        Input=source, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0
    )
    display = simple.Show(edges, view)
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = CUT_COLOUR
    display.LineWidth = 3
    display.RenderLinesAsTubes = 1


def shaded(source, other, view):
    """Regions from one source and the shade from another: a view shows each source once."""
    for shown, array in ((source, REGION), (other, SHADE)):
        display = show_regions(shown, view, array)
        display.Ambient = 1.0
        display.Diffuse = 0.0


def scale_bar(bounds, view):
    """A line of known length below the middle of the map."""
    middle = 0.5 * (bounds[0] + bounds[1])
    low = 0.5 * (bounds[2] + bounds[3]) - 0.43 * MAP_HEIGHT
    ends = [[middle + side * SCALE_BAR / 2, low, 0] for side in (-1, 1)]
    display = simple.Show(simple.Line(Point1=ends[0], Point2=ends[1]), view)
    display.DiffuseColor = display.AmbientColor = INK
    display.LineWidth = 5
    text = simple.Show(simple.Text(Text=f"{SCALE_BAR:g} mm"), view)
    text.WindowLocation = "Lower Center"
    text.Color = INK
    text.FontSize = 15


def surface_view(disk):
    view = render_view("(a) The surface and its cuts")
    display = show_regions(disk, view, REGION)
    display.Specular = 0.0
    outlined(disk, view)
    look(view, disk.GetDataInformation().GetBounds(), [0.3, 0.8, 0.5], [0.0, 0.0, 1.0], 0.4, 0.03)
    return view


def map_view(title, flat):
    metrics = simple.DistortionMetrics(Input=flat)
    metrics.UpdatePipeline()
    view = render_view(f"{title}\n{measured_errors(metrics)}")
    shaded(metrics, flat, view)
    outlined(flat, view)
    bounds = metrics.GetDataInformation().GetBounds()
    scale_bar(bounds, view)
    look(view, bounds, [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], 0.0, 0.0)
    view.CameraParallelScale = MAP_HEIGHT / 2
    return view


def colour_maps(surface):
    names = read_names(os.path.join(TEMPLATES, "aal.nii.txt"))
    names[UNLABELLED] = "unlabelled"
    colours = {label: colour_of(name) for label, name in names.items()}
    region_colour_map(REGION, sorted(names), names, colours)
    low, high = surface.GetDataInformation().GetPointDataInformation().GetArrayInformation(SHADE).GetComponentRange(0)
    shade_map(SHADE, low + 0.4 * (high - low), low + 0.8 * (high - low))


def main():
    scan = simple.NIfTIImageReader(FileName=os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    volume = pad(cast_to_float(scan))
    surface = labelled(with_shade(contour(smooth(volume, SMOOTHING), ISOVALUE, name="Brain"), volume))
    disk = simple.SurfaceToDisk(Input=surface, Cut="Relief", Remesh=1)
    disk.UpdatePipeline()
    colour_maps(disk)
    conformal = simple.ConformalDisk(Input=disk)
    views = [
        surface_view(disk),
        map_view("(b) In the disk", simple.OMTAreaPreserving(Input=conformal)),
        map_view("(c) With a free outline", simple.OMTAreaPreserving(Input=conformal, FreeOutline=1)),
    ]
    layout = simple.CreateLayout("Free outline")
    for cell, view in zip(split(layout, 0, WIDTHS, "Horizontal"), views):
        layout.AssignView(cell, view)
    layout.SetSize(SIZE)
    path = os.path.join(sys.argv[1], "free_outline.png")
    simple.SaveScreenshot(path, layout, ImageResolution=SIZE, CompressionLevel="9")


if __name__ == "__main__":
    main()
