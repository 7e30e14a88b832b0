# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions from a surface to its flat map, each a thin layer over one VTK filter, or over all of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional

from . import SurfaceFlatteningFilters as filters
from .errors import FlatteningError
from .meshes import Surface, as_polydata, like
from .running import Abort, Progress, run
from .settings import apply_all, documented, setting_named, shared_settings, unknown_setting

if TYPE_CHECKING:
    import numpy


class Distortion(NamedTuple):
    """What distortion() returns."""

    mesh: Any
    """The flat map with an array for each measure of its faces and points; the field data have means."""
    table: List[Dict[str, Any]]
    """A row for each region, and one for all, as dict by the names of the columns."""


class Region(NamedTuple):
    """What region() returns."""

    mesh: Any
    """The flat map of the region and its margin, with the measures in the field data."""
    table: List[Dict[str, Any]]
    """A row for each measure, as dict: Measure, OnSurface, its StandardDeviation, OnMap and Unit."""
    curves: Any
    """Both diameters and the outline as lines on the map, with the arrays SurfacePoints, Measure and Length; that of the
    outline is along the edges, with their teeth, and greater than the Perimeter of the table."""


# The steps of flatten(): the name in messages, the filter, and the share of the progress, which is the share of the time
# that half a brain takes.
STEPS = (
    ("to_disk", filters.vtkSurfaceToDiskFilter, 0.4),
    ("conformal", filters.vtkConformalDiskFilter, 0.2),
    ("area_preserving", filters.vtkOMTAreaPreservingFilter, 0.35),
    ("distortion", filters.vtkDistortionMetrics, 0.05),
)


def _made(function: str, filter_class: Any, surface: Any, settings: Dict[str, Any]) -> Any:
    """A filter of the class with the surface as input and with the settings."""
    if surface.GetNumberOfCells() == 0:
        raise FlatteningError("the surface has no faces: check that its file could be read")
    filter = filter_class()
    filter.SetInputData(surface)
    named = {}
    for keyword, value in settings.items():
        name = setting_named(filter_class, keyword)
        if name is None:
            raise unknown_setting(function, keyword, (filter_class,))
        named[name] = value
    apply_all(filter, surface, named)
    return filter


def _applied(function: str, filter_class: Any, surface: Surface, progress: Progress, abort: Abort, **settings: Any) -> Any:
    filter = _made(function, filter_class, as_polydata(surface), settings)
    return like(surface, run(filter, progress, abort))


@documented(filters.vtkSurfaceToDiskFilter)
def to_disk(surface: Surface, *, progress: Progress = None, abort: Abort = None, **settings: Any) -> Any:
    """Turns any surface into one clean oriented disk of triangles: repaired, without handles, and cut open if it is closed.

    surface: a vtkPolyData, a PyVista PolyData, or a pair of arrays, points (n x 3) and faces (m x 3).
    progress, abort: callbacks, see flatten().
    Returns a vtkPolyData, or a PyVista PolyData if the surface was one. Raises FlatteningError.
    """
    return _applied("to_disk", filters.vtkSurfaceToDiskFilter, surface, progress, abort, **settings)


@documented(filters.vtkConformalDiskFilter)
def conformal(disk: Surface, *, progress: Progress = None, abort: Abort = None, **settings: Any) -> Any:
    """Maps a disk, as to_disk() makes it, to the plane such that angles are kept.

    The points of the disk are in the point array SurfacePoints of the map. progress, abort: see flatten().
    """
    return _applied("conformal", filters.vtkConformalDiskFilter, disk, progress, abort, **settings)


@documented(filters.vtkOMTAreaPreservingFilter)
def area_preserving(flat: Surface, *, progress: Progress = None, abort: Abort = None, **settings: Any) -> Any:
    """Turns a conformal map, of conformal(), into one on which every face has the area that it has on the surface.

    progress, abort: see flatten().
    """
    return _applied("area_preserving", filters.vtkOMTAreaPreservingFilter, flat, progress, abort, **settings)


@documented(filters.vtkDistortionMetrics)
def distortion(flat: Surface, *, progress: Progress = None, abort: Abort = None, **settings: Any) -> Distortion:
    """Measures a flat map against its surface: errors of areas, angles and lengths of each face, region and of all.

    Returns a Distortion: mesh, the map with arrays and field data, and table, a list of a dict for each region. progress, abort: see flatten().
    """
    filter = _made("distortion", filters.vtkDistortionMetrics, as_polydata(flat), settings)
    mesh = like(flat, run(filter, progress, abort))
    return Distortion(mesh, _rows(filter.GetSummary()))


