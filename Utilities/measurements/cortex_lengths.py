# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the errors of areas, angles and lengths of flat maps of a half brain, as a Markdown table with a row per way of
opening it. Needs Debian's package mricron-data:

    PV_PLUGIN_PATH=build/plugins pvpython Utilities/measurements/cortex_lengths.py

The closed half is the isosurface of the right half of the scan; the one with a boundary is the whole brain, cut at the
mid-plane. Errors of lengths are percentages with their standard errors.
"""

import argparse
import os
import time

from catalogue import TEMPLATES
from paraview import servermanager, simple

MID_PLANE = 90  # voxels and mm
ISOVALUE = 40
SMOOTHING = 2  # mm
PLANE = {"Cut": "Plane", "PlaneOrigin": [MID_PLANE, 0, 0]}
# The part that is opened, and the settings of Surface To Disk. OMT Area Preserving has the same Free Outline.
OPENINGS = {
    "closed half, hole": ("half", {"Cut": "Hole", "FreeOutline": 0}),
    "closed half, seam": ("half", {"Cut": "Seam", "FreeOutline": 0}),
    "closed half, automatic, free outline": ("half", {"Cut": "Automatic", "FreeOutline": 1}),
    "closed half, cut 2 mm from its flat side, free outline": (
        "half",
        {"Cut": "Plane", "PlaneOrigin": [MID_PLANE + 2, 0, 0], "FreeOutline": 1},
    ),
    "whole, cut at a plane": ("whole", {**PLANE, "FreeOutline": 0}),
    "whole, cut at a plane, free outline": ("whole", {**PLANE, "FreeOutline": 1}),
}
COLUMNS = [
    "surface",
    "points",
    "flat in s",
    "faces within 2 %",
    "SD of area ratio",
    "flipped",
    "angle error",
    "local",
    "within the map",
    "global",
    "rings",
    "lengths in s",
]


def isosurface_of(part):
    import surfaceflattening_volume

    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    if part == "half":
        scan.UpdatePipeline()
        extent = list(scan.GetDataInformation().GetExtent())
        extent[0] = MID_PLANE
        scan = simple.ExtractSubset(Input=scan, VOI=extent)
    return surfaceflattening_volume.isosurface(scan, ISOVALUE, smoothing_mm=SMOOTHING, patient_space=False).surface


def value(text):
    """A whole number, another number, or the text itself, such as the name of a cut."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def row(name, surface, opening, of_map):
    began = time.monotonic()
    disk = simple.SurfaceToDisk(Input=surface, **opening)
    of_map = {"FreeOutline": opening["FreeOutline"], **of_map}
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk), **of_map)
    flat.UpdatePipeline()
    flat_seconds = time.monotonic() - began
    began = time.monotonic()
    data = servermanager.Fetch(simple.DistortionMetrics(Input=flat, MeasureLengths=1))
    length_seconds = time.monotonic() - began

    def figure(figure_name):
        return data.GetFieldData().GetArray(figure_name).GetTuple1(0)

    def length(kind):
        return f"{figure(f'Mean{kind}LengthError'):.1f} ± {figure(f'StandardError{kind}LengthError'):.1f} %"

    return [
        name,
        f"{data.GetNumberOfPoints():,}",
        f"{flat_seconds:.1f}",
        f"{figure('FacesWithin2Percent'):.1f} %",
        f"{figure('SDAreaRatio'):.4f}",
        f"{figure('FlippedFaces'):.0f}",
        f"{figure('MeanAngleError'):.1f}°",
        *(length(kind) for kind in ("Local", "WithinMap", "Global")),
        f"{figure('RingDistanceError'):.1f} %",
        f"{length_seconds:.1f}",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="openings whose name has this in it")
    parser.add_argument(
        "--set", action="append", default=[], metavar="NAME=VALUE", help="a property of Surface To Disk, e.g. Remesh=1"
    )
    parser.add_argument(
        "--set-map", action="append", default=[], metavar="NAME=VALUE", help="a property of OMT Area Preserving"
    )
    arguments = parser.parse_args()
    settings, of_map = (
        {name: value(text) for name, text in (each.split("=", 1) for each in given)}
        for given in (arguments.set, arguments.set_map)
    )
    print(f"| {' | '.join(COLUMNS)} |\n|{' --- |' * len(COLUMNS)}", flush=True)
    for name, (part, opening) in OPENINGS.items():
        if arguments.only in name:
            cells = row(name, isosurface_of(part), {**opening, **settings}, of_map)
            print(f"| {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
