# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface flattened, and what that did to areas and angles, side by side.

    from surfaceflattening_layout import flatten_and_compare

    comparison = flatten_and_compare(GetActiveSource())

The module comes with the plugin. The macro "Flatten and Compare" calls it for the source that is selected in
the pipeline browser. Everything in the layout is stock ParaView on the four filters of the plugin:

    surface, by area distortion | conformal disk              | area-preserving disk
    distortion of faces, table  | histograms: area, both maps | histograms: angle, both maps

What is selected in one of the three views of the surface is selected in all of them. Playing the animation
unrolls the surface to the area-preserving disk.
"""

from dataclasses import dataclass

from paraview import servermanager, simple

MEASURES = (
    # cell array, title of the axis, range of the colours and the histogram, number of bars
    ("AreaDistortion", "area distortion (log of the area ratio)", (-1.5, 1.5), 60),
    ("AngleDistortion", "angle distortion (log of the axis ratio)", (0.0, 1.5), 30),
)
COLOURED_BY = "AreaDistortion"
COLOUR_RANGE = (-0.5, 0.5)  # beyond it the colours of the ends; e^0.5 is 65 % too much area
COLOUR_PRESET = "Cool to Warm"
MAP_COLOURS = {"conformal": (0.85, 0.45, 0.15), "area-preserving": (0.15, 0.45, 0.70)}
DISPLACEMENT = "SurfaceDisplacement"
LINK = "Flatten and Compare"


@dataclass
class Comparison:
    """The proxies that flatten_and_compare() made."""

    disk: object
    conformal: object  # measured
    area_preserving: object  # measured
    morph: object  # Warp By Vector: 1 is the surface, 0 the area-preserving disk
    layout: object


def flatten_and_compare(source=None, cut="Automatic"):
    """Takes @source, a surface (by default the active source), through Surface To Disk, Conformal Disk, OMT
    Area Preserving and Distortion Metrics and shows the maps and their distortion in a new layout.
    @cut: Cut of Surface To Disk, such as "Plane"; the place of the cut is a setting of that filter.

    @raise ValueError if there is no source or it is no surface.
    @raise RuntimeError if a filter fails; its message is in ParaView's output window.
    """
    surface = _surface_of(source or simple.GetActiveSource())
    disk = _updated(
        simple.SurfaceToDisk(registrationName="Surface to disk", Input=surface, Cut=cut)
    )
    conformal_map = _updated(simple.ConformalDisk(registrationName="Conformal disk", Input=disk))
    transported = _updated(
        simple.OMTAreaPreserving(registrationName="Area-preserving disk", Input=conformal_map)
    )
    conformal, area_preserving = (
        _updated(simple.DistortionMetrics(registrationName=f"{name} map, measured", Input=flat))
        for name, flat in (("Conformal", conformal_map), ("Area-preserving", transported))
    )
    morph = _morph(disk, area_preserving)
    layout = _layout(morph, conformal, area_preserving)
    _link_selections(morph, conformal, area_preserving)
    _animate(morph)
    simple.SetActiveSource(area_preserving)
    _show_series(layout)
    simple.RenderAllViews()
    return Comparison(disk, conformal, area_preserving, morph, layout)


def _surface_of(source):
    if source is None:
        raise ValueError("no source is selected: click a surface in the pipeline browser first")
    source.UpdatePipeline()
    information = source.GetDataInformation()
    if information.GetDataSetTypeAsString() != "vtkPolyData":
        raise ValueError(
            f"the selected source is a {information.GetDataSetTypeAsString()}, not a surface: of an image "
            "take a Contour first (surfaceflattening_volume.isosurface does that well), of other data "
            "Extract Surface"
        )
    return source


def _updated(proxy):
    proxy.UpdatePipeline()
    if proxy.GetDataInformation().GetNumberOfCells() == 0:
        raise RuntimeError(
            f"{proxy.GetXMLLabel()} has no output: its message in the output window says why"
        )
    return proxy


def _morph(disk, area_preserving):
    bounds, flat_bounds = (
        proxy.GetDataInformation().GetBounds() for proxy in (disk, area_preserving)
    )
    centred = simple.Transform(registrationName="Disk at the surface", Input=area_preserving)
    centred.Transform.Translate = [
        (bounds[2 * k] + bounds[2 * k + 1] - flat_bounds[2 * k] - flat_bounds[2 * k + 1]) / 2
        for k in range(3)
    ]
    displaced = simple.Calculator(
        registrationName="Way to the surface",
        Input=centred,
        ResultArrayName=DISPLACEMENT,
        Function="SurfacePoints-coords",
    )
    morph = simple.WarpByVector(
        registrationName="Surface and morph", Input=displaced, Vectors=["POINTS", DISPLACEMENT]
    )
    morph.ScaleFactor = 1.0
    return _updated(morph)


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
    return f"mean error: area {area:.2g} %, angle {angle:.2g}\N{DEGREE SIGN}"


def _layout(morph, conformal, area_preserving):
    maps = {"conformal": conformal, "area-preserving": area_preserving}
    layout = simple.CreateLayout("Flatten and Compare")
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
    for view, (cell, _) in zip(above, cells):
        layout.AssignView(cell, view)
        simple.ResetCamera(view)
    # After the displays, which scale the colours to their data.
    colours = simple.GetColorTransferFunction(COLOURED_BY)
    colours.ApplyPreset(COLOUR_PRESET, True)
    colours.AutomaticRescaleRangeMode = "Never"
    colours.RescaleTransferFunction(*COLOUR_RANGE)
    return layout


def _render_view(title, source):
    view = simple.CreateView("RenderView", registrationName=title.splitlines()[0])
    view.OrientationAxesVisibility = 0
    text = simple.Text(registrationName=title.splitlines()[0], Text=title)
    label = simple.Show(text, view)
    label.WindowLocation = "Upper Center"
    label.FontSize = 12
    display = simple.Show(source, view)
    simple.ColorBy(display, ("CELLS", COLOURED_BY))
    return view, display


def _surface_view(title, morph):
    view, display = _render_view(title, morph)
    display.Specular = 0.0
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(COLOURED_BY), view)
    bar.Title = "log of the area ratio"
    bar.ComponentTitle = ""
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.TitleFontSize = bar.LabelFontSize = 12
    view.CameraParallelProjection = 1
    view.ResetActiveCameraToPositiveX()
    return view


def _disk_view(title, flat):
    view, display = _render_view(title, flat)
    display.SetScalarBarVisibility(view, False)
    display.Ambient = 1.0
    display.Diffuse = 0.0
    view.InteractionMode = "2D"
    view.CameraParallelProjection = 1
    view.ResetActiveCameraToNegativeZ()
    return view


def _histogram_view(maps, array, axis_title, value_range, bars):
    view = simple.CreateView("XYBarChartView", registrationName=f"Histogram, {array}")
    for name, flat in maps.items():
        histogram = simple.Histogram(
            registrationName=f"{array}, {name}",
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
    view.BottomAxisUseCustomRange = 1
    view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = value_range
    return view


def _show_series(layout):
    """ParaView's property panel, which shows the last source while the layout is made, hides its series."""
    for view in simple.GetViewsInLayout(layout):
        if view.GetXMLName() == "XYBarChartView":
            for display in view.Representations:
                display.SeriesVisibility = ["bin_values"]


def _table_view(flat):
    """The summary of Distortion Metrics, its second output."""
    view = simple.CreateView("SpreadSheetView", registrationName="Distortion")
    view.FieldAssociation = "Row Data"
    simple.Show(simple.OutputPort(flat, 1), view)
    return view


def _link_selections(*sources):
    """A selection in one is one in all: they have the same points and cells, by number."""
    link = servermanager.vtkSMSelectionLink()
    for source in sources:
        for direction in (servermanager.vtkSMLink.INPUT, servermanager.vtkSMLink.OUTPUT):
            link.AddLinkedSelection(source.SMProxy, direction)
    servermanager.ProxyManager().RegisterLink(LINK, link)


def _animate(morph):
    track = simple.GetAnimationTrack("ScaleFactor", proxy=morph)
    frames = []
    for time, factor in ((0.0, 1.0), (1.0, 0.0)):
        frame = simple.CompositeKeyFrame()
        frame.KeyTime = time
        frame.KeyValues = [factor]
        frames.append(frame)
    track.KeyFrames = frames
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = 60
    scene.GoToFirst()
