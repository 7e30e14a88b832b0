# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo's ParaView layout: one picture after the paper's Fig. 1 (surface and maps) and Fig. 11
(histograms of their distortions).

    lateral view | conformal disk     | area-preserving disk | legend
    medial view  | its two histograms | its two histograms   |
"""

from paraview import servermanager, simple
from surfaceflattening_views import measured_errors, split

# Pixels of layout and picture alike: a chart saved larger than it is writes its titles over its labels.
SIZE = (2100, 1180)
TEXT_ON_SCREEN = 0.55  # size of the text in ParaView's window, relative to the picture's
MAP_COLOURS = {"conformal": (0.85, 0.45, 0.15), "area-preserving": (0.15, 0.45, 0.70)}
# Array of Distortion Metrics, title of the axis, its range, number of bars, highest share of faces shown.
# The first and last bar include what lies beyond the range.
DISTORTIONS = (
    ("AreaDistortion", "area distortion (log of the area ratio)", (-1.5, 1.5), 75, 0.5),
    ("AngleDistortion", "angle distortion (log of the axis ratio)", (0.0, 1.5), 30, 1.0),
)
INK = (0.1, 0.1, 0.1)


def region_colour_map(array, labels, names, colours):
    """Makes ParaView colour @p array by category; the legend lists @p labels."""
    table = simple.GetColorTransferFunction(array)
    table.InterpretValuesAsCategories = 1
    table.AnnotationsInitialized = 1
    table.Annotations = [text for label in labels for text in (str(label), names[label])]
    table.IndexedColors = [channel for label in labels for channel in colours[label]]
    table.NanColor = colours[labels[0]]
    return table


def shade_map(array, low, high):
    """Makes ParaView draw @p array as a shadow: clear up to @p low, dark from @p high on."""
    table = simple.GetColorTransferFunction(array)
    table.RGBPoints = [low, 0.0, 0.0, 0.0, high, 0.0, 0.0, 0.0]
    table.EnableOpacityMapping = 1
    opacity = simple.GetOpacityTransferFunction(array)
    opacity.Points = [low, 0.0, 0.5, 0.0, high, 0.45, 0.5, 0.0]
    return table


def render_view(title):
    view = simple.CreateView("RenderView", registrationName=title)
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.CameraParallelProjection = 1
    text = simple.Text(registrationName=title, Text=title)
    display = simple.Show(text, view)
    display.WindowLocation = "Upper Center"
    display.Color = INK
    display.FontSize = 18
    return view


def look(view, bounds, direction, up, margin, headroom):
    """Points the parallel camera at the box @p bounds, along @p direction, and fits the box with room
    for a title. Margin and headroom are relative to the height of the box."""
    centre = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
    size = [bounds[2 * k + 1] - bounds[2 * k] for k in range(3)]
    height = sum(s * abs(u) for s, u in zip(size, up))
    centre = [c + headroom * height * u for c, u in zip(centre, up)]
    distance = 3 * max(size)
    view.CameraFocalPoint = centre
    view.CameraPosition = [c - distance * d for c, d in zip(centre, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = (1 + margin) * height / 2


def show_regions(source, view, array):
    display = simple.Show(source, view)
    simple.ColorBy(display, ("POINTS", array))
    display.SetScalarBarVisibility(view, False)
    return display


def surface_view(title, surface, array, direction):
    view = render_view(title)
    display = show_regions(surface, view, array)
    display.Specular = 0.0
    display.Ambient = 0.25
    display.Diffuse = 0.8
    bounds = surface.GetDataInformation().GetBounds()
    look(view, bounds, direction, [0.0, 0.0, 1.0], 0.22, 0.03)
    return view


def disk_view(title, metrics, array, shade):
    """The flat map straight from above. The shade is drawn from the filter's input, which is the same
    mesh: a view shows each source once."""
    view = render_view(title)
    view.InteractionMode = "2D"
    for source, coloured_by in ((metrics, array), (metrics.Input, shade)):
        display = show_regions(source, view, coloured_by)
        display.Ambient = 1.0
        display.Diffuse = 0.0
    bounds = metrics.GetDataInformation().GetBounds()
    look(view, bounds, [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], 0.16, 0.05)
    return view


def legend_view(surface, array, title):
    """A view of nothing but the colour legend, so that it hides no map."""
    view = render_view(title)
    display = show_regions(surface, view, array)
    display.Opacity = 0.0
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Title = ""
    bar.ComponentTitle = ""
    bar.WindowLocation = "Any Location"
    bar.Orientation = "Vertical"
    bar.Position = [0.04, 0.02]
    bar.ScalarBarLength = 0.92
    bar.ScalarBarThickness = 20
    bar.LabelFontSize = 15
    bar.LabelColor = INK
    bar.TextPosition = "Ticks left/bottom, annotations right/top"
    bar.Visibility = 1
    display.SetScalarBarVisibility(view, True)
    return view


def histogram_view(metrics, map_name, array, axis_title, value_range, bars, top):
    histogram = simple.Histogram(
        registrationName=f"Histogram, {map_name}, {array}",
        Input=metrics,
        SelectInputArray=["CELLS", array],
        BinCount=bars,
        UseCustomBinRanges=1,
        CustomBinRanges=list(value_range),
        Normalize=1,
    )
    view = simple.CreateView("XYBarChartView", registrationName=f"{map_name}, {array}")
    display = simple.Show(histogram, view, "XYBarChartRepresentation")
    display.SeriesColor = ["bin_values", *map(str, MAP_COLOURS[map_name])]
    display.SeriesLabel = ["bin_values", map_name]
    view.ShowLegend = 0
    view.ChartTitle = ""
    view.LeftAxisTitle = "share of faces"
    view.BottomAxisTitle = axis_title
    view.LeftAxisUseCustomRange = 1
    view.LeftAxisRangeMinimum, view.LeftAxisRangeMaximum = 0.0, top
    view.BottomAxisUseCustomRange = 1
    view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = value_range
    view.LeftAxisTitleFontSize = view.BottomAxisTitleFontSize = 17
    view.LeftAxisLabelFontSize = view.BottomAxisLabelFontSize = 15
    return view


def compose(pipeline, region, shade):
    """Makes all views and arranges them in one layout, which is returned."""
    surface = pipeline.surface
    maps = (
        ("(c)", "conformal", pipeline.conformal),
        ("(d)", "area-preserving", pipeline.area_preserving),
    )
    layout = simple.CreateLayout("Flattening of a brain")
    views, *map_columns, legend = split(layout, 0, (0.29, 0.29, 0.29, 0.13), "Horizontal")
    map_cells = [split(layout, column, (0.52, 0.24, 0.24), "Vertical") for column in map_columns]

    # Charts first, and at their size: once a render view has drawn text, VTK 9.2 draws a chart's new text
    # with its own ghost below.
    for (_, map_name, metrics), (_, *charts) in zip(maps, map_cells):
        for cell, distortion in zip(charts, DISTORTIONS):
            layout.AssignView(cell, histogram_view(metrics, map_name, *distortion))
    layout.SetSize(SIZE)
    simple.RenderAllViews()

    for (letter, map_name, metrics), (disk, *_) in zip(maps, map_cells):
        title = f"{letter} {map_name.capitalize()} map\n{measured_errors(metrics)}"
        layout.AssignView(disk, disk_view(title, metrics, region, shade))
    for cell, title, direction in zip(
        split(layout, views, (0.5, 0.5), "Vertical"),
        ("(a) Surface, lateral view", "(b) Surface, medial view (cut open)"),
        ([1, 0, 0], [-1, 0, 0]),
    ):
        layout.AssignView(cell, surface_view(title, surface, region, direction))
    layout.AssignView(legend, legend_view(surface, region, "AAL region"))
    layout.SetSize(SIZE)  # of the views, so after they are assigned
    return layout


def scale_text(factor):
    """Scales all text of all views: the picture is larger than ParaView's window, which has panels too."""
    proxies = servermanager.ProxyManager()
    for group in ("views", "representations", "scalar_bars"):
        for proxy in proxies.GetProxiesInGroup(group).values():
            for name in proxy.ListProperties():
                if name.endswith("FontSize"):
                    setattr(proxy, name, round(factor * int(getattr(proxy, name))))