@documented(filters.vtkFlattenRegion)
def region(surface: Surface, *, progress: Progress = None, abort: Abort = None, **settings: Any) -> Region:
    """Flattens one region of a surface, with a margin, and measures it: label=3 and label_array="Regions", for instance.

    Returns a Region: mesh, the map of the region and its margin; table, a list of a dict for each measure, with its
    value, standard deviation, value on the map and unit; and curves, the diameters and the outline as lines on the map.
    progress, abort: see flatten().
    """
    filter = _made("region", filters.vtkFlattenRegion, as_polydata(surface), settings)
    mesh = like(surface, run(filter, progress, abort))
    return Region(mesh, _rows(filter.GetMeasures()), like(surface, filter.GetCurves()))


@documented(*(filter_class for _, filter_class, _ in STEPS))
def flatten(
    surface: Surface,
    faces: Optional[numpy.ndarray] = None,
    *,
    progress: Progress = None,
    abort: Abort = None,
    to_disk: Optional[Dict[str, Any]] = None,
    conformal: Optional[Dict[str, Any]] = None,
    area_preserving: Optional[Dict[str, Any]] = None,
    distortion: Optional[Dict[str, Any]] = None,
    **settings: Any,
) -> Any:
    """Flattens a surface to a disk on which every triangle has the area that it has on the surface.

    surface: a vtkPolyData, a PyVista PolyData, or an array of points (n x 3); then faces is an array of the numbers of
    three points each (m x 3).
    progress: is called with the share of the work that is done, from 0 to 1, and with what is being done.
    abort: is called as often; the work stops if it returns True, and Cancelled is raised.
    to_disk, conformal, area_preserving, distortion: settings of one of the four filters, as a dict. Needed for those
    that two filters have: conformal={"boundary_point": (0, 0, 1)}.
    All other settings by keyword: cut_mode="Seam", or CutMode="Seam". A point, plane, label or array that is given is
    used: its text below says which switch or mode that sets. With use_hole_point=False beside it, hole_point is not
    used, and so for all switches; another mode than the one that it needs is an error.

    Returns the map as vtkPolyData, or PyVista's PolyData if the surface was one, with z = 0. Its points have the
    arrays of the surface and SurfacePoints, where they are on it; its faces AreaDistortion, AngleDistortion and more;
    its field data means, such as FacesWithin2Percent, and what was repaired. docs/reference.md lists them.
    Raises FlatteningError with the message of the filter that failed, which says what to do, and SettingError, which is
    one too, if a setting cannot have its value.
    """
    mesh = as_polydata(surface, faces)
    steps = {"to_disk": to_disk, "conformal": conformal, "area_preserving": area_preserving, "distortion": distortion}
    shares = _settings_of_steps(steps, settings)
    done = 0.0
    for step, filter_class, share in STEPS:
        filter = _made(f"flatten, {step}", filter_class, mesh, shares[step])
        reported = _part_of(progress, done, share)
        mesh = run(filter, reported, abort)
        done += share
    return like(surface, mesh)


def _part_of(progress: Progress, done: float, share: float) -> Progress:
    return progress and (lambda fraction, stage: progress(done + share * fraction, stage))


def _settings_of_steps(steps: Dict[str, Any], settings: Dict[str, Any]) -> Dict[str, Dict[str, Any]]:
    """The settings of each step: those given for it, and those that it alone has."""
    shares = {step: dict(given or {}) for step, given in steps.items()}
    classes = tuple(filter_class for _, filter_class, _ in STEPS)
    for keyword, value in settings.items():
        having = {step: name for step, c, _ in STEPS if (name := setting_named(c, keyword))}
        if not having:
            raise unknown_setting("flatten", keyword, classes)
        if shared_settings(classes).intersection(having.values()):
            first = next(iter(having))
            raise TypeError(
                f"flatten() has {keyword} for {' and '.join(having)}: say which, {first}={{{keyword!r}: {value!r}}}"
            )
        for step in having:
            shares[step].setdefault(keyword, value)
    return shares


def _rows(table: Any) -> List[Dict[str, Any]]:
    columns = {table.GetColumnName(c): table.GetColumn(c) for c in range(table.GetNumberOfColumns())}
    return [{name: column.GetValue(row) for name, column in columns.items()} for row in range(table.GetNumberOfRows())]
