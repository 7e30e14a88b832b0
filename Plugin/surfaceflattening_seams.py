# SPDX-License-Identifier: GPL-3.0-or-later
"""The seams of a surface or a flat map, in colours that are the same on both banks.

    from surfaceflattening_seams import show_seams

    show_seams(flat)

The module comes with the plugin. The command "Show Seams" calls it for the source that is selected in the pipeline
browser; Flatten and Compare shows them in its views.
"""

from paraview import simple
from surfaceflattening_present import unused

SEAM_DISTANCE = "SeamDistance"
# Red, yellow, green, cyan, blue, magenta.
HUES = ((1, 0, 0), (1, 1, 0), (0, 0.8, 0), (0, 1, 1), (0.1, 0.2, 1), (1, 0, 1))
CUTS_PORT = 1  # of Surface To Disk


def show_seams(source=None, view=None):
    """Shows the seams of @source, by default the active source, in @view, by default the active one. Returns the
    Feature Edges that are drawn.

    @raise ValueError if there is no source, or it has no seams.
    """
    source = source or simple.GetActiveSource()
    if source is None:
        raise ValueError("no source is selected: click a Surface To Disk or a flat map in the pipeline browser first")
    source.UpdatePipeline()
    if not has_seams(source):
        raise ValueError(
            "the selected source has no seams: select a Surface To Disk that was cut along a seam, or a flat map of it"
        )
    view = view or simple.GetActiveViewOrCreate("RenderView")
    if source.GetXMLName() == "SurfaceToDisk":
        simple.Hide(simple.OutputPort(source, CUTS_PORT), view)  # which lies in the same place
    _hide_without_surface(view)
    border = show_banks(source, view)
    simple.SetActiveSource(source)
    simple.Render(view)
    return border


def _hide_without_surface(view):
    """Hides the seams of surfaces that are hidden, as one is when a filter of it is shown in its place."""
    shown = [d for d in view.Representations if getattr(d, "Visibility", 0) and hasattr(d, "Input")]
    for display in shown:
        if display.Input.SMProxy.GetXMLName() == "FeatureEdges" and SEAM_DISTANCE in display.ColorArrayName:
            if not any(other.Input == display.Input.Input for other in shown):
                display.Visibility = 0


def has_seams(source):
    return SEAM_DISTANCE in source.PointData.keys() and source.PointData[SEAM_DISTANCE].GetRange()[1] > 0.0


def show_banks(source, view):
    """Draws the seams in colours by the distance along them, which is the same on both banks: where the colours agree,
    the map was one piece on the surface."""
    border = simple.FeatureEdges(
        registrationName=unused("Banks of the seams"),
        Input=source,
        BoundaryEdges=1,
        FeatureEdges=0,
        NonManifoldEdges=0,
        ManifoldEdges=0,
        Coloring=0,
    )
    display = simple.Show(border, view)
    simple.ColorBy(display, ("POINTS", SEAM_DISTANCE))
    length = source.PointData[SEAM_DISTANCE].GetRange()[1]
    colours = simple.GetColorTransferFunction(SEAM_DISTANCE)
    colours.ColorSpace = "RGB"
    colours.RGBPoints = [value for k, hue in enumerate(HUES) for value in (length * k / (len(HUES) - 1), *hue)]
    display.SetScalarBarVisibility(view, False)
    display.Ambient, display.Diffuse, display.LineWidth = 1.0, 0.0, 3
    display.Pickable = 0  # so that the map below is selected
    return border
