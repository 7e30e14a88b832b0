# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of the cortex and what is known of their vertices: files of FreeSurfer and GIFTI, read by nibabel.

    from surfaceflattening_neuro import read_cortex, read_overlay

    cortex = read_cortex("lh.pial", overlays=["lh.curv", "lh.aparc.annot"])  # vtkPolyData

Each vertex has its number in the file as point array VertexNumber, so that a flat map can be written for the vertices
of the file (surfaceflattening_neuro_writers). Regions are point arrays of labels; their names are in the field arrays
<array>Labels and <array>Names.
"""

import os
import re
import struct
import warnings

import numpy as np
from surfaceflattening_scans import place
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

VERTEX_NUMBER = "VertexNumber"
VERTEX_COUNT = "VertexCount"

QUAD_OR_CURVATURE = b"\xff\xff\xff"
USE_REAL_RAS, SURFACE_GEOMETRY = 2, 20  # FreeSurfer's tags in the footer of a surface
# FreeSurfer's surface RAS of the axes of a volume, as columns.
SURFACE_AXES = np.array([[-1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
GEOMETRY = (b"\xff\xff\xfe", b"\xff\xff\xfd")

# Surfaces to look for beside an overlay that is opened alone, the most usual first.
NEIGHBOURS = ("pial", "white", "inflated", "smoothwm", "orig", "sphere")

# What tells the hemisphere in the name of a file, the surest first: names of studies and subjects may have an r or l in
# them. FreeSurfer, BIDS, any lh or rh, HCP, any l or r.
HEMISPHERES = (
    r"^(lh|rh)\.",
    r"(?:^|[._-])hemi-(lh|rh|l|r)[._]",
    r"(?:^|[._-])(lh|rh)[._]",
    r"\.(l|r)\.",
    r"(?:^|[._-])(l|r)[._]",
)


class CortexError(ValueError):
    """Why a file cannot be read or written, in words for the user."""


def nibabel():
    try:
        import nibabel as module
        import nibabel.freesurfer.io  # noqa: F401
    except ImportError:
        raise CortexError(
            "files of FreeSurfer and GIFTI are read and written by nibabel, which this Python does not have: install "
            "the package python3-nibabel"
        ) from None
    return module


def kind_of(path):
    """surface, annotation, label, or morphometry for FreeSurfer; gifti for any GIFTI file."""
    name = os.path.basename(path).lower()
    if name.endswith((".gii", ".gii.gz")):
        return "gifti"
    if name.endswith(".annot"):
        return "annotation"
    if name.endswith(".label"):
        return "label"
    try:
        with open(path, "rb") as stream:
            head = stream.read(15)
    except OSError as error:
        raise CortexError(f"{path}: {error.strerror or error}") from None
    if head[:3] in GEOMETRY:
        return "surface"
    if head[:3] == QUAD_OR_CURVATURE:
        # Old surfaces of quadrangles begin with the same three bytes as curvatures, whose size follows from the header.
        vertices = struct.unpack(">i", head[3:7])[0] if len(head) == 15 else -1
        return "morphometry" if 15 + 4 * vertices == os.path.getsize(path) or _is_measure(name) else "surface"
    raise CortexError(f"{path}: this is no file of FreeSurfer that is known, nor GIFTI (.gii)")


def read_cortex(path, overlays=(), warn=print):
    """A surface with @overlays as point arrays. An overlay that is given as @path brings the surface beside it."""
    paths = [path, *overlays]
    geometry = geometry_among(paths)
    if geometry in paths:
        paths.remove(geometry)
    else:
        warn(f"{path}: shown on {geometry}")
    surface = _attempt(geometry, read_geometry, warn)
    side = hemisphere_of(geometry)
    if side:
        text = vtkStringArray()
        text.SetName("Hemisphere")
        text.InsertNextValue(side)
        surface.GetFieldData().AddArray(text)
    for overlay in paths:
        for item in _attempt(overlay, read_overlay):
            add_overlay(surface, item, overlay)
    return surface


def geometry_among(paths):
    """The first of some files that has a surface, or else the surface beside the first file."""
    for path in paths:
        kind = kind_of(path)
        if kind == "surface" or (kind == "gifti" and _gifti_surface(path)):
            return path
    return neighbour(paths[0])


def neighbour(path):
    """The surface of the same hemisphere beside an overlay, or in FreeSurfer's folder surf."""
    folder, name = os.path.split(os.path.abspath(path))
    hemisphere = name.split(".")[0]
    for place_of in (folder, os.path.join(folder, "..", "surf")):
        for kind in NEIGHBOURS:
            for candidate in (f"{hemisphere}.{kind}", f"{hemisphere}.{kind}.surf.gii"):
                found = os.path.normpath(os.path.join(place_of, candidate))
                if os.path.isfile(found):
                    return found
    raise CortexError(
        f"{path}: this has values but no surface, and there is no {hemisphere}.pial or the like beside it: open the "
        "surface, and give this file as its overlay"
    )


