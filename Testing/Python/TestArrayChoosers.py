# SPDX-License-Identifier: GPL-3.0-or-later
"""Array choosers whose default is None: a fresh filter has no array chosen whatever arrays its input has, and offers
the arrays of points and cells, but not those of the field data."""

import glob
import os
import xml.etree.ElementTree as xml

from paraview import simple
from paraview.simple import Calculator, PointDatatoCellData, ProgrammableFilter, Sphere

PLUGIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin")

places = Calculator(Input=Sphere(), ResultArrayName="SurfacePoints", Function="coords")
heights = Calculator(Input=places, ResultArrayName="Height", Function="coordsZ")
cells = PointDatatoCellData(Input=heights, PassPointData=1, ProcessAllArrays=0, PointDataArraytoprocess=["Height"])
surface = ProgrammableFilter(
    Input=cells,
    CopyArrays=1,
    Script="""
output.FieldData.append(1.0, "Figure")
output.GetPointData().SetActiveScalars("Height")
output.GetCellData().SetActiveScalars("Height")""",
)
surface.UpdatePipeline()
assert surface.FieldData["Figure"] and surface.PointData["Height"] and surface.CellData["Height"]

tested = set()
for path in sorted(glob.glob(os.path.join(PLUGIN, "*.xml"))):
    for proxy in xml.parse(path).getroot().iter("SourceProxy"):
        choosers = [
            p.get("name")
            for p in proxy.iter("StringVectorProperty")
            for domain in p.findall("ArrayListDomain")
            if domain.get("none_string")  # that of Volume To Surface begins with the active scalars
        ]
        if not choosers:
            continue
        fresh = getattr(simple, proxy.get("name"))(Input=surface)
        for name in choosers:
            tested.add(f"{proxy.get('name')}.{name}")
            prop = fresh.GetProperty(name).SMProperty
            assert prop.GetNumberOfElements() == 5, (name, prop.GetNumberOfElements())
            assert prop.GetElement(4) == "None", (proxy.get("name"), name, prop.GetElement(4))
            domain = prop.GetDomain("array_list")
            offered = {domain.GetString(k) for k in range(domain.GetNumberOfStrings())}
            wanted = "SurfacePoints" if name == "PositionArray" else "Height"
            assert {"None", wanted} <= offered and "Figure" not in offered, (proxy.get("name"), name, offered)

assert tested == {
    "AreaWeights.PositionArray",
    "AreaWeights.WeightArray",
    "ContextResolution.RegionArray",
    "DistortionMetrics.RegionArray",
    "FlattenRegion.LabelArray",
    "OMTAreaPreserving.AreaWeightArray",
    "RegionTable.CurvatureArray",
    "RegionTable.RegionArray",
    "SurfaceToDisk.LabelArray",
    "SurfaceToDisk.RegionOfInterest",
}, tested
