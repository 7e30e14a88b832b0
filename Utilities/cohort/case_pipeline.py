# SPDX-License-Identifier: GPL-3.0-or-later
"""One case from its file to a measured flat map, by the filters that ParaView's menus have."""

import resource
from dataclasses import dataclass, field

from case_files import CaseError, Messages, is_volume, read

try:
    from surfaceflattening import (
        vtkConformalDiskFilter,
        vtkDistortionMetrics,
        vtkOMTAreaPreservingFilter,
        vtkSurfaceToDiskFilter,
        vtkVolumeToSurface,
    )
except ImportError as error:
    raise SystemExit(
        f"{error}: set PYTHONPATH to the folder with the package surfaceflattening, "
        "such as build/lib/python3/dist-packages"
    ) from None

CUTS = {"automatic": 5, "hole": 0, "seam": 1, "plane": 2, "relief": 3}  # values of CutMode
HANDLES = ("remove", "cut", "error")
READING = "the reader"
CONTOUR = "the contour of the volume"
STAGES = {
    vtkSurfaceToDiskFilter: "Surface To Disk",
    vtkConformalDiskFilter: "Conformal Disk",
    vtkOMTAreaPreservingFilter: "OMT Area Preserving",
    vtkDistortionMetrics: "Distortion Metrics",
    vtkVolumeToSurface: "Volume To Surface",
}

# Field data of the flat map that the summary has, in this order.
FIGURES = (
    "Genus",
    "RemovedHandles",
    "SelfIntersections",
    "SurfaceArea",
    "FlatArea",
    "MaxCellAreaError",
    "FacesWithin2Percent",
    "AreaWeightedMeanAreaError",
    "AreaWeightedMeanAngleError",
    "FlippedFaces",
    "Bijective",
)


@dataclass
class CaseResult:
    """The flat map, with its row of the summary and what it cost."""

    flat: object
    figures: dict
    costs: dict
    warnings: list = field(default_factory=list)


def run(algorithm, warnings, announce):
    """Executes a filter; returns its output. Raises CaseError with the filter's own message."""
    announce(STAGES[type(algorithm)])
    with Messages(algorithm) as messages:
        algorithm.Update()
    warnings += messages.warnings
    if messages.errors:
        raise CaseError(messages.errors[0])
    data = algorithm.GetOutput()
    if data.GetNumberOfPoints() == 0:
        raise CaseError(f"{algorithm.GetClassName()} has no output")
    return data


def isosurface(image, isovalue, smoothing):
    """Volume To Surface at an isovalue, smoothed by @smoothing mm, with all components."""
    surface = vtkVolumeToSurface()
    surface.SetInputData(image)
    surface.AutomaticIsovalueOff()
    surface.SetIsovalue(isovalue)
    surface.AutomaticSmoothingOff()
    surface.SetSmoothing(smoothing)
    surface.SetComponentModeToAll()
    return run(surface, [], lambda stage: None)


def flatten(path, settings, announce=lambda stage: None):
    """Takes one file to its CaseResult. Raises CaseError.

    @settings: isovalue, smoothing, cut, plane_normal, plane_origin, hole_area, handles, remesh, edge_length,
    free_outline.
    @announce: is told of each stage that begins, by its name.
    """
    announce(READING)
    warnings = []
    return flatten_data(read(path, warnings), is_volume(path), settings, announce, warnings)


def flatten_data(data, volume, settings, announce, warnings):
    """As flatten(), for what a file holds. @warnings: that there are so far."""
    if volume:
        if settings["isovalue"] is None:
            raise CaseError("it is a volume: give --isovalue")
        announce(CONTOUR)
        data = isosurface(data, settings["isovalue"], settings["smoothing"])
    disk = vtkSurfaceToDiskFilter()
    disk.SetInputData(data)
    disk.SetCutMode(CUTS[settings["cut"]])
    disk.SetHandleMode(HANDLES.index(settings["handles"]))
    disk.SetHoleAreaFraction(settings["hole_area"])
    disk.SetPlaneNormal(settings["plane_normal"])
    disk.SetPlaneOrigin(settings["plane_origin"] or data.GetCenter())
    disk.SetFreeOutline(settings["free_outline"])
    disk.SetRemesh(settings["remesh"])
    disk.SetTargetEdgeLength(settings["edge_length"])
    run(disk, warnings, announce)
    conformal = vtkConformalDiskFilter()
    conformal.SetInputData(disk.GetOutput())
    run(conformal, warnings, announce)
    area_preserving = vtkOMTAreaPreservingFilter()
    area_preserving.SetInputData(conformal.GetOutput())
    area_preserving.SetFreeOutline(settings["free_outline"])
    run(area_preserving, warnings, announce)
    metrics = vtkDistortionMetrics()
    metrics.SetInputData(area_preserving.GetOutput())
    flat = run(metrics, warnings, announce)
    return CaseResult(flat, figures_of(flat), costs_of_process(), warnings)


def figures_of(flat):
    figures = {"Points": flat.GetNumberOfPoints(), "Faces": flat.GetNumberOfCells()}
    for name in FIGURES:
        array = flat.GetFieldData().GetArray(name)
        figures[name] = array.GetTuple1(0) if array and array.GetNumberOfTuples() == 1 else None
    return figures


def costs_of_process():
    """Of the process of the case, since it began."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return {
        "ProcessorSeconds": round(usage.ru_utime + usage.ru_stime, 2),
        "PeakMemoryMB": round(usage.ru_maxrss / 1024),
    }
