# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the JSON output of the benchmarks as Markdown tables: markdown_table.py results.json ..."""

import json
import sys


def given(benchmark, counter):
    return f"{benchmark[counter]:.2f}" if counter in benchmark else ""


def flow(title, name, tail):
    """Columns of a method that the paper compares itself with; @p tail tells equal titles apart."""

    def where_there_is(text):
        return lambda b: text(b) if b.get(f"{name}_converged") else "-"

    return {
        f"{title} (s)": where_there_is(lambda b: f"{b[name + '_cpu_seconds']:.2f}"),
        f"steps{tail}": where_there_is(lambda b: f"{b[name + '_steps']:.0f}"),
        f"faces within 2 % {tail}": where_there_is(lambda b: f"{b[name + '_faces_within_2_percent']:.1f} %"),
        f"mean area error{tail}": where_there_is(lambda b: f"{b[name + '_area_error_percent']:.1f} %"),
    }


def plain_newton(benchmark):
    seconds = f"{benchmark['plain_newton_cpu_seconds']:.2f}"
    reached = benchmark["plain_newton_cell_error"]
    return seconds if benchmark["plain_newton_converged"] else f"{seconds}, at a cell error of {reached:.0e}"


TIMES = {
    "surface": lambda b: b["name"].split("/")[0],
    "vertices": lambda b: f"{b['vertices']:,.0f}",
    "to disk (s)": lambda b: f"{b['surface_to_disk_seconds']:.1f}",
    "conformal (s)": lambda b: f"{b['conformal_seconds']:.2f}",
    "sites": lambda b: f"{b['sites']:,.0f}",
    "their transport (s)": lambda b: f"{b['sites_seconds']:.2f}",
    "refinement (s)": lambda b: f"{b['refinement_seconds']:.2f}",
    "rounds": lambda b: f"{b['rounds']:.0f}",
    "both (s)": lambda b: f"{b['area_preserving_seconds']:.2f}",
    "memory (GB)": lambda b: f"{b['peak_memory']:.2f}",
}
ERRORS = {
    "surface": TIMES["surface"],
    "conformal: angle error": lambda b: f"{b['conformal_angle_error']:.2f}°",
    "flipped": lambda b: f"{b['conformal_flipped']:.0f}",
    "area-preserving: faces within 2 %": lambda b: f"{b['faces_within_2_percent']:.1f} %",
    "mean area error": lambda b: f"{b['area_error_percent']:.2f} %",
    "P99": lambda b: f"{b['area_error_p99']:.1f} %",
    "angle error": lambda b: f"{b['angle_error']:.1f}°",
    "by area": lambda b: f"{b['angle_error_by_area']:.1f}°",
    "flipped  ": lambda b: f"{b['flipped']:.0f}",
    "bijective": lambda b: "yes" if b["bijective"] else "no",
}
CELLS = {
    "surface": TIMES["surface"],
    "transport of every vertex (s)": lambda b: f"{b['transport_seconds']:.2f}",
    "Newton steps ": lambda b: f"{b['newton_steps']:.0f}",
    "power diagrams": lambda b: f"{b['power_diagrams']:.0f}",
    "one triangulation + factorization (s)": lambda b: (
        f"{b['triangulation_seconds']:.3f} + {b['factorization_seconds']:.3f}"
    ),
    "ratio": lambda b: f"{b['transport_ratio']:.1f}",
    "cell error": lambda b: f"{b['cell_error']:.0e}",
    "faces within 2 %": lambda b: f"{b['cells_within_2_percent']:.1f} %",
    "flipped ": lambda b: f"{b['cells_flipped']:.0f}",
}
PLAIN = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "ours (s)": lambda b: f"{b['transport_cpu_seconds']:.2f}",
    "steps": CELLS["Newton steps "],
    "power diagrams": CELLS["power diagrams"],
    "plain Newton (s)": lambda b: plain_newton(b),
    "steps ": lambda b: f"{b['plain_newton_steps']:.0f}",
    "power diagrams ": lambda b: f"{b['plain_newton_power_diagrams']:.0f}",
}
PAPER = {
    "surface": lambda b: b["name"].split("/")[0].removeprefix("paper: "),
    "paper: vertices": lambda b: f"{b['paper_vertices']:,.0f}",
    "OMT (s)": lambda b: f"{b['paper_seconds']:.2f}",
    "minimal flow (s)": lambda b: given(b, "paper_minimal_flow_seconds"),
    "Lie advection (s)": lambda b: given(b, "paper_lie_advection_seconds"),
    "ours: vertices": TIMES["vertices"],
    "conformal (s)": lambda b: f"{b['conformal_cpu_seconds']:.2f}",
    "transport of every vertex (s)": lambda b: f"{b['transport_cpu_seconds']:.2f}",
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
    "genus": lambda b: f"{b['genus']:.0f}",
    "handles removed (s)": lambda b: f"{b['handles_seconds']:.1f}",
    "longest loop (mm)": lambda b: f"{b['longest_loop']:.0f}",
    "area added": lambda b: f"{b['area_added_percent']:.2f} %",
    "moved at most (mm)": lambda b: f"{b['displacement']:.2f}",
    "whole filter (s)": lambda b: f"{b['raw_seconds']:.1f}",
    "intersecting pairs": lambda b: f"{b['intersections']:.0f}",
    "with Remesh (s)": lambda b: f"{b['remeshed_seconds']:.1f}",
    "smallest angle": lambda b: f"{b['smallest_angle']:.1f}°",
    "intersecting pairs ": lambda b: f"{b['remeshed_intersections']:.0f}",
}
METHODS = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "method": lambda b: b["name"].split("/")[1],
    "seconds": lambda b: f"{b['conformal_cpu_seconds']:.2f}",
    "wall clock": lambda b: f"{b['conformal_wall_seconds']:.2f}",
    "memory (GB)": lambda b: f"{b['peak_memory']:.1f}",
    "in factorizations": lambda b: f"{b['conformal_ratio']:.1f}",
    "mean angle error": lambda b: f"{b['angle_error']:.2f}°",
    "AngleDistortion P95": lambda b: f"{b['angle_distortion_p95']:.3f}",
    "turned over": lambda b: f"{b['repaired']:.0f}",
    "flipped": lambda b: f"{b['flipped']:.0f}",
    "curvature error": lambda b: f"{b['curvature_error']:.0e}" if "curvature_error" in b else "",
}

