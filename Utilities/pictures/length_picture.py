# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the JSON output of BenchmarkLengths: mean area error against mean error of local lengths within the map, a point
for each map of a surface.

    pvpython Utilities/pictures/length_picture.py lengths.json length_errors.png [surface]
"""

import sys

from line_chart import (
    BLUE,
    BROWN,
    CIRCLE,
    CROSS,
    DIAMOND,
    GREEN,
    GREY,
    NO_LINE,
    ORANGE,
    PINK,
    PLUS,
    SQUARE,
    LineChart,
    benchmarks_of,
)

MARKERS = [(ORANGE, CIRCLE), (BLUE, CROSS), (GREEN, PLUS), (PINK, SQUARE), (BROWN, DIAMOND), (GREY, CIRCLE), (PINK, CROSS)]
SIZE = 14
# So that no marker lies on an axis: percent beyond the points, and the factor of the logarithmic axis.
MARGIN = 1.0
FACTOR = 2.0


def main(source, picture, surface="half brain, remeshed"):
    chart = LineChart(
        "mean error of lengths within the map (%)", "mean area error (%)", log_y=True, legend="BottomRight"
    )
    maps = [b for b in benchmarks_of(source) if b["name"].split("/")[0] == surface]
    points = [(b["within_map_length_error"], b["area_error_percent"]) for b in maps]
    for i, (b, point) in enumerate(zip(maps, points)):
        colour, marker = MARKERS[i % len(MARKERS)]
        chart.draw(b["name"].split("/")[1], [point], colour, NO_LINE, marker, SIZE)
    lengths, areas = zip(*points)
    chart.set_ranges((min(lengths) - MARGIN, max(lengths) + MARGIN), (min(areas) / FACTOR, max(areas) * FACTOR))
    chart.save(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
