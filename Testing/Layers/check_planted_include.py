# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants forbidden includes and too many lines into a copy of Filters/Core and expects check_includes.py to name each.

    python3 check_planted_include.py <folder of Core>"""
import pathlib
import shutil
import sys
import tempfile

import check_includes

PLANTED = (
    ("Mesh/TriangleMesh.h", '#include "Areas/AreaPreservingDisk.h"\n', "does not let Mesh include Areas"),
    ("Conformal/ConformalDisk.cxx", '#include "Disk/SurfaceToDisk.h"\n', "does not let Conformal include Disk"),
    ("Disk/SurfaceToDisk.cxx", "#include <vtkPolyData.h>\n", "a header of VTK"),
    ("Base/Errors.h", '#include "../Mesh/TriangleMesh.h"\n', "does not begin at Core"),
    ("Base/Memory.cxx", "\n" * check_includes.MOST_LINES, "lines, more than"),
)


def main():
    with tempfile.TemporaryDirectory() as folder:
        core = pathlib.Path(folder) / "Core"
        shutil.copytree(sys.argv[1], core)
        for name, include, expected in PLANTED:
            path = core / name
            original = path.read_text()
            path.write_text(include + original)
            found = list(check_includes.faults(core))
            path.write_text(original)
            if len(found) != 1 or expected not in found[0]:
                sys.exit(f"{include.strip() or 'Lines'} in {name}: expected '{expected}', found {found}")
            print(found[0])
    return 0


if __name__ == "__main__":
    sys.exit(main())
