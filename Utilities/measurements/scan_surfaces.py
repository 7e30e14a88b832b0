# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes real scans through isosurface, Surface To Disk and, with --flatten, to a measured flat map, and prints
a Markdown table with a row per surface. Needs Debian's packages mricron-data and invesalius-examples:

    PV_PLUGIN_PATH=build/plugins pvpython Utilities/measurements/scan_surfaces.py --set Remesh=1

The exit status is 1 if a surface did not become a disk.
"""

import argparse
import fnmatch
import os
import resource
import sys
import tempfile
import time

from catalogue import SURFACES
from paraview import simple
from surface_checks import measure
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter

COLUMNS = ["surface", "vertices", "components", "genus", "disk in s", "disk"]
FLATTENING_COLUMNS = ["flat in s", "faces within 2 %", "area error", "angle error", "flipped", "one-to-one"]
# Field data of Surface To Disk that is printed if the filter writes it.
REPORTED = ["Genus", "SmallestAngle", "SelfIntersectionsBefore", "SelfIntersections"]


def execute(proxy):
    """Updates a proxy; returns its output, the error messages, as pvpython raises none, and the seconds."""
    errors = []

    def failed(_caller, _event, text=""):
        errors.append(" ".join(text.split()))

    failed.CallDataType = "string0"
    algorithm = proxy.GetClientSideObject()
    observed = [algorithm, algorithm.GetExecutive()]
    tags = [(item, item.AddObserver("ErrorEvent", failed)) for item in observed]
    began = time.monotonic()
    proxy.UpdatePipeline()
    seconds = time.monotonic() - began
    for item, tag in tags:
        item.RemoveObserver(tag)
    return algorithm.GetOutputDataObject(0), errors, seconds


def figures_of(data):
    fields = data.GetFieldData()
    arrays = (fields.GetArray(i) for i in range(fields.GetNumberOfArrays()))
    return {a.GetName(): a.GetTuple1(0) for a in arrays if a and a.GetNumberOfValues() == 1}


def largest_component(polydata):
    connectivity = vtkPolyDataConnectivityFilter()
    connectivity.SetInputData(polydata)
    connectivity.SetExtractionModeToLargestRegion()
    connectivity.Update()
    return connectivity.GetNumberOfExtractedRegions(), connectivity.GetOutput()


def short(error):
    """The cause, without VTK's class and address before it."""
    return error.split("): ", 1)[-1][:120]


class Run:
    def __init__(self, arguments):
        self.flatten = arguments.flatten or arguments.free_outline
        self.free_outline = arguments.free_outline
        self.settings = dict(setting.split("=", 1) for setting in arguments.set)
        self.scratch = tempfile.TemporaryDirectory()

    def open(self, path):
        import surfaceflattening_volume

        if path.endswith(".inv3"):
            path = surfaceflattening_volume.metaimage_of_invesalius(path, self.scratch.name)
        return simple.OpenDataFile(path)

    def disk_proxy(self, surface):
        proxy = simple.SurfaceToDisk(Input=surface, FreeOutline=int(self.free_outline))
        for name, text in self.settings.items():
            proxy.SetPropertyWithName(name, [_number(word) for word in text.split(",")])
        return proxy

    def row(self, scan_surface):
        """The cells of one row, and whether the surface became a disk and all that was asked for."""
        import surfaceflattening_volume

        scan = self.open(scan_surface.path)
        recipe = surfaceflattening_volume.isosurface(
            scan, scan_surface.isovalue, scan_surface.smoothing
        )
        components, largest = largest_component(recipe.surface.GetClientSideObject().GetOutput())
        raw = measure(largest)
        cells = [scan_surface.name, f"{raw.vertices:,}", f"{components:,}", str(raw.genus)]
        disk = self.disk_proxy(recipe.surface)
        data, errors, seconds = execute(disk)
        cells.append(f"{seconds:.1f}")
        if errors or data.GetNumberOfCells() == 0:
            return cells + [short(errors[0]) if errors else "empty"], False
        found, reported = measure(data), figures_of(data)
        text = "yes" if found.is_disk else f"no: {found}"
        text += f", {found.vertices:,} vertices, smallest angle {found.smallest_angle:.2g}°"
        text += "".join(f", {name} {reported[name]:g}" for name in REPORTED if name in reported)
        cells.append(text)
        complete = found.is_disk
        if self.flatten and complete:
            flat_cells, complete = self.flat_cells(disk)
            cells += flat_cells
        return cells, complete

    def flat_cells(self, disk):
        began = time.monotonic()
        start = disk if self.free_outline else simple.ConformalDisk(Input=disk)
        area_preserving = simple.OMTAreaPreserving(Input=start, FreeOutline=int(self.free_outline))
        metrics = simple.DistortionMetrics(Input=area_preserving)
        for proxy in (start, area_preserving, metrics):
            data, errors, _seconds = execute(proxy)
            if errors or data.GetNumberOfCells() == 0:
                return [f"{time.monotonic() - began:.1f}", short(errors[0]) if errors else "empty"], False
        figure = figures_of(data)
        return [
            f"{time.monotonic() - began:.1f}",
            f"{figure['FacesWithin2Percent']:.1f} %",
            f"{figure['AreaWeightedMeanAreaError']:.2g} %",
            f"{figure['AreaWeightedMeanAngleError']:.1f}°",
            f"{figure['FlippedFaces']:.0f}",
            "yes" if figure["Bijective"] == 1 else "no",
        ], figure["FreeOutline"] == self.free_outline


def _number(text):
    return float(text) if "." in text or "e" in text else int(text)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--plugin", help="SurfaceFlattening.so, unless PV_PLUGIN_PATH brings it")
    parser.add_argument("--only", default="*", help="surfaces whose name fits, e.g. 'ch2bet iso 40*'")
    parser.add_argument("--flatten", action="store_true", help="go on to the flat map")
    parser.add_argument("--free-outline", action="store_true", help="the same, with a free outline")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="a property of Surface To Disk, e.g. Remesh=1; can be given several times",
    )
    arguments = parser.parse_args()
    if arguments.plugin:
        simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))

    columns = COLUMNS + (FLATTENING_COLUMNS if arguments.flatten or arguments.free_outline else [])
    print(f"| {' | '.join(columns)} |\n|{' --- |' * len(columns)}", flush=True)
    run = Run(arguments)
    failed = 0
    for scan_surface in SURFACES:
        if not fnmatch.fnmatch(scan_surface.name, arguments.only):
            continue
        cells, complete = run.row(scan_surface)
        failed += not complete
        cells += [""] * (len(columns) - len(cells))
        print(f"| {' | '.join(cells)} |", flush=True)
        simple.ResetSession()
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    print(f"\n{failed} incomplete; peak memory {peak:.1f} GB")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
