# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 5: a chest flattened, and a region measured on the map."""

import math

import numpy as np
import meshes
import panels
from paraview import servermanager, simple

TITLE = "Chest (Figure 5)"
PICTURE = "chest.png"
SIZE = (440, 440)
HEIGHT = 420.0  # mm
CENTRE_ANGLE, CENTRE_HEIGHT, RADIUS = 0.55, 250.0, 55.0  # of the region; radius in space, mm
SKIN = (0.86, 0.70, 0.60)


def wall(angle, height):
    """Points of a trunk's front (mm): x to its left, y backwards, z up; ribs, breastbone and shoulders."""
    share = height / HEIGHT
    wide = 150 + 25 * np.sin(math.pi * share * 0.9) + 30 * np.clip(share - 0.75, 0, 1) * 2
    deep = 95 + 15 * np.sin(math.pi * share)
    ribs = 3.5 * np.sin(2 * math.pi * (height + 45 * np.abs(angle)) / 34) * np.exp(-((share - 0.5) / 0.33) ** 4)
    ribs *= np.clip(np.abs(angle) / 0.25, 0, 1)
    breasts = sum(
        22 * np.exp(-(((angle - side * 0.6) / 0.32) ** 2 + ((height - 265) / 48) ** 2)) for side in (-1, 1)
    )
    navel = -9 * np.exp(-((angle / 0.07) ** 2 + ((height - 60) / 9) ** 2))
    bone = -4 * np.exp(-((angle / 0.12) ** 2)) * np.exp(-((share - 0.6) / 0.3) ** 4)
    grow = 1 + (ribs + breasts + navel + bone) / 120
    return np.stack([wide * grow * np.sin(angle), -deep * grow * np.cos(angle), height + 0 * angle], axis=-1)


def chest(columns=120, rows=130):
    angle, height = np.meshgrid(np.linspace(-1.9, 1.9, columns), np.linspace(0, HEIGHT, rows))
    points = wall(angle, height).reshape(-1, 3)
    faces = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column
            b, c, d = a + 1, a + columns + 1, a + columns
            faces += [[a, b, c], [a, c, d]] if (row + column) % 2 else [[a, b, d], [b, c, d]]
    faces = np.array(faces)
    centre = wall(np.array(CENTRE_ANGLE), np.array(CENTRE_HEIGHT))
    distance = np.linalg.norm(points - centre, axis=1)
    region = (distance <= RADIUS).astype(np.int32)
    return points, faces, {"Distance": distance, "Region": region, "Light": light(points, faces)}


def light(points, faces):
    """Brightness from the front, left and above, for the flat maps."""
    outward = points * [1 / 160**2, 1 / 100**2, 0]
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    return (meshes.vertex_normals(points, faces) - outward) @ np.array([0.3, -0.1, 0.8])


def shown(source, outline, direction, up, solid):
    view = panels.new_view()
    display = panels.show_solid(source, view) if solid else panels.show_flat(source, view)
    if solid:
        panels.one_colour(display, SKIN)
    else:
        panels.colour_by(display, "POINTS", "Light")
    panels.show_lines(outline, view, (0.95, 0.8, 0.0), 3)
    panels.look(view, source.GetDataInformation().GetBounds(), SIZE, direction, up)
    return panels.screenshot(view, SIZE)


def ring(source):
    contour = simple.Contour(Input=source, ContourBy=["POINTS", "Distance"], Isosurfaces=[RADIUS])
    contour.UpdatePipeline()
    return contour


def make(path):
    points, faces, arrays = chest()
    surface = meshes.source_of(meshes.poly_data(points, faces, point_arrays=arrays), "chest.vtp")
    table = simple.GetColorTransferFunction("Light")
    table.RGBPoints = [
        x
        for value, factor in ((-0.4, 0.35), (0.0, 1.0), (0.3, 1.15))
        for x in (value, *(min(1, factor * c) for c in SKIN))
    ]
    # The right of the trunk, at the left of the picture, to the left end of the maps.
    conformal = simple.ConformalDisk(
        Input=surface,
        NormalizeTo="Surface Area",
        UseBoundaryPoint=1,
        BoundaryPoint=wall(np.array(1.9), np.array(HEIGHT / 2)).tolist(),
    )
    preserving = simple.OMTAreaPreserving(Input=conformal)
    row = [(shown(surface, ring(surface), (0, 1, 0), (0, 0, 1), True), "(a) surface and region")]
    for letter, name, flat in (("b", "conformal", conformal), ("c", "area-preserving", preserving)):
        row.append((shown(flat, ring(flat), (0, 0, -1), (0, 1, 0), False), f"({letter}) {name} map"))
    panels.compose(path, [row], smooth=True)

    lines = ["| of the region | surface | conformal map | area-preserving map |", "|---|---|---|---|"]
    area = [meshes.region_areas(flat, "Region")[1] for flat in (conformal, preserving)]
    lines.append(f"| area (mm²) | {area[0][0]:,.0f} | {area[0][1]:,.0f} | {area[1][1]:,.0f} |")
    measured = simple.FlattenRegion(Input=surface, LabelArray=["POINTS", "Region"], Label=1)
    measured.UpdatePipeline()
    measures = servermanager.Fetch(measured, idx=1)
    for k in range(measures.GetNumberOfRows()):
        name, value, error, on_map, unit = (
            measures.GetValueByName(k, column)
            for column in ("Measure", "OnSurface", "StandardDeviation", "OnMap", "Unit")
        )
        lines.append(
            f"| {name.ToString()}, by *Flatten Region* ({unit.ToString().replace('^2', '²')}) "
            f"| {value.ToDouble():,.1f} ± {error.ToDouble():,.1f} | | {on_map.ToDouble():,.1f} |"
        )
    return [
        f"A generated trunk of {len(points):,} points with ribs. The region is what lies within {RADIUS:g} mm "
        "of a point. It can be measured on the area-preserving map of the whole; *Flatten Region*, which "
        "flattens it alone, adds diameters and errors:",
        "",
        *lines,
        "",
        "In the GUI: *File > Open* `gallery-output/chest.vtp`, *Apply*; *Flatten Region* with *Label Array* `Region` and *Label* 1, *Apply*, *Reset Camera*; "
        "*Split Horizontal Axis* above the view, *SpreadSheet View*, the eye of *Measures* ([more](flatten_region.md)). For the maps of the whole click *chest.vtp*; "
        "*Conformal Disk*, *OMT Area Preserving*, *Distortion Metrics* with *Use Region Array* and *Region Array* `Region`, each with *Apply*: the row 1 of *Summary*.",
    ]
