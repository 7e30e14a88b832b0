# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the JSON output of BenchmarkConvergence: error of the conformal radius against the number of vertices.

    pvpython Utilities/convergence_picture.py convergence.json convergence.png
"""

import json
import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable

COLOURS = {
    "paraboloid": (0.84, 0.37, 0.0),
    "Gaussian bump": (0.0, 0.62, 0.45),
    "capsule of length 3": (0.8, 0.47, 0.65),
}


def curves_of(path):
    """The points of every curve, by surface and method."""
    with open(path, encoding="utf-8") as file:
        benchmarks = json.load(file)["benchmarks"]
    curves = {}
    for b in benchmarks:
        surface, method = b["name"].split("/")[:2]
        curves.setdefault((surface, method), []).append((b["vertices"], b["radius_error"]))
    return curves


def table_of(points):
    table = vtkTable()
    for k, name in enumerate(("vertices", "error")):
        column = vtkDoubleArray()
        column.SetName(name)
        for point in points:
            column.InsertNextValue(point[k])
        table.AddColumn(column)
    return table


def draw(view, label, points, colour, style, marker):
    producer = simple.TrivialProducer(registrationName=label)
    producer.GetClientSideObject().SetOutput(table_of(points))
    producer.UpdatePipeline()
    display = simple.Show(producer, view, "XYChartRepresentation")
    display.AttributeType = "Row Data"
    display.UseIndexForXAxis = 0
    display.XArrayName = "vertices"
    display.SeriesVisibility = ["error"]
    display.SeriesLabel = ["error", label]
    display.SeriesColor = ["error", *map(str, colour)]
    display.SeriesLineStyle = ["error", str(style)]
    display.SeriesLineThickness = ["error", "2"]
    display.SeriesMarkerStyle = ["error", str(marker)]
    display.SeriesMarkerSize = ["error", "8"]


def main(source, picture):
    curves = curves_of(source)
    view = simple.CreateView("XYChartView")
    view.ViewSize = [1100, 800]
    view.LeftAxisLogScale = 1
    view.BottomAxisLogScale = 1
    view.LeftAxisTitle = "RMS error of the radius"
    view.BottomAxisTitle = "vertices"
    view.LegendLocation = "BottomLeft"
    for (surface, method), points in curves.items():
        style = 1 if method == "Ricci Flow" else 2
        draw(view, f"{surface}, {method}", points, COLOURS[surface], style, 4)
    first = max(points[0][1] for points in curves.values())
    vertices = [points[0] for points in next(iter(curves.values()))]
    slope = [(n, 1.5 * first * vertices[0] / n) for n in (vertices[0], vertices[-1])]
    draw(view, "second order", slope, (0.5, 0.5, 0.5), 1, 0)
    simple.SaveScreenshot(picture, view, OverrideColorPalette="WhiteBackground")


if __name__ == "__main__":
    main(*sys.argv[1:])
