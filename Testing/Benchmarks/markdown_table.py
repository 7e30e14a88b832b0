# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the JSON output of BenchmarkFlattening as Markdown tables: markdown_table.py results.json"""

import json
import sys

TIMES = {
    "surface": lambda b: b["name"].split("/")[0],
    "vertices": lambda b: f"{b['vertices']:,.0f}",
    "to disk (s)": lambda b: f"{b['surface_to_disk_seconds']:.1f}",
    "conformal (s)": lambda b: f"{b['conformal_seconds']:.2f}",
    "Newton steps": lambda b: f"{b['conformal_newton_steps']:.0f}",
    "transport (s)": lambda b: f"{b['transport_seconds']:.2f}",
    "Newton steps ": lambda b: f"{b['newton_steps']:.0f}",
    "power diagrams": lambda b: f"{b['power_diagrams']:.0f}",
    "one triangulation + factorization (s)": lambda b: (
        f"{b['triangulation_seconds']:.3f} + {b['factorization_seconds']:.3f}"
    ),
    "ratio": lambda b: f"{b['transport_ratio']:.1f}",
}
ERRORS = {
    "surface": TIMES["surface"],
    "curvature error": lambda b: f"{b['curvature_error']:.0e}",
    "conformal: angle error": lambda b: f"{b['conformal_angle_error']:.2f}°",
    "flipped": lambda b: f"{b['conformal_flipped']:.0f}",
    "area-preserving: cell error": lambda b: f"{b['cell_error']:.0e}",
    "faces within 2 %": lambda b: f"{b['faces_within_2_percent']:.1f} %",
    "mean area error": lambda b: f"{b['area_error_percent']:.1f} %",
    "angle error": lambda b: f"{b['angle_error']:.1f}°",
    "flipped ": lambda b: f"{b['flipped']:.0f}",
}


def table(columns, benchmarks):
    yield "| " + " | ".join(name.strip() for name in columns) + " |"
    yield "|" + " --- |" * len(columns)
    for benchmark in benchmarks:
        yield "| " + " | ".join(cell(benchmark) for cell in columns.values()) + " |"


def main(path):
    with open(path, encoding="utf-8") as file:
        benchmarks = json.load(file)["benchmarks"]
    print("\n".join(table(TIMES, benchmarks)), "\n".join(table(ERRORS, benchmarks)), sep="\n\n")


if __name__ == "__main__":
    main(sys.argv[1])
