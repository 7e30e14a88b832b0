# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens surfaces to a disk or another planar domain such that every triangle keeps its area.

    from surfaceflattening import flatten
    flat = flatten(surface)  # a vtkPolyData, a PyVista PolyData, or (points, faces) as arrays

flatten() does all steps; to_disk(), conformal(), area_preserving(), distortion(), region() and isosurface() do one
each. read_scan() opens a scan where the patient is.
They raise FlatteningError where a filter would leave its output empty, and for an empty surface or image. The
VTK filters themselves are here too, vtkSurfaceToDiskFilter and so on, for pipelines: their output is empty then.

Lengths are in the units of the surface, areas in their squares, angles of settings in degrees.
"""

import sys

try:
    from vtkmodules import vtkCommonExecutionModel as _  # noqa: F401
except ImportError as error:
    raise ImportError(
        f"surfaceflattening needs the Python modules of the VTK that it was built for, and {sys.executable} has none "
        f"({error}): on Debian, apt install python3-vtk9, or python3-paraview for a build with ParaView"
    ) from error

from .SurfaceFlatteningFilters import *  # noqa: F401,F403
from .errors import Cancelled, FlatteningError, FlatteningWarning, SettingError
from .functions import Distortion, Region, area_preserving, conformal, distortion, flatten, region, to_disk
from .volumes import isosurface, read_scan

__all__ = [name for name in dir() if name.startswith("vtk")] + [
    "Cancelled",
    "Distortion",
    "FlatteningError",
    "FlatteningWarning",
    "Region",
    "SettingError",
    "area_preserving",
    "conformal",
    "distortion",
    "flatten",
    "isosurface",
    "read_scan",
    "region",
    "to_disk",
]

if "pyvista" in sys.modules:
    from . import accessors  # noqa: F401