def hemisphere_of(path):
    """left or right by the name of the file, as FreeSurfer (lh.pial), HCP (100307.L.pial) and BIDS (hemi-L) have it; or
    nothing."""
    found = _hemisphere_in(os.path.basename(path))
    return {"l": "left", "r": "right"}[found.group(1)[0].lower()] if found else None


def hemisphere_stem(path):
    """The name of a file up to its first dot, or as far as it tells the hemisphere: lh of lh.pial, 100307.L of
    100307.L.pial.surf.gii."""
    name = os.path.basename(path)
    found = _hemisphere_in(name)
    end = name.find(".", found.end(1) if found else 0)
    return name[:end] if end >= 0 else name


def _hemisphere_in(name):
    matches = (re.search(pattern, name, re.IGNORECASE) for pattern in HEMISPHERES)
    return next(filter(None, matches), None)


def read_geometry(path, warn=print):
    """The surface in a file as vtkPolyData."""
    if kind_of(path) == "gifti":
        points, faces, matrix, in_patient_space, source = _gifti_geometry(path)
    else:
        points, faces, matrix, in_patient_space, source = _freesurfer_geometry(path, warn)
    if len(points) == 0 or len(faces) == 0:
        raise CortexError("there are no triangles")
    if faces.min() < 0 or faces.max() >= len(points):
        raise CortexError(f"a triangle has the vertex {faces.max()}, but there are {len(points)}: the file is damaged")
    surface = polydata(points, faces)
    if matrix is not None:
        place(surface, matrix, source)
    if in_patient_space:
        add_field(surface, "InPatientSpace", 1)
    return surface


def polydata(points, faces):
    data = vtkPolyData()
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(positions)
    cells = vtkCellArray()
    offsets = np.arange(0, 3 * len(faces) + 1, 3, dtype=np.int64)
    cells.SetData(
        numpy_to_vtk(offsets, deep=True),
        numpy_to_vtk(np.ascontiguousarray(faces, np.int64).ravel(), deep=True),
    )
    data.SetPolys(cells)
    add_points_array(data, VERTEX_NUMBER, np.arange(len(points), dtype=np.int32))
    add_field(data, VERTEX_COUNT, len(points))
    return data


class Overlay:
    """@values for each vertex of a surface under a @name; @names: of labels, with colours (R, G, B, A from 0 to 255).
    @vertices: those that have a value, if not all have one."""

    def __init__(self, name, values, names=None, colours=None, vertices=None):
        self.name, self.values, self.names = name, values, names or {}
        self.colours, self.vertices = colours or {}, vertices


def read_overlay(path):
    """The values in a file, a list of Overlay."""
    kind = kind_of(path)
    if kind == "gifti":
        return _gifti_overlays(path)
    freesurfer, name = nibabel().freesurfer.io, overlay_name(path)
    if kind == "morphometry":
        values = freesurfer.read_morph_data(path)
        return [Overlay(name, values.astype(values.dtype.newbyteorder("=")))]
    if kind == "annotation":
        labels, table, names = freesurfer.read_annot(path)
        texts = {k: text.decode("utf-8", "replace") for k, text in enumerate(names)}
        colours = {k: tuple(int(c) for c in row[:3]) + (255 - int(row[3]),) for k, row in enumerate(table)}
        return [Overlay(name, labels.astype(np.int32), texts, colours)]
    vertices = freesurfer.read_label(path)
    return [Overlay(name, np.ones(len(vertices), np.int32), {1: name}, vertices=vertices)]


def overlay_names(path):
    """The names of the point arrays that an overlay becomes, as its reader gives them."""
    return [overlay.name for overlay in _attempt(path, read_overlay)]


def overlay_name(path):
    """curv of lh.curv, aparc of lh.aparc.annot."""
    name = os.path.basename(path)
    name = re.sub(r"^[lr]h\.", "", name)
    name = re.sub(r"\.(annot|label|mgh|func\.gii|shape\.gii|label\.gii|gii|gii\.gz)$", "", name)
    return name or "Values"


def add_overlay(surface, overlay, path):
    """Adds the values as a point array. Raises CortexError if they are of another surface."""
    count = surface.GetNumberOfPoints()
    values = overlay.values
    if overlay.vertices is not None:
        if len(overlay.vertices) and not 0 <= overlay.vertices.min() <= overlay.vertices.max() < count:
            raise CortexError(
                f"{path}: it has the vertex {overlay.vertices.max()}, and the surface {count} vertices: they are of "
                "different surfaces"
            )
        values = np.zeros(count, overlay.values.dtype)
        values[overlay.vertices] = overlay.values
    if len(values) != count:
        raise CortexError(
            f"{path}: it has {len(values)} values, and the surface {count} vertices: they are of different surfaces"
        )
    add_points_array(surface, overlay.name, values)
    if overlay.names:
        labels = sorted(overlay.names)
        add_field(surface, f"{overlay.name}Labels", labels)
        names = vtkStringArray()
        names.SetName(f"{overlay.name}Names")
        for label in labels:
            names.InsertNextValue(overlay.names[label])
        surface.GetFieldData().AddArray(names)
    if overlay.colours:
        rows = np.array([overlay.colours[label] for label in sorted(overlay.names)], np.uint8)
        add_field(surface, f"{overlay.name}Colours", rows)


