# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figures 2 and 11: an elongated vase with a face, flattened; histograms of the distortion of its maps."""

import io

import matplotlib
import numpy as np
import meshes
import panels
from paraview import simple
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot

TITLE = "Elongated vase (Figures 2 and 11)"
PICTURE = "vase.png"
SIZE = (230, 420)
DISK = (420, 420)
VASE, HEAD, FACE = 1, 2, 3
COLOURS = {VASE: (0.45, 0.62, 0.75), HEAD: (0.84, 0.68, 0.44), FACE: (0.85, 0.50, 0.38)}
LENGTH = 6.0
MIDDLE = 1.05  # of the face, below the crown
MAPS = (("conformal", (0.85, 0.45, 0.15)), ("area-preserving", (0.15, 0.45, 0.70)))


def profile(down):
    """Radius of the head on its vase, at a distance below the crown."""
    head = np.sqrt(np.maximum(1 - (down - 1) ** 2, 0))
    share = np.clip((down - 1.6) / (LENGTH - 1.6), 0, 1)
    vase = np.where(down > 1.6, 0.55 + 0.36 * np.sin(np.pi * share**1.1) ** 2 - 0.1 * share, 0)
    return np.logaddexp(24 * head, 24 * vase) / 24 * np.minimum(1, np.sqrt(down / 0.02))


def hill(x, y, at, width, height):
    return height * np.exp(-(((x - at[0]) / width[0]) ** 2 + ((y - at[1]) / width[1]) ** 2))


def relief(angle, down):
    """A face on the front of the head, nose, mouth, brows, cheeks and eyes, with a mane; flutes on the vase."""
    x, y = np.arctan2(np.sin(angle), np.cos(angle)), MIDDLE - down
    result = hill(x, y, (0, -0.02), (0.11, 0.22), 0.24) + hill(x, y, (0, -0.43), (0.26, 0.06), 0.1)
    for side in (-1, 1):
        result += hill(x, y, (0.3 * side, 0.33), (0.2, 0.06), 0.12)
        result += hill(x, y, (0.36 * side, -0.2), (0.16, 0.15), 0.09)
        result -= hill(x, y, (0.3 * side, 0.16), (0.12, 0.08), 0.1)
    mane = np.exp(-(((np.hypot(x, y) - 0.76) / 0.11) ** 2)) * (1 + 0.5 * np.cos(16 * np.arctan2(y, x)))
    flutes = 0.03 * np.cos(10 * angle) * np.exp(-(((down - 4.0) / 0.9) ** 4))
    return result + 0.09 * mane + flutes


def surface_of_vase(rings=170, around=140):
    """Closed at the crown, open at the foot: points, triangles, and the part that each point belongs to."""
    down = LENGTH * np.linspace(0, 1, rings + 1)[1:] ** 1.4
    angle = 2 * np.pi * np.arange(around) / around
    a, d = np.meshgrid(angle, down)
    radius = profile(d) + relief(a, d) * np.clip(d / 0.3, 0, 1)
    points = np.column_stack([(radius * np.cos(a)).ravel(), (radius * np.sin(a)).ravel(), LENGTH - d.ravel()])
    points = np.vstack([points, [0, 0, LENGTH]])
    faces = [[len(points) - 1, k, (k + 1) % around] for k in range(around)]
    for ring in range(rings - 1):
        for k in range(around):
            p, q = ring * around + k, ring * around + (k + 1) % around
            faces += [[p, p + around, q + around], [p, q + around, q]]
    x = np.append(np.arctan2(np.sin(a), np.cos(a)).ravel(), np.pi)
    below = LENGTH - points[:, 2]
    in_face = np.hypot(x, MIDDLE - below) < 0.88
    part = np.where(in_face, FACE, np.where(below < 1.95, HEAD, VASE))
    return points, np.array(faces), part.astype(np.int32)


def light(points, faces):
    normals = meshes.vertex_normals(points, faces)
    # Against the smooth vase's own normal, so that the back is as bright as the front.
    outward = points * [1, 1, 0] / np.maximum(np.hypot(points[:, 0], points[:, 1]), 1e-9)[:, None]
    sideways = np.cross([0, 0, 1], outward)
    return np.clip(0.62 + 0.5 * normals[:, 2] + 0.35 * (normals * sideways).sum(axis=1), 0, 1)


def shade_map():
    table = simple.GetColorTransferFunction("Light")
    table.RGBPoints = [0, 0, 0, 0, 1, 0, 0, 0]
    table.EnableOpacityMapping = 1
    simple.GetOpacityTransferFunction("Light").Points = [0, 0.75, 0.5, 0, 0.62, 0, 0.5, 0]


def surface_panel(surface, direction):
    view = panels.new_view()
    panels.colour_by(panels.show_solid(surface, view), "POINTS", "Part")
    panels.look(view, surface.GetDataInformation().GetBounds(), SIZE, direction, (0, 0, 1))
    return panels.screenshot(view, SIZE)


