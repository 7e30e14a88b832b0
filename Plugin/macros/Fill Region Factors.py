# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: a row for every label in the table of the Area Weights that is selected in the pipeline browser."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip  # noqa: F401
import surfaceflattening_commands

surfaceflattening_commands.run("fill_region_factors")
