# SPDX-License-Identifier: GPL-3.0-or-later
"""Between numpy and the data sets of a ParaView pipeline."""

import numpy as np
from paraview import servermanager, simple
from vtkmodules.numpy_interface import dataset_adapter as dsa
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


INPUTS = {}  # what examples begin with, by the name of the file that the gallery saves it to


def source_of(data, name=None):
    """A data set as a source in the pipeline; with a name, one that an example begins with."""
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    if name:
        INPUTS[name] = producer
    return producer


def poly_data(points, polygons=None, lines=None, vertices=False, point_arrays=None, cell_arrays=None):
    """vtkPolyData of n x 3 points; m x k corners of polygons, ends of lines, and a vertex in every point."""
    ends = np.arange(len(points))[:, None] if vertices else None
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=1))
    data.SetPoints(vtk_points)
    for cells, put in ((ends, data.SetVerts), (polygons, data.SetPolys), (lines, data.SetLines)):
        if cells is not None:
            cells = np.asarray(cells)
            array = vtkCellArray()
            sizes = np.arange(0, cells.size + 1, cells.shape[1])
            array.SetData(
                numpy_to_vtkIdTypeArray(sizes.astype(np.int64), deep=1),
                numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel(), np.int64), deep=1),
            )
            put(array)
    for arrays, attributes in ((point_arrays, data.GetPointData()), (cell_arrays, data.GetCellData())):
        for name, values in (arrays or {}).items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
            array.SetName(name)
            attributes.AddArray(array)
    return data


def fetched(source):
    """The data set of a source, for numpy."""
    data = dsa.WrapDataObject(servermanager.Fetch(source))
    if data.GetNumberOfPoints() == 0:
        raise RuntimeError("a step of the pipeline came out empty; see the error above")
    return data


def triangles(data):
    return np.asarray(data.Polygons).reshape(-1, 4)[:, 1:]


def flat_areas(points, faces):
    u, v = (points[faces[:, k], :2] - points[faces[:, 0], :2] for k in (1, 2))
    return 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


def vertex_normals(points, faces):
    """Unit normals of the points: means over the triangles around each point, weighted by their areas."""
    u, v = (points[faces[:, k]] - points[faces[:, 0]] for k in (1, 2))
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, faces[:, k], np.cross(u, v))
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def region_areas(flat, array):
    """{label: (area on the surface, area on the flat map)}, by the table of Distortion Metrics."""
    metrics = simple.DistortionMetrics(Input=flat, UseRegionArray=1, RegionArray=["POINTS", array])
    table = servermanager.Fetch(metrics, idx=1)
    rows = (
        [table.GetValueByName(row, name) for name in ("RegionId", "SurfaceArea", "FlatArea")]
        for row in range(table.GetNumberOfRows() - 1)  # the last is the total
    )
    return {label.ToInt(): (surface.ToDouble(), on_map.ToDouble()) for label, surface, on_map in rows}
