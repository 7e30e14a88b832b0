# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws processor time against size, from the JSON output of BenchmarkFlattening (the stages of the flattening, the
plain Newton iteration, one triangulation and factorization) and BenchmarkAreaMaps (other area-preserving maps).

    pvpython Utilities/pictures/time_picture.py flattening.json area_maps.json time_against_size.png
"""

import sys

from line_chart import (
    BLUE, BROWN, CIRCLE, CROSS, DASHED, DIAMOND, GREEN, GREY, NO_LINE, NO_MARKER, ORANGE, PINK, PLUS, SQUARE,
    LineChart, benchmarks_of,
)

# The half brains by size: surfaces of other kinds would make the curves jump.
SURFACES = (
    "paper: brain", "half brain, remeshed", "half brain, raw", "half brain, split once", "half brain, split twice",
)
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


def main(flattening, area_maps, picture):
    chart = LineChart("vertices", "processor time (s)", log_x=True, log_y=True, legend="BottomRight")
    rows = stages_of(flattening)
    for label, (seconds, colour, marker) in STAGES.items():
        chart.draw(label, points_of(rows, seconds), colour, marker=marker)
    for label, (seconds, colour, marker) in BASELINES.items():
        points = points_of(rows, seconds)
        if points:
            chart.draw(label, points, colour, DASHED, marker)
    maps = benchmarks_of(area_maps)
    for name, marker in OTHER_MAPS.items():
        points = [(b["vertices"], b["map_cpu_seconds"]) for b in maps if b["name"].split("/")[1] == name]
        if points:
            chart.draw(name, points, (0.0, 0.0, 0.0), NO_LINE, marker, 12)
    total = points_of(rows, STAGES["all three"][0])
    (n0, t0), (n1, _) = total[0], total[-1]
    chart.draw("linear", [(n0, 2.5 * t0), (n1, 2.5 * t0 * n1 / n0)], GREY, marker=NO_MARKER)
    chart.save(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
