# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of the maps that Flatten and Compare shows: their anatomy, or their distortion.

The module comes with the plugin.
"""

from paraview import simple

ANATOMY = ("POINTS", "ScaledCurvature")
DISTORTION = ("CELLS", "AreaDistortion")
DISTORTION_TITLE = "surface area against map area"


def switch_colours(view=None):
    """Shows the area distortion in place of the anatomy in all views of the layout of @view (by default the active
    one), or the other way round."""
    layout = simple.GetLayout(view) if view else simple.GetLayout()
    views = [v for v in simple.GetViewsInLayout(layout) if v.GetXMLName() == "RenderView"]
    shown = [(v, display) for v in views for display in v.Representations if _can_switch(display)]
    if not shown:
        raise ValueError("no measured map is shown here: run Flatten and Compare, or show a Distortion Metrics")
    wanted = ANATOMY if shown[0][1].ColorArrayName[1] == DISTORTION[1] else DISTORTION
    for v, display in shown:
        colour(display, wanted)
        simple.HideUnusedScalarBars(v)
    if wanted == DISTORTION:
        # The colour bar goes to the view that shows the fewest things beside the map.
        _show_distortion_bar(*min(shown, key=lambda pair: len(pair[0].Representations)))
    simple.RenderAllViews()


def _can_switch(display):
    if not (hasattr(display, "ColorArrayName") and display.Visibility and hasattr(display, "Input")):
        return False
    information = display.Input.GetDataInformation(0)
    return all(
        information.GetArrayInformation(name, association) is not None
        for association, name in ((0, ANATOMY[1]), (1, DISTORTION[1]))
    )


def colour(display, array):
    colours = simple.GetColorTransferFunction(array[1])
    points = list(colours.RGBPoints)
    simple.ColorBy(display, array)
    colours.RGBPoints = points  # ColorBy() has taken the range of the data


def _show_distortion_bar(view, display):
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(DISTORTION[1]), view)
    bar.Title = DISTORTION_TITLE
    bar.ComponentTitle = ""
    bar.DrawTickLabels = 0
    bar.AddRangeLabels = 0
    bar.Orientation = "Vertical"
    bar.WindowLocation = "Lower Right Corner"
    bar.TitleFontSize = bar.LabelFontSize = 12
