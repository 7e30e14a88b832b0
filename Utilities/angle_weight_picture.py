# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the JSON output of BenchmarkAreaMaps: mean area error against mean angle error. The map with several angle
weights is a curve for each surface, other maps are points.

    pvpython Utilities/angle_weight_picture.py area_maps.json angle_weight.png
"""

import json
import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable

COLOURS = {"half brain, remeshed": (0.84, 0.37, 0.0), "half brain, raw": (0.0, 0.45, 0.7)}
CIRCLE = 4
NO_LINE, SOLID = 0, 1
# Marker styles of the other maps: cross, plus, square, diamond, circle.
MARKERS = {
    "stretch energy, 10 iterations": 1,
    "stretch energy, 100 iterations": 2,
    "CGAL iterative authalic": 3,
    "Boundary First": 5,
    "Ricci Flow": CIRCLE,
}


def series_of(path):
    """Points of angle and area error: of the curves by surface, and of the other maps by surface and name."""
    with open(path, encoding="utf-8") as file:
        benchmarks = json.load(file)["benchmarks"]
    curves, others = {}, {}
    for b in benchmarks:
        if b.get("error_occurred"):
            continue
        surface, name = b["name"].split("/")[:2]
        point = (b["angle_error"], b["area_error_percent"])
        if "angle_weight" in b:
            curves.setdefault(surface, []).append(point)
        else:
            others[surface, name] = [point, point]  # VTK complains about lines of one point
    return curves, others


def table_of(points):
    table = vtkTable()
    for k, name in enumerate(("angle error", "area error")):
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
    display.XArrayName = "angle error"
    display.SeriesVisibility = ["area error"]
    display.SeriesLabel = ["area error", label]
    display.SeriesColor = ["area error", *map(str, colour)]
    display.SeriesLineStyle = ["area error", str(style)]
    display.SeriesLineThickness = ["area error", "2"]
    display.SeriesMarkerStyle = ["area error", str(marker)]
    display.SeriesMarkerSize = ["area error", "12"]


def main(source, picture):
    curves, others = series_of(source)
    view = simple.CreateView("XYChartView")
    view.ViewSize = [1100, 800]
    view.LeftAxisLogScale = 1
    view.LeftAxisTitle = "mean area error (%)"
    view.BottomAxisTitle = "mean angle error (degrees)"
    view.LegendLocation = "BottomLeft"
    for surface, points in curves.items():
        draw(view, f"{surface}: Angle Weight 0 to 0.9", points, COLOURS[surface], SOLID, CIRCLE)
    for (surface, name), points in others.items():
        draw(view, f"{surface}: {name}", points, COLOURS[surface], NO_LINE, MARKERS[name])
    simple.SaveScreenshot(picture, view, OverrideColorPalette="WhiteBackground")


if __name__ == "__main__":
    main(*sys.argv[1:])
