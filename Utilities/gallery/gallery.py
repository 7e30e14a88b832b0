# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures and the page of the gallery: run by gallery.sh, in pvpython.

    pvpython gallery.py --plugin SurfaceFlattening.so --pictures docs/pictures/gallery --page docs/gallery.md
    pvpython gallery.py --plugin SurfaceFlattening.so --pictures . city graph    (these alone, figures printed)
"""

import argparse
import importlib
import os
import time

import meshes
from paraview import simple

EXAMPLES = (
    "brain",
    "cortex",
    "thalamus",
    "vase",
    "power_diagram",
    "chest",
    "colon",
    "earth",
    "city",
    "graph",
    "hierarchy",
    "timings",
)

HEAD = """# Gallery

The paper's figures and tables with this project's data. `Utilities/gallery/gallery.sh` makes this page, its pictures and its
figures; it takes a few minutes. Every example is a script of its own in `Utilities/gallery/`:
`Utilities/gallery/gallery.sh city` makes its picture alone and prints its figures. What the examples begin with is saved in
`gallery-output/`, so that they can be made by hand.
"""


def save_inputs(folder):
    os.makedirs(folder, exist_ok=True)
    for name, source in meshes.INPUTS.items():
        simple.SaveData(os.path.join(folder, name), source, DataMode="Binary")


def section(title, picture, text, page):
    link = f"![{title}]({os.path.relpath(picture, os.path.dirname(page))})\n\n" if picture and page else ""
    return f"## {title}\n\n{link}{text}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plugin", required=True, help="SurfaceFlattening.so")
    parser.add_argument("--pictures", required=True, help="folder to write pictures to")
    parser.add_argument("--page", help="the page to write, with all examples")
    parser.add_argument("--inputs", help="folder to write what the examples begin with to, for the GUI")
    parser.add_argument("--tables", nargs="*", default=[], help="files with further sections of the page")
    parser.add_argument("examples", nargs="*", help="of " + ", ".join(EXAMPLES))
    arguments = parser.parse_args()
    unknown = set(arguments.examples) - set(EXAMPLES)
    if unknown:
        parser.error(f"no such example: {', '.join(sorted(unknown))}")
    os.makedirs(arguments.pictures, exist_ok=True)
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
    simple._DisableFirstRenderCameraReset()

    sections = [HEAD]
    for name in arguments.examples or EXAMPLES:
        began = time.monotonic()
        example = importlib.import_module(name)
        picture = os.path.join(arguments.pictures, example.PICTURE) if example.PICTURE else None
        text = "\n".join(example.make(picture))
        if arguments.inputs and picture:
            save_inputs(arguments.inputs)
        meshes.INPUTS.clear()
        simple.ResetSession()
        simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
        print(f"[{time.monotonic() - began:5.1f} s] {picture or name}\n\n{text}\n", flush=True)
        sections.append(section(example.TITLE, picture, text, arguments.page))
    for path in arguments.tables:
        with open(path, encoding="utf-8") as table:
            sections.append(table.read())
    if arguments.page:
        with open(arguments.page, "w", encoding="utf-8") as page:
            page.write("\n".join(sections))


if __name__ == "__main__":
    main()
