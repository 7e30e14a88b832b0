# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 6: polyps of a colon found by saliency, one of them flattened and measured."""

import numpy as np
import meshes
import panels
from paraview import servermanager, simple
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

TITLE = "Colon (Figure 6)"
PICTURE = "colon.png"
SIZE = (400, 400)
LENGTH, BEND, TUBE = 240.0, 130.0, 20.0  # mm: of the centre line, its radius, the lumen's radius
SPACING = 1.0
# Along the colon, around it, and diameter.
POLYPS = ((-80, 0.6, 8.0), (-35, -2.2, 10.0), (5, 2.0, 12.0), (50, -0.4, 8.0), (88, 2.9, 6.0))
SHOWN = 2  # the polyp that is flattened
WALL = (0.86, 0.58, 0.52)


def wall_radius(along, angle):
    phase = along - 25 * np.round(along / 25)
    fold = np.exp(-0.5 * (phase / 3.0) ** 2)
    return TUBE - 7 * fold * (0.5 - 0.5 * np.cos(3 * angle))


def place(along, radius, angle):
    bend, away = along / BEND, BEND + radius * np.cos(angle)
    return np.array([away * np.cos(bend), away * np.sin(bend), radius * np.sin(angle)])


def ct_volume():
    """A generated CT (HU): air in the colon, soft tissue around, rounded where polyps meet the wall, with noise."""
    reach = LENGTH / 2 / BEND
    low = np.array([(BEND - 30) * np.cos(reach), -(BEND + 30) * np.sin(reach), -30])
    high = np.array([BEND + 30, (BEND + 30) * np.sin(reach), 30])
    size = np.ceil((high - low) / SPACING).astype(int) + 1
    x, y, z = np.meshgrid(*(low[k] + SPACING * np.arange(size[k]) for k in range(3)), indexing="ij")
    from_axis = np.hypot(x, y)
    along, angle = BEND * np.arctan2(y, x), np.arctan2(z, from_axis - BEND)
    outside = np.hypot(from_axis - BEND, z) - wall_radius(along, angle)
    outside = np.maximum(outside, np.abs(along) - LENGTH / 2)
    for polyp in POLYPS:
        centre = polyp_centre(polyp)
        ball = polyp[2] / 2 - np.sqrt((x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2)
        blend = np.maximum(1 - np.abs(outside - ball), 0)
        outside = np.maximum(outside, ball) + 0.25 * blend**2
    noise = np.random.default_rng(3).normal(0, 8, outside.shape)
    hounsfield = -1000 + 1040 / (1 + np.exp(-np.clip(outside / 0.5, -50, 50))) + noise
    image = vtkImageData()
    image.SetDimensions(*map(int, size))
    image.SetOrigin(*low)
    image.SetSpacing(SPACING, SPACING, SPACING)
    array = numpy_to_vtk(hounsfield.ravel(order="F").astype(np.float32), deep=1)
    array.SetName("HU")
    image.GetPointData().SetScalars(array)
    return image, hounsfield, low


def polyp_centre(polyp):
    along, angle, _ = polyp
    return place(along, wall_radius(along, angle), angle)


def ct_panel(hounsfield, low):
    """The slice through the polyp that is flattened."""
    centre = polyp_centre(POLYPS[SHOWN])
    z = int(round((centre[2] - low[2]) / SPACING))
    grey = np.clip((hounsfield[:, :, z] + 1050) / 1250 * 255, 0, 255).astype(np.uint8).T
    scale = SIZE[1] / grey.shape[0]
    image = Image.fromarray(grey[::-1]).convert("RGB")
    image = image.resize((round(grey.shape[1] * scale), SIZE[1]), Image.BICUBIC)
    spot = [(centre[0] - low[0]) / SPACING * scale, SIZE[1] - (centre[1] - low[1]) / SPACING * scale]
    panels.ring(image, spot, 22, (240, 200, 0))
    return image


def view_of(source, colour, size, direction, up, bounds=None, flat=False):
    view = panels.new_view()
    display = panels.show_flat(source, view) if flat else panels.show_solid(source, view)
    if isinstance(colour, str):
        panels.colour_by(display, "POINTS", colour)
    else:
        panels.one_colour(display, colour)
    panels.look(view, bounds or source.GetDataInformation().GetBounds(), size, direction, up)
    return view


def saliency_view(source, size, direction, up):
    view = view_of(source, "Saliency", size, direction, up)
    values = np.asarray(meshes.fetched(source).PointData["Saliency"])
    table = simple.GetColorTransferFunction("Saliency")
    top = np.percentile(values, 97)
    table.RGBPoints = [0, 0.93, 0.91, 0.88, 0.5 * top, 0.96, 0.76, 0.42, top, 0.72, 0.07, 0.12]  # after showing
    return view


def found_regions(salient):
    """For every polyp the region whose points are nearest to it, or None beyond its own radius."""
    data = meshes.fetched(salient)
    points, labels = np.asarray(data.Points), np.asarray(data.PointData["SaliencyRegion"])
    result = []
    for polyp in POLYPS:
        distance = np.linalg.norm(points - polyp_centre(polyp), axis=1)
        distance[labels == 0] = np.inf
        nearest = int(np.argmin(distance))
        result.append(int(labels[nearest]) if distance[nearest] <= polyp[2] / 2 + SPACING else None)
    return result, int(labels.max())


def opened(source):
    """The half with the polyp that is flattened."""
    clip = simple.Clip(Input=source, ClipType="Plane", Invert=0)
    clip.ClipType.Origin, clip.ClipType.Normal = [0, 0, 0], [0, 0, 1]
    return clip


def make(path):
    image, hounsfield, low = ct_volume()
    wall = simple.Contour(Input=meshes.source_of(image, "colon.vti"), ContourBy=["POINTS", "HU"], Isosurfaces=[-480])
    disk = simple.SurfaceToDisk(Input=wall, Remesh=1, TargetEdgeLength=0.9, Cut="Seam")
    salient = simple.MeshSaliency(Input=disk)
    regions, count = found_regions(salient)
    label = regions[SHOWN]
    if label is None:
        raise RuntimeError("the polyp that is to be shown was not found")
    region = simple.FlattenRegion(Input=salient, LabelArray=["POINTS", "SaliencyRegion"], Label=label)
    in_space = simple.Calculator(
        Input=region, CoordinateResults=1, ResultArrayName="InSpace", Function="SurfacePoints"
    )
    conformal = simple.ConformalDisk(Input=in_space, NormalizeTo="Surface Area")

    patch = panels_of_region(region, in_space, conformal)
    half, tall = (260, 400), ((0, 0, 1), (0, 1, 0))
    inside, marked = (opened(source) for source in (simple.GenerateSurfaceNormals(Input=wall), salient))
    top = [
        (panels.screenshot(view_of(inside, WALL, half, *tall), half), "(a) the colon, cut open"),
        (ct_panel(hounsfield, low), "(b) a slice of the CT"),
        (panels.screenshot(saliency_view(marked, half, *tall), half), "(c) saliency"),
    ]
    panels.compose(path, [top, patch], smooth=True)
    return report(regions, count, region, conformal)


def light_of(region):
    """Brightness of the polyp by its slope in space, for the maps."""
    data = meshes.fetched(region)
    faces = meshes.triangles(data)
    points = np.asarray(data.PointData["SurfacePoints"])
    normals = meshes.vertex_normals(points, faces)
    mean = normals.mean(axis=0) / np.linalg.norm(normals.mean(axis=0))
    side = np.cross(mean, [0.3, 0.5, 0.8])
    return normals @ (0.8 * mean + 0.6 * side / np.linalg.norm(side)), mean, points, faces


def panels_of_region(region, in_space, conformal):
    values, mean, points, faces = light_of(region)
    table = simple.GetColorTransferFunction("Light")
    low, high = np.percentile(values, [1, 99])
    table.RGBPoints = [
        x
        for value, factor in ((low, 0.25), (high, 1.12))
        for x in (value, *(min(1, factor * c) for c in WALL))
    ]
    size = (300, 300)
    row = []
    up = np.cross(mean, np.cross([0.0, 0.0, 1.0], mean))
    up = tuple(up / np.linalg.norm(up))
    lit = meshes.source_of(meshes.poly_data(points, faces, point_arrays={"Light": values}))
    side = np.cross(up, mean)
    slanted = tuple(0.75 * mean + 0.66 * side)
    row.append((panels.screenshot(view_of(lit, "Light", size, slanted, up, flat=True), size), "(d) the polyp"))
    for letter, name, flat in (("e", "area-preserving", region), ("f", "conformal", conformal)):
        positions = np.asarray(meshes.fetched(flat).Points)
        source = meshes.source_of(meshes.poly_data(positions, faces, point_arrays={"Light": values}))
        image = panels.screenshot(view_of(source, "Light", size, (0, 0, -1), (0, 1, 0), flat=True), size)
        row.append((image, f"({letter}) {name} map"))
    return row


def report(regions, count, region, conformal):
    lines = ["| polyp, diameter (mm) | found |", "|---|---|"]
    lines += [
        f"| {polyp[2]:g} | {'no' if label is None else f'region {label}'} |"
        for polyp, label in zip(POLYPS, regions)
    ]
    measures = servermanager.Fetch(region, idx=1)
    lines += ["", "| of the polyp's region | on the surface | error | on the map |", "|---|---|---|---|"]
    for k in range(measures.GetNumberOfRows()):
        name, value, error, on_map, unit = (
            measures.GetValueByName(k, column)
            for column in ("Measure", "OnSurface", "StandardDeviation", "OnMap", "Unit")
        )
        lines.append(
            f"| {name.ToString()} ({unit.ToString().replace('^2', '²')}) | {value.ToDouble():.2f} "
            f"| {error.ToDouble():.2f} | {on_map.ToDouble():.2f} |"
        )
    data = meshes.fetched(conformal)
    inside = np.asarray(data.CellData["InRegion"]) == 1
    area = meshes.flat_areas(np.asarray(data.Points), meshes.triangles(data))[inside].sum()
    lines += ["", f"On the conformal map of the same piece the region has {area:.1f} mm²."]
    return [
        f"A generated CT of a colon with haustral folds and {len(POLYPS)} polyps. *Mesh Saliency* with its defaults marks {count} regions; "
        f"those at polyps are below, the others are crests of folds; ringed in the slice is the polyp shown below. *Flatten Region* cuts out the one of the {POLYPS[SHOWN][2]:g} mm "
        "polyp, with a margin, and flattens it:",
        "",
        *lines,
        "",
        "In the GUI: *File > Open* `gallery-output/colon.vti`, *Apply*; *Filters > Common > Contour*, double-click the value in the table and type -480, "
        "*Enter*, *Apply*; *Surface To Disk* with *Cut* Seam, *Remesh* and *Target Edge Length* (not *Relative*) 0.9, *Apply*; *Mesh Saliency*, *Apply*. Coloured "
        "by `SaliencyRegion`, with *Hover Points On* above the view, the mouse tells the number of a polyp's region. *Flatten Region* with *Label Array* `SaliencyRegion` and "
        f"*Label* {regions[SHOWN]}, *Apply*, *Zoom to Data*. *Split Horizontal Axis* above the view, *SpreadSheet View*, the eye of *Measures*: the table.",
    ]
