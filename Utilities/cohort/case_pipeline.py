# SPDX-License-Identifier: GPL-3.0-or-later
"""One case from its file to a measured flat map, by the filters that ParaView's menus have."""

import math
import resource
from dataclasses import dataclass, field

from case_files import CaseError, Messages, is_volume, read
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkImagingCore import vtkImageCast, vtkImageConstantPad
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth

try:
    from surfaceflattening import (
        vtkConformalDiskFilter,
        vtkDistortionMetrics,
        vtkOMTAreaPreservingFilter,
        vtkPatientSpace,
        vtkSurfaceToDiskFilter,
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
}
MARGIN = 10  # voxels around a volume

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
    """The steps of docs/volumes.md: cast, pad, smooth by @smoothing mm, contour, move to patient space."""
    scalars = image.GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfComponents() != 1:
        raise CaseError("the volume has no single value per voxel")
    if not all(math.isfinite(size) and size > 0 for size in image.GetSpacing()):
        raise CaseError(f"the voxels have the sizes {', '.join(f'{size:g}' for size in image.GetSpacing())}")
    low, high = scalars.GetRange()
    cast = vtkImageCast()
    cast.SetInputData(image)
    cast.SetOutputScalarTypeToFloat()
    pad = vtkImageConstantPad()
    pad.SetInputConnection(cast.GetOutputPort())
    pad.SetOutputWholeExtent(
        [e + m for e, m in zip(image.GetExtent(), (-MARGIN, MARGIN) * 3)]
    )
    pad.SetConstant(low)
    last = pad
    if smoothing > 0:
        last = vtkImageGaussianSmooth()
        last.SetInputConnection(pad.GetOutputPort())
        last.SetStandardDeviations([smoothing / s for s in image.GetSpacing()])
        last.SetRadiusFactors(3, 3, 3)
    last.Update()
    low, high = last.GetOutput().GetScalarRange()
    if not low < isovalue < high:
        raise CaseError(
            f"the isovalue {isovalue:g} is not between the least and greatest value, {low:g} and {high:g}"
        )
    contour = vtkContourFilter()
    contour.SetInputConnection(last.GetOutputPort())
    contour.SetValue(0, isovalue)
    contour.ComputeNormalsOff()
    contour.Update()
    if contour.GetOutput().GetFieldData().HasArray("PatientMatrix") == 0:
        return contour.GetOutput()
    placed = vtkPatientSpace()
    placed.SetInputConnection(contour.GetOutputPort())
    placed.Update()
    return placed.GetOutput()


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
