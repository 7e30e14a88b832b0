# SPDX-License-Identifier: GPL-3.0-or-later
"""From an image to an isosurface that can be flattened, by the filter Volume To Surface or step by step.

    from paraview.simple import *
    from surfaceflattening_volume import isosurface

    scan = OpenDataFile("ch2bet.nii.gz")
    brain = isosurface(scan, 40).surface
    disk = SurfaceToDisk(Input=brain)

The module comes with the plugin: once that is loaded, ParaView's Python Shell and pvpython can import it.
isosurface() takes all steps at once. Every step is also a function of its own, and a proxy with a name of its own in
the pipeline browser, where its settings can be changed afterwards. docs/volumes.md has the steps as clicks and what goes wrong without each.

The figures below are of ch2bet.nii.gz (181 x 217 x 181 voxels of 1 mm, bytes) at isovalue 40, smoothed by
1 mm: 36 closed surfaces with 15 handles. Utilities/measurements/volume_recipe.py prints them.
"""

import math
import warnings
from dataclasses import dataclass

from paraview import simple
from surfaceflattening_invesalius import metaimage_of_invesalius  # noqa: F401


@dataclass
class Isosurface:
    """What isosurface() and label_surface() return."""

    surface: object  # the proxy, a Volume To Surface


def cast_to_float(image):
    """The image in floating point.

    Without it: a smoothed image of integers is rounded to integers. The isosurface follows the plateaus, and
    where a plateau has the isovalue it touches itself: it is no manifold.
    """
    return _filter("ImageCast")(registrationName="Float", Input=image, OutputScalarType="float")


def pad(image, voxels=10, background=None):
    """The image with a margin of @voxels on every side, filled with @background: air, by default the
    lowest value in the image.

    Without it: a surface that reaches the border of the scan is open there. The skin of ch2.nii.gz, a head
    cut off at the neck, has 13 boundaries at isovalue 30.
    """
    if voxels < 1:
        raise ValueError(f"the margin is {voxels} voxels: 1 at least closes the surface")
    extent = _information(image).GetExtent()
    if background is None:
        background = _value_range(image)[0]
    return _filter("ImagePad")(
        registrationName="Padded",
        Input=image,
        OutputWholeExtent=[e + m for e, m in zip(extent, (-voxels, voxels) * 3)],
        Constant=background,
    )


def smooth(image, standard_deviation=1.0):
    """The image convolved with a Gaussian of @standard_deviation in mm, whatever the voxels' shape.

    Without it: noise makes handles and fragments, 103 and 266. With 2 mm: 0 and 5. Smoothing by voxels
    instead of mm would smooth thick slices more than thin ones.
    """
    if not (standard_deviation > 0 and math.isfinite(standard_deviation)):
        raise ValueError(f"the standard deviation is {standard_deviation}: a length above 0, in mm")
    spacing = _spacing(image)
    return _filter("ImageGaussianSmooth")(
        registrationName=f"Smoothed, {standard_deviation:g} mm",
        Input=image,
        StandardDeviations=[standard_deviation / s for s in spacing],
        RadiusFactors=[3, 3, 3],
    )


def contour(image, isovalue, name="Isosurface"):
    """The surface at @isovalue.

    Raises ValueError if no voxel is on one of its sides.
    """
    _require_between(isovalue, *_value_range(image))
    return simple.Contour(
        registrationName=name,
        Input=image,
        ContourBy=["POINTS", _scalars(image).GetName()],
        Isosurfaces=[isovalue],
    )


def in_patient_space(surface, name="Patient space"):
    """The @surface of a scan where it lies in the patient: x is right, y is front, z is top, in mm (RAS+). The
    surface itself if it is there already, if its file has no orientation, or if it is a flat map."""
    points = _information(surface).GetPointDataInformation()
    if (
        not _field(surface, "PatientMatrix")
        or _field(surface, "InPatientSpace")
        or points.GetArrayInformation("SurfacePoints")
    ):
        return surface
    return _filter("PatientSpace")(registrationName=name, Input=surface)


