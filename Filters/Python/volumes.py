# SPDX-License-Identifier: GPL-3.0-or-later
"""From a scan to a surface, with VTK alone. Plugin/surfaceflattening_volume.py has the same steps in ParaView."""

from __future__ import annotations

import math
import sys
from typing import Any, Optional

from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkImagingCore import vtkImageCast, vtkImageConstantPad
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth

from .SurfaceFlatteningFilters import vtkPatientSpace
from .running import Abort, Progress, run


def read_scan(path: str, volume: int = 0, warn: Any = print) -> Any:
    """The volume in a file, with the values of its header and its place in the patient, as vtkImageData.

    path: NIfTI, MetaImage, NRRD, .mgz of FreeSurfer (which needs nibabel), an InVesalius project, or a DICOM series by
        one of its files or its folder (which needs pydicom).
    volume: of a file with several. warn: is told what is odd about the file, a sentence each.
    isosurface() puts its surface where the patient is: x is right, y is front, z is top, in mm.
    Raises ValueError if the file cannot be read.
    """
    import surfaceflattening_scans

    return surfaceflattening_scans.read_scan(path, volume=volume, warn=warn)


def isosurface(
    image: Any,
    isovalue: float,
    smoothing_mm: float = 1.0,
    padding: int = 10,
    background: Optional[float] = None,
    patient_space: bool = True,
    *,
    progress: Progress = None,
    abort: Abort = None,
) -> Any:
    """The surface of a scan at an isovalue: the image in floating point, with a margin, smoothed, contoured.

    image: a vtkImageData, or PyVista's ImageData, with one value for each voxel; its spacing is in mm.
    isovalue: in the units of the image.
    smoothing_mm: standard deviation of the Gaussian, in mm; 0 smooths nothing. The surface of integers that are not
        smoothed would touch itself at an isovalue that is an integer, which is then moved down by a half.
    padding: voxels that are added on every side, so that the surface is closed; 0 adds none.
    background: the value of what is added; the lowest of the image if it is not given.
    patient_space: moves the surface of a scan of read_scan() to where the patient is; False leaves it in its voxels.
    progress, abort: see flatten().
    Returns a vtkPolyData, or a PyVista PolyData if the image was of PyVista, in mm, in patient space or otherwise in
    the coordinates of the image.
    Raises ValueError if the isovalue is not between the image's values.
    """
    _require_scalar_image(image)
    scalars = image.GetPointData().GetScalars()
    low, high = scalars.GetRange()
    if not low < isovalue < high:
        raise ValueError(f"the isovalue {isovalue:g} is not between the least and greatest value, {low:g} and {high:g}")
    if padding < 0 or not (smoothing_mm >= 0 and math.isfinite(smoothing_mm)):
        raise ValueError(f"smoothing_mm is {smoothing_mm} and padding {padding}: both must be 0 or more")
    if not smoothing_mm and scalars.GetDataTypeAsString() not in ("float", "double"):
        isovalue = math.ceil(isovalue) - 0.5

    floating = vtkImageCast()
    floating.SetInputData(image)
    floating.SetOutputScalarTypeToFloat()
    last = floating
    if padding:
        last = vtkImageConstantPad()
        last.SetInputConnection(floating.GetOutputPort())
        extent = image.GetExtent()
        last.SetOutputWholeExtent(*(e + m for e, m in zip(extent, (-padding, padding) * 3)))
        last.SetConstant(low if background is None else background)
    if smoothing_mm:
        smooth = vtkImageGaussianSmooth()
        smooth.SetInputConnection(last.GetOutputPort())
        smooth.SetStandardDeviations(*(smoothing_mm / s for s in image.GetSpacing()))
        smooth.SetRadiusFactors(3, 3, 3)
        last = smooth
    contour = vtkContourFilter()
    contour.SetInputConnection(last.GetOutputPort())
    contour.SetValue(0, isovalue)
    result = run(contour, progress, abort)
    if patient_space and image.GetFieldData().GetArray("PatientMatrix"):
        to_patient = vtkPatientSpace()
        to_patient.SetInputData(result)
        result = run(to_patient, progress, abort)
    pyvista = sys.modules.get("pyvista")
    return pyvista.wrap(result) if pyvista and isinstance(image, pyvista.DataSet) else result


def _require_scalar_image(image: Any) -> None:
    if not (hasattr(image, "IsA") and image.IsA("vtkImageData")):
        raise TypeError(f"this is a {type(image).__name__}, not an image: give a vtkImageData or a PyVista ImageData")
    scalars = image.GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfComponents() != 1:
        raise ValueError("the image must have active scalars, one value for each voxel")
    if min(image.GetDimensions()) < 2:
        raise ValueError(f"the image is flat, {image.GetDimensions()} voxels: give the whole volume")
