# SPDX-License-Identifier: GPL-3.0-or-later
"""Enlarges and shrinks regions of the demo's half brain, large and small ones, with sharp and soft edges, and prints as
tables in Markdown what the faces of the region came to, as compared with the rest:

    PV_PLUGIN_PATH=build/plugins pvpython Utilities/measurements/region_factors.py demo-output/flattened.vtp
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "gallery"))

import meshes
import numpy as np
from paraview import simple

REGIONS = (7, 69, 17, 29)  # AAL: large to small
FACTORS = (0.25, 1, 2, 4, 8)
EDGES = (0, 5)  # mm


def conformal_map(path):
    flat = simple.OpenDataFile(path)
    brain = simple.Calculator(Input=flat, CoordinateResults=1, Function="SurfacePoints")
    return simple.ConformalDisk(Input=brain)


def areas(points, faces):
    u, v = (points[faces[:, k]] - points[faces[:, 0]] for k in (1, 2))
    return 0.5 * np.linalg.norm(np.cross(u, v), axis=1)


class Measured:
    """A map: the faces of the region are those with all corners in it, of the rest those without weight."""

    def __init__(self, flat, label, factor):
        data = meshes.fetched(flat)
        faces = meshes.triangles(data)
        surface = areas(np.asarray(data.PointData["SurfacePoints"]), faces)
        on_map = areas(np.asarray(data.Points), faces)
        inside = (np.asarray(data.PointData["Region"]) == label)[faces].all(axis=1)
        rest = (np.asarray(data.PointData["AreaWeight"]) == 1)[faces].all(axis=1)
        if factor == 1:
            rest &= ~inside
        scale = on_map[rest].sum() / surface[rest].sum()
        self.faces = int(inside.sum())
        self.area = surface[inside].sum()
        self.error = on_map[inside].sum() / surface[inside].sum() / scale / factor - 1
        single = on_map[inside] / surface[inside] / scale / factor - 1
        self.within = (np.abs(single) <= 0.02).mean()
        self.flipped = int(data.FieldData["FlippedFaces"][0])
        self.cells = float(data.FieldData["MaxCellAreaError"][0])


def measured(conformal, label, factor, edge):
    weights = simple.AreaWeights(
        Input=conformal, WeightArray=["POINTS", "Region"], Label=label, Factor=factor, EdgeWidth=edge
    )
    flat = simple.OMTAreaPreserving(Input=weights, UseAreaWeight=1, AreaWeightArray=["POINTS", "AreaWeight"])
    return Measured(flat, label, factor)


def main(path):
    conformal = conformal_map(path)
    for edge in EDGES:
        print(f"Edge width {edge} mm: the region's faces together, and how many of them are within 2 % each.\n")
        print("| region | faces | mm² | " + " | ".join(f"{factor:g}" for factor in FACTORS) + " |")
        print("|---|---|---|" + "---|" * len(FACTORS), flush=True)
        worst, flipped = 0.0, 0
        for label in REGIONS:
            results = [measured(conformal, label, factor, edge) for factor in FACTORS]
            print(
                f"| {label} | {results[0].faces:,} | {results[0].area:,.0f} | "
                + " | ".join(f"{100 * r.error:+.2f} %, {100 * r.within:.0f} %" for r in results)
                + " |",
                flush=True,
            )
            worst = max(worst, *(r.cells for r in results))
            flipped += sum(r.flipped for r in results)
        print(f"\nCells: {worst:.0e} at most. Flipped faces: {flipped}.\n")


main(sys.argv[1])
