# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads every include of Filters/Core and compares it with the table of folders in Filters/Core/README.md.

    python3 check_includes.py <folder of Core>

Prints each include that the table does not allow, each file that is in no folder, and each source file that is too
long; the exit status is 0 if there is none."""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
MOST_UNITS = 30  # a folder that one can take in at a glance
MOST_LINES = 400  # of a source file


def allowed_folders(readme):
    """The table's rows as {folder: names of the folders that it may include}."""
    rows = re.findall(r"^\| \d+ \| (\w+) \| ([\w, ]*)\|", readme.read_text(), re.MULTILINE)
    return {folder: set(re.findall(r"\w+", names)) for folder, names in rows}


def faults_of_file(path, core, allowed):
    folder = path.relative_to(core).parts[0]
    for name in INCLUDE.findall(path.read_text()):
        if pathlib.PurePath(name).name.startswith("vtk"):
            yield f"{path}: includes {name}, a header of VTK"
        if not (core / name).exists():
            if name.startswith("..") or (path.parent / name).exists():
                yield f"{path}: includes {name} by a path that does not begin at Core"
            continue
        other = name.split("/")[0]
        if other != folder and other not in allowed[folder]:
            yield f"{path}: includes {name}, but the table does not let {folder} include {other}"


def faults(core):
    allowed = allowed_folders(core / "README.md")
    folders = {path.name for path in core.iterdir() if path.is_dir()}
    for folder in folders ^ allowed.keys():
        yield f"{core / folder}: stands in the table or on the disk, but not in both"
    for path in core.iterdir():
        if path.is_file() and path.name not in ("CMakeLists.txt", "README.md"):
            yield f"{path}: belongs in a folder"
    for folder in sorted(folders & allowed.keys()):
        files = sorted(path for path in (core / folder).rglob("*") if path.suffix in (".h", ".cxx"))
        units = {path.stem for path in files}
        if len(units) > MOST_UNITS:
            yield f"{core / folder}: has {len(units)} units, more than {MOST_UNITS}"
        for path in files:
            yield from faults_of_file(path, core, allowed)
            lines = path.read_text().count("\n")
            if path.suffix == ".cxx" and lines > MOST_LINES:
                yield f"{path}: has {lines} lines, more than {MOST_LINES}"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "Every include of Core is allowed.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
