# SPDX-License-Identifier: GPL-3.0-or-later
"""Line charts of benchmark results, for the scripts of this folder that draw them."""

import json

from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable

NO_LINE, SOLID, DASHED = 0, 1, 2
NO_MARKER, CROSS, PLUS, SQUARE, CIRCLE, DIAMOND = range(6)

ORANGE = (0.84, 0.37, 0.0)
BLUE = (0.0, 0.45, 0.7)
GREEN = (0.0, 0.62, 0.45)
PINK = (0.8, 0.47, 0.65)
BROWN = (0.55, 0.4, 0.2)
GREY = (0.5, 0.5, 0.5)


def benchmarks_of(path):
    """The runs in a JSON output of Google Benchmark that did not fail."""
    with open(path, encoding="utf-8") as file:
        return [b for b in json.load(file)["benchmarks"] if not b.get("error_occurred")]


class LineChart:
    """A chart with a legend. `x` and `y` are the titles of the axes."""

    def __init__(self, x, y, log_x=False, log_y=False, legend="BottomLeft"):
        self.view = simple.CreateView("XYChartView")
        self.view.ViewSize = [1100, 800]
        self.view.BottomAxisTitle = x
        self.view.LeftAxisTitle = y
        self.view.BottomAxisLogScale = int(log_x)
        self.view.LeftAxisLogScale = int(log_y)
        self.view.LegendLocation = legend

    def draw(self, label, points, colour, style=SOLID, marker=CIRCLE, size=8):
        """Adds a line through `points`, pairs of x and y."""
        if len(points) == 1:
            points = 2 * points  # VTK complains about lines of one point
        producer = simple.TrivialProducer(registrationName=label)
        producer.GetClientSideObject().SetOutput(self._table_of(points))
        producer.UpdatePipeline()
        display = simple.Show(producer, self.view, "XYChartRepresentation")
        display.AttributeType = "Row Data"
        display.UseIndexForXAxis = 0
        display.XArrayName = "x"
        display.SeriesVisibility = ["y"]
        display.SeriesLabel = ["y", label]
        display.SeriesColor = ["y", *map(str, colour)]
        display.SeriesLineStyle = ["y", str(style)]
        display.SeriesLineThickness = ["y", "2"]
        display.SeriesMarkerStyle = ["y", str(marker)]
        display.SeriesMarkerSize = ["y", str(size)]

    def set_ranges(self, x, y):
        """Sets the ends of the axes, pairs of numbers, instead of those of the points."""
        self.view.BottomAxisUseCustomRange = 1
        self.view.BottomAxisRangeMinimum, self.view.BottomAxisRangeMaximum = x
        self.view.LeftAxisUseCustomRange = 1
        self.view.LeftAxisRangeMinimum, self.view.LeftAxisRangeMaximum = y

    def save(self, picture):
        simple.SaveScreenshot(picture, self.view, OverrideColorPalette="WhiteBackground")

    @staticmethod
    def _table_of(points):
        table = vtkTable()
        for k, name in enumerate("xy"):
            column = vtkDoubleArray()
            column.SetName(name)
            for point in points:
                column.InsertNextValue(point[k])
            table.AddColumn(column)
        return table
