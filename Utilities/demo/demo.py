# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens the left half of a brain MRI and writes what came out: run by demo.sh, in pvpython.

    pvpython demo.py --plugin SurfaceFlattening.so --output demo-output
"""

import argparse
import csv
import os
import sys
import time

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

TEMPLATES = "/usr/share/mricron/templates"  # Debian's package mricron-data


class StageProgress:
    """Runs pipeline stages and tells the terminal how far they are."""

    def __init__(self, stream=sys.stdout):
        self.stream = stream
        self.began = time.monotonic()

    def line(self, text):
        print(f"[{time.monotonic() - self.began:6.1f} s] {text}", file=self.stream, flush=True)

    def __call__(self, proxy, title):
        """Executes a proxy. Raises if it failed: pvpython itself does not."""
        self.line(f"{title} ...")
        algorithm = proxy.GetClientSideObject()
        reported = [0]

        def progressed(caller, _event):
            percent = int(100 * caller.GetProgress())
            if percent >= reported[0] + 10:
                reported[0] = percent
                self.line(f"    {percent:3d} %  {caller.GetProgressText() or ''}")

        observer = algorithm.AddObserver("ProgressEvent", progressed)
        proxy.UpdatePipeline()
        algorithm.RemoveObserver(observer)
        information = proxy.GetDataInformation()
        points, cells = information.GetNumberOfPoints(), information.GetNumberOfCells()
        if points == 0:
            raise RuntimeError(f"{title}: nothing came out; see the error above")
        self.line(f"    {points:,} points, {cells:,} cells")


def labels_of(surface, array):
    """The labels that occur on the surface, in increasing order."""
    points = servermanager.Fetch(surface).GetPointData()
    return sorted(set(vtk_to_numpy(points.GetArray(array)).tolist()))


def summary(map_name, metrics):
    figure = {array.Name: array.GetRange()[0] for array in metrics.FieldData}
    return (
        f"{map_name} map: mean area error {figure['AreaWeightedMeanAreaError']:.2g} %, mean angle error "
        f"{figure['AreaWeightedMeanAngleError']:.2g} degrees, "
        f"{figure['FacesWithin2Percent']:.3g} % of the faces within 2 % of their area, "
        f"{figure['FlippedFaces']:.0f} flipped"
    )


def write_distortion(path, maps, names):
    """One CSV for all maps: a row per region, and one for the whole surface."""
    with open(path, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        for number, (map_name, metrics) in enumerate(maps):
            metrics.UpdatePipeline()
            table = metrics.GetClientSideObject().GetOutputDataObject(1)
            columns = [table.GetColumn(k) for k in range(table.GetNumberOfColumns())]
            if number == 0:
                writer.writerow(["Map", *(column.GetName() for column in columns)])
            for row in range(table.GetNumberOfRows()):
                values = {c.GetName(): c.GetVariantValue(row).ToString() for c in columns}
                values["Region"] = names.get(int(values["RegionId"]), values["Region"])
                writer.writerow([map_name, *values.values()])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plugin", required=True, help="SurfaceFlattening.so")
    parser.add_argument("--output", default="demo-output", help="folder to write to")
    parser.add_argument("--templates", default=TEMPLATES, help="folder of ch2bet and aal")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
    simple._DisableFirstRenderCameraReset()

    import aal_atlas
    import figure
    import flattening_pipeline

    run = StageProgress()
    pipeline = flattening_pipeline.build(
        os.path.join(arguments.templates, "ch2bet.nii.gz"),
        os.path.join(arguments.templates, "aal.nii.gz"),
        run,
    )

    run.line("pictures ...")
    names = aal_atlas.read_names(os.path.join(arguments.templates, "aal.nii.txt"))
    names[aal_atlas.UNLABELLED] = "unlabelled"
    colours = {label: aal_atlas.colour_of(name) for label, name in names.items()}
    region, shade = flattening_pipeline.REGION, flattening_pipeline.SHADE
    labels = labels_of(pipeline.surface, region)
    figure.region_colour_map(region, labels, names, colours)
    low, high = pipeline.surface.PointData[shade].GetRange()
    figure.shade_map(shade, low + 0.4 * (high - low), low + 0.8 * (high - low))
    layout = figure.compose(pipeline, region, shade)

    def output(name):
        return os.path.join(arguments.output, name)

    simple.SaveScreenshot(
        output("flattening.png"),
        layout,
        ImageResolution=figure.SIZE,
        SeparatorWidth=0,
    )
    # Debian's ParaView cannot read the writer's default, appended data.
    simple.SaveData(output("flattened.vtp"), pipeline.area_preserving, DataMode="Binary")
    maps = (("conformal", pipeline.conformal), ("area-preserving", pipeline.area_preserving))
    write_distortion(output("distortion.csv"), maps, names)
    figure.scale_text(figure.TEXT_ON_SCREEN)
    simple.SaveState(output("flattening.pvsm"))
    for map_name, metrics in maps:
        run.line(summary(map_name, metrics))
    run.line(f"written to {arguments.output}: " + ", ".join(sorted(os.listdir(arguments.output))))


if __name__ == "__main__":
    main()
