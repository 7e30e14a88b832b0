# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the JSON output of the benchmarks as Markdown tables, or writes them into pages that have a place for them:

    markdown_table.py [--pages <repository>] results.json ...

A place lies between the lines "<!-- benchmark.sh: NAME -->" and "<!-- end -->"; NAME is a key of TABLES, or "run" for
the day, the commit and the machine."""

import argparse
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path


def figure(counter, form, unit=""):
    """A column: a counter of the benchmark."""
    return lambda b: f"{b[counter]:{form}}{unit}"


def figure_if_given(counter, form):
    """The same, empty where the benchmark does not have it."""
    return lambda b: figure(counter, form)(b) if counter in b else ""


def flow(title, name, tail):
    """Columns of a method that the paper compares itself with; @p tail tells equal titles apart."""

    def where_there_is(text):
        return lambda b: text(b) if b.get(f"{name}_converged") else "-"

    return {
        f"{title} (s)": where_there_is(figure(f"{name}_cpu_seconds", ".2f")),
        f"steps{tail}": where_there_is(figure(f"{name}_steps", ".0f")),
        f"faces within 2 % {tail}": where_there_is(figure(f"{name}_faces_within_2_percent", ".1f", " %")),
        f"mean area error{tail}": where_there_is(figure(f"{name}_area_error_percent", ".1f", " %")),
    }


def plain_newton(benchmark):
    seconds = f"{benchmark['plain_newton_cpu_seconds']:.2f}"
    reached = benchmark["plain_newton_cell_error"]
    return seconds if benchmark["plain_newton_converged"] else f"{seconds}, at a cell error of {reached:.0e}"


TIMES = {
    "surface": lambda b: b["name"].split("/")[0],
    "vertices": figure("vertices", ",.0f"),
    "to disk (s)": figure("surface_to_disk_seconds", ".1f"),
    "conformal (s)": figure("conformal_seconds", ".2f"),
    "sites": figure("sites", ",.0f"),
    "their transport (s)": figure("sites_seconds", ".2f"),
    "refinement (s)": figure("refinement_seconds", ".2f"),
    "rounds": figure("rounds", ".0f"),
    "both (s)": figure("area_preserving_seconds", ".2f"),
    "memory (GB)": figure("peak_memory", ".2f"),
}
SUMMARY = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "time (s)": lambda b: (
        f"{b['surface_to_disk_seconds'] + b['conformal_seconds'] + b['area_preserving_seconds']:.1f}"
    ),
    "triangles within 2 %": figure("faces_within_2_percent", ".1f", " %"),
    "memory (GB)": TIMES["memory (GB)"],
}
SUMMARISED = ("half brain, remeshed", "half brain, raw", "whole brain, raw", "half brain, split twice")
ERRORS = {
    "surface": TIMES["surface"],
    "conformal: angle error": figure("conformal_angle_error", ".2f", "°"),
    "flipped": figure("conformal_flipped", ".0f"),
    "area-preserving: faces within 2 %": figure("faces_within_2_percent", ".1f", " %"),
    "mean area error": figure("area_error_percent", ".2f", " %"),
    "P99": figure("area_error_p99", ".1f", " %"),
    "angle error": figure("angle_error", ".1f", "°"),
    "by area": figure("angle_error_by_area", ".1f", "°"),
    "flipped  ": figure("flipped", ".0f"),
    "bijective": lambda b: "yes" if b["bijective"] else "no",
}
CELLS = {
    "surface": TIMES["surface"],
    "transport of every vertex (s)": figure("transport_seconds", ".2f"),
    "Newton steps ": figure("newton_steps", ".0f"),
    "power diagrams": figure("power_diagrams", ".0f"),
    "one triangulation + factorization (s)": lambda b: (
        f"{b['triangulation_seconds']:.3f} + {b['factorization_seconds']:.3f}"
    ),
    "ratio": figure("transport_ratio", ".1f"),
    "cell error": figure("cell_error", ".0e"),
    "faces within 2 %": figure("cells_within_2_percent", ".1f", " %"),
    "flipped ": figure("cells_flipped", ".0f"),
}
PLAIN = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "ours (s)": figure("transport_cpu_seconds", ".2f"),
    "steps": CELLS["Newton steps "],
    "power diagrams": CELLS["power diagrams"],
    "plain Newton (s)": plain_newton,
    "steps ": figure("plain_newton_steps", ".0f"),
    "power diagrams ": figure("plain_newton_power_diagrams", ".0f"),
}
PAPER = {
    "surface": lambda b: b["name"].split("/")[0].removeprefix("paper: "),
    "paper: vertices": figure("paper_vertices", ",.0f"),
    "OMT (s)": figure("paper_seconds", ".2f"),
    "minimal flow (s)": figure_if_given("paper_minimal_flow_seconds", ".2f"),
    "Lie advection (s)": figure_if_given("paper_lie_advection_seconds", ".2f"),
    "ours: vertices": TIMES["vertices"],
    "conformal (s)": figure("conformal_cpu_seconds", ".2f"),
    "transport of every vertex (s)": figure("transport_cpu_seconds", ".2f"),
    "faces within 2 %": CELLS["faces within 2 %"],
    "transport of sites + refinement (s)": lambda b: (
        f"{b['sites_cpu_seconds']:.2f} + {b['refinement_cpu_seconds']:.2f}"
    ),
    "faces within 2 % ": ERRORS["area-preserving: faces within 2 %"],
    "mean area error": ERRORS["mean area error"],
    "angle error": ERRORS["angle error"],
    "flipped": ERRORS["flipped  "],
}
FLOWS = {
    "surface": PAPER["surface"],
    "vertices": TIMES["vertices"],
    "ours, every vertex (s)": PAPER["transport of every vertex (s)"],
    "faces within 2 %": CELLS["faces within 2 %"],
    "ours, refined (s)": lambda b: f"{b['sites_cpu_seconds'] + b['refinement_cpu_seconds']:.2f}",
    "faces within 2 % ": ERRORS["area-preserving: faces within 2 %"],
    **flow("minimal flow", "minimal_flow", " "),
    **flow("Lie advection", "lie", "  "),
}
HANDLES = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "genus": figure("genus", ".0f"),
    "handles removed (s)": figure("handles_seconds", ".1f"),
    "longest loop (mm)": figure("longest_loop", ".0f"),
    "area added": figure("area_added_percent", ".2f", " %"),
    "moved at most (mm)": figure("displacement", ".2f"),
    "whole filter (s)": figure("raw_seconds", ".1f"),
    "intersecting pairs": figure("intersections", ".0f"),
    "with Remesh (s)": figure("remeshed_seconds", ".1f"),
    "smallest angle": figure("smallest_angle", ".1f", "°"),
    "intersecting pairs ": figure("remeshed_intersections", ".0f"),
}
METHODS = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "method": lambda b: b["name"].split("/")[1],
    "seconds": figure("conformal_cpu_seconds", ".2f"),
    "wall clock": figure("conformal_wall_seconds", ".2f"),
    "memory (GB)": figure("peak_memory", ".1f"),
    "in factorizations": figure("conformal_ratio", ".1f"),
    "mean angle error": figure("angle_error", ".2f", "°"),
    "AngleDistortion P95": figure("angle_distortion_p95", ".3f"),
    "untangled": figure("repaired", ".0f"),
    "flipped": figure("flipped", ".0f"),
    "curvature error": figure_if_given("curvature_error", ".0e"),
}

AREA_MAPS = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "map": lambda b: b["name"].split("/")[1],
    "seconds": figure("map_cpu_seconds", ".1f"),
    "faces within 2 %": figure("faces_within_2_percent", ".1f", " %"),
    "mean area error": figure("area_error_percent", ".2f", " %"),
    "mean angle error": figure("angle_error", ".1f", "°"),
    "flipped": figure("flipped", ".0f"),
}

LENGTHS = {
    "surface": TIMES["surface"],
    "map": AREA_MAPS["map"],
    "seconds": figure("named_map_cpu_seconds", ".1f"),
    "faces within 2 %": AREA_MAPS["faces within 2 %"],
    "SD of area ratio": figure("sd_area_ratio", ".4f"),
    "flipped": AREA_MAPS["flipped"],
    "outline crossings": figure("outline_crossings", ".0f"),
    "mean angle error": AREA_MAPS["mean angle error"],
    "local lengths": lambda b: f"{b['local_length_error']:.1f} ± {b['local_length_standard_error']:.1f} %",
    "within the map": figure("within_map_length_error", ".1f", " %"),
    "global": lambda b: f"{b['global_length_error']:.1f} ± {b['global_length_standard_error']:.1f} %",
    "rings": figure("ring_distance_error", ".1f", " %"),
}

INTERACTIVE = {
    "factor": lambda b: b["name"].split("/")[0],
    "from the map before (s)": figure("warm_cpu_seconds", ".2f"),
    "rounds": figure("warm_rounds", ".0f"),
    "faces within 2 %": figure("warm_within_2_percent", ".1f", " %"),
    "angle error": figure("warm_angle_error", ".1f", "°"),
    "from the beginning (s)": figure("cold_cpu_seconds", ".2f"),
    "rounds ": figure("cold_rounds", ".0f"),
    "faces within 2 % ": figure("cold_within_2_percent", ".1f", " %"),
    "angle error ": figure("cold_angle_error", ".1f", "°"),
}

FLAT_MAP = {
    "surface": TIMES["surface"],
    "triangles": figure("faces", ",.0f"),
    "greatest error, of the diagonal": figure("greatest_error", ".0e"),
    "lost": figure("lost", ".0f"),
    "1024 x 1024 pixels looked up (s)": figure("pixels_cpu_seconds", ".1f"),
}

SALIENCY = {
    "surface": TIMES["surface"],
    "points": TIMES["vertices"],
    "processor time (s)": figure("saliency_cpu_seconds", ".1f"),
    "by the clock (s)": figure("saliency_seconds", ".1f"),
}


def table(columns, benchmarks):
    yield "| " + " | ".join(name.strip() for name in columns) + " |"
    yield "|" + " --- |" * len(columns)
    for benchmark in benchmarks:
        yield "| " + " | ".join(cell(benchmark) for cell in columns.values()) + " |"


TABLES = {
    "summary": SUMMARY,
    "times": TIMES,
    "errors": ERRORS,
    "cells": CELLS,
    "plain_newton": PLAIN,
    "paper": PAPER,
    "flows": FLOWS,
    "handles": HANDLES,
    "methods": METHODS,
    "area_maps": AREA_MAPS,
    "lengths": LENGTHS,
    "changed_weight": INTERACTIVE,
    "flat_map": FLAT_MAP,
    "saliency": SALIENCY,
}
PLACE = re.compile(r"(<!-- benchmark\.sh: (\w+) -->\n\n).*?(\n<!-- end -->)", re.DOTALL)


def kinds_of(benchmarks):
    """The names of the tables that the benchmarks of one program fill."""
    if "genus" in benchmarks[0]:
        return ["handles"]
    if "conformal_ratio" in benchmarks[0]:
        return ["methods"]
    if any("map_cpu_seconds" in b for b in benchmarks):
        return ["area_maps"]
    if "named_map_cpu_seconds" in benchmarks[0]:
        return ["lengths"]
    if "warm_seconds" in benchmarks[0]:
        return ["changed_weight"]
    if "greatest_error" in benchmarks[0]:
        return ["flat_map"]
    if "saliency_seconds" in benchmarks[0]:
        return ["saliency"]
    return ["summary", "times", "errors", "cells", "plain_newton", "paper", "flows"]


def rows_of(kind, benchmarks):
    if kind == "summary":
        return [b for b in benchmarks if TIMES["surface"](b) in SUMMARISED]
    rows = [b for b in benchmarks if kind not in ("cells", "plain_newton") or "transport_seconds" in b]
    if kind != "plain_newton":
        rows = [b for b in rows if ("paper_seconds" in b) == (kind in ("paper", "flows"))]
    return [b for b in rows if kind != "flows" or "lie_steps" in b]


def tables_of(paths):
    """{name of a table: its lines as one text}."""
    found = {}
    for path in paths:
        run = json.loads(Path(path).read_text(encoding="utf-8"))["benchmarks"]
        for b in (b for b in run if b.get("error_occurred")):
            print(f"{b['name']}: {b['error_message']}", file=sys.stderr)
        benchmarks = [b for b in run if not b.get("error_occurred")]
        for kind in kinds_of(benchmarks) if benchmarks else []:
            rows = rows_of(kind, benchmarks)
            if rows:
                found[kind] = "\n".join(table(TABLES[kind], rows)) + "\n"
    return found


def description_of_this_run():
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    return f"{time.strftime('%-d %B %Y')}, commit {commit or 'unknown'}, {os.cpu_count()} cores.\n"


def write_into_pages(repository, found):
    texts = {"run": description_of_this_run(), **found}
    for page in [Path(repository, "README.md"), *sorted(Path(repository, "docs").glob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        renewed = PLACE.sub(lambda m: m[1] + texts[m[2]] + m[3] if m[2] in texts else m[0], text)
        if renewed != text:
            page.write_text(renewed, encoding="utf-8")
            print(f"Renewed: {page}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--pages", help="repository whose pages to write the tables into")
    parser.add_argument("results", nargs="+")
    arguments = parser.parse_args()
    found = tables_of(arguments.results)
    if arguments.pages:
        write_into_pages(arguments.pages, found)
    else:
        print("\n".join(found.values()))


if __name__ == "__main__":
    main()
