# SPDX-License-Identifier: GPL-3.0-or-later
"""Of a test of the window: three Surface To Disk one after the other give the same disk, whose seam is open. An assertion
that fails is an error."""

from paraview import servermanager, simple
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges

disks = [source for source in simple.GetSources().values() if source.GetXMLName() == "SurfaceToDisk"]
assert len(disks) == 3, disks
first, *others = (servermanager.Fetch(disk) for disk in disks)


def boundary_edges(surface):
    edges = vtkFeatureEdges()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.SetInputDataObject(surface)
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


for other in others:
    assert other.GetNumberOfCells() == first.GetNumberOfCells(), (other.GetNumberOfCells(), first.GetNumberOfCells())
    assert other.GetNumberOfPoints() == first.GetNumberOfPoints()
    assert all(other.GetPoint(k) == first.GetPoint(k) for k in range(first.GetNumberOfPoints()))
    assert boundary_edges(other) == boundary_edges(first) > 20, boundary_edges(other)
# The banks of the seam coincide: merged, the sphere would be closed.
merged = vtkCleanPolyData()
merged.SetInputDataObject(first)
merged.Update()
assert boundary_edges(merged.GetOutput()) == 0
measured = simple.GetActiveSource()
assert measured.FieldData["FlippedFaces"].GetRange()[0] == 0
assert measured.GetDataInformation().GetNumberOfPoints() == first.GetNumberOfPoints()
