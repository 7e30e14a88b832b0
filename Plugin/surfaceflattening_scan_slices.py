# SPDX-License-Identifier: GPL-3.0-or-later
"""Three slices of a scan where the patient is, in the view of its surfaces.

    from surfaceflattening_scan_slices import show_scan_slices

    slices = show_scan_slices(scan)  # or a surface that was made of a scan

The command "Show Scan Slices" calls it for the source that is selected in the pipeline browser.
"""

from paraview import simple
from surfaceflattening_volume import _field, _filter

IMAGES = ("vtkImageData", "vtkUniformGrid")

# The planes of anatomy by the axis that is normal to each.
PLANES = {"Sagittal": (1, 0, 0), "Coronal": (0, 1, 0), "Axial": (0, 0, 1)}


def show_scan_slices(source=None, view=None):
    """Shows a sagittal, a coronal and an axial slice of a scan in patient space, in grey. Returns the three sources, stock
    slices, whose planes can be moved.

    @source: a scan, or a surface that was made of one; by default the active source. The slices meet in the middle of it.
    Raises ValueError.
    """
    source = source or simple.GetActiveSource()
    images = _images_of(source)
    view = view or simple.GetActiveViewOrCreate("RenderView")
    volume = _in_patient_space(images[-1])
    middle = source if _field(source, "InPatientSpace") else volume
    bounds = middle.GetDataInformation().GetBounds()
    for image in images:  # which the view has at their rows and columns
        if not _field(image, "InPatientSpace"):
            simple.Hide(image, view)
    slices = []
    for name, normal in PLANES.items():
        item = simple.Slice(registrationName=f"{name} slice", Input=volume, SliceType="Plane")
        item.SliceType.Origin = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
        item.SliceType.Normal = normal
        item.Triangulatetheslice = 0
        _show_in_grey(item, volume, view)
        slices.append(item)
    if source in images:
        simple.ResetCamera(view)
        source = volume  # what is shown now, so that Show Patient Axes puts its letters around it
    simple.SetActiveSource(source)
    view.StillRender()
    return slices


def _images_of(source):
    """The images with a place in the patient on the way to the source, which may be one, and last the first of them: the
    scan itself."""
    if source is None:
        raise ValueError("select a scan, or a surface that was made of one, in the pipeline browser")
    found, item = [], source
    while hasattr(item, "UpdatePipeline"):
        item.UpdatePipeline()
        is_image = item.GetDataInformation().GetDataSetTypeAsString() in IMAGES
        if is_image and (_field(item, "PatientMatrix") or _field(item, "InPatientSpace")):
            found.append(item)
        item = getattr(item, "Input", None)
    if not found:
        raise ValueError(
            "there is no scan before this that says where it lies in the patient: open the scan with a reader of Surface "
            "Flattening, and look whether its file has an orientation"
        )
    return found


def _in_patient_space(scan):
    if _field(scan, "InPatientSpace"):
        return scan
    for other in simple.GetSources().values():
        if other.GetXMLName() == "ScanInPatientSpace" and other.Input == scan:
            return other
    volume = _filter("ScanInPatientSpace")(registrationName="Scan in patient space", Input=scan)
    volume.UpdatePipeline()
    if volume.GetDataInformation().GetNumberOfPoints() == 0:
        raise ValueError("the scan cannot be shown where the patient is: its message in the output window says why")
    return volume


def _show_in_grey(item, volume, view):
    display = simple.Show(item, view)
    values = volume.GetDataInformation().GetPointDataInformation().GetAttributeInformation(0)
    # A map of its own: an atlas often has an array of the same name.
    simple.ColorBy(display, ("POINTS", values.GetName()), separate=True)
    colours = simple.GetColorTransferFunction(values.GetName(), display, separate=True)
    colours.ApplyPreset("Grayscale", True)
    colours.RescaleTransferFunction(*values.GetComponentRange(0))
    display.SetScalarBarVisibility(view, False)
    # As bright from every side.
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
