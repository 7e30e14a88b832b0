# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: flattens the surface that is selected in the pipeline browser and compares the maps."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip
from surfaceflattening_layout import flatten_and_compare

flatten_and_compare(simple.GetActiveSource())
