# SPDX-License-Identifier: GPL-3.0-or-later
"""From a scan to a surface."""

from __future__ import annotations

import sys
from typing import Any, Optional

from .errors import FlatteningError, SettingError
from .running import Abort, Progress, run
from .settings import set_number
from .SurfaceFlatteningFilters import vtkVolumeToSurface


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
    isovalue: Optional[float] = None,
    smoothing_mm: Optional[float] = 1.0,
    padding: int = 10,
    background: Optional[float] = None,
    patient_space: bool = True,
    *,
    component: str = "All",
    progress: Progress = None,
    abort: Abort = None,
) -> Any:
    """The surface of a scan at an isovalue, by vtkVolumeToSurface: the image in floating point, with a margin, smoothed,
    contoured, and carried to patient space if the image has the field array PatientMatrix.

    image: a vtkImageData, or PyVista's ImageData, with one value for each voxel; its spacing is in mm.
    isovalue: in the units of the image; if it is not given, the one that the histogram suggests (Otsu).
    smoothing_mm: standard deviation of the Gaussian, in mm; 0 smooths nothing, None smooths by two voxels. The surface
        of integers that are not smoothed would touch itself at an isovalue that is an integer, which is then moved down
        by a half.
    padding: voxels that are added on every side, so that the surface is closed; 0 adds none.
    background: the value of what is added; the lowest of the image if it is not given.
    patient_space: moves the surface of a scan of read_scan() to where the patient is; False leaves it in its voxels.
    component: "All", or "Largest".
    progress, abort: see flatten().
    Returns a vtkPolyData, or a PyVista PolyData if the image was of PyVista, in mm, in patient space or otherwise in
    the coordinates of the image. Its field data have the isovalue (Isovalue) and what it makes of the voxels.
    Raises FlatteningError with the filter's message if there is no such surface, and for an image without voxels.
    """
    if not (hasattr(image, "IsA") and image.IsA("vtkImageData")):
        raise TypeError(f"this is a {type(image).__name__}, not an image: give a vtkImageData or a PyVista ImageData")
    modes = {"all": vtkVolumeToSurface.AllComponents, "largest": vtkVolumeToSurface.LargestComponent}
    if component.lower() not in modes:
        raise SettingError(f"component is {component!r}: it must be All or Largest")
    if image.GetNumberOfPoints() == 0:
        raise FlatteningError("the image has no voxels: check that its file could be read")
    surface = vtkVolumeToSurface()
    surface.SetInputData(image)
    surface.SetComponentMode(modes[component.lower()])
    set_number(surface, "Margin", padding, "padding")
    set_number(surface, "PatientSpace", patient_space)
    for name, keyword, value in (
        ("Isovalue", "isovalue", isovalue),
        ("Smoothing", "smoothing_mm", smoothing_mm),
        ("Air", "background", background),
    ):
        getattr(surface, f"SetAutomatic{name}")(value is None)
        if value is not None:
            set_number(surface, name, value, keyword)
    result = run(surface, progress, abort)
    pyvista = sys.modules.get("pyvista")
    return pyvista.wrap(result) if pyvista and isinstance(image, pyvista.DataSet) else result
