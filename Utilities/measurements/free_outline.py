# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens a brain, whole and half, into a disk and with a free outline, and prints a Markdown table. Needs Debian's
package mricron-data:

    PV_PLUGIN_PATH=build/plugins pvpython Utilities/measurements/free_outline.py

With a file name, writes that page's table in place of the old one.
"""

import sys
import time

import numpy as np
from paraview import servermanager, simple
from surfaceflattening_volume import isosurface
from vtkmodules.util.numpy_support import vtk_to_numpy

SCAN = "/usr/share/mricron/templates/ch2bet.nii.gz"
MIDDLE = [90, 0, 0]  # mm, between the halves
HEADER = """| surface | vertices | outline | seconds | faces within 2 % | mean area error | mean angle error | flipped | boundary |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |"""


def figure(proxy, name):
    return proxy.FieldData[name].GetRange()[0]


def boundary_stretch(flat):
    """The greatest ratio of the length of a boundary edge on the map to its length on the surface."""
    data = servermanager.Fetch(flat)
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    start, end = edges[counts == 1].T

    def lengths(points):
        points = vtk_to_numpy(points).astype(float)
        return np.linalg.norm(points[start] - points[end], axis=1)

    on_surface = lengths(data.GetPointData().GetArray("SurfacePoints"))
    return (lengths(data.GetPoints().GetData()) / on_surface).max()


def rows_of(name, disk):
    conformal = simple.ConformalDisk(Input=disk)
    conformal.UpdatePipeline()
    vertices = conformal.GetDataInformation().GetNumberOfPoints()
    for free in (0, 1):
        flat = simple.OMTAreaPreserving(Input=conformal, FreeOutline=free)
        began = time.process_time()
        flat.UpdatePipeline()
        seconds = time.process_time() - began
        measured = simple.DistortionMetrics(Input=flat)
        measured.UpdatePipeline()
        is_sound = figure(flat, "Bijective") == 1 and figure(flat, "FreeOutline") == free
        outline = ("free" if free else "disk") if is_sound else "(failed)"
        yield (
            f"| {name} | {vertices:,} | {outline} | {seconds:.1f} "
            f"| {figure(measured, 'FacesWithin2Percent'):.1f} % | {figure(measured, 'MeanAreaError'):.2f} % "
            f"| {figure(measured, 'MeanAngleError'):.1f}° | {figure(measured, 'FlippedFaces'):.0f} | {boundary_stretch(flat):.1f} |"
        )


def table():
    brain = isosurface(simple.OpenDataFile(SCAN), 40, smoothing_mm=2, patient_space=False).surface
    for remeshed in (0, 1):
        kind = "remeshed" if remeshed else "raw"
        half = simple.SurfaceToDisk(Input=brain, Cut="Plane", PlaneOrigin=MIDDLE, Remesh=remeshed)
        yield from rows_of(f"half brain, {kind}, plane", half)
        yield from rows_of(f"half brain, {kind}, plane and relief", simple.SurfaceToDisk(Input=half, Cut="Relief"))
        automatic = simple.SurfaceToDisk(Input=brain, Remesh=remeshed)
        yield from rows_of(f"whole brain, {kind}, automatic", automatic)
        relief = simple.SurfaceToDisk(Input=brain, Cut="Relief", Remesh=remeshed)
        yield from rows_of(f"whole brain, {kind}, relief", relief)


def main():
    lines = [HEADER]
    print(HEADER)
    for row in table():
        print(row, flush=True)
        lines.append(row)
    if len(sys.argv) > 1:
        with open(sys.argv[1], encoding="utf-8") as page:
            text = page.read()
        begin = text.index("<!-- free_outline.py -->") + len("<!-- free_outline.py -->")
        end = text.index("<!-- end -->", begin)
        with open(sys.argv[1], "w", encoding="utf-8") as page:
            page.write(text[:begin] + "\n\n" + "\n".join(lines) + "\n\n" + text[end:])


if __name__ == "__main__":
    main()
