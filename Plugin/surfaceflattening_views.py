# SPDX-License-Identifier: GPL-3.0-or-later
"""The views of Flatten and Compare.

    surface, with its folds     | conformal disk              | area-preserving disk, with a scale bar
    distortion of faces, table  | histograms: area, both maps | histograms: angle, both maps

The module comes with the plugin.
"""

import math

from paraview import simple
from surfaceflattening_colours import ANATOMY, colour
from surfaceflattening_outlines import label_array, label_outlines
from surfaceflattening_present import unused
from surfaceflattening_seams import has_seams, show_banks
from surfaceflattening_selection import percent, show_measures

MEASURES = (
    # cell array, title of the axis, range of the colours and the histogram, number of bars
    ("AreaDistortion", "area distortion (log of the area ratio)", (-1.5, 1.5), 60),
    ("AngleDistortion", "angle distortion (log of the axis ratio)", (0.0, 1.5), 30),
)
COLUMNS = ("Faces", "FacesWithin2Percent", "FlatArea", "MeanAngleError", "MeanAreaError", "Region", "SurfaceArea")
OUTLINE_COLOUR = (0.8, 0.1, 0.1)
MAP_COLOURS = {"conformal": (0.85, 0.45, 0.15), "area-preserving": (0.15, 0.45, 0.70)}


def split(layout, cell, fractions, direction):
    """Splits a cell of the layout; returns the indices of the parts, as wide as @fractions."""
    parts = []
    remaining = 1.0
    for fraction in fractions[:-1]:
        first = getattr(layout, f"Split{direction}")(cell, fraction / remaining)
        parts.append(first)
        cell = first + 1
        remaining -= fraction
    return [*parts, cell]


def measured_errors(metrics):
    """The two figures that tell maps apart, from Distortion Metrics' field data."""
    area, angle = (
        metrics.FieldData[f"AreaWeightedMean{measure}"].GetRange()[0]
        for measure in ("AreaError", "AngleError")
    )
    return f"mean error: area {percent(area)}, angle {angle:.0f}\N{DEGREE SIGN}"


def layout_of(morph, conformal, area_preserving):
    maps = {"conformal": conformal, "area-preserving": area_preserving}
    layout = simple.CreateLayout(unused("Flatten and Compare", "layouts"))
    columns = split(layout, 0, (1 / 3, 1 / 3, 1 / 3), "Horizontal")
    cells = [split(layout, column, (0.55, 0.45), "Vertical") for column in columns]
    # Charts first: once a render view has drawn text, VTK 9.2 draws a chart's new text with a ghost below.
    below = [_table_view(area_preserving), *(_histogram_view(maps, *m) for m in MEASURES)]
    for view, (_, cell) in zip(below, cells):
        layout.AssignView(cell, view)
    above = [_surface_view("Surface", morph)]
    above += [
        _disk_view(f"{name.capitalize()} map\n{measured_errors(flat)}", flat)
        for name, flat in maps.items()
    ]
    labels = label_array(area_preserving)
    for view, source, (cell, _) in zip(above, (morph, conformal, area_preserving), cells):
        if labels:
            _show_outlines(view, source, labels)
        if has_seams(source):
            show_banks(source, view)
        layout.AssignView(cell, view)
        simple.ResetCamera(view)
    _show_scale_bar(above[2], area_preserving)
    _show_selection(above[0], area_preserving)
    return layout


def _render_view(title, source):
    view = simple.CreateView("RenderView", registrationName=unused(title.splitlines()[0], "views"))
    view.OrientationAxesVisibility = 0
    _show_text(view, title, "Upper Center")
    display = simple.Show(source, view)
    colour(display, ANATOMY)
    display.SetScalarBarVisibility(view, False)
    return view, display


def _show_text(view, words, place):
    text = simple.Text(registrationName=unused(words.splitlines()[0]), Text=words)
    label = simple.Show(text, view)
    label.WindowLocation = place
    label.FontSize = 12
    return text, label


def _surface_view(title, morph):
    view, display = _render_view(title, morph)
    display.Specular = 0.0
    view.CameraParallelProjection = 1
    view.ResetActiveCameraToPositiveX()
    return view


