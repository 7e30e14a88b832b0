# SPDX-License-Identifier: GPL-3.0-or-later
"""The outlines of labelled regions, as lines on a surface or a flat map.

    from surfaceflattening_outlines import label_array, label_outlines

    outlines = label_outlines(flat, *label_array(flat))

The module comes with the plugin. Flatten and Compare draws them where the surface has labels.
"""

from paraview import simple

# Arrays of whole numbers that the plugin's filters and ParaView add, which are no labels of regions.
NO_LABELS = {"Seam", "SeamId", "Filled", "Flipped", "Degenerate", "vtkOriginalPointIds", "vtkOriginalCellIds"}
# More values than regions of any atlas: identifiers, or grey values.
MOST_LABELS = 1000


def label_array(source):
    """The association and the name of the first array of whole numbers with 2 to MOST_LABELS values; None."""
    for association, arrays in (("POINTS", source.PointData), ("CELLS", source.CellData)):
        for array in arrays.values():
            whole = array.GetDataTypeAsString() not in ("float", "double", "string")
            if whole and array.GetNumberOfComponents() == 1 and array.GetName() not in NO_LABELS:
                low, high = array.GetRange()
                if 0 < high - low <= MOST_LABELS:
                    return association, array.GetName()
    return None


def label_outlines(source, association, name, registration_name="Outlines"):
    """Lines between the regions: between labels of cells along edges, between labels of points through the
    middles of the edges whose ends differ."""
    return simple.ProgrammableFilter(
        registrationName=registration_name,
        Input=source,
        OutputDataSetType="vtkPolyData",
        Script=SCRIPT.format(association=association, name=name),
    )


SCRIPT = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray

data = self.GetInputDataObject(0, 0)
on_cells = {association!r} == "CELLS"
labels = vtk_to_numpy((data.GetCellData() if on_cells else data.GetPointData()).GetArray({name!r}))
faces = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
if on_cells:
    sides = numpy.sort(numpy.vstack([faces[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    of = numpy.tile(labels, 3)
    order = numpy.lexsort((sides[:, 1], sides[:, 0]))
    sides, of = sides[order], of[order]
    border = (sides[1:] == sides[:-1]).all(axis=1) & (of[1:] != of[:-1])
    ends = points[sides[1:][border]]
else:
    corners, here = points[faces], labels[faces]
    middle = [(corners[:, k] + corners[:, (k + 1) % 3]) / 2 for k in range(3)]
    differ = [here[:, k] != here[:, (k + 1) % 3] for k in range(3)]
    parts = []
    for k in range(3):
        two = differ[k] & differ[(k + 1) % 3] & ~differ[(k + 2) % 3]
        parts.append(numpy.stack([middle[k][two], middle[(k + 1) % 3][two]], axis=1))
        three = differ[0] & differ[1] & differ[2]
        parts.append(numpy.stack([middle[k][three], corners[three].mean(axis=1)], axis=1))
    ends = numpy.concatenate(parts)
places = vtkPoints()
places.SetDataTypeToDouble()
places.SetData(numpy_to_vtk(numpy.ascontiguousarray(ends.reshape(-1, 3)), deep=1))
lines = vtkCellArray()
ids = numpy.arange(2 * len(ends))
lines.SetData(2, numpy_to_vtk(ids, deep=1, array_type=12))
result = self.GetOutputDataObject(0)
result.Initialize()  # it has the points and triangles of the input
result.SetPoints(places)
result.SetLines(lines)
"""