def add_points_array(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def add_field(data, name, values):
    values = np.atleast_1d(np.asarray(values))
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.GetFieldData().AddArray(array)


def _attempt(path, read, *arguments):
    """Reads, with every failure of nibabel, which has no exceptions of its own for damaged files, as CortexError."""
    nibabel()
    try:
        return read(path, *arguments)
    except CortexError as error:
        text = str(error)
        raise CortexError(text if text.startswith(path) else f"{path}: {text}") from None
    except Exception as error:
        reason = getattr(error, "strerror", None) or error
        raise CortexError(f"{path}: cannot be read, the file may be damaged or cut short: {reason}") from None


def _is_measure(name):
    return bool(re.search(r"\.(curv|sulc|thickness|area|volume|avg_curv|jacobian_white)(\.|$)", name))


def _freesurfer_geometry(path, warn):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a footer that is missing, which is told below
        points, faces, information = nibabel().freesurfer.io.read_geometry(path, read_metadata=True)
    points, faces = points.astype(np.float32), np.asarray(faces)
    if _in_scanner_space(path):
        return points, faces, np.eye(4), True, "FreeSurfer, scanner RAS"
    if not str(information.get("valid", "")).startswith("1"):
        warn(
            f"{path}: it does not say where the scan's own space is (c_ras): its coordinates are FreeSurfer's surface "
            "RAS, which may be shifted by some centimetres"
        )
        return points, faces, None, False, ""
    return points, faces, _scanner_of_surface(information), False, "FreeSurfer, surface RAS"


def _in_scanner_space(path):
    """Whether the footer says useRealRAS: the numbers 2, 1, 20 in place of 2, 0, 20."""
    with open(path, "rb") as stream:
        content = stream.read()
    start = content.rfind(b"valid = ")
    tags = (USE_REAL_RAS, 1, SURFACE_GEOMETRY)
    return start >= 12 and struct.unpack(">3i", content[start - 12 : start]) == tags


def _scanner_of_surface(information):
    """Surface RAS to scanner RAS by the volume that the surface was made of: both are maps of its voxels. For a volume
    in FreeSurfer's own order of the axes it is the shift by c_ras."""
    sizes = np.array(information["voxelsize"])
    half = np.array(information["volume"]) * sizes / 2
    surface = np.eye(4)
    surface[:3, :3] = SURFACE_AXES
    surface[:3, 3] = -surface[:3, :3] @ half
    scanner = np.eye(4)
    scanner[:3, :3] = np.column_stack([information["xras"], information["yras"], information["zras"]])
    scanner[:3, 3] = np.array(information["cras"]) - scanner[:3, :3] @ half
    return scanner @ np.linalg.inv(surface)


def _gifti(path):
    # Not mapped into memory: nibabel takes mapped columns for rows.
    image = nibabel().gifti.GiftiImage.from_filename(path, mmap=False)
    for array in image.darrays:
        # Before version 5.3 nibabel makes a row of each line of text, which the format does not ask for. In memory the numbers
        # are in the order of the text, whatever the version.
        order = "F" if array.ind_ord == 2 else "C"
        if array.encoding == 1:
            array.data = np.ravel(array.data, order="K").reshape(array.dims, order=order)
        # Since 5.3 nibabel leaves the file's order of bytes.
        array.data = array.data.astype(array.data.dtype.newbyteorder("="), copy=False)
    return image


def _gifti_surface(path):
    return bool(_attempt(path, lambda p: _gifti(p).get_arrays_from_intent("NIFTI_INTENT_TRIANGLE")))


def _gifti_geometry(path):
    image = _gifti(path)
    points = image.get_arrays_from_intent("NIFTI_INTENT_POINTSET")
    triangles = image.get_arrays_from_intent("NIFTI_INTENT_TRIANGLE")
    if not points or not triangles:
        raise CortexError("there is no surface in it, which has points and triangles")
    system = points[0].coordsys
    matrix, in_patient_space, source = None, False, ""
    if system is not None and system.dataspace > 0:
        matrix, in_patient_space, source = np.eye(4), True, "GIFTI, data space"
    elif system is not None and system.xformspace > 0:
        matrix, source = np.asarray(system.xform, float), "GIFTI, transform of the data space"
    return np.asarray(points[0].data), np.asarray(triangles[0].data), matrix, in_patient_space, source


def _gifti_overlays(path):
    image = _gifti(path)
    overlays = []
    table = image.labeltable
    names = {item.key: item.label or str(item.key) for item in table.labels} if table else {}
    colours = {item.key: tuple(round(255 * (c or 0)) for c in item.rgba) for item in table.labels} if table else {}
    for number, array in enumerate(image.darrays):
        if array.intent in (1008, 1009):  # points and triangles
            continue
        values = np.asarray(array.data)
        name = array.meta.get("Name") or overlay_name(path)
        if number and any(name == other.name for other in overlays):
            name = f"{name} {number}"
        labels = array.intent == 1002
        overlays.append(Overlay(name, values, names if labels else None, colours if labels else None))
    if not overlays:
        raise CortexError("there are no values in it")
    return overlays
