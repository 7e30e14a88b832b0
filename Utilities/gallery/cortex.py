# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat map of one hemisphere as atlases of the cortex draw it: curvature in grey, outlines of AAL regions, a scale
bar; cut along its relief, with a free outline."""

import os
import sys

import numpy as np
import panels
from paraview import servermanager, simple
from PIL import ImageDraw
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "demo"))

import aal_atlas
import flattening_pipeline

TITLE = "Map of a cortex"
PICTURE = "cortex.png"
TEMPLATES = "/usr/share/mricron/templates"  # Debian's package mricron-data
SIDE = (380, 330)  # pixels
MAP = (760, 620)
CURVATURE = "Mean_Curvature"  # of ParaView's filter, per mm: negative in a sulcus
GREATEST = 0.12  # per mm; stronger curvature is drawn like this
SCALE_BAR = 50  # mm
NAMED = 30  # the largest regions have their names on the map
OUTLINE = (0.75, 0.1, 0.1)
CUT = (0.1, 0.3, 0.8)


def hemisphere():
    """The left half of the smoothed brain with curvature and AAL regions."""
    scan = simple.NIfTIImageReader(FileName=os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    volume = flattening_pipeline.pad(flattening_pipeline.cast_to_float(scan))
    smoothed = flattening_pipeline.smooth(volume, flattening_pipeline.SMOOTHING)
    surface = flattening_pipeline.contour(smoothed, flattening_pipeline.ISOVALUE, name="Brain surface")
    bounds = volume.GetDataInformation().GetBounds()
    half = simple.SurfaceToDisk(
        Input=surface,
        Cut="Plane",
        PlaneOrigin=[(bounds[0] + bounds[1]) / 2, 0, 0],
        PlaneNormal=[-1, 0, 0],
        Remesh=1,
        TargetEdgeLength=flattening_pipeline.EDGE_LENGTH,
    )
    curved = simple.Curvature(Input=half, CurvatureType="Mean")
    return flattening_pipeline.with_labels(curved, os.path.join(TEMPLATES, "aal.nii.gz"))


def outlines(data, array):
    """Lines between the regions of point array @p array: through the middles of edges whose ends differ, and through
    the middles of triangles with three regions."""
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    labels = vtk_to_numpy(data.GetPointData().GetArray(array))[triangles]
    middles = 0.5 * (points[triangles] + points[np.roll(triangles, -1, axis=1)])
    differs = labels != np.roll(labels, -1, axis=1)
    two = differs.sum(axis=1) == 2
    three = differs.all(axis=1)
    ends = [middles[two][differs[two]].reshape(-1, 2, 3)]
    centres = points[triangles[three]].mean(axis=1)
    ends += [np.stack((middles[three][:, k], centres), axis=1) for k in range(3)]
    ends = np.concatenate(ends).reshape(-1, 3)
    lines = vtkPolyData()
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(ends, deep=1))
    lines.SetPoints(positions)
    cells = vtkCellArray()
    for k in range(len(ends) // 2):
        cells.InsertNextCell(2, (2 * k, 2 * k + 1))
    lines.SetLines(cells)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(lines)
    return source


def panel(source, lines, cuts, size, direction, up, flat):
    """The picture, and its pixels per millimetre."""
    view = panels.new_view()
    display = panels.show_flat(source, view) if flat else panels.show_solid(source, view)
    panels.colour_by(display, "POINTS", CURVATURE)
    for drawn, colour, width in ((lines, OUTLINE, 1), (cuts, CUT, 2)):
        line = panels.show_lines(drawn, view, colour, width)
        line.Position = [-0.5 * d for d in direction]  # in front of the surface
    panels.look(view, source.GetDataInformation().GetBounds(), size, direction, up)
    per_mm = size[1] / 2 / view.CameraParallelScale
    return panels.screenshot(view, size), per_mm


def annotated(image, flat, per_mm, names):
    """The map with the names of its largest regions, as far as they do not overlap, and a scale bar."""
    data = servermanager.Fetch(flat)
    bounds = data.GetBounds()
    points = vtk_to_numpy(data.GetPoints().GetData())[:, :2]
    labels = vtk_to_numpy(data.GetPointData().GetArray(flattening_pipeline.REGION))
    pen = ImageDraw.Draw(image)
    small = panels.font(12)
    middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2]
    values, counts = np.unique(labels, return_counts=True)
    largest = [int(v) for _, v in sorted(zip(-counts, values)) if int(v) in names][:NAMED]
    taken = []
    for label in largest:
        own = points[labels == label]
        place = own[np.argmin(np.linalg.norm(own - np.median(own, axis=0), axis=1))]  # inside the region
        x = image.width / 2 + per_mm * (place[0] - middle[0])
        y = image.height / 2 - per_mm * (place[1] - middle[1])
        text = names[label].removesuffix("_L").replace("_", " ")
        box = pen.textbbox((x, y), text, font=small, anchor="mm", stroke_width=2)
        if all(box[0] > b[2] or b[0] > box[2] or box[1] > b[3] or b[1] > box[3] for b in taken):
            pen.text((x, y), text, (255, 255, 255), small, "mm", stroke_width=2, stroke_fill=(20, 20, 60))
            taken.append(box)
    left, low = 20, image.height - 18
    pen.line((left, low, left + SCALE_BAR * per_mm, low), fill=panels.INK, width=4)
    pen.text((left + SCALE_BAR * per_mm / 2, low - 8), f"{SCALE_BAR} mm", fill=panels.INK, font=small, anchor="mb")
    return image


def grey():
    table = simple.GetColorTransferFunction(CURVATURE)
    table.RGBPoints = [-GREATEST, 0.35, 0.35, 0.35, GREATEST, 0.95, 0.95, 0.95]


def make(path):
    disk = simple.SurfaceToDisk(Input=hemisphere(), Cut="Relief")
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk), FreeOutline=1)
    metrics = simple.DistortionMetrics(Input=flat)
    metrics.UpdatePipeline()
    names = aal_atlas.read_names(os.path.join(TEMPLATES, "aal.nii.txt"))
    grey()
    cuts = simple.OutputPort(disk, 1)
    on_surface = outlines(servermanager.Fetch(disk), flattening_pipeline.REGION)
    on_map = outlines(servermanager.Fetch(flat), flattening_pipeline.REGION)
    banks = simple.FeatureEdges(Input=flat, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0, ManifoldEdges=0)
    sides = [
        (panel(disk, on_surface, cuts, SIDE, direction, (0, 0, 1), False)[0], title)
        for direction, title in (((1, 0, 0), "(a) lateral"), ((-1, 0, 0), "(b) medial, cut open"))
    ]
    image, per_mm = panel(flat, on_map, banks, MAP, (0, 0, -1), (0, 1, 0), True)
    panels.compose(path, [sides, [(annotated(image, flat, per_mm, names), "(c) flat map")]], smooth=True)
    return report(disk, metrics)


def report(disk, metrics):
    def figure(source, name):
        return source.FieldData[name].GetRange()[0]

    return [
        "The left half of `ch2bet.nii.gz` as above, cut along its relief and flattened with a free outline: mean "
        "curvature in grey (sulci dark), red outlines of the AAL regions, the boundary blue. The map has the area "
        f"of the surface, {figure(disk, 'SurfaceArea'):,.0f} mm², so that the bar holds on average. "
        f"{figure(disk, 'ReliefBranches'):.0f} branches, "
        f"{figure(disk, 'ReliefLength'):.0f} mm; {figure(metrics, 'FacesWithin2Percent'):.1f} % of the triangles have "
        f"their areas within 2 %, the mean angle error is {figure(metrics, 'AreaWeightedMeanAngleError'):.1f}°.",
        "",
        "In the GUI: the surface of the brain as in the [tutorial](tutorial.md); *Surface To Disk* with *Cut* Plane, "
        "*Plane Origin* 90 0 0, *Plane Normal* -1 0 0 and *Remesh*; *Filters > Alphabetical > Curvature* with "
        "*Curvature Type* Mean; the regions as in the tutorial; a second *Surface To Disk* with *Cut* Relief; "
        "*Conformal Disk*; *OMT Area Preserving* with *Free Outline*; colour by `Mean_Curvature`, "
        "in grey from -0.12 to 0.12. A *Line* of 50 is the scale bar. The outlines of the regions are drawn by the script.",
    ]
