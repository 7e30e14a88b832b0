# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin loads in ParaView from PV_PLUGIN_PATH, and a failing filter leaves ParaView alive."""

import math
import os
import re

from paraview import servermanager
from paraview.simple import Calculator, Delete, DistortionMetrics, Plane, Triangulate

flat = Triangulate(Input=Plane(XResolution=8, YResolution=8))
stretched = Calculator(
    Input=flat, ResultArrayName="SurfacePoints", Function="4 * coordsX * iHat + coordsY * jHat"
)
metrics = DistortionMetrics(Input=stretched)
metrics.UpdatePipeline()
low, high = metrics.CellData["AngleDistortion"].GetRange()
assert math.isclose(low, math.log(4), rel_tol=1e-6), low
assert math.isclose(high, math.log(4), rel_tol=1e-6), high
table = servermanager.Fetch(metrics, idx=1)
assert table.GetNumberOfRows() == 1, table.GetNumberOfRows()
assert table.GetValueByName(0, "FlippedFaces").ToInt() == 0

# A filter whose input lacks SurfacePoints: pvpython raises nothing, and the output is empty.
wrong = DistortionMetrics(Input=flat)
wrong.UpdatePipeline()
assert wrong.GetDataInformation().GetNumberOfCells() == 0
Delete(wrong)

metrics.UseTargetArea = 0
metrics.UpdatePipeline()
assert metrics.GetDataInformation().GetNumberOfCells() == 128

# The version that the plugin manager shows is the project's.
source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cmake", "SurfaceFlatteningVersion.cmake")
with open(source, encoding="utf-8") as lines:
    version = re.search(r"^set\(SURFACEFLATTENING_VERSION (\S+)\)$", lines.read(), re.MULTILINE).group(1)
plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
shown = {plugins.GetPluginName(i): plugins.GetPluginVersion(i) for i in range(plugins.GetNumberOfPlugins())}
assert shown["SurfaceFlattening"] == version, shown
