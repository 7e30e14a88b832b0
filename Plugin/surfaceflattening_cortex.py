# SPDX-License-Identifier: GPL-3.0-or-later
"""A hemisphere's cortex to a flat map in one go: surface and annotation in; map, table of regions and patch out.

    from surfaceflattening_cortex import flatten_cortex

    cortex = flatten_cortex("lh.pial", annotation="lh.aparc.annot", curvature="lh.curv", folder="flat")
    cortex.table      # the areas of the regions on the surface and on the map
    cortex.patch      # flat/lh.flat.patch.3d, for FreeSurfer and pycortex

The steps are sources and filters in the pipeline browser, and can be changed there. The command "Flatten Cortex" does the
same with the surface that is selected.
"""

import contextlib
import os
from dataclasses import dataclass

from paraview import servermanager, simple
from surfaceflattening_neuro import (
    VERTEX_NUMBER,
    CortexError,
    geometry_among,
    hemisphere_stem,
    overlay_name,
    overlay_names,
)
from surfaceflattening_neuro_writers import write_cortex
from surfaceflattening_region_table import region_table, write_csv
from surfaceflattening_volume import _filter
from surfaceflattening_whole_file import reason_of

# Names that atlases give to the part of the surface that is no cortex: Desikan-Killiany, Destrieux, HCP, and Yeo.
NO_CORTEX = ("unknown", "corpuscallosum", "medial_wall", "medialwall", "???", "freesurfer_defined_medial_wall")
UNLABELLED = -1


@dataclass
class FlatCortex:
    """The proxies, in their order, and the files that were written."""

    surface: object
    cortex: object
    disk: object
    flat: object
    measured: object
    table: object
    regions: str = None  # the point arrays of labels and curvature
    curvature: str = None
    patch: str = None
    csv: str = None


def flatten_cortex(
    surface, annotation=None, curvature=None, medial_wall=None, cut="Relief", free_outline=True, folder=None
):
    """Flattens the cortex of one hemisphere.

    @surface: a file of FreeSurfer or GIFTI, or a source with a surface. @annotation: a file with regions, or the name
    of a point array of the source. @curvature: likewise; by default it is computed. @medial_wall: names or labels of
    regions that are no cortex; by default the usual names, and vertices without a region. @cut, @free_outline: of
    Surface To Disk and OMT Area Preserving. @folder: where the patch and the table are written; by default nowhere.

    Raises ValueError, and OSError if the folder cannot be written.
    """
    source = _source(surface, annotation, curvature)
    regions = _array_name(source, annotation)
    bend = _array_name(source, curvature)
    if bend is None:
        source = simple.Curvature(registrationName="Curvature", Input=source, CurvatureType="Mean")
        bend = "Mean_Curvature"
    cortex = _without(source, regions, medial_wall) if regions else source
    disk = _filter("SurfaceToDisk")(registrationName="Disk", Input=cortex, Cut=cut, FreeOutline=int(free_outline))
    flat = _filter("OMTAreaPreserving")(
        registrationName="Flat cortex",
        Input=_filter("ConformalDisk")(registrationName="Conformal map", Input=disk),
        FreeOutline=int(free_outline),
    )
    settings = {"UseRegionArray": 1, "RegionArray": ["POINTS", regions], "RegionNamesArray": f"{regions}Names"}
    measured = _filter("DistortionMetrics")(
        registrationName="Flat cortex, measured", Input=flat, **(settings if regions else {"UseRegionArray": 0})
    )
    measured.UpdatePipeline()
    if measured.GetDataInformation().GetNumberOfCells() == 0:
        raise ValueError("nothing came out: see the messages of the filters")
    table = None
    if regions:
        table = _filter("RegionTable")(
            registrationName="Regions", Input=measured, RegionArray=["POINTS", regions], CurvatureArray=["POINTS", bend]
        )
        table.UpdatePipeline()
    result = FlatCortex(source, cortex, disk, flat, measured, table, regions, bend)
    if folder:
        _write(result, folder)
    return result


def _source(surface, annotation, curvature):
    if not isinstance(surface, (str, os.PathLike)):
        if surface is None:
            raise ValueError("select the surface of a cortex in the pipeline browser first")
        return surface
    files = [path for path in (annotation, curvature) if path]
    for path in (surface, *files):
        if not os.path.isfile(path):
            raise ValueError(f"{path}: there is no such file")
    reader = _filter("CortexReader")(registrationName=os.path.basename(surface), FileName=str(surface))
    reader.Overlays = [str(path) for path in files]
    reader.UpdatePipeline()
    if reader.GetDataInformation().GetNumberOfPoints() == 0:
        raise ValueError(f"{surface} could not be read: see the message of the reader")
    return reader


def _array_name(source, given):
    """The name of the point array of a file, or of an array."""
    if given is None:
        return None
    source.UpdatePipeline()
    arrays = source.GetDataInformation().GetPointDataInformation()
    if arrays.GetArrayInformation(str(given)):
        return str(given)
    # A file of GIFTI may have a name for its array within.
    names = overlay_names(str(given)) if os.path.isfile(given) else [overlay_name(str(given))]
    for name in names:
        if arrays.GetArrayInformation(name):
            return name
    raise ValueError(f"the surface has no point array {names[0]}: give its file as an overlay to the reader")


