# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens surfaces at a plane and compares two flat maps of each, without and with the relief that Cut Automatic adds if
the strain is large. Prints a Markdown table. Needs Debian's package mricron-data:

    PV_PLUGIN_PATH=build/plugins pvpython Utilities/measurements/open_surfaces.py
"""

from paraview import simple
from surfaceflattening_volume import isosurface

TEMPLATES = "/usr/share/mricron/templates"
HEADER = """| surface | points | strain | faces within 2 %, angle error: boundary alone | *Automatic* | *Automatic* and free outline |
| --- | --- | --- | --- | --- | --- |"""


def figure(proxy, name, component=0):
    return proxy.FieldData[name].GetRange(component)[0]


def above(surface, axis, share):
    """The part of a surface above a plane at a share of its extent along an axis."""
    surface.UpdatePipeline()
    bounds = surface.GetDataInformation().GetBounds()
    origin = [0, 0, 0]
    normal = [0, 0, 0]
    origin[axis] = bounds[2 * axis] + share * (bounds[2 * axis + 1] - bounds[2 * axis])
    normal[axis] = 1
    clip = simple.Clip(Input=surface, ClipType="Plane", Invert=0)
    clip.ClipType.Origin = origin
    clip.ClipType.Normal = normal
    return simple.ExtractSurface(Input=clip)


def cup(height):
    can = simple.Cylinder(Resolution=60, Radius=1, Height=height)
    fine = simple.LoopSubdivision(Input=simple.Triangulate(Input=simple.Clean(Input=can)), NumberofSubdivisions=4)
    return above(fine, 1, 0.02)


def isosurface_of(scan, isovalue):
    image = simple.OpenDataFile(f"{TEMPLATES}/{scan}.nii.gz")
    return isosurface(image, isovalue, smoothing_mm=2, patient_space=False).surface


def surfaces():
    """Name, surface, and length of the edges after remeshing."""
    yield "cup, 2 high and wide", cup(2), 0.08
    yield "cup, 3 high and 2 wide", cup(3), 0.08
    brain = isosurface_of("ch2bet", 40)
    for share in (0.03, 0.1, 0.2):
        yield f"brain without its lowest {100 * share:.0f} %", above(brain, 2, share), 2.5
    yield "head without its lowest 10 %", above(isosurface_of("ch2", 30), 2, 0.1), 4


def map_of(surface, edge, cut, free):
    disk = simple.SurfaceToDisk(
        Input=surface, Remesh=1, TargetEdgeLength=edge, Cut=cut, FreeOutline=free
    )
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk), FreeOutline=free)
    measured = simple.DistortionMetrics(Input=flat)
    measured.UpdatePipeline()
    return measured


def text_of(measured):
    faces = figure(measured, "FacesWithin2Percent")
    return f"{faces:.1f} %, {figure(measured, 'MeanAngleError'):.1f}°"


def main():
    print(HEADER)
    for name, surface, edge in surfaces():
        kept = map_of(surface, edge, "Hole", 0)
        automatic = map_of(surface, edge, "Automatic", 0)
        free = map_of(surface, edge, "Automatic", 1)
        points = automatic.GetDataInformation().GetNumberOfPoints()
        strain = figure(automatic, "ReliefStrain")
        row = [name, f"{points:,}", f"{strain:.2f}", text_of(kept), text_of(automatic), text_of(free)]
        print("|", " | ".join(row), "|", flush=True)


if __name__ == "__main__":
    main()
