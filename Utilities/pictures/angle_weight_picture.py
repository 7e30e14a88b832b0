# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the JSON output of BenchmarkAreaMaps: mean area error against mean angle error. The map with several angle
weights is a curve for each surface, other maps are points.

    pvpython Utilities/pictures/angle_weight_picture.py area_maps.json angle_weight.png
"""

import sys

from line_chart import BLUE, CIRCLE, CROSS, DIAMOND, NO_LINE, ORANGE, PLUS, SQUARE, LineChart, benchmarks_of

COLOURS = {"half brain, remeshed": ORANGE, "half brain, raw": BLUE}
MARKERS = {
    "stretch energy, 10 iterations": CROSS,
    "stretch energy, 100 iterations": PLUS,
    "CGAL iterative authalic": SQUARE,
    "Boundary First": DIAMOND,
    "Ricci Flow": CIRCLE,
}
SIZE = 12


def series_of(path):
    """Points of angle and area error: of the curves by surface, and of the other maps by surface and name."""
    curves, others = {}, {}
    for b in benchmarks_of(path):
        surface, name = b["name"].split("/")[:2]
        point = (b["angle_error"], b["area_error_percent"])
        if "angle_weight" in b:
            curves.setdefault(surface, []).append(point)
        else:
            others[surface, name] = [point]
    return curves, others


def main(source, picture):
    curves, others = series_of(source)
    chart = LineChart("mean angle error (degrees)", "mean area error (%)", log_y=True)
    for surface, points in curves.items():
        chart.draw(f"{surface}: Angle Weight 0 to 0.9", points, COLOURS[surface], size=SIZE)
    for (surface, name), points in others.items():
        chart.draw(f"{surface}: {name}", points, COLOURS[surface], NO_LINE, MARKERS[name], SIZE)
    chart.save(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
