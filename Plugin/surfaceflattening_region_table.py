# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of regions as papers report them: area, mean curvature, extent, for each label and hemisphere.

    from surfaceflattening_region_table import region_table, write_csv
    write_csv("lh.regions.csv", region_table(flat, "aparc"))

It needs numpy and VTK alone. The filter Region Table shows the same table in ParaView.
"""

import csv
import re
from collections import Counter

import numpy as np
from surfaceflattening_whole_file import whole_file
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable
from vtkmodules.vtkFiltersGeneral import vtkCurvatures

TOTAL = "Total"


class RegionTableError(ValueError):
    """Why there is no table, in words for the user."""


def region_table(surface, array, curvature=None, names=None, hemisphere=None, hole=None):
    """Rows as dictionaries, one for each label and hemisphere, then one Total for each hemisphere.

    @surface: vtkPolyData of triangles, a surface or a flat map. @array: its labels, on points or cells.
    @curvature: a point array; by default the mean curvature is computed, above 0 where the surface bulges outwards.
    @names: {label: name}; by default those that came with the file. @hemisphere: "left" or "right"; by default by the
    ending _L or _R of the name, or by the side of the patient on which each triangle lies. @hole: a label that is left
    out, such as 0.
    """
    data = surface
    faces = _faces(data)
    points = _in_space(data)
    labels = _labels_of_faces(data, array, faces)
    areas = _areas(points, faces)
    flat_areas = _areas(_points(data), faces) if data.GetPointData().GetArray("SurfacePoints") else None
    bend = _curvature(data, points, curvature)[faces].mean(axis=1)
    names = names or names_of(data, array)
    sides = _sides(data, points, faces, labels, names, hemisphere)
    keys = sorted({(int(label), side) for label, side in zip(labels, sides) if label != hole})
    patient = _to_patient(data)
    rows = []
    for label, side in keys:
        own = (labels == label) & (sides == side)
        name = names.get(label, str(label))
        rows.append(_row(label, name, side, own, points, faces, areas, flat_areas, bend, patient))
    for side in sorted({side for _label, side in keys}):
        own = (sides == side) & np.isin(labels, [label for label, _side in keys])
        rows.append(_row(-1, TOTAL, side, own, points, faces, areas, flat_areas, bend, patient))
    return rows


def names_of(data, array):
    """{label: name} from the field arrays that the reader of cortex files writes."""
    field = data.GetFieldData()
    labels, names = field.GetArray(f"{array}Labels"), field.GetAbstractArray(f"{array}Names")
    if not labels or not names:
        return {}
    return {int(labels.GetTuple1(k)): names.GetValue(k) for k in range(names.GetNumberOfValues())}


def read_names(path):
    """{label: name} of a text file with a label and a name in each line, such as mricron's aal.nii.txt or FreeSurfer's
    table of colours. Numbers behind a name are codes or colours, unless regions differ by them alone."""
    names, whole = {}, {}
    with open(path, encoding="utf-8-sig", errors="replace") as lines:
        for line in lines:
            words = line.split()
            if len(words) >= 2 and re.fullmatch(r"-?\d+", words[0]):
                label = int(words[0])
                names[label], whole[label] = _name_of(words[1:]), " ".join(words[1:])
    if not names:
        raise RegionTableError(f"{path}: no line has a label and a name")
    times = Counter(names.values())
    return {label: name if times[name] == 1 else whole[label] for label, name in names.items()}


def _name_of(words):
    """The words without the numbers at their end; the first one always."""
    end = len(words)
    while end > 1 and re.fullmatch(r"-?\d+(\.\d+)?", words[end - 1]):
        end -= 1
    return " ".join(words[:end])


def write_csv(path, rows):
    """A file that spreadsheets open: commas, a header, and UTF-8 with the mark by which Excel knows it."""
    if not rows:
        raise RegionTableError("there are no regions")
    with whole_file(path) as part, open(part, "w", encoding="utf-8-sig", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def _row(label, name, side, own, points, faces, areas, flat_areas, bend, patient):
    area = areas[own].sum()
    corners = points[np.unique(faces[own])] @ patient[:3, :3].T + patient[:3, 3]
    weights = areas[own] / area if area > 0 else np.full(own.sum(), 1 / max(own.sum(), 1))
    centre = weights @ (points[faces[own]].mean(axis=1) @ patient[:3, :3].T + patient[:3, 3])
    size = np.ptp(corners, axis=0)
    row = {"Label": label, "Name": name, "Hemisphere": side, "Triangles": int(own.sum()), "SurfaceArea": float(area)}
    if flat_areas is not None:
        row["FlatArea"] = float(flat_areas[own].sum())
        row["FlatAreaErrorPercent"] = float(100 * (row["FlatArea"] / area - 1)) if area > 0 else float("nan")
    row["MeanCurvature"] = float(weights @ bend[own])
    for k, axis in enumerate("XYZ"):
        row[f"Centre{axis}"] = float(centre[k])
    for k, axis in enumerate("XYZ"):
        row[f"Extent{axis}"] = float(size[k])
    return row


def _faces(data):
    cells = data.GetPolys()
    if cells.GetNumberOfCells() == 0 or cells.IsHomogeneous() != 3:
        raise RegionTableError("there are no triangles, or other cells as well: use Triangulate first")
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)


def _points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def _in_space(data):
    array = data.GetPointData().GetArray("SurfacePoints")
    return vtk_to_numpy(array).astype(float) if array else _points(data)


def _areas(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def _labels_of_faces(data, name, faces):
    """As Distortion Metrics has them: two corners outvote the third, and of three regions the first corner's counts."""
    array = data.GetCellData().GetArray(name) if name else None
    on_points = data.GetPointData().GetArray(name) if name else None
    if array is None and on_points is None:
        raise RegionTableError(f"there is no array {name}: choose the array of labels")
    labels = vtk_to_numpy(on_points if on_points is not None else array)
    if labels.ndim > 1 or not np.array_equal(labels, np.rint(labels)):
        raise RegionTableError(
            f"{name} does not have whole numbers, one for each point or cell: it is no array of labels"
        )
    labels = labels.astype(np.int64)
    if on_points is None:
        return labels
    a, b, c = labels[faces].T
    return np.where(b == c, b, a)


