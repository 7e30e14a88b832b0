# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: flattens the cortex that is selected in the pipeline browser: map, table of regions, FreeSurfer's patch."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip
from surfaceflattening_cortex import flatten_cortex_and_show

flatten_cortex_and_show(simple.GetActiveSource())
