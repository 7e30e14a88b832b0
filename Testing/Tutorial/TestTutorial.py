# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs in docs/tutorial.md print the result that the page promises.

TestTutorial.py python <folder to work in> <pvpython>
TestTutorial.py cxx <folder to work in> <CMake> [its arguments]
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
SCAN = Path("/usr/share/mricron/templates/ch2bet.nii.gz")
PAGE = Path(__file__).resolve().parents[2] / "docs/tutorial.md"


def code(language):
    fenced = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.M | re.S)
    blocks = [text for marked, text in fenced if marked == language]
    assert len(blocks) == 1, f"{len(blocks)} blocks of {language!r} in {PAGE.name}"
    return blocks[0]


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def python(folder, pvpython):
    script = folder / "region_area.py"
    script.write_text(code("python"), encoding="utf-8")
    return run(pvpython, script)


def cxx(folder, cmake, *arguments):
    (folder / "CMakeLists.txt").write_text(code("cmake"), encoding="utf-8")
    (folder / "RegionArea.cxx").write_text(code("cpp"), encoding="utf-8")
    build = folder / "build"
    run(cmake, "-S", folder, "-B", build, *arguments)
    run(cmake, "--build", build)
    return run(build / "RegionArea")


if not SCAN.exists():
    print(f"skipped: {SCAN} is in Debian's package mricron-data")
    sys.exit(SKIPPED)
work = Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
printed = {"python": python, "cxx": cxx}[sys.argv[1]](work, *sys.argv[3:])
promised = code("")
assert printed == promised, f"printed {printed!r}, the page says {promised!r}"
