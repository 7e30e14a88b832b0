# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes flat maps, surfaces and point arrays as files of FreeSurfer and GIFTI.

    from surfaceflattening_neuro_writers import write_cortex
    write_cortex("lh.flat.patch.3d", flat)        # a patch of FreeSurfer, which pycortex reads, too
    write_cortex("lh.flat.surf.gii", flat)        # a surface with the vertices of the original one
    write_cortex("lh.distortion.shape.gii", flat, "MeanAreaDistortion")

The point array VertexNumber says which vertex of the original surface a point is. Readers of this plugin write it; Flat
Map Transfer keeps it for every vertex of the original surface.
"""

import os
import struct
import warnings

import numpy as np
from surfaceflattening_neuro import (
    SURFACE_AXES,
    SURFACE_GEOMETRY,
    USE_REAL_RAS,
    VERTEX_COUNT,
    VERTEX_NUMBER,
    CortexError,
    nibabel,
)
from surfaceflattening_whole_file import whole_file
from vtkmodules.util.numpy_support import vtk_to_numpy

ORIGINAL = "vtkOriginalPointIds"
SCANNER = 1  # space of GIFTI
# How far the products of the axes of a matrix may be from those of unit vectors, as headers have single precision or six
# digits: a stretch of so little is a hundredth of a millimetre in a head.
TURN_TOLERANCE = 1e-4
COLOURS = 1 << 24  # of three bytes
COLOUR_STEP = 0x9E3779  # odd, so that its multiples go through all colours; neighbours in the order look different


def write_cortex(path, data, array=None, warn=print):
    """Writes @data, vtkPolyData or a proxy of ParaView, in the format that the name of the file tells.

    @array: the point array to write, for the formats of values: .shape.gii, .func.gii, .label.gii, .annot, .label,
    and FreeSurfer's curvature, .curv. @warn: is told what the file cannot hold. Raises CortexError, and OSError if the
    file cannot be written: an earlier one stays as it was.
    """
    data = _fetched(data)
    if data.GetNumberOfPoints() == 0:
        raise CortexError("there are no points to write")
    with whole_file(path) as part:
        _write(part, data, array, lambda text: warn(f"{path}: {text}"))


def _write(path, data, array, warn):
    name = os.path.basename(path)
    if name.endswith(".patch.3d"):
        _write_patch(path, data)
    elif name.endswith((".shape.gii", ".func.gii", ".label.gii")):
        _write_gifti_values(path, data, _chosen(data, array), array)
    elif name.endswith(".gii"):
        _write_gifti_surface(path, data)
    elif name.endswith(".curv"):
        values = _of_all_vertices(data, _chosen(data, array).astype(np.float32))
        nibabel().freesurfer.io.write_morph_data(path, values)
    elif name.endswith(".label"):
        _write_label(path, data, _chosen(data, array))
    elif name.endswith(".annot"):
        _write_annotation(path, data, _chosen(data, array), array, warn)
    else:
        _write_freesurfer_surface(path, data, warn)


def _write_patch(path, data):
    """FreeSurfer's binary patch: -1, the number of vertices, then for each its number + 1, negative on the border, and
    x, y, z; integers and single precision, all big-endian (mrisWritePatch in FreeSurfer's mrisurf_io.cpp).

    A vertex on a cut has several places on the map, and is left out, as FreeSurfer itself does."""
    numbers, known, kept = vertices_of_patch(data)
    faces = _faces(data)
    on_cut = known & ~kept
    border = np.zeros(len(kept), bool)
    border[border_points(faces)] = True
    border[faces[on_cut[faces].any(axis=1)]] = True  # the neighbours of what is left out
    rows = np.zeros(kept.sum(), dtype=[("number", ">i4"), ("position", ">f4", 3)])
    rows["number"] = np.where(border, -(numbers + 1), numbers + 1)[kept]
    rows["position"] = _points(data)[kept]
    rows = rows[np.argsort(numbers[kept])]
    with open(path, "wb") as stream:
        stream.write(struct.pack(">2i", -1, len(rows)) + rows.tobytes())


def vertices_of_patch(data):
    """The vertex of the original surface that each point is, whether it is one, and whether it is that one's only
    point. Raises CortexError if most points are no vertex of it, as after remeshing."""
    numbers, known = _numbers(data)
    unique, places, counts = np.unique(numbers[known], return_inverse=True, return_counts=True)
    kept = known.copy()
    kept[known] = counts[places] == 1
    # Points that were added along cuts are no reason to refuse: of a surface with 400 vertices they were 60 % of all
    # points, of a hemisphere they are some percent. Of a remeshed surface nearly all points are new.
    if len(unique) == 0 or kept.sum() < 0.2 * len(kept):
        raise CortexError(
            f"{kept.sum()} of {len(kept)} points are vertices of the original surface, as it was remeshed: use the "
            "output of Flat Map Transfer, with the original surface as its second input"
        )
    return numbers, known, kept


def _numbers(data):
    """The vertex that each point is, and whether it is one at all and not a new point."""
    numbers, ids = (data.GetPointData().GetArray(name) for name in (VERTEX_NUMBER, ORIGINAL))
    if not numbers and not ids:
        raise CortexError(
            "the points do not say which vertices of the original surface they are (VertexNumber): use the output of "
            "Flat Map Transfer"
        )
    values = vtk_to_numpy(numbers or ids).astype(np.int64)
    return values, (vtk_to_numpy(ids) >= 0 if ids else np.ones(len(values), bool)) & (values >= 0)


def vertex_numbers(data):
    """Which vertex of the original surface each point is. Raises CortexError if a point is none, or two are the
    same."""
    numbers, known = _numbers(data)
    if not known.all():
        raise CortexError(
            "the points are not one vertex of the original surface each, as it was cut or remeshed: use the output of "
            "Flat Map Transfer, with the original surface as its second input"
        )
    twice = len(numbers) - len(np.unique(numbers))
    if twice:
        raise CortexError(
            f"{twice} vertices of the original surface are there twice, on both banks of a seam, and the file has each "
            "once: save a patch (.patch.3d), which leaves them out"
        )
    return numbers


def border_points(faces):
    """The ends of the edges that have one triangle."""
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    return np.unique(unique[counts == 1])


def _fetched(data):
    if hasattr(data, "SMProxy"):
        from paraview import servermanager

        data.UpdatePipeline()
        data = servermanager.Fetch(data)
    if not data.IsA("vtkPolyData"):
        raise CortexError(f"only a surface can be written, not {data.GetClassName()}")
    return data


def _points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def _faces(data):
    cells = data.GetPolys()
    if cells.GetNumberOfCells() == 0 or cells.IsHomogeneous() != 3:
        raise CortexError("there are cells other than triangles: use Triangulate first")
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)


def _chosen(data, name):
    array = data.GetPointData().GetArray(name) if name else None
    if array is None:
        known = [data.GetPointData().GetArrayName(k) for k in range(data.GetPointData().GetNumberOfArrays())]
        raise CortexError(f"choose the point array to write ({', '.join(filter(None, known))}): there is no {name}")
    return vtk_to_numpy(array)


def _of_all_vertices(data, values, missing=0):
    """Values of the points at the places of their vertices in the original surface, @missing at others. Without
    vertices of an original surface, and if it is not known how many it has, the values as they are."""
    count = data.GetFieldData().GetArray(VERTEX_COUNT)
    if not data.GetPointData().GetArray(VERTEX_NUMBER) or not count:
        return values
    numbers = vertex_numbers(data)
    whole = np.full((int(count.GetTuple1(0)), *values.shape[1:]), missing, values.dtype)
    whole[numbers] = values
    return whole


def _faces_of_all_vertices(data):
    faces = _faces(data)
    if not data.GetPointData().GetArray(VERTEX_NUMBER) or not data.GetFieldData().GetArray(VERTEX_COUNT):
        return faces
    return vertex_numbers(data)[faces]


def _names(data, array):
    """{label: (name, (R, G, B, A))} of an array of labels, where the reader had them. Labels that have names alone get
    colours of their own."""
    field = data.GetFieldData()
    labels, names = field.GetArray(f"{array}Labels"), field.GetAbstractArray(f"{array}Names")
    colours = field.GetArray(f"{array}Colours")
    found = {}
    for k in range(labels.GetNumberOfTuples() if labels and names else 0):
        colour = tuple(int(c) for c in colours.GetTuple(k)) if colours else _colour(k)
        found[int(labels.GetTuple1(k))] = (names.GetValue(k), colour)
    return found


def _colour(number):
    """The colour of a region by its place in the order, never black: the first 16 million differ."""
    code = (number + 1) * COLOUR_STEP % COLOURS
    return code & 255, code >> 8 & 255, code >> 16, 255


def _code(colour):
    """The number of a colour in an annotation of FreeSurfer."""
    return colour[0] | colour[1] << 8 | colour[2] << 16


def _told_apart(rows, warn):
    """The [(name, colour)] of an annotation with a new colour for each region that is black or has that of an earlier
    one: in the file a vertex has the colour of its region and nothing else, and black is that of no region."""
    taken, seen, found, changed = {0, *(_code(colour) for _name, colour in rows)}, {0}, [], []
    for number, (name, colour) in enumerate(rows):
        if _code(colour) in seen:
            while _code(colour) in taken:
                colour, number = _colour(number), number + 1
            taken.add(_code(colour))
            changed.append(name)
        seen.add(_code(colour))
        found.append((name, colour))
    if changed:
        warn(
            f"{len(changed)} of {len(rows)} regions are black or have the colour of another one, {changed[0]} is one: "
            "as FreeSurfer tells regions apart by their colours, they have others in the file"
        )
    return found


def _place(data):
    """Whether the coordinates are those of the patient, and if not, the matrix that leads there, or None. A flat map
    has neither: its coordinates are on the map."""
    field = data.GetFieldData()
    placed, matrix = field.GetArray("InPatientSpace"), field.GetArray("PatientMatrix")
    if data.GetPointData().GetArray("SurfacePoints"):
        return False, None
    if placed and placed.GetTuple1(0):
        return True, None
    return False, np.reshape(matrix.GetTuple(0), (4, 4)) if matrix else None


def _write_gifti_surface(path, data):
    gifti = nibabel().gifti
    points = _of_all_vertices(data, _points(data).astype(np.float32))
    in_patient_space, matrix = _place(data)
    known = in_patient_space or matrix is not None
    system = gifti.GiftiCoordSystem(
        dataspace=SCANNER if in_patient_space else 0, xformspace=SCANNER if known else 0, xform=matrix
    )
    image = gifti.GiftiImage(
        darrays=[
            gifti.GiftiDataArray(
                points, intent="NIFTI_INTENT_POINTSET", datatype="NIFTI_TYPE_FLOAT32", coordsys=system
            ),
            gifti.GiftiDataArray(
                _faces_of_all_vertices(data).astype(np.int32),
                intent="NIFTI_INTENT_TRIANGLE",
                datatype="NIFTI_TYPE_INT32",
            ),
        ]
    )
    nibabel().save(image, path)


def _write_gifti_values(path, data, values, name):
    gifti = nibabel().gifti
    labels = path.endswith(".label.gii")
    table = gifti.GiftiLabelTable()
    for key, (text, colour) in _names(data, name).items() if labels else ():
        label = gifti.GiftiLabel(key, *(c / 255 for c in colour))
        label.label = text
        table.labels.append(label)
    kind = (np.int32, "NIFTI_INTENT_LABEL", "NIFTI_TYPE_INT32")
    if not labels:
        intent = "NIFTI_INTENT_SHAPE" if path.endswith(".shape.gii") else "NIFTI_INTENT_NONE"
        kind = (np.float32, intent, "NIFTI_TYPE_FLOAT32")
    array = gifti.GiftiDataArray(
        _of_all_vertices(data, values.astype(kind[0])),
        intent=kind[1],
        datatype=kind[2],
        meta=gifti.GiftiMetaData({"Name": name}),
    )
    nibabel().save(gifti.GiftiImage(labeltable=table, darrays=[array]), path)


def _write_annotation(path, data, values, name, warn):
    known = {label: row for label, row in _names(data, name).items() if label >= 0} or {
        int(label): (str(int(label)), _colour(k)) for k, label in enumerate(np.unique(values[values >= 0]))
    }
    if not known:
        raise CortexError(f"no point has a region: choose an array with labels of 0 and more, {name} has none")
    labels = _of_all_vertices(data, values.astype(np.int64), -1)
    rows = sorted(known)
    unknown = set(np.unique(labels)) - set(rows) - {-1}
    if unknown:
        raise CortexError(f"the label {min(unknown)} of {name} has no name")
    index = np.full(len(labels), -1, np.int32)
    for k, label in enumerate(rows):
        index[labels == label] = k
    names, colours = zip(*_told_apart([known[label] for label in rows], warn))
    table = np.array([[*colour[:3], 255 - colour[3], 0] for colour in colours], np.int32)
    nibabel().freesurfer.io.write_annot(path, index, table, [text.encode() for text in names], fill_ctab=True)


def _write_label(path, data, values):
    """FreeSurfer's text: a comment, the number of vertices, and for each its number, x, y, z and a value."""
    chosen = np.flatnonzero(values)
    array = data.GetPointData().GetArray("SurfacePoints")
    points = vtk_to_numpy(array) if array else _points(data)
    numbers = vertex_numbers(data)
    with open(path, "w", encoding="ascii") as stream:
        stream.write(f"#!ascii label\n{len(chosen)}\n")
        for k in chosen:
            x, y, z = points[k]
            stream.write(f"{numbers[k]} {x:.6f} {y:.6f} {z:.6f} {float(values[k]):.6f}\n")


def _write_freesurfer_surface(path, data, warn):
    in_patient_space, matrix = _place(data)
    if matrix is not None and not np.allclose(matrix[:3, :3] @ matrix[:3, :3].T, np.eye(3), atol=TURN_TOLERANCE):
        warn(
            "the place of the surface in the patient is lost: a file of FreeSurfer tells it by a turn and a shift, but "
            "the PatientMatrix stretches or shears: apply Patient Space before"
        )
        matrix = None
    information = None
    if in_patient_space or matrix is not None:
        information = _volume_of_surface(np.eye(4) if matrix is None else matrix)
        information["head"] = [USE_REAL_RAS, int(in_patient_space), SURFACE_GEOMETRY]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of nibabel, which does not know the coordinates of the scanner
        nibabel().freesurfer.io.write_geometry(
            path,
            _of_all_vertices(data, _points(data).astype(np.float32)),
            _faces_of_all_vertices(data),
            volume_info=information,
        )


def _volume_of_surface(matrix):
    """FreeSurfer's description of a volume whose surface RAS the matrix leads to scanner RAS: surface RAS are 0 at the
    middle of the volume, where scanner RAS are c_ras, and the sizes cancel out. Of coordinates that are scanner RAS
    both are the same, so that programs that do not look at useRealRAS find the place, too."""
    x, y, z = (matrix[:3, :3] @ SURFACE_AXES).T
    return {
        "valid": "1  # volume info valid",
        "filename": "unknown",
        "volume": [256, 256, 256],
        "voxelsize": [1.0, 1.0, 1.0],
        "xras": x,
        "yras": y,
        "zras": z,
        "cras": matrix[:3, 3],
    }
