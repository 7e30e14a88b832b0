# SPDX-License-Identifier: GPL-3.0-or-later
"""Macro: shows the letters R, L, A, P, S and I around the scan or surface that is selected in the pipeline browser."""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip  # noqa: F401
import surfaceflattening_commands

surfaceflattening_commands.run("patient_axes")
