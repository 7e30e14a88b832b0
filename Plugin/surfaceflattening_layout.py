# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface or a scan flattened, and what that did to areas and angles, side by side.

    from surfaceflattening_layout import flatten_and_compare

    comparison = flatten_and_compare(GetActiveSource())

The module comes with the plugin. The command "Flatten and Compare" calls it for the source that is selected in
the pipeline browser. Everything in the layout is stock ParaView on the filters of the plugin;
surfaceflattening_views has the views.

The three views of the surface show its anatomy, the array ScaledCurvature, and the outlines of its labels if it
has some; switch_colours() shows their area distortion instead, and back. What is selected in one of them is
selected in all, and measured. Playing the animation unrolls the surface to the area-preserving disk.
"""

from dataclasses import dataclass

from paraview import servermanager, simple
from surfaceflattening_present import LINK, FilterFailed, Present, links, unused
from surfaceflattening_views import layout_of, show_series
from surfaceflattening_volume import in_patient_space

DISPLACEMENT = "SurfaceDisplacement"
VOLUMES = ("vtkImageData", "vtkUniformGrid")


@dataclass
class Comparison:
    """The proxies that flatten_and_compare() made."""

    disk: object
    conformal: object  # measured
    area_preserving: object  # measured
    morph: object  # Warp By Vector: 1 is the surface, 0 the area-preserving disk
    layout: object


def flatten_and_compare(source=None, cut="Automatic"):
    """Takes @source, a surface or a scan (by default the active source), through Surface To Disk, Conformal Disk, OMT
    Area Preserving and Distortion Metrics and shows the maps and their distortion in a new layout. Of a scan it takes
    the surface first, by Volume To Surface.
    @cut: Cut of Surface To Disk, such as "Plane"; the place of the cut is a setting of that filter.

    @raise ValueError if there is no source, or no surface can be had of it.
    @raise FilterFailed, a RuntimeError, if a filter fails; its message is in ParaView's output window. Nothing is left then.
    """
    source = _flattenable(source or _selected_source())
    before = Present.now(source)
    try:
        comparison = _flatten_and_compare(_surface_of(source), cut)
    except Exception:
        before.restore()
        raise
    _earlier.append((before, cut))
    _taken_back.clear()
    return comparison


def take_back():
    """Removes what the last flatten_and_compare() made, and all that was made since from it: its undo."""
    if _earlier:
        before, cut = _earlier.pop()
        before.restore()
        _taken_back.append((before.active, cut))


def do_again():
    """Does once more what take_back() has removed last: its redo."""
    if _taken_back:
        source, cut = _taken_back.pop()
        others = list(_taken_back)
        flatten_and_compare(source, cut)
        _taken_back.extend(others)


_earlier = []  # what there was before each flatten_and_compare(), and its cut
_taken_back = []  # sources and cuts of those that were taken back


def _flatten_and_compare(surface, cut):
    disk = _updated(
        simple.SurfaceToDisk(registrationName=unused("Surface to disk"), Input=surface, Cut=cut)
    )
    conformal_map = _updated(
        simple.ConformalDisk(registrationName=unused("Conformal disk"), Input=disk)
    )
    transported = _updated(
        simple.OMTAreaPreserving(registrationName=unused("Area-preserving disk"), Input=conformal_map)
    )
    conformal, area_preserving = (
        _updated(
            simple.DistortionMetrics(registrationName=unused(f"{name} map, measured"), Input=flat)
        )
        for name, flat in (("Conformal", conformal_map), ("Area-preserving", transported))
    )
    morph = _morph(disk, area_preserving)
    layout = layout_of(morph, conformal, area_preserving)
    _link_selections(morph, conformal, area_preserving)
    _animate(morph)
    simple.SetActiveSource(area_preserving)
    show_series(layout)
    simple.RenderAllViews()
    return Comparison(disk, conformal, area_preserving, morph, layout)


def _selected_source():
    """The active source. Of several that are selected in the pipeline browser ParaView makes none the active one."""
    selected = servermanager.ProxyManager().GetSelectionModel("ActiveSources")
    if selected is not None and selected.GetNumberOfSelectedProxies() > 1:
        raise ValueError("several sources are selected: click one surface or scan alone in the pipeline browser")
    return simple.GetActiveSource()


def _flattenable(source):
    if source is None:
        raise ValueError("no source is selected: click a surface or a scan in the pipeline browser first")
    source.UpdatePipeline()
    information = source.GetDataInformation()
    kind = information.GetDataSetTypeAsString()
    if kind not in ("vtkPolyData", *VOLUMES):
        raise ValueError(
            f"the selected source is a {kind}, neither a surface nor a scan: take the surface of it by Extract Surface first"
        )
    if information.GetNumberOfCells() == 0:
        if information.GetNumberOfPoints() > 1 and kind == "vtkPolyData":
            raise ValueError(
                "the selected source has points and no triangles: make a surface of them first, such as by Delaunay 3D "
                "and Extract Surface"
            )
        raise ValueError("the selected source is empty: press Apply, or select another source")
    return source


def _surface_of(source):
    if source.GetDataInformation().GetDataSetTypeAsString() not in VOLUMES:
        return in_patient_space(source, unused("Patient space"))
    return _updated(simple.VolumeToSurface(registrationName=unused("Surface of the scan"), Input=source))


def _updated(proxy):
    proxy.UpdatePipeline()
    if proxy.GetDataInformation().GetNumberOfCells() == 0:
        raise FilterFailed(
            f"{proxy.GetXMLLabel()} has no output: its message in the output window says why"
        )
    return proxy


def _morph(disk, area_preserving):
    bounds, flat_bounds = (
        proxy.GetDataInformation().GetBounds() for proxy in (disk, area_preserving)
    )
    centred = simple.Transform(registrationName=unused("Disk at the surface"), Input=area_preserving)
    centred.Transform.Translate = [
        (bounds[2 * k] + bounds[2 * k + 1] - flat_bounds[2 * k] - flat_bounds[2 * k + 1]) / 2
        for k in range(3)
    ]
    displaced = simple.Calculator(
        registrationName=unused("Way to the surface"),
        Input=centred,
        ResultArrayName=DISPLACEMENT,
        Function="SurfacePoints-coords",
    )
    morph = simple.WarpByVector(
        registrationName=unused("Surface and morph"), Input=displaced, Vectors=["POINTS", DISPLACEMENT]
    )
    morph.ScaleFactor = 1.0
    return _updated(morph)


def _link_selections(*sources):
    """A selection in one is one in all: they have the same points and cells, by number."""
    link = servermanager.vtkSMSelectionLink()
    for source in sources:
        for direction in (servermanager.vtkSMLink.INPUT, servermanager.vtkSMLink.OUTPUT):
            link.AddLinkedSelection(source.SMProxy, direction)
    name = LINK if LINK not in links() else f"{LINK} {len(links()) + 1}"
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
