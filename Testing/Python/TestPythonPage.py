# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts of docs/python.md and of the README do as they stand there; those that import PyVista only where it is."""

import contextlib
import importlib.util
import io
import os
import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
os.makedirs(os.environ["TEMPORARY_DIRECTORY"], exist_ok=True)
os.chdir(os.environ["TEMPORARY_DIRECTORY"])
if not Path("/usr/share/mricron/templates/ch2bet.nii.gz").exists():
    print("The scan is not there: apt install mricron-data")
    sys.exit(77)
has_pyvista = importlib.util.find_spec("pyvista") is not None
if has_pyvista:
    import surfaceflattening.accessors  # noqa: F401  for PyVista before 0.48

ran = 0
for page in ("docs/python.md", "README.md"):
    for script in re.findall(r"^```python\n(.*?)^```", (root / page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL):
        assert "surfaceflattening" in script or "flatten" in script, script
        if "pyvista" in script and not has_pyvista:
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(script, page, "exec"), {"__name__": page})
        percent = float(re.match(r"([\d.]+) % of the triangles", printed.getvalue()).group(1))
        assert 99 < percent <= 100, printed.getvalue()
        ran += 1
assert ran >= (3 if has_pyvista else 2), ran
