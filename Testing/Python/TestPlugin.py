# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin loads in ParaView from PV_PLUGIN_PATH, and a failing filter leaves ParaView alive."""

import math
import os
import re

from paraview import servermanager
from paraview.simple import Calculator, Delete, DistortionMetrics, GetParaViewVersion, Plane, Triangulate

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

# Without MeasureLengths there is no error of lengths. The stretch by 4 is that of a length along x against one along y.
assert metrics.FieldData.GetArray("MeanLocalLengthError") is None
metrics.MeasureLengths = 1
metrics.LengthRadius = 0.8
metrics.LengthSamples = 40
metrics.UpdatePipeline()
for kind in ("Local", "WithinMap", "Global"):
    mean, error, p95 = (
        metrics.FieldData[f"{name}{kind}LengthError"].GetRange()[0] for name in ("Mean", "StandardError", "P95")
    )
    assert 10 < mean < 60 and 0 < error < mean and mean < p95 < 300, (kind, mean, error, p95)
assert metrics.FieldData["RingDistanceError"].GetRange()[0] > 10
assert metrics.PointData["LengthError"].GetRange()[1] > 10
metrics.MeasureLengths = 0

metrics.UseTargetArea = 0
metrics.UpdatePipeline()
assert metrics.GetDataInformation().GetNumberOfCells() == 128

# The version that the plugin manager shows is the project's.
source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cmake", "SurfaceFlatteningVersion.cmake")
with open(source, encoding="utf-8") as lines:
    version = re.search(r"^set\(SURFACEFLATTENING_VERSION (\S+)\)$", lines.read(), re.MULTILINE).group(1)
plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
shown = {plugins.GetPluginName(i): plugins.GetPluginVersion(i) for i in range(plugins.GetNumberOfPlugins())}
if GetParaViewVersion() < (6, 0):
    assert shown["SurfaceFlattening"] == version, shown
else:  # from the list beside the plugin, before it is loaded
    with open(os.path.join(os.environ["PV_PLUGIN_PATH"], "surfaceflattening.xml"), encoding="utf-8") as lines:
        assert f'version="{version}" description="Flattens' in lines.read()