def label_arrays(source):
    """The point arrays of a source that have names for their labels."""
    source.UpdatePipeline()
    information = source.GetDataInformation()
    points, field = information.GetPointDataInformation(), information.GetFieldDataInformation()
    names = [points.GetArrayInformation(k).GetName() for k in range(points.GetNumberOfArrays())]
    return [name for name in names if field.GetArrayInformation(f"{name}Names")]


def _without(source, regions, medial_wall):
    """The surface without the triangles at a vertex of the medial wall."""
    labels = wall_labels(source, regions, medial_wall)
    # 0 at these labels and 1 or more at others; the calculator knows neither "or" nor names with dots in them.
    product = "*".join(f'abs("{regions}"-({label}))' for label in labels)
    marked = simple.Calculator(
        registrationName="In the cortex", Input=source, ResultArrayName="InCortex", Function=f"min(1,{product})"
    )
    kept = simple.Threshold(
        registrationName="Without the medial wall",
        Input=marked,
        Scalars=["POINTS", "InCortex"],
        LowerThreshold=0.5,
        UpperThreshold=1.5,
        AllScalars=1,
    )
    cortex = simple.ExtractSurface(registrationName="Cortex", Input=kept)
    cortex.UpdatePipeline()
    if cortex.GetDataInformation().GetNumberOfCells() == 0:
        raise ValueError(f"no triangle has a region of {regions} that is cortex")
    return cortex


def wall_labels(source, regions, medial_wall=None):
    """The labels of what is no cortex. Raises ValueError if a name that was given is none."""
    field = servermanager.Fetch(source).GetFieldData()
    labels, names = field.GetArray(f"{regions}Labels"), field.GetAbstractArray(f"{regions}Names")
    known = {}
    if labels and names:
        known = {names.GetValue(k).lower(): int(labels.GetTuple1(k)) for k in range(names.GetNumberOfValues())}
    if medial_wall is None:
        return [UNLABELLED, *sorted(known[name] for name in NO_CORTEX if name in known)]
    found = [UNLABELLED]
    for item in [medial_wall] if isinstance(medial_wall, (str, int)) else medial_wall:
        if isinstance(item, str) and item.lower() not in known:
            raise ValueError(f"there is no region {item}: there are {', '.join(sorted(known))}")
        found.append(known[item.lower()] if isinstance(item, str) else int(item))
    return found


def _write(result, folder):
    stem = _stem(result.surface)
    data = servermanager.Fetch(result.measured)
    try:
        os.makedirs(folder, exist_ok=True)
        if data.GetPointData().GetArray(VERTEX_NUMBER):
            result.patch = os.path.join(folder, f"{stem}.flat.patch.3d")
            write_cortex(result.patch, data)
        if result.regions:
            result.csv = os.path.join(folder, f"{stem}.regions.csv")
            write_csv(result.csv, region_table(data, result.regions, result.curvature))
    except OSError as error:
        raise OSError(
            f"the map is finished, but the folder {folder} cannot be written ({reason_of(error)}): save the map "
            "and the table of regions in another folder, by File > Save Data"
        ) from None


def _stem(proxy):
    """The beginning of the names of the files for a surface: that of its file's name, with the hemisphere."""
    while not hasattr(proxy, "FileName"):
        if not hasattr(proxy, "Input") or proxy.Input is None:
            return "cortex"
        proxy = proxy.Input
    return hemisphere_stem(str(proxy.FileName))


def flatten_cortex_and_show(source=None):
    """What the macro does: the map beside the surface, the table below, and the files in a folder beside the surface's
    file."""
    source = source or simple.GetActiveSource()
    if source is None:
        raise ValueError("select the surface of a cortex in the pipeline browser first")
    arrays = label_arrays(source)
    if not arrays:
        raise ValueError(
            "the surface has no regions: give its reader an annotation as overlay, such as lh.aparc.annot"
        )
    names = source.PointData.keys()
    bend = next((name for name in ("curv", "sulc") if name in names), None)
    result = flatten_cortex(source, annotation=arrays[0], curvature=bend)
    _show(result)
    folder = _folder_beside(source)
    if folder:
        _write(result, folder)
    for written in (result.patch, result.csv):
        if written:
            print(f"Written: {written}")
    return result


def _folder_beside(source):
    """The folder for the files of a surface from a file; nothing for another one."""
    path = getattr(source, "FileName", None)
    if not path:
        return None
    path = str(path)
    with contextlib.suppress(CortexError):  # of a file of another kind, which is the surface itself
        path = geometry_among([path, *getattr(source, "Overlays", [])])
    return os.path.join(os.path.dirname(path), "flat")


def _show(result):
    layout = simple.CreateLayout("Flat cortex")
    views = []
    for proxy in (result.cortex, result.measured):
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view=view, layout=layout, hint=0)
        display = simple.Show(proxy, view)
        simple.ColorBy(display, ("POINTS", result.regions))
        view.ResetCamera()
        views.append(view)
    sheet = simple.CreateView("SpreadSheetView")
    simple.AssignViewToLayout(view=sheet, layout=layout, hint=0)
    simple.Show(result.table, sheet)
    simple.SetActiveView(views[1])
    simple.SetActiveSource(result.measured)
    simple.RenderAllViews()