def isosurface(
    image,
    isovalue=None,
    smoothing_mm=1.0,
    padding=10,
    background=None,
    name="Isosurface",
    patient_space=True,
    component="All",
):
    """The whole recipe by one filter, Volume To Surface: cast to float, pad, smooth, contour, move to patient space.
    Returns an Isosurface.

    @image: a proxy of an image, as OpenDataFile returns it, in mm.
    @isovalue: in the image's units; for CT, bone is above 200 to 400 HU. None: the one that the histogram suggests.
    @smoothing_mm: standard deviation in mm; 0: none; None: two voxels. An image of integers that is not smoothed has
        voxels at an isovalue that is an integer, and a surface that touches itself there. The isovalue is then
        moved down to halfway between two integers: voxels of that value are inside.
    @padding: voxels added on every side; 0: none.
    @background: the value of what is added; by default the lowest in the image.
    @patient_space: moves the surface to where it lies in the patient, if the image came from a reader of this
        plugin and its file has an orientation. Otherwise it stays in the coordinates of the voxels.
    @component: "All", or "Largest".

    The surface may have several components, handles and boundaries: Surface To Disk takes it from there
    and keeps the largest component. Errors raise ValueError, as pvpython itself does not.
    """
    _require_scalar_image(image)
    if isovalue is not None:
        _require_between(isovalue, *_value_range(image))
    if patient_space and hasattr(image, "FileName") and not _field(image, "PatientMatrix"):
        warnings.warn(
            "The reader of the scan does not say where it lies in the patient, so that left and right are as the "
            "voxels are stored: in Python open the file by surfaceflattening_scans.open_scan(path), in the window by "
            "File > Open and Scan Reader, which tell what it has.",
            stacklevel=2,
        )
    surface = _filter("VolumeToSurface")(
        registrationName=name,
        Input=image,
        Margin=padding,
        PatientSpace=int(patient_space),
        Component=component,
    )
    for setting, value in (("Isovalue", isovalue), ("Smoothing", smoothing_mm), ("Air", background)):
        setattr(surface, f"Automatic{setting}", int(value is None))
        if value is not None:
            setattr(surface, setting, value)
    surface.UpdatePipeline()
    if surface.GetDataInformation(0).GetNumberOfCells() == 0:
        raise ValueError("Volume To Surface has no output: its message says why")
    return Isosurface(surface)


def label_surface(atlas, labels, smoothing_mm=1.0, name="Structure", patient_space=True):
    """The surface of a structure in a volume of labels, such as the thalamus in an atlas. Returns an Isosurface.

    @labels: of the structure, one or several. @smoothing_mm: as of isosurface(); without smoothing the surface has
    the steps of the voxels, and more than the thickness of the structure makes it vanish.
    """
    labels = [labels] if isinstance(labels, int) else list(labels)
    _require_scalar_image(atlas)
    array = _scalars(atlas).GetName()
    product = "*".join(f'abs("{array}"-({label}))' for label in labels)
    inside = simple.Calculator(
        registrationName=f"{name}, voxels", Input=atlas, ResultArrayName=array, Function=f"1-min(1,{product})"
    )
    if _value_range(inside)[1] < 1:
        raise ValueError(f"no voxel has the label {', '.join(map(str, labels))}: look at the atlas's list of labels")
    return isosurface(inside, 0.5, smoothing_mm, name=name, patient_space=patient_space)


def _filter(name):
    # LoadPlugin(path, ns=globals()) tells the caller of the plugin's filters, but not paraview.simple.
    if not hasattr(simple, name) and hasattr(simple, "_add_functions"):
        simple._add_functions(vars(simple))
    creator = getattr(simple, name, None)
    if creator is None:
        raise RuntimeError(
            f"ParaView has no {name}: load the plugin SurfaceFlattening first, by LoadPlugin(path) in a "
            "script or by PV_PLUGIN_PATH"
        )
    return creator


def _field(proxy, name):
    return _information(proxy).GetFieldDataInformation().GetArrayInformation(name)


def _information(image):
    image.UpdatePipeline()
    return image.GetDataInformation()


def _spacing(image):
    information = _information(image)
    bounds, extent = information.GetBounds(), information.GetExtent()
    return [
        (bounds[2 * k + 1] - bounds[2 * k]) / max(extent[2 * k + 1] - extent[2 * k], 1) for k in range(3)
    ]


def _scalars(image):
    """Name, number of components and range of the array that image filters work on; None without one."""
    return _information(image).GetPointDataInformation().GetAttributeInformation(0)


def _value_range(image):
    return _scalars(image).GetComponentRange(0)


def _require_between(isovalue, low, high):
    if not low < isovalue < high:
        raise ValueError(
            f"the isovalue {isovalue:g} is not between the least and greatest value of the image, "
            f"{low:g} and {high:g}: look at its histogram, and smooth less if that removed the tissue"
        )


def _require_scalar_image(image):
    information = _information(image)
    if information.GetDataSetTypeAsString() not in ("vtkImageData", "vtkUniformGrid"):
        raise ValueError(
            f"this is {information.GetDataSetTypeAsString() or 'nothing'}, not an image: "
            "check that the file could be read"
        )
    scalars = _scalars(image)
    if scalars is None:
        raise ValueError("the image has no values: check that the file could be read")
    if scalars.GetNumberOfComponents() != 1:
        raise ValueError(
            f"a voxel has {scalars.GetNumberOfComponents()} values: choose one with Calculator, e.g. the "
            "magnitude"
        )
    extent = information.GetExtent()
    if min(extent[2 * k + 1] - extent[2 * k] for k in range(3)) < 1:
        raise ValueError(f"the image is flat, its extent is {extent}: open the whole series")
