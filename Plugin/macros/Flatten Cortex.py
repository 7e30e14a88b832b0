# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: flattens the cortex that is selected in the pipeline browser: map, table of regions, FreeSurfer's patch."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip  # noqa: F401
import surfaceflattening_commands

surfaceflattening_commands.run("flatten_cortex")
