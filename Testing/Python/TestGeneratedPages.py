# SPDX-License-Identifier: GPL-3.0-or-later
"""The generated pages and pictures of docs are up to date, and no parameter or array lacks a text."""

import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "Utilities/docs"))

import architecture_picture
import reference

missing = list(reference.undocumented(root))
assert not missing, "\n".join(missing)

page = (root / "docs/reference.md").read_text(encoding="utf-8")
assert page.count("\n## ") > 12 and page.count("\n- ") > 250, "the script finds next to nothing"
assert page == reference.reference(root), "docs/reference.md is stale: run Utilities/docs/reference.py"

picture = (root / "docs/pictures/architecture.svg").read_text(encoding="utf-8")
assert picture == architecture_picture.picture(root), (
    "docs/pictures/architecture.svg is stale: run Utilities/docs/architecture_picture.py"
)
