# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the voxels of a scan lie in the patient, by what the headers of the formats say.

A Placement has a matrix that takes the index of a voxel to RAS+ millimetres: x grows to the patient's right,
y to the front, z to the top. Each format has its own way to say so; DICOM, MetaImage and NRRD count to the left
and to the back (LPS+). This module needs numpy alone.
"""

import os
import re
from dataclasses import dataclass, field

import numpy as np

RAS_OF_LPS = np.diag([-1.0, -1.0, 1.0, 1.0])

# The volume of a voxel, relative to the product of its edges, below which it is flat. The filter Patient Space has the
# same bound, for the same reason.
LEAST_VOLUME = 1e-6

# Quaternions are in single precision, which moves the voxels of a head by up to 1e-4 mm. A distance below this one
# says nothing about the file; a much greater one would hide that it was realigned in one form only.
FORMS_AGREE = 1e-2  # mm

# Relative. Header and matrix are both in single precision, and sizes come from norms of three numbers.
SIZES_AGREE = 1e-3

# The square of the fourth number of a quaternion that single precision cannot tell from 0; nibabel has the same
# bound. Without it, rotations by half a turn would be off by 6e-4, the root of it.
QUATERNION_ZERO = 3 * np.finfo(np.float32).eps


# The names of units in headers, in mm. The letter for micro has two codes in Unicode, and one of its own in Latin-1.
MILLIMETRES = {
    **dict.fromkeys(("nm", "nanometer", "nanometre"), 1e-6),
    **dict.fromkeys(("um", "\u00b5m", "\u03bcm", "\udcb5m", "micron", "micrometer", "micrometre"), 1e-3),
    **dict.fromkeys(("mm", "millimeter", "millimetre"), 1.0),
    **dict.fromkeys(("cm", "centimeter", "centimetre"), 10.0),
    **dict.fromkeys(("m", "meter", "metre"), 1000.0),
}


@dataclass
class Placement:
    """@matrix: voxel index to RAS+ mm, or None. @source: what it is made of, in words."""

    matrix: object
    source: str
    warnings: list = field(default_factory=list)


def fault_of(matrix):
    """Why a 4 x 4 matrix cannot place voxels, or None."""
    if not np.isfinite(matrix).all():
        return "it is not finite"
    linear = matrix[:3, :3]
    sizes = np.linalg.norm(linear, axis=0)
    if not abs(np.linalg.det(linear)) > LEAST_VOLUME * sizes.prod():
        return "it is singular"
    return None


def voxel_sizes(matrix):
    return np.linalg.norm(matrix[:3, :3], axis=0)


def corners(shape):
    """The indices of the eight outermost voxels (8 x 4)."""
    grid = np.stack(np.meshgrid(*((0, n - 1) for n in shape), indexing="ij"), -1).reshape(-1, 3)
    return np.c_[grid, np.ones(8)]


def greatest_distance(one, other, shape):
    """How far two matrices place a voxel of a volume of this shape from each other, in mm."""
    return np.linalg.norm(corners(shape) @ (one - other).T, axis=1).max()


def letters(matrix):
    """The sides to which the axes of a matrix lead, as RAS or LPS."""
    linear = np.asarray(matrix)[:3, :3] / voxel_sizes(np.asarray(matrix))
    text = ""
    for axis in range(3):
        side = np.argmax(abs(linear[:, axis]))
        text += ("RAS" if linear[side, axis] > 0 else "LPI")[side]
    return text


def nifti_unit(header):
    """The unit of lengths of a NIfTI file in mm."""
    if not header.GetMagic().startswith("n"):
        return 1.0  # Analyze 7.5 has another number at that place of the header
    return {1: 1000.0, 3: 0.001}.get(header.GetXYZTUnits() & 7, 1.0)


def nifti_placement(header, shape):
    """By the sform, or the qform if there is none that can be used (https://nifti.nimh.nih.gov/nifti-1).

    @header: a vtkNIFTIImageHeader. @shape: the number of voxels along i, j and k.
    """
    if not header.GetMagic().startswith("n"):
        return Placement(None, "none", [_without("this is a file of Analyze 7.5, which has no orientation")])
    forms, warnings = {}, []
    if header.GetSFormCode() > 0:
        forms["sform"] = np.array([header.GetSRowX(), header.GetSRowY(), header.GetSRowZ(), (0, 0, 0, 1)])
    if header.GetQFormCode() > 0:
        forms["qform"] = _qform(header)
    scale = nifti_unit(header)
    for name, matrix in list(forms.items()):
        matrix[:3] *= scale
        fault = fault_of(matrix)
        if fault:
            warnings.append(f"the {name} is left out, because {fault}")
            del forms[name]
    if not forms:
        return Placement(None, "none", [*warnings, _without("the file has neither an sform nor a qform")])
    source = next(iter(forms))
    matrix = forms[source]
    if len(forms) == 2:
        distance = greatest_distance(forms["sform"], forms["qform"], shape)
        if distance > FORMS_AGREE:
            warnings.append(
                f"sform and qform differ by up to {distance:.4g} mm within the volume: the sform is taken, "
                f"whose axes lead to {letters(forms['sform'])} (qform: {letters(forms['qform'])})"
            )
    stated = np.abs([header.GetPixDim(k) for k in (1, 2, 3)]) * scale
    if not np.allclose(voxel_sizes(matrix), stated, rtol=SIZES_AGREE):
        warnings.append(
            f"the {source} has voxels of {_sizes(voxel_sizes(matrix))} mm, and the header says "
            f"{_sizes(stated)}: the {source} is taken"
        )
    return Placement(matrix, source, warnings)


def metaimage_placement(fields, unit):
    """By TransformMatrix and Offset, which are LPS+ as in ITK. @fields: of header_fields(). @unit: of lengths, in mm."""
    numbers = _numbers(fields, "transformmatrix", "rotation", "orientation")
    if len(numbers) != 9:
        return Placement(None, "none", [_without("the header has no TransformMatrix of nine numbers")])
    origin = _numbers(fields, "offset", "position", "origin")
    sizes = _numbers(fields, "elementspacing", "elementsize")
    matrix = np.eye(4)
    # A row of the header is an axis of the volume.
    matrix[:3, :3] = np.array(numbers).reshape(3, 3).T * (sizes if len(sizes) == 3 else 1.0)
    matrix[:3, 3] = origin if len(origin) == 3 else 0.0
    matrix[:3] *= unit
    return _checked(RAS_OF_LPS @ matrix, "TransformMatrix")


def nrrd_placement(fields):
    """By space, space directions and space origin (https://teem.sourceforge.net/nrrd/format.html)."""
    space = fields.get("space", "").lower().removesuffix("-time").removesuffix("t")
    to_ras = {
        "right-anterior-superior": np.eye(4),
        "ras": np.eye(4),
        "left-anterior-superior": np.diag([-1.0, 1.0, 1.0, 1.0]),
        "las": np.diag([-1.0, 1.0, 1.0, 1.0]),
        "left-posterior-superior": RAS_OF_LPS,
        "lps": RAS_OF_LPS,
    }.get(space)
    axes = [axis for axis in nrrd_directions(fields) if axis is not None]
    if to_ras is None or len(axes) != 3 or any(len(axis) != 3 for axis in axes):
        return Placement(
            None, "none", [_without("the header has no space, as left-posterior-superior, with three directions")]
        )
    origin = _in_space(fields, _vector(fields.get("space origin", "").rstrip(")")))
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(axes).T
    matrix[:3, 3] = origin if len(origin) == 3 else 0.0
    return _checked(to_ras @ matrix, "space directions")


def _in_space(fields, vector):
    """A vector of a NRRD in mm."""
    units, _warnings = units_of(fields.get("space units", ""), len(vector))
    return [number * unit for number, unit in zip(vector, units)]


def units_of(text, count):
    """The units in a list such as "um" "um" "um", in mm, and what is odd about it. Units that are not there or not
    known are mm."""
    names = [name.strip() for name in re.findall(r'"([^"]*)"', text) or text.split()]
    known = [MILLIMETRES.get(name.lower().removesuffix("s")) for name in names]
    odd = sorted({name for name, unit in zip(names, known) if unit is None and name not in ("", "?")})
    warnings = [f"the header has lengths in {name}, a unit that is not known: they are taken for mm" for name in odd]
    if len(names) not in (0, count):
        return [1.0] * count, [f"the header has {len(names)} units for {count} axes: lengths are taken for mm"]
    return [unit or 1.0 for unit in known] or [1.0] * count, warnings


def nrrd_directions(fields):
    """The vectors of the axes of a NRRD in mm, None for an axis that is not in space; nothing without space
    directions."""
    words = fields.get("space directions", "").replace(")", ") ").split()
    # A vector may have spaces within.
    text = " ".join(words).replace(", ", ",").replace("( ", "(").replace(" )", ")")
    vectors = [None if word.lower() == "none" else _vector(word.rstrip(")")) for word in text.split()]
    return [vector and _in_space(fields, vector) for vector in vectors]


def header_fields(path, separator):
    """The lines "name separator value" at the beginning of a file, with the names in lower case; the lines of a list of
    files that the header ends with; and the number of bytes of the header. It ends with an empty line, or with
    ElementDataFile."""
    fields, lines, ended = {}, [], False
    with open(path, "rb") as stream:
        end = 0
        for line in stream:
            text = line.decode("utf-8", "surrogateescape").strip()  # as names of files are
            if ended:
                lines.append(text)
                continue
            end = stream.tell()
            name, found, value = text.partition(separator)
            is_pair = value.startswith("=")  # key:=value of a NRRD, whatever the key is
            value = value.strip()
            if found and not is_pair and not text.startswith("#"):
                fields[name.strip().lower()] = value
            if not text or end > 1 << 20:
                break
            if name.strip() == "ElementDataFile" or name.strip().lower() in ("data file", "datafile"):
                if value.split()[:1] == ["LIST"]:
                    ended = True
                elif name.strip() == "ElementDataFile":
                    break
    return fields, [line for line in lines if line], end


def is_true(word):
    """Whether a word of a MetaImage header means yes."""
    return word.strip().lower() in ("true", "t", "1")


def named_file(folder, name):
    """The path of a file that a header names, in UTF-8, in the bytes of the file's own name, or in Latin-1."""
    path = os.path.join(folder, name)
    latin = os.path.join(folder, name.encode("utf-8", "surrogateescape").decode("latin-1"))
    return latin if os.path.exists(latin) and not os.path.exists(path) else path


def nearest_ras(matrix):
    """How to reorder the axes of a volume so that they lead to the patient's right, front and top as nearly as
    they can: (order, flips), the old axis for each new one, and whether it is turned round.

    Greedy by the greatest cosine, so that every old axis is used once; an axis at 45 degrees to two sides may
    go to either.
    """
    cosines = matrix[:3, :3] / voxel_sizes(matrix)
    left = np.abs(cosines)
    order, flips = [0, 0, 0], [False] * 3
    for _ in range(3):
        side, axis = np.unravel_index(np.argmax(left), (3, 3))
        order[side], flips[side] = int(axis), bool(cosines[side, axis] < 0)
        left[side], left[:, axis] = -1.0, -1.0
    return order, flips


def reordered_matrix(matrix, shape, order, flips):
    """The matrix of the volume after nearest_ras() was applied to its voxels."""
    old_of_new = np.zeros((4, 4))
    old_of_new[3, 3] = 1.0
    for new, (old, flip) in enumerate(zip(order, flips)):
        old_of_new[old, new] = -1.0 if flip else 1.0
        old_of_new[old, 3] = shape[old] - 1.0 if flip else 0.0
    return matrix @ old_of_new


def _qform(header):
    """Rotation by a quaternion of which three numbers are stored."""
    vector = np.array([header.GetQuaternB(), header.GetQuaternC(), header.GetQuaternD()])
    rest = 1.0 - vector @ vector
    if rest < -QUATERNION_ZERO:
        return np.full((4, 4), np.nan)
    a = 0.0 if rest < QUATERNION_ZERO else np.sqrt(rest)
    b, c, d = vector
    norm = a * a + b * b + c * c + d * d
    rotation = np.array(
        [
            [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c],
        ]
    )
    sizes = np.array([header.GetPixDim(k) for k in (1, 2, 3)])
    if header.GetPixDim(0) < 0:
        sizes[2] = -sizes[2]
    matrix = np.eye(4)
    matrix[:3, :3] = rotation / norm * sizes
    matrix[:3, 3] = header.GetQOffsetX(), header.GetQOffsetY(), header.GetQOffsetZ()
    return matrix


def _checked(matrix, source):
    fault = fault_of(matrix)
    if fault:
        return Placement(None, "none", [_without(f"the matrix of {source} is left out, because {fault}")])
    return Placement(matrix, source)


def _without(reason):
    return f"{reason}: the volume stays as it is, and its left and right are as the voxels are stored"


def _numbers(fields, *names):
    for name in names:
        if name in fields:
            return _floats(fields[name].split())
    return []


def _vector(text):
    return _floats(text.split("(")[-1].split(","))


def _floats(words):
    try:
        return [float(word) for word in words]
    except ValueError:
        return []


def _sizes(sizes):
    return " x ".join(f"{size:.4g}" for size in sizes)
