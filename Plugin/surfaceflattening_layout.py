# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface flattened, and what that did to areas and angles, side by side.

    from surfaceflattening_layout import flatten_and_compare

    comparison = flatten_and_compare(GetActiveSource())

The module comes with the plugin. The command "Flatten and Compare" calls it for the source that is selected in
the pipeline browser. Everything in the layout is stock ParaView on the four filters of the plugin:

    surface, with its folds     | conformal disk              | area-preserving disk, with a scale bar
    distortion of faces, table  | histograms: area, both maps | histograms: angle, both maps

The three views of the surface show its anatomy, the array ScaledCurvature, and the outlines of its labels if it
has some; switch_colours() shows their area distortion instead, and back. What is selected in one of them is
selected in all, and measured. Playing the animation unrolls the surface to the area-preserving disk.
"""

import math

from dataclasses import dataclass

from paraview import servermanager, simple
from surfaceflattening_outlines import label_array, label_outlines
from surfaceflattening_selection import percent, show_measures
from surfaceflattening_volume import in_patient_space

MEASURES = (
    # cell array, title of the axis, range of the colours and the histogram, number of bars
    ("AreaDistortion", "area distortion (log of the area ratio)", (-1.5, 1.5), 60),
    ("AngleDistortion", "angle distortion (log of the axis ratio)", (0.0, 1.5), 30),
)
ANATOMY = ("POINTS", "ScaledCurvature")
DISTORTION = ("CELLS", "AreaDistortion")
DISTORTION_TITLE = "surface area against map area"
COLUMNS = ("Faces", "FacesWithin2Percent", "FlatArea", "MeanAngleError", "MeanAreaError", "Region", "SurfaceArea")
OUTLINE_COLOUR = (0.8, 0.1, 0.1)
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
    @raise RuntimeError if a filter fails; its message is in ParaView's output window. Nothing is left then.
    """
    surface = _surface_of(source or simple.GetActiveSource())
    before = _Present.now(surface)
    try:
        comparison = _flatten_and_compare(surface, cut)
    except Exception:
        before.restore()
        raise
    _earlier.append(before)
    return comparison


def take_back():
    """Removes what the last flatten_and_compare() made, and all that was made since from it: its undo."""
    if _earlier:
        _earlier.pop().restore()


_earlier = []  # what there was before each flatten_and_compare()