AREA_MAPS = {
    "surface": TIMES["surface"],
    "vertices": TIMES["vertices"],
    "map": lambda b: b["name"].split("/")[1],
    "seconds": lambda b: f"{b['map_cpu_seconds']:.1f}",
    "faces within 2 %": lambda b: f"{b['faces_within_2_percent']:.1f} %",
    "mean area error": lambda b: f"{b['area_error_percent']:.2f} %",
    "mean angle error": lambda b: f"{b['angle_error']:.1f}°",
    "flipped": lambda b: f"{b['flipped']:.0f}",
}

INTERACTIVE = {
    "factor": lambda b: b["name"].split("/")[0],
    "from the map before (s)": lambda b: f"{b['warm_cpu_seconds']:.2f}",
    "rounds": lambda b: f"{b['warm_rounds']:.0f}",
    "faces within 2 %": lambda b: f"{b['warm_within_2_percent']:.1f} %",
    "angle error": lambda b: f"{b['warm_angle_error']:.1f}°",
    "from the beginning (s)": lambda b: f"{b['cold_cpu_seconds']:.2f}",
    "rounds ": lambda b: f"{b['cold_rounds']:.0f}",
    "faces within 2 % ": lambda b: f"{b['cold_within_2_percent']:.1f} %",
    "angle error ": lambda b: f"{b['cold_angle_error']:.1f}°",
}

FLAT_MAP = {
    "surface": TIMES["surface"],
    "triangles": lambda b: f"{b['faces']:,.0f}",
    "greatest error, of the diagonal": lambda b: f"{b['greatest_error']:.0e}",
    "lost": lambda b: f"{b['lost']:.0f}",
    "1024 x 1024 pixels looked up (s)": lambda b: f"{b['pixels_cpu_seconds']:.1f}",
}

SALIENCY = {
    "surface": TIMES["surface"],
    "points": TIMES["vertices"],
    "processor time (s)": lambda b: f"{b['saliency_cpu_seconds']:.1f}",
    "by the clock (s)": lambda b: f"{b['saliency_seconds']:.1f}",
}


def table(columns, benchmarks):
    yield "| " + " | ".join(name.strip() for name in columns) + " |"
    yield "|" + " --- |" * len(columns)
    for benchmark in benchmarks:
        yield "| " + " | ".join(cell(benchmark) for cell in columns.values()) + " |"


def main(paths):
    for path in paths:
        with open(path, encoding="utf-8") as file:
            run = json.load(file)["benchmarks"]
        for b in (b for b in run if b.get("error_occurred")):
            print(f"{b['name']}: {b['error_message']}", file=sys.stderr)
        benchmarks = [b for b in run if not b.get("error_occurred")]
        if "genus" in benchmarks[0]:
            kinds = [HANDLES]
        elif "conformal_ratio" in benchmarks[0]:
            kinds = [METHODS]
        elif any("map_cpu_seconds" in b for b in benchmarks):
            kinds = [AREA_MAPS]
        elif "warm_seconds" in benchmarks[0]:
            kinds = [INTERACTIVE]
        elif "greatest_error" in benchmarks[0]:
            kinds = [FLAT_MAP]
        elif "saliency_seconds" in benchmarks[0]:
            kinds = [SALIENCY]
        else:
            kinds = [TIMES, ERRORS, CELLS, PLAIN, PAPER, FLOWS]
        for columns in kinds:
            rows = [b for b in benchmarks if columns not in (CELLS, PLAIN) or "transport_seconds" in b]
            if columns is not PLAIN:
                rows = [b for b in rows if ("paper_seconds" in b) == (columns in (PAPER, FLOWS))]
            if columns is FLOWS:
                rows = [b for b in rows if "lie_steps" in b]
            if rows:
                print("\n".join(table(columns, rows)), end="\n\n")


if __name__ == "__main__":
    main(sys.argv[1:])
