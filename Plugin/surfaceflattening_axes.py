# SPDX-License-Identifier: GPL-3.0-or-later
"""Letters in the view that say where the patient's right, left, front, back, top and bottom are."""

import numpy as np
from paraview import servermanager, simple
from surfaceflattening_volume import _field

SIDES = {"R": (1, 0, 0), "L": (-1, 0, 0), "A": (0, 1, 0), "P": (0, -1, 0), "S": (0, 0, 1), "I": (0, 0, -1)}

# Free space between the data and a letter, in shares of the data's diagonal: a letter is half of it high.
GAP = 0.06


def patient_axes(source=None, view=None):
    """Shows R, L, A, P, S and I around a surface or scan, at the sides where they are. Returns the six texts.

    @source: by default the active source. It must say where it lies in the patient: a scan of this plugin's readers,
    or what was made of it, but no flat map. Raises ValueError otherwise.
    """
    source = source or simple.GetActiveSource()
    if source is None:
        raise ValueError("select a scan, or a surface of one, in the pipeline browser")
    view = view or simple.GetActiveViewOrCreate("RenderView")
    directions = _directions(source)
    bounds = np.array(source.GetDataInformation().GetBounds()).reshape(3, 2)
    centre, half = bounds.mean(axis=1), np.diff(bounds, axis=1).ravel() / 2
    texts = []
    for letter, side in SIDES.items():
        direction = directions @ side
        # Where the ray from the centre leaves the box.
        with np.errstate(divide="ignore"):
            reach = np.min(half / np.abs(direction))
        place = centre + direction * (reach + GAP * 2 * np.linalg.norm(half))
        text = simple.Text(registrationName=letter, Text=letter)
        display = simple.Show(text, view, "TextSourceRepresentation")
        display.TextPropMode = "Billboard 3D Text"
        display.BillboardPosition = place.tolist()
        display.FontSize = 24
        display.Bold = 1
        texts.append(text)
    simple.SetActiveSource(source)
    view.StillRender()
    return texts


def _directions(source):
    """The patient's right, front and top in the coordinates of the data, as the columns of a matrix."""
    information = source.GetDataInformation()
    if information.GetPointDataInformation().GetArrayInformation("SurfacePoints"):
        raise ValueError("a flat map has no sides of the patient: select the surface that it came from")
    if _field(source, "InPatientSpace"):
        return np.eye(3)
    if not _field(source, "PatientMatrix"):
        raise ValueError(
            "this does not say where it lies in the patient: open the scan with a reader of Surface Flattening, "
            "and look whether its file has an orientation"
        )
    data = servermanager.Fetch(source)
    matrix = np.reshape(data.GetFieldData().GetArray("PatientMatrix").GetTuple(0), (4, 4))[:3, :3]
    directions = np.linalg.inv(matrix)
    return directions / np.linalg.norm(directions, axis=0)
