# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws processor time and memory against size, from the JSON output of BenchmarkFlattening (the stages of the
flattening, the plain Newton iteration, one triangulation and factorization) and BenchmarkAreaMaps (other area-preserving
maps). The legends have the power of the number of vertices with which a curve grows on large surfaces.

    pvpython Utilities/pictures/time_picture.py flattening.json area_maps.json time_against_size.png memory.png
"""

import math
import sys

from line_chart import (
    BLUE, BROWN, CIRCLE, CROSS, DASHED, DIAMOND, GREEN, GREY, NO_LINE, NO_MARKER, ORANGE, PINK, PLUS, SQUARE,
    LineChart, benchmarks_of,
)

# The half brains by size: surfaces of other kinds would make the curves jump.
SURFACES = (
    "half brain, edges of 7 mm", "half brain, edges of 3.5 mm", "paper: brain", "half brain, remeshed", "half brain, raw",
    "half brain, split once", "half brain, split twice", "half brain, split three times",
)
# Vertices from which on the growth is measured: with fewer, constant times count, and the memory of an empty process.
LEAST_OF_TIMES = 30000
LEAST_OF_MEMORY = 200000
STAGES = {
    "conformal map": (lambda b: b["conformal_cpu_seconds"], GREEN, CIRCLE),
    "transport of the sites": (lambda b: b["sites_cpu_seconds"], PINK, CIRCLE),
    "refinement": (lambda b: b["refinement_cpu_seconds"], ORANGE, CIRCLE),
    "all three": (
        lambda b: b["conformal_cpu_seconds"] + b["sites_cpu_seconds"] + b["refinement_cpu_seconds"], BLUE, DIAMOND,
    ),
}
BASELINES = {
    "transport of every vertex": (lambda b: b.get("transport_cpu_seconds"), PINK, SQUARE),
    "plain damped Newton, every vertex": (
        lambda b: b.get("plain_newton_cpu_seconds") if b.get("plain_newton_converged") else None, BROWN, SQUARE,
    ),
    "one triangulation + factorization": (lambda b: b.get("yardstick_cpu_seconds"), GREY, SQUARE),
}
OTHER_MAPS = {
    "stretch energy, 10 iterations": CROSS,
    "stretch energy, 100 iterations": PLUS,
    "CGAL iterative authalic": SQUARE,
}


def stages_of(path):
    rows = {b["name"].split("/")[0]: b for b in benchmarks_of(path)}
    return [rows[name] for name in SURFACES if name in rows]


def points_of(rows, seconds):
    return [(b["vertices"], seconds(b)) for b in rows if seconds(b)]


def large(points, least):
    return [point for point in points if point[0] >= least]


def growth(points):
    """The power of x with which y grows: the slope of the line that fits best on logarithmic axes."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x, mean_y = (sum(values) / len(logs) for values in zip(*logs))
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)


def with_growth(label, points, least):
    return f"{label}: n^{growth(large(points, least)):.2f}"


def draw_linear(chart, points, share):
    """A line that grows as the number of vertices, through a `share` of the first point."""
    (n0, y0), (n1, _) = points[0], points[-1]
    chart.draw("linear", [(n0, share * y0), (n1, share * y0 * n1 / n0)], GREY, marker=NO_MARKER)


def draw_times(rows, area_maps, picture):
    chart = LineChart("vertices", "processor time (s)", log_x=True, log_y=True, legend="BottomRight")
    for label, (seconds, colour, marker) in STAGES.items():
        points = points_of(rows, seconds)
        chart.draw(with_growth(label, points, LEAST_OF_TIMES), points, colour, marker=marker)
    for label, (seconds, colour, marker) in BASELINES.items():
        points = points_of(rows, seconds)
        if points:
            chart.draw(label, points, colour, DASHED, marker)
    maps = benchmarks_of(area_maps)
    for name, marker in OTHER_MAPS.items():
        points = [(b["vertices"], b["map_cpu_seconds"]) for b in maps if b["name"].split("/")[1] == name]
        if points:
            chart.draw(name, points, (0.0, 0.0, 0.0), NO_LINE, marker, 12)
    draw_linear(chart, large(points_of(rows, STAGES["all three"][0]), LEAST_OF_TIMES), 2.5)
    chart.save(picture)


def draw_memory(rows, picture):
    chart = LineChart("vertices", "memory of the process at its peak (GB)", log_x=True, log_y=True, legend="TopLeft")
    # The surfaces of the paper come last, in a process that keeps the memory of larger ones.
    points = points_of([b for b in rows if "paper_seconds" not in b], lambda b: b["peak_memory"])
    chart.draw(with_growth("all three stages", points, LEAST_OF_MEMORY), points, BLUE, marker=DIAMOND)
    draw_linear(chart, large(points, LEAST_OF_MEMORY), 2.0)
    chart.save(picture)


def main(flattening, area_maps, time_picture, memory_picture):
    rows = stages_of(flattening)
    draw_times(rows, area_maps, time_picture)
    draw_memory(rows, memory_picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