def _curvature(data, points, name):
    if name:
        array = data.GetPointData().GetArray(name)
        if array is None or array.GetNumberOfComponents() != 1:
            raise RegionTableError(f"there is no point array {name} of one number: choose the array of curvature")
        return vtk_to_numpy(array).astype(float)
    surface = vtkPolyData()
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(points, deep=True))
    surface.SetPoints(positions)
    surface.SetPolys(data.GetPolys())
    filter_ = vtkCurvatures()
    filter_.SetInputData(surface)
    filter_.SetCurvatureTypeToMean()
    filter_.Update()
    return vtk_to_numpy(filter_.GetOutput().GetPointData().GetArray("Mean_Curvature")).copy()


def _to_patient(data):
    """The matrix from the coordinates of the surface to RAS+ mm; the identity if it is there, or if it is unknown."""
    field = data.GetFieldData()
    matrix, placed = field.GetArray("PatientMatrix"), field.GetArray("InPatientSpace")
    if not matrix or (placed and placed.GetTuple1(0)):
        return np.eye(4)
    return np.reshape(matrix.GetTuple(0), (4, 4))


def _sides(data, points, faces, labels, names, hemisphere):
    """left, right, or nothing where it is not known, for each triangle."""
    if hemisphere:
        return np.full(len(faces), hemisphere, dtype=object)
    known = data.GetFieldData().GetAbstractArray("Hemisphere")
    if known:
        return np.full(len(faces), known.GetValue(0), dtype=object)
    sides = np.full(len(faces), "", dtype=object)
    field = data.GetFieldData()
    if field.GetArray("PatientMatrix") or field.GetArray("InPatientSpace"):
        patient = _to_patient(data)
        middle = points[faces].mean(axis=1) @ patient[0, :3] + patient[0, 3]
        sides = np.where(middle < 0, "left", "right").astype(object)
    for label, name in names.items():
        for ending, side in (("_L", "left"), ("_R", "right")):
            if name.endswith(ending):
                sides[labels == label] = side
    return sides


def table_of(rows):
    """The rows as vtkTable."""
    table = vtkTable()
    for name in rows[0]:
        values = [row[name] for row in rows]
        if isinstance(values[0], str):
            column = vtkStringArray()
            for value in values:
                column.InsertNextValue(value)
        else:
            column = numpy_to_vtk(np.array(values), deep=True)
        column.SetName(name)
        table.AddColumn(column)
    return table


class RegionTable(VTKPythonAlgorithmBase):
    """The filter behind the proxy RegionTable in NeuroFiles.xml."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, inputType="vtkPolyData", outputType="vtkTable")
        self._regions, self._curvature, self._names_file = None, None, None

    def SetRegionArray(self, *arguments):
        self._regions = arguments[-1]
        self.Modified()

    def SetCurvatureArray(self, *arguments):
        self._curvature = None if arguments[-1] in ("", "None") else arguments[-1]
        self.Modified()

    def SetNamesFile(self, path):
        self._names_file = path or None
        self.Modified()

    def RequestData(self, _request, inputs, outputs):
        data = vtkPolyData.GetData(inputs[0], 0)
        output = vtkTable.GetData(outputs, 0)
        if data.GetNumberOfPoints() == 0:
            return 1
        try:
            names = read_names(self._names_file) if self._names_file else None
            output.ShallowCopy(table_of(region_table(data, self._regions, self._curvature, names)))
        except (RegionTableError, OSError) as error:
            vtkOutputWindow.GetInstance().DisplayErrorText(f"Region Table: {error}\n")
        return 1
