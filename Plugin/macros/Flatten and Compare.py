# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: flattens the surface that is selected in the pipeline browser and compares the maps."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip  # noqa: F401
import surfaceflattening_commands

surfaceflattening_commands.run("flatten_and_compare")
