# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the JSON output of BenchmarkConvergence: error of the conformal radius against the number of vertices.

    pvpython Utilities/pictures/convergence_picture.py convergence.json convergence.png
"""

import sys

from line_chart import DASHED, GREEN, GREY, NO_MARKER, ORANGE, PINK, SOLID, LineChart, benchmarks_of

COLOURS = {"paraboloid": ORANGE, "Gaussian bump": GREEN, "capsule of length 3": PINK}


def curves_of(path):
    """The points of every curve, by surface and method."""
    curves = {}
    for b in benchmarks_of(path):
        surface, method = b["name"].split("/")[:2]
        curves.setdefault((surface, method), []).append((b["vertices"], b["radius_error"]))
    return curves


def main(source, picture):
    curves = curves_of(source)
    chart = LineChart("vertices", "RMS error of the radius", log_x=True, log_y=True)
    for (surface, method), points in curves.items():
        style = SOLID if method == "Ricci Flow" else DASHED
        chart.draw(f"{surface}, {method}", points, COLOURS[surface], style)
    first = max(points[0][1] for points in curves.values())
    vertices = [points[0] for points in next(iter(curves.values()))]
    slope = [(n, 1.5 * first * vertices[0] / n) for n in (vertices[0], vertices[-1])]
    chart.draw("second order", slope, GREY, marker=NO_MARKER)
    chart.save(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
