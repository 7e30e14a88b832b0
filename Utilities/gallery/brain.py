# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 1: half a brain by AAL region, conformal and area-preserving."""

import os
import sys

import panels
from paraview import servermanager

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "demo"))

import aal_atlas
import flattening_pipeline

TITLE = "Brain (Figure 1)"
PICTURE = "brain.png"
TEMPLATES = "/usr/share/mricron/templates"  # Debian's package mricron-data
SIZE = (440, 370)
DISK = (440, 440)
SHOWN = 8  # regions in the table


def executed(proxy, title):
    proxy.UpdatePipeline()
    if proxy.GetDataInformation().GetNumberOfPoints() == 0:
        raise RuntimeError(f"{title}: nothing came out; see the error above")


def panel(source, size, direction, up, flat):
    view = panels.new_view()
    display = panels.show_flat(source, view) if flat else panels.show_solid(source, view)
    panels.colour_by(display, "POINTS", flattening_pipeline.REGION)
    if flat:  # a view shows each source once
        shade = panels.show_flat(source.Input, view)
        panels.colour_by(shade, "POINTS", flattening_pipeline.SHADE)
    panels.look(view, source.GetDataInformation().GetBounds(), size, direction, up)
    return panels.screenshot(view, size)


def region_rows(metrics):
    table = servermanager.Fetch(metrics, idx=1)
    names = [table.GetColumnName(k) for k in range(table.GetNumberOfColumns())]
    return [
        {name: table.GetValueByName(row, name) for name in names} for row in range(table.GetNumberOfRows())
    ]


def make(path):
    import figure  # the demo's colours

    pipeline = flattening_pipeline.build(
        os.path.join(TEMPLATES, "ch2bet.nii.gz"), os.path.join(TEMPLATES, "aal.nii.gz"), executed
    )
    names = aal_atlas.read_names(os.path.join(TEMPLATES, "aal.nii.txt"))
    names[aal_atlas.UNLABELLED] = "unlabelled"
    present = [int(row["RegionId"].ToDouble()) for row in region_rows(pipeline.conformal)]
    labels = sorted(label for label in present if label in names)
    colours = {label: aal_atlas.colour_of(name) for label, name in names.items()}
    figure.region_colour_map(flattening_pipeline.REGION, labels, names, colours)
    low, high = pipeline.surface.PointData[flattening_pipeline.SHADE].GetRange()
    figure.shade_map(flattening_pipeline.SHADE, low + 0.4 * (high - low), low + 0.8 * (high - low))
    top = [
        (panel(pipeline.surface, SIZE, (1, 0, 0), (0, 0, 1), False), "(a) lateral view"),
        (panel(pipeline.surface, SIZE, (-1, 0, 0), (0, 0, 1), False), "(b) medial view, cut open"),
    ]
    bottom = [
        (panel(metrics, DISK, (0, 0, -1), (0, 1, 0), True), title)
        for metrics, title in (
            (pipeline.conformal, "(c) conformal map"),
            (pipeline.area_preserving, "(d) area-preserving map"),
        )
    ]
    panels.compose(path, [top, bottom])
    return report(pipeline, names)


def report(pipeline, names):
    rows = [
        "| region | surface (mm²) | conformal map | area-preserving map (mm²) | error |",
        "|---|---|---|---|---|",
    ]
    maps = {
        key: {int(row["RegionId"].ToDouble()): row for row in region_rows(metrics)}
        for key, metrics in (("conformal", pipeline.conformal), ("preserving", pipeline.area_preserving))
    }
    total = sum(row["SurfaceArea"].ToDouble() for row in maps["preserving"].values())
    scale = total / sum(row["FlatArea"].ToDouble() for row in maps["conformal"].values())
    found = [label for label in maps["preserving"] if names.get(label, "unlabelled") != "unlabelled"]
    found.sort(key=lambda label: -maps["preserving"][label]["SurfaceArea"].ToDouble())
    for label in found[:SHOWN]:
        area = maps["preserving"][label]["SurfaceArea"].ToDouble()
        flat = maps["preserving"][label]["FlatArea"].ToDouble()
        conformal = scale * maps["conformal"][label]["FlatArea"].ToDouble()
        rows.append(
            f"| {names[label]} | {area:,.0f} | {conformal:,.0f} | {flat:,.0f} "
            f"| {100 * (flat / area - 1):+.2f} % |"
        )
    measures = ("AreaWeightedMeanAreaError", "AreaWeightedMeanAngleError", "FlippedFaces")
    figures = {
        key: [metrics.FieldData[name].GetRange()[0] for name in measures]
        for key, metrics in (("conformal", pipeline.conformal), ("area-preserving", pipeline.area_preserving))
    }
    text = "; ".join(
        f"{key}: area {area:.2g} %, angle {angle:.2g}°, {flipped:.0f} flipped"
        for key, (area, angle, flipped) in figures.items()
    )
    return [
        "The left half of the brain MRI `ch2bet.nii.gz` of Debian's package `mricron-data`, by AAL region, as in "
        f"`Utilities/demo.sh`; sulci are dark on the maps. Mean errors of the faces: {text}. The largest "
        "regions (the conformal map scaled to the surface's area):",
        "",
        *rows,
        "",
        "In the GUI: `Utilities/demo.sh` first. *File > Open* `demo-output/flattened.vtp`, *Apply*: the area-preserving map, by `Region`. *Distortion Metrics* with *Use Region Array* and "
        "*Region Array* `Region`, *Apply*; *Split Horizontal Axis* above the view, *SpreadSheet View*, the eye of *Summary*: the table. *Filters > Common > Calculator*, *Coordinate Results*, "
        "`SurfacePoints`, *Apply*, on *flattened.vtp* is the half brain in space; *Conformal Disk* of it and *Distortion Metrics* of that have the figures of the conformal map. From the scan itself: "
        "the steps of the [README](../README.md#in-paraview), or the [tutorial](tutorial.md).",
    ]
