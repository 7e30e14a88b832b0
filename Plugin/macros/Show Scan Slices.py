# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: shows three slices of the scan that is selected in the pipeline browser, or that a surface was made of."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip  # noqa: F401
import surfaceflattening_commands

surfaceflattening_commands.run("scan_slices")
