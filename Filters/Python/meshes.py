# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces as callers have them, to vtkPolyData and back."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

if TYPE_CHECKING:
    import numpy
    import pyvista

    Surface = Union[vtkPolyData, pyvista.PolyData, Tuple[numpy.ndarray, numpy.ndarray]]
else:
    Surface = Any


def as_polydata(surface: Surface, faces: Optional[numpy.ndarray] = None) -> vtkPolyData:
    """The surface as vtkPolyData: itself if it is one, as PyVista's PolyData is, or made of arrays."""
    if isinstance(surface, vtkPolyData):
        if faces is not None:
            raise TypeError("a vtkPolyData has faces of its own: leave out the argument faces")
        return surface
    if faces is not None:
        return _polydata_of_arrays(surface, faces)
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        return _polydata_of_arrays(*surface)
    if hasattr(surface, "IsA") and surface.IsA("vtkDataObject"):
        raise TypeError(
            f"this is a {surface.GetClassName()}, not a surface: take its surface first, with vtkGeometryFilter or "
            "PyVista's extract_surface(), or one block of it"
        )
    raise TypeError(
        f"this is a {type(surface).__name__}, not a surface: give a vtkPolyData, a PyVista PolyData, or an array of "
        "points (n x 3) and one of faces (m x 3)"
    )


def like(surface: Surface, result: vtkPolyData) -> Any:
    """The result as PyVista's PolyData if the surface was one."""
    pyvista = sys.modules.get("pyvista")
    return pyvista.wrap(result) if pyvista and isinstance(surface, pyvista.PolyData) else result


def _polydata_of_arrays(points: Any, faces: Any) -> vtkPolyData:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    points = numpy.ascontiguousarray(points, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"the array of points has the shape {points.shape}: it must be n x 3")
    corners = numpy.asarray(faces)
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError(f"the array of faces has the shape {corners.shape}: it must be m x 3, three points of each")
    if not numpy.issubdtype(corners.dtype, numpy.integer):
        raise ValueError(f"the array of faces has values of type {corners.dtype}: they must be numbers of points")
    if corners.size and (corners.min() < 0 or corners.max() >= len(points)):
        raise ValueError(
            f"the faces name points {corners.min()} to {corners.max()}: there are points 0 to {len(points) - 1}"
        )
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(corners, dtype=numpy.int64).ravel(), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    return surface
