# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the longest time between two progress reports of each filter, which is how long an abort may have to wait.

    PV_PLUGIN_PATH=build/plugins taskset -c 0 pvpython Utilities/measurements/progress_gaps.py

Takes the brain of Debian's package mricron-data (130 thousand vertices raw from the isosurface) through the four
filters, with and without remeshing, then through those around the map, and prints the longest gaps as a Markdown table: the stage that the report before
the gap named, and the seconds of processor time, which on one processor (taskset) are those of a clock on a machine
that does nothing else. Then aborts each filter at the report before its longest gap, and prints how long
it took to return. The exit status is 1 if progress went back, a stage had no name, or a filter had a result after an
abort or none when it was run again.
"""

import argparse
import sys
import time

from paraview import simple

POINT = 0  # vtkDataObject's attribute type
SCAN = "/usr/share/mricron/templates/ch2bet.nii.gz"


class Watch:
    """The reports of a filter: fraction, stage, and when."""

    def __init__(self, proxy):
        self.algorithm = proxy.GetClientSideObject()
        self.proxy = proxy

    def run(self, abort_at=None):
        """Reports as (fraction, stage, seconds since the start); aborts at the report number @abort_at."""
        reports = []

        def reported(caller, _event):
            reports.append((caller.GetProgress(), caller.GetProgressText(), time.process_time() - began))
            if len(reports) - 1 == abort_at:
                caller.SetAbortExecute(1)

        self.algorithm.Modified()
        self.algorithm.SetAbortExecute(0)
        observer = self.algorithm.AddObserver("ProgressEvent", reported)
        began = time.process_time()
        self.algorithm.Update()
        end = time.process_time() - began
        self.algorithm.RemoveObserver(observer)
        self.algorithm.SetAbortExecute(0)
        return [(0.0, "start", 0.0), *reports], end

    def is_empty(self):
        return self.algorithm.GetOutputDataObject(0).GetNumberOfElements(POINT) == 0


def gaps_of(reports, end):
    """(seconds, stage, number of the report before it), the longest first."""
    times = [report[2] for report in reports] + [end]
    gaps = [(times[k + 1] - times[k], reports[k][1], k - 1) for k in range(len(reports))]
    return sorted(gaps, reverse=True)


def defects(reports):
    fractions = [report[0] for report in reports]
    found = [] if fractions == sorted(fractions) else ["progress goes back"]
    # VTK itself reports 0 before the filter is at work.
    named = all(stage for fraction, stage, _seconds in reports if fraction > 0)
    return found + ([] if named else ["a stage without a name"])


def flattening(surface):
    """(name, proxy) of the four filters from surface to measured map, raw and remeshed."""
    for suffix, remesh in (("", 0), (", remeshed", 1)):
        disk = simple.SurfaceToDisk(Input=surface, Remesh=remesh)
        conformal = simple.ConformalDisk(Input=disk)
        area_preserving = simple.OMTAreaPreserving(Input=conformal)
        yield "Surface To Disk" + suffix, disk
        yield "Conformal Disk" + suffix, conformal
        yield "OMT Area Preserving" + suffix, area_preserving
        yield "Distortion Metrics" + suffix, simple.DistortionMetrics(Input=area_preserving)


def others(surface, scan):
    """(name, proxy) of the filters around the map; half of the surface is their region."""
    disk = simple.SurfaceToDisk(Input=surface)
    half = simple.Calculator(
        Input=disk, ResultArrayName="Half", ResultArrayType="Int", Function="if(coordsX > 90, 1, 0)"
    )
    chosen = ["POINTS", "Half"]
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=half))
    flat.UpdatePipeline()
    grid = simple.SurfaceToDisk(Input=simple.Plane(XResolution=360, YResolution=360))
    moved = simple.ConformalDisk(Input=grid)
    moved.UpdatePipeline()
    yield "Mesh Saliency", simple.MeshSaliency(Input=half)
    yield "Context Resolution", simple.ContextResolution(Input=half, RegionArray=chosen)
    yield "Area Weights", simple.AreaWeights(Input=half, WeightArray=chosen, EdgeWidth=5)
    yield "Flatten Region", simple.FlattenRegion(Input=half, LabelArray=chosen)
    yield "Flat Map Image", simple.FlatMapImage(Input=flat)
    yield "Flat Map Slab", simple.FlatMapSlab(Input=flat, Volume=scan)
    yield "Flat Map Transfer", simple.FlatMapTransfer(Input=flat, Original=disk)
    yield "Planar Warp", simple.PlanarWarp(Input=moved, Carried=grid)


def table_row(name, proxy, gaps):
    """Prints it; returns how much is wrong."""
    watch = Watch(proxy)
    reports, end = watch.run()
    wrong = defects(reports)
    longest = gaps_of(reports, end)[:gaps]
    cut_short, stopped = watch.run(abort_at=max(longest[0][2], 0))
    wrong += [] if watch.is_empty() else [f"a result after an abort at {cut_short[-1]}"]
    watch.run()
    wrong += ["no result after an abort"] if watch.is_empty() else []
    cells = [
        name,
        str(len(reports) - 1),
        f"{end:.1f}",
        "; ".join(f"{seconds:.2f} {stage}" for seconds, stage, _number in longest),
        f"{stopped - cut_short[-1][2]:.2f}",
    ]
    print(f"| {' | '.join(cells)} |", flush=True)
    for text in wrong:
        print(f"{name}: {text}", flush=True)
    return len(wrong)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--scan", default=SCAN)
    parser.add_argument("--isovalue", type=float, default=40.0)
    parser.add_argument("--smoothing", type=float, default=2.0, help="mm (default 2)")
    parser.add_argument("--filters", choices=("all", "flattening", "others"), default="all")
    parser.add_argument("--longest", type=int, default=3, help="gaps per filter (default 3)")
    arguments = parser.parse_args()
    from surfaceflattening_volume import isosurface

    scan = simple.OpenDataFile(arguments.scan)
    surface = isosurface(scan, arguments.isovalue, smoothing_mm=arguments.smoothing).surface
    print("| filter | reports | in all (s) | longest gaps (s) | aborted there (s) |\n|" + " --- |" * 5, flush=True)
    bad = 0
    if arguments.filters != "others":
        bad += sum(table_row(*row, arguments.longest) for row in flattening(surface))
    if arguments.filters != "flattening":
        bad += sum(table_row(*row, arguments.longest) for row in others(surface, scan))
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