def _flatten_and_compare(surface, cut):
    disk = _updated(
        simple.SurfaceToDisk(
            registrationName=_unused("Surface to disk"),
            Input=in_patient_space(surface, _unused("Patient space")),
            Cut=cut,
        )
    )
    conformal_map = _updated(
        simple.ConformalDisk(registrationName=_unused("Conformal disk"), Input=disk)
    )
    transported = _updated(
        simple.OMTAreaPreserving(registrationName=_unused("Area-preserving disk"), Input=conformal_map)
    )
    conformal, area_preserving = (
        _updated(
            simple.DistortionMetrics(registrationName=_unused(f"{name} map, measured"), Input=flat)
        )
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


@dataclass
class _Present:
    """What there is at a time; the source that is active, and its layout."""

    sources: set
    layouts: set
    links: set
    active: object
    view: object

    @staticmethod
    def now(active):
        return _Present(
            sources={proxy.SMProxy for proxy in simple.GetSources().values()},
            layouts={layout.SMProxy for layout in simple.GetLayouts().values()},
            links=set(_links()),
            active=active,
            view=simple.GetActiveView(),
        )

    def restore(self):
        """Removes what was made since then."""
        manager = servermanager.ProxyManager()
        for name in set(_links()) - self.links:
            manager.UnRegisterLink(name)
        for layout in list(simple.GetLayouts().values()):
            if layout.SMProxy not in self.layouts:
                for view in simple.GetViewsInLayout(layout):
                    simple.Delete(view)
                simple.RemoveLayout(layout)
        for proxy in reversed(list(simple.GetSources().values())):
            if proxy.SMProxy not in self.sources:
                simple.Delete(proxy)
        if self.view is not None and self.view in simple.GetRenderViews():
            simple.SetActiveView(self.view)
        simple.SetActiveSource(self.active)


def _links():
    """The names of the selection links that flatten_and_compare() makes."""
    manager = servermanager.ProxyManager()
    names = (LINK if number == 1 else f"{LINK} {number}" for number in range(1, 100))
    return [name for name in names if manager.GetRegisteredLink(name) is not None]


def _unused(name, group="sources"):
    """The name, or with the first number that makes it one that no other proxy of the group has."""
    manager = servermanager.ProxyManager()
    number, unused = 1, name
    while manager.GetProxy(group, unused) is not None:
        number += 1
        unused = f"{name} {number}"
    return unused


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
        _colour(display, wanted)
        simple.HideUnusedScalarBars(v)
    if wanted == DISTORTION:
        # Where there is least beside the map.
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


def _colour(display, array):
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
    if information.GetNumberOfCells() == 0:
        raise ValueError("the selected source is empty: press Apply, or select another source")
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
    centred = simple.Transform(registrationName=_unused("Disk at the surface"), Input=area_preserving)
    centred.Transform.Translate = [
        (bounds[2 * k] + bounds[2 * k + 1] - flat_bounds[2 * k] - flat_bounds[2 * k + 1]) / 2
        for k in range(3)
    ]
    displaced = simple.Calculator(
        registrationName=_unused("Way to the surface"),
        Input=centred,
        ResultArrayName=DISPLACEMENT,
        Function="SurfacePoints-coords",
    )
    morph = simple.WarpByVector(
        registrationName=_unused("Surface and morph"), Input=displaced, Vectors=["POINTS", DISPLACEMENT]
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
    return f"mean error: area {percent(area)}, angle {angle:.0f}\N{DEGREE SIGN}"


def _layout(morph, conformal, area_preserving):
    maps = {"conformal": conformal, "area-preserving": area_preserving}
    layout = simple.CreateLayout(_unused("Flatten and Compare", "layouts"))
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
        layout.AssignView(cell, view)
        simple.ResetCamera(view)
    _show_scale_bar(above[2], area_preserving)
    _show_selection(above[0], area_preserving)
    return layout


def _render_view(title, source):
    view = simple.CreateView("RenderView", registrationName=_unused(title.splitlines()[0], "views"))
    view.OrientationAxesVisibility = 0
    _show_text(view, title, "Upper Center")
    display = simple.Show(source, view)
    _colour(display, ANATOMY)
    display.SetScalarBarVisibility(view, False)
    return view, display


def _show_text(view, words, place):
    text = simple.Text(registrationName=_unused(words.splitlines()[0]), Text=words)
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
    outlines = label_outlines(source, *labels, _unused(f"Outlines of {labels[1]}"))
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
        registrationName=_unused("Scale bar"), Point1=[low_x, y, 0], Point2=[low_x + length, y, 0], Resolution=1
    )
    _solid(simple.Show(bar, view), (1.0, 1.0, 1.0), 4)
    simple.ResetCamera(view)
    _, label = _show_text(view, f"scale bar: {length:g} units of the surface", "Lower Center")
    label.FontSize = 10


def _show_selection(view, flat):
    text, label = _show_text(view, "Selection", "Lower Left Corner")
    label.FontSize = 10
    show_measures(flat, text)


def _histogram_view(maps, array, axis_title, value_range, bars):
    view = simple.CreateView("XYBarChartView", registrationName=_unused(f"Histogram, {array}", "views"))
    for name, flat in maps.items():
        histogram = simple.Histogram(
            registrationName=_unused(f"{array}, {name}"),
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


def _show_series(layout):
    """ParaView's property panel, which shows the last source while the layout is made, hides its series."""
    for view in simple.GetViewsInLayout(layout):
        if view.GetXMLName() == "XYBarChartView":
            for display in view.Representations:
                display.SeriesVisibility = ["bin_values"]


def _table_view(flat):
    """The summary of Distortion Metrics, its second output."""
    view = simple.CreateView("SpreadSheetView", registrationName=_unused("Distortion", "views"))
    view.FieldAssociation = "Row Data"
    simple.Show(simple.OutputPort(flat, 1), view)
    # ParaView sorts the columns by name; those that are hidden are in its list of columns.
    columns = flat.GetDataInformation(1).GetRowDataInformation()
    names = [columns.GetArrayInformation(k).GetName() for k in range(columns.GetNumberOfArrays())]
    view.HiddenColumnLabels = ["Row ID", *(name for name in names if name not in COLUMNS)]
    return view


def _link_selections(*sources):
    """A selection in one is one in all: they have the same points and cells, by number."""
    link = servermanager.vtkSMSelectionLink()
    for source in sources:
        for direction in (servermanager.vtkSMLink.INPUT, servermanager.vtkSMLink.OUTPUT):
            link.AddLinkedSelection(source.SMProxy, direction)
    name = LINK if LINK not in _links() else f"{LINK} {len(_links()) + 1}"
    servermanager.ProxyManager().RegisterLink(name, link)


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