def flat_panel(metrics):
    view = panels.new_view()
    panels.colour_by(panels.show_flat(metrics, view), "POINTS", "Part")
    panels.colour_by(panels.show_flat(metrics.Input, view), "POINTS", "Light")
    panels.look(view, metrics.GetDataInformation().GetBounds(), DISK)
    return panels.screenshot(view, DISK)


def histogram(metrics, array, colour, limits, label):
    values = np.asarray(meshes.fetched(metrics).CellData[array])
    size = (315, 240)
    picture, axes = pyplot.subplots(figsize=(size[0] / 100, size[1] / 100), dpi=200)
    axes.hist(np.clip(values, *limits), 60, limits, weights=np.full(len(values), 1 / len(values)), color=colour)
    axes.set_xlim(limits)
    axes.set_xlabel(label, fontsize=9)
    axes.set_ylabel("share of faces", fontsize=9)
    axes.tick_params(labelsize=8)
    picture.tight_layout()
    stream = io.BytesIO()
    picture.savefig(stream)
    pyplot.close(picture)
    return Image.open(stream).convert("RGB").resize(size, Image.LANCZOS)


def make(path):
    panels.categories("Part", COLOURS)
    shade_map()
    points, faces, part = surface_of_vase()
    surface = meshes.source_of(
        meshes.poly_data(points, faces, point_arrays={"Part": part, "Light": light(points, faces)}),
        "vase.vtp",
    )
    disk = simple.SurfaceToDisk(Input=surface, Cut="Hole")
    conformal = simple.ConformalDisk(
        Input=disk, NormalizeTo="Surface Area", UseBoundaryPoint=1, BoundaryPoint=[0, profile(LENGTH), 0]
    )
    preserving = simple.OMTAreaPreserving(Input=conformal)
    metrics = [simple.DistortionMetrics(Input=flat) for flat in (conformal, preserving)]
    top = [
        (surface_panel(surface, (-1, 0, 0)), "(a) front"),
        (surface_panel(surface, (1, 0, 0)), "(b) back"),
    ]
    middle = [(flat_panel(flat), f"({'cd'[k]}) {MAPS[k][0]} map") for k, flat in enumerate(metrics)]
    rows = [[], []]
    for k, flat in enumerate(metrics):
        name, colour = MAPS[k]
        for row, (array, limits, label) in zip(
            rows,
            (
                ("AreaDistortion", (-4, 16), "area distortion, log of the area ratio"),
                ("AngleDistortion", (0, 3), "angle distortion, log of the axis ratio"),
            ),
        ):
            row.append((histogram(flat, array, colour, limits, label), name))
    panels.compose(path, [top + middle, rows[0] + rows[1]], smooth=True)
    return report(metrics)


def report(metrics):
    lines = ["| | surface | conformal map | area-preserving map |", "|---|---|---|---|"]
    areas = [meshes.region_areas(flat, "Part") for flat in metrics]
    for name, number in (("face", FACE), ("rest of the head", HEAD), ("vase", VASE)):
        surface, conformal = areas[0][number]
        lines.append(f"| {name} | {surface:.3f} | {conformal:.2g} | {areas[1][number][1]:.3f} |")
    for title, name, form in (
        ("mean area error", "AreaWeightedMeanAreaError", "{:.2f} %"),
        ("faces within 2 % of their area", "FacesWithin2Percent", "{:.1f} %"),
        ("mean angle error", "AreaWeightedMeanAngleError", "{:.1f}°"),
        ("flipped faces", "FlippedFaces", "{:.0f}"),
    ):
        figures = [form.format(flat.FieldData[name].GetRange()[0]) for flat in metrics]
        lines.append(f"| {title} | | {figures[0]} | {figures[1]} |")
    return [
        "A generated head on a vase, of 23,801 points, open at the foot (the paper has a lion's head). The first "
        "and last bar of a histogram include what lies beyond. Areas of the parts, in units of the surface:",
        "",
        *lines,
        "",
        "In the GUI: *File > Open* `gallery-output/vase.vtp`, *Apply*; colour by `Part` and turn it by dragging: at first one looks at "
        "the crown. *Surface To Disk*, *Conformal Disk*, *OMT Area Preserving*, each with *Apply*; *Set view direction to -Z*. *Distortion "
        f"Metrics* with *Use Region Array* and *Region Array* `Part`, *Apply*. *Split Horizontal Axis* above the view, *SpreadSheet View*, the eye "
        f"of *Summary*: `SurfaceArea` and `FlatArea` of the parts ({VASE} vase, {HEAD} rest of the head, {FACE} face), and in the row *Total* "
        "`AreaWeightedMeanAreaError`, `FacesWithin2Percent`, `AreaWeightedMeanAngleError` and `FlippedFaces`; ParaView sorts the columns by name. Click *DistortionMetrics1*; *Filters > Data "
        "Analysis > Histogram* of `AreaDistortion`, *Apply*; the same of `AngleDistortion`. For the conformal map click *ConformalDisk1* and go on "
        "from *Distortion Metrics*.",
    ]
