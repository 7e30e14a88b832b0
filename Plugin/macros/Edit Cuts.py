# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: makes the cuts of the Surface To Disk that is selected in the pipeline browser points that can be moved."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip  # noqa: F401
import surfaceflattening_commands

surfaceflattening_commands.run("edit_cuts")