def _disk_view(title, flat):
    view, display = _render_view(title, flat)
    display.Ambient = 1.0
    display.Diffuse = 0.0
    view.InteractionMode = "2D"
    view.CameraParallelProjection = 1
    view.ResetActiveCameraToNegativeZ()
    return view


def _solid(display, colour, width):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = list(colour)
    display.Ambient, display.Diffuse, display.LineWidth = 1.0, 0.0, width
    display.Pickable = 0  # so that the map below is selected


def _show_outlines(view, source, labels):
    outlines = label_outlines(source, *labels, unused(f"Outlines of {labels[1]}"))
    _solid(simple.Show(outlines, view), OUTLINE_COLOUR, 2)


def nice_length(longest):
    """The longest of 1, 2 or 5 times a power of ten that is not longer."""
    power = 10.0 ** math.floor(math.log10(longest))
    return max(factor * power for factor in (1.0, 2.0, 5.0) if factor * power <= longest)


def _show_scale_bar(view, flat):
    """A line below the map with its length in units of the surface, which are those of the map. Nothing tells ParaView
    the name of the unit."""
    low_x, high_x, low_y, high_y, *_ = flat.GetDataInformation().GetBounds()
    size = max(high_x - low_x, high_y - low_y)
    length = nice_length(0.3 * size)
    y = low_y - 0.05 * size
    bar = simple.Line(
        registrationName=unused("Scale bar"), Point1=[low_x, y, 0], Point2=[low_x + length, y, 0], Resolution=1
    )
    _solid(simple.Show(bar, view), (1.0, 1.0, 1.0), 4)
    simple.ResetCamera(view)
    _, label = _show_text(view, f"scale bar: {length:g} units of the surface", "Lower Center")
    label.FontSize = 10


def _show_selection(view, flat):
    text, label = _show_text(view, "Selection", "Lower Left Corner")
    label.FontSize = 10
    show_measures(flat, text, view)


def _histogram_view(maps, array, axis_title, value_range, bars):
    view = simple.CreateView("XYBarChartView", registrationName=unused(f"Histogram, {array}", "views"))
    for name, flat in maps.items():
        histogram = simple.Histogram(
            registrationName=unused(f"{array}, {name}"),
            Input=flat,
            SelectInputArray=["CELLS", array],
            BinCount=bars,
            UseCustomBinRanges=1,
            CustomBinRanges=list(value_range),
            Normalize=1,
        )
        display = simple.Show(histogram, view, "XYBarChartRepresentation")
        display.SeriesColor = ["bin_values", *map(str, MAP_COLOURS[name])]
        display.SeriesLabel = ["bin_values", name]
    view.LeftAxisTitle = "share of faces"
    view.BottomAxisTitle = axis_title
    view.LeftAxisTitleFontSize = view.BottomAxisTitleFontSize = 11  # the view is narrow
    view.BottomAxisUseCustomRange = 1
    view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = value_range
    # The outermost bars hold all that is beyond them.
    low, high = value_range
    ticks = [low + k * (high - low) / 6 for k in range(7)]
    names = [f"{tick:g}" for tick in ticks]
    names[-1] = f"\N{GREATER-THAN OR EQUAL TO} {high:g}"
    if low < 0.0:
        names[0] = f"\N{LESS-THAN OR EQUAL TO} {low:g}"
    view.BottomAxisUseCustomLabels = 1
    view.BottomAxisLabels = [word for pair in zip(map(str, ticks), names) for word in pair]
    return view


def show_series(layout):
    """ParaView's property panel, which shows the last source while the layout is made, hides its series."""
    for view in simple.GetViewsInLayout(layout):
        if view.GetXMLName() == "XYBarChartView":
            for display in view.Representations:
                display.SeriesVisibility = ["bin_values"]


def _table_view(flat):
    """The summary of Distortion Metrics, its second output."""
    view = simple.CreateView("SpreadSheetView", registrationName=unused("Distortion", "views"))
    view.FieldAssociation = "Row Data"
    simple.Show(simple.OutputPort(flat, 1), view)
    # ParaView sorts the columns by name; those that are hidden are in its list of columns.
    columns = flat.GetDataInformation(1).GetRowDataInformation()
    names = [columns.GetArrayInformation(k).GetName() for k in range(columns.GetNumberOfArrays())]
    view.HiddenColumnLabels = ["Row ID", *(name for name in names if name not in COLUMNS)]
    return view
