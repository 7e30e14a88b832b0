# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/pictures/architecture.svg: the layers of the project and the folders of Filters/Core.

    python3 Utilities/docs/architecture_picture.py

Names, floors and texts come from the table in Filters/Core/README.md, arrows from the includes of the files."""

import html
import re
import sys
import textwrap
from pathlib import Path

GENERAL = ("Base", "Mesh")  # every folder includes these: they get no arrows
COLUMNS = {  # left and right end of each folder's box, so that arrows can run straight down
    "Disk": (20, 415),
    "Regions": (425, 515),
    "FlatMap": (525, 680),
    "Remeshing": (70, 200),
    "Geodesics": (380, 640),
    "Conformal": (660, 800),
    "Areas": (690, 980),
    "Repair": (20, 190),
    "Handles": (200, 275),
    "Intrinsic": (285, 690),
    "Untangling": (710, 850),
    "Transport": (870, 980),
    "Mesh": (20, 980),
    "Base": (20, 980),
}
STAGES = {"Disk": "1", "Conformal": "2", "Areas": "3"}
WAY = (  # the way of the data: what it is, and between two of them the filter that makes the next
    "surface",
    "Surface To Disk",
    "disk in space",
    "Conformal Disk",
    "conformal map",
    "OMT Area Preserving",
    "flat map",
)
LAYERS = (  # top to bottom: name, text
    ("Plugin", "ParaView's panels, menus, help and macros: server-manager XML, no code of the method"),
    ("Filters", "VTK classes, one per filter; Filters/Internal converts data sets to Core's meshes and back"),
)
FLOOR_TOP = 300
HEIGHTS = {5: 84, 4: 70, 3: 104, 2: 50, 1: 50}  # of the boxes, by floor
GAPS = {5: 40, 4: 40, 3: 30, 2: 14, 1: 4}  # below them
FLOOR_COLOURS = {5: "#fde5cf", 4: "#fdf3cf", 3: "#dff0d8", 2: "#d9e9f6", 1: "#e4e0f0"}


def table_of(core):
    """The folders of Core as {name: (floor, text)}."""
    rows = re.findall(r"^\| (\d+) \| (\w+) \| [\w, ]*\| (.*?) \|$", (core / "README.md").read_text(), re.MULTILINE)
    return {name: (int(floor), text) for floor, name, text in rows}


def includes_of(core, folders):
    """The pairs (folder, folder that it includes), without the general ones."""
    found = set()
    for folder in folders:
        for path in (core / folder).rglob("*"):
            if path.suffix in (".h", ".cxx"):
                for other in re.findall(r'^#include "(\w+)/', path.read_text(), re.MULTILINE):
                    if other in folders and other != folder and other not in GENERAL:
                        found.add((folder, other))
    return sorted(found)


class Picture:
    def __init__(self, folders):
        self.folders = folders
        self.parts = []
        self.tops = {}
        top = FLOOR_TOP
        for floor in sorted({floor for floor, _ in folders.values()}, reverse=True):
            self.tops[floor] = top
            top += HEIGHTS[floor] + GAPS[floor]
        self.height = top

    def text(self, x, y, content, size=13, anchor="start", weight="normal", colour="#222"):
        self.parts.append(
            f'<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}" font-weight="{weight}" '
            f'fill="{colour}">{html.escape(content)}</text>'
        )

    def box(self, left, top, right, height, colour):
        self.parts.append(
            f'<rect x="{left}" y="{top}" width="{right - left}" height="{height}" rx="6" fill="{colour}" '
            'stroke="#777"/>'
        )

    def arrow(self, x1, y1, x2, y2, colour="#555"):
        self.parts.append(
            f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="{colour}" stroke-width="1.6" '
            'marker-end="url(#head)"/>'
        )

    def box_of(self, folder):
        """Left, top, right and bottom of a folder's box."""
        floor = self.folders[folder][0]
        left, right = COLUMNS[folder]
        return left, self.tops[floor], right, self.tops[floor] + HEIGHTS[floor]

    def draw_way(self):
        self.text(20, 28, "The way of the data", 15, weight="bold")
        x = 20
        for i, name in enumerate(WAY):
            if i % 2:
                self.text(x + 66, 50, name, 12, "middle", colour="#333")
                self.arrow(x + 4, 60, x + 128, 60)
                self.text(x + 66, 78, f"stage {i // 2 + 1}", 11, "middle", colour="#777")
                x += 134
            else:
                self.box(x, 44, x + 136, 32, "#f4f4f4")
                self.text(x + 68, 65, name, 13, "middle", "bold")
                x += 136

    def draw_layers(self):
        self.text(20, 112, "The layers: each includes only what lies below it", 15, weight="bold")
        y = 124
        for name, text in LAYERS:
            self.box(20, y, 980, 46, "#f4f4f4")
            self.text(32, y + 20, name, 14, weight="bold")
            self.text(32, y + 37, text, 12)
            y += 58
        self.text(
            20,
            y + 24,
            "Filters/Core: the mathematics, without VTK. An arrow points to what a folder includes;",
            13,
            weight="bold",
        )
        self.text(20, y + 42, "every folder may include Mesh and Base as well. Circles mark the three stages.", 13)

    def draw_folder(self, folder):
        left, top, right, bottom = self.box_of(folder)
        floor, text = self.folders[folder]
        self.box(left, top, right, bottom - top, FLOOR_COLOURS[floor])
        self.text(left + 10, top + 21, folder, 14, weight="bold")
        width = max(16, (right - left - 20) // 6)
        for i, line in enumerate(textwrap.wrap(text.removeprefix(f"stage {STAGES.get(folder)}: "), width)):
            self.text(left + 10, top + 39 + 14 * i, line, 11)
        if folder in STAGES:
            self.parts.append(f'<circle cx="{right - 16}" cy="{top + 16}" r="10" fill="#c0392b"/>')
            self.text(right - 16, top + 20, STAGES[folder], 12, "middle", "bold", "#fff")

    def draw_include(self, upper, lower, taken):
        left = max(self.box_of(upper)[0], self.box_of(lower)[0])
        right = min(self.box_of(upper)[2], self.box_of(lower)[2])
        between = [
            self.box_of(other)
            for other, (floor, _) in self.folders.items()
            if self.folders[lower][0] < floor < self.folders[upper][0]
        ]
        free = [
            x
            for x in range(left + 12, right - 11)
            if all(not box[0] - 8 < x < box[2] + 8 for box in between) and all(abs(x - other) > 16 for other in taken)
        ]
        if not free:
            raise ValueError(f"no straight line leads from {upper} to {lower}: change COLUMNS")
        middle = (left + right) / 2
        x = min(free, key=lambda each: abs(each - middle))
        taken.append(x)
        self.arrow(x, self.box_of(upper)[3], x, self.box_of(lower)[1] - 2)

    def draw(self, includes):
        self.draw_way()
        self.draw_layers()
        taken = {}
        for upper, lower in includes:
            self.draw_include(upper, lower, taken.setdefault(self.folders[upper][0], []))
        for folder in self.folders:
            self.draw_folder(folder)
        return "\n".join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="{self.height}" '
                f'viewBox="0 0 1000 {self.height}" font-family="DejaVu Sans, Verdana, sans-serif">',
                '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" '
                'orient="auto"><path d="M0,0 L8,4 L0,8 z" fill="#555"/></marker></defs>',
                f'<rect width="1000" height="{self.height}" fill="#fff"/>',
                *self.parts,
                "</svg>",
                "",
            ]
        )


def picture(repository):
    core = Path(repository) / "Filters/Core"
    folders = table_of(core)
    if folders.keys() != COLUMNS.keys():
        raise ValueError(f"COLUMNS does not fit the folders of Core: {folders.keys() ^ COLUMNS.keys()}")
    return Picture(folders).draw(includes_of(core, folders))


def main():
    repository = Path(__file__).resolve().parents[2]
    target = repository / "docs/pictures/architecture.svg"
    target.write_text(picture(repository), encoding="utf-8")
    print(target, file=sys.stderr)


if __name__ == "__main__":
    main()
