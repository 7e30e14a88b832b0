# SPDX-License-Identifier: GPL-3.0-or-later
"""Every place of Utilities/campaigns/code_breaks.py stands in the code, once."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Utilities/campaigns"))

import break_code

lines = break_code.find_lines()  # ends with a message that names the place otherwise
assert len(lines) == len(break_code.BREAKS) >= 100, len(lines)
assert min(lines) > 3, "no place stands above the includes"
