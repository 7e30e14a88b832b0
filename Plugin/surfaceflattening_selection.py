# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures of what is selected on a flat map or on its surface.

    from surfaceflattening_selection import measure_selection

    print(measure_selection(measured))  # measured: Distortion Metrics with a selection

The module comes with the plugin. Flatten and Compare shows these measures in its layout while one selects.
"""

from dataclasses import dataclass

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy


@dataclass
class SelectionMeasures:
    """Lengths and areas are in units of the surface."""

    faces: int  # those with a selected corner, if points are selected
    surface_area: float
    flat_area: float
    area_error: float  # percent, mean of the faces' errors, weighted by their areas
    angle_error: float  # degrees, likewise
    centroid: tuple  # on the surface
    extent: tuple  # of the bounding box on the surface

    def __str__(self):
        change = 100.0 * (self.flat_area / self.surface_area - 1.0)
        centroid = ", ".join(f"{x:.1f}" for x in self.centroid)
        extent = " x ".join(f"{x:.1f}" for x in self.extent)
        return (
            f"Selection: {self.faces:,} triangles\n"
            f"area: {self.surface_area:.1f} on the surface,\n"
            f"{self.flat_area:.1f} on the map ({round(change, 2) + 0.0:+.2f} %)\n"  # no -0.00
            f"mean error: area {percent(self.area_error)}, angle {self.angle_error:.1f}\N{DEGREE SIGN}\n"
            f"centroid: {centroid}\n"
            f"extent: {extent}"
        )


def percent(value):
    """A share in percent with two digits, or without decimals from 10 on."""
    return f"{value:.0f} %" if abs(value) >= 10.0 else f"{value:.2g} %"


def measure_selection(source):
    """The measures of the selection on @source, a Distortion Metrics; None if nothing is selected. Of selected
    points a triangle counts as many thirds as it has selected corners.

    @raise ValueError if @source is no Distortion Metrics or its selection cannot be evaluated.
    """
    if source.SMProxy.GetSelectionInput(0) is None:
        return None
    extracted = servermanager.filters.ExtractSelection(Input=source, PreserveTopology=1)
    extracted.Selection = servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0))
    extracted.UpdatePipeline()
    data = servermanager.Fetch(extracted)
    del extracted
    return None if data is None or data.GetNumberOfCells() == 0 else _measures_of(data)


def _measures_of(data):
    cells, points = data.GetCellData(), data.GetPointData()
    if not (cells.HasArray("AreaRatio") and points.HasArray("SurfacePoints")):
        raise ValueError("this is no Distortion Metrics: it has no arrays AreaRatio and SurfacePoints")
    faces = _triangles(data)
    chosen = cells.GetArray("vtkInsidedness")
    if chosen is not None:
        share = (vtk_to_numpy(chosen) > 0).astype(float)
    else:
        share = (vtk_to_numpy(points.GetArray("vtkInsidedness")) > 0)[faces].mean(axis=1)
    inside = share > 0
    if not inside.any():
        return None
    faces, share = faces[inside], share[inside]
    surface = vtk_to_numpy(points.GetArray("SurfacePoints"))[faces]
    areas = _areas(surface) * share
    total = areas.sum()
    if not total > 0.0:
        return None
    flat = vtk_to_numpy(data.GetPoints().GetData())[faces]
    ratio, angle = (vtk_to_numpy(cells.GetArray(name))[inside] for name in ("AreaRatio", "AngleError"))
    return SelectionMeasures(
        faces=int(inside.sum()),
        surface_area=float(total),
        flat_area=float((_areas(flat) * share).sum()),
        area_error=float((100.0 * abs(ratio - 1.0) * areas).sum() / total),
        angle_error=float((angle * areas).sum() / total),
        centroid=tuple(float(x) for x in (surface.mean(axis=1) * areas[:, None]).sum(axis=0) / total),
        extent=tuple(float(x) for x in numpy.ptp(surface.reshape(-1, 3), axis=0)),
    )


def _triangles(data):
    cells = data.GetPolys() if data.IsA("vtkPolyData") else data.GetCells()
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)


def _areas(corners):
    sides = corners[:, 1:] - corners[:, :1]
    return 0.5 * numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1)


INVITATION = "Select triangles or points to measure\nthem: keys S and D, then drag."


def show_measures(source, text, view):
    """Keeps the Text source @text, which is shown in @view, up to date with the selection on @source."""

    def update(*_):
        try:
            measures = measure_selection(source)
        except (ValueError, RuntimeError) as error:
            measures = error
        text.Text = str(measures) if measures else INVITATION
        simple.Render(view)

    text.Text = INVITATION
    tag = source.SMProxy.AddObserver("SelectionChangedEvent", update)
    _observed.append((source.SMProxy, tag))
    return tag


_observed = []  # proxies and tags of the observers


def stop(kept=()):
    """Ends the updates but those of the sources whose proxies are @kept. ParaView clears selections when it ends, and its
    views can no longer be drawn then."""
    for proxy, tag in list(_observed):
        if proxy not in kept:
            proxy.RemoveObserver(tag)
            _observed.remove((proxy, tag))
