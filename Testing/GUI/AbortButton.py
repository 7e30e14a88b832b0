# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: a conformal map whose faces take OMT Area Preserving some seconds (see AbortButton.cxx)."""

import os

from paraview import simple

sphere = simple.Sphere(ThetaResolution=250, PhiResolution=250)
conformal = simple.ConformalDisk(Input=simple.SurfaceToDisk(Input=sphere))
simple.Show(conformal)
simple.Render()
simple.SetActiveSource(conformal)
os.environ["CONFORMAL_MAP_IS_MADE"] = "1"
