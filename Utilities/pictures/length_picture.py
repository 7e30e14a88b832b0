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


def main(source, picture, surface="half brain, remeshed"):
    chart = LineChart(
        "mean error of lengths within the map (%)", "mean area error (%)", log_y=True, legend="BottomRight"
    )
    maps = [b for b in benchmarks_of(source) if b["name"].split("/")[0] == surface]
    for i, b in enumerate(maps):
        colour, marker = MARKERS[i % len(MARKERS)]
        point = (b["within_map_length_error"], b["area_error_percent"])
        chart.draw(b["name"].split("/")[1], [point], colour, NO_LINE, marker, SIZE)
    chart.save(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
