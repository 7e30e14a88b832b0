# SPDX-License-Identifier: GPL-3.0-or-later
"""A series of DICOM slices as a Scan, read by pydicom; slices that are compressed need GDCM as well.

The place of a slice is that of its own header, so that a CT with a tilted gantry gets a sheared matrix, and slices
that are missing become interpolated ones instead of a scan that is too short. Both are reported.
"""

import os

import numpy as np
from surfaceflattening_orientation import RAS_OF_LPS, Placement, fault_of
from surfaceflattening_scans import Scan, ScanError

CONVERTER = "dcm2niix (package dcm2niix) makes a NIfTI file of it, which can be read"

# How far a slice may lie from its place, in shares of the distance between slices. Scanners round positions to some
# 1e-4 mm; more than a tenth is a slice of another spacing, not rounding.
SPACING_AGREES = 0.1

# Degrees between the normal of the slices and the way from slice to slice, below which a tilt is rounding.
LEAST_TILT = 0.1

# Difference of direction cosines between slices of one stack: they are written with six digits.
SAME_DIRECTION = 1e-4

# Relative difference of the sizes of pixels of one stack, which are written with four digits or more: a greater one
# moves the last pixel of a row of 512 by more than a tenth.
SAME_SIZE = 2e-4

# Distance of slices along their normal, in mm, below which they are at one position: no scanner has thinner slices, and
# the positions of repeated ones differ by rounding.
SAME_POSITION = 1e-3

# What says where an image lies in the patient.
PLACE = ("ImageOrientationPatient", "ImagePositionPatient", "PixelSpacing")

# Cosine of the angle between rows and columns, which are at right angles in every image: six digits leave 1e-6.
PERPENDICULAR = 1e-2


class DICOMScan(Scan):
    name = "DICOM"

    def __init__(self, path):
        try:
            self._read_headers(path)
        except (ScanError, OSError):
            raise
        except Exception as error:  # a number that is none, a list of three that has two
            raise ScanError(f"{path}: the headers of the series cannot be understood: {error}. {CONVERTER}") from None

    def _read_headers(self, path):
        warnings = []
        images, chosen = _series(path, warnings)
        slices = _stack(images, chosen, path, warnings)
        self._files = [item.filename for item in slices]
        self._places, step = _places(slices, warnings)
        first, columns, rows = slices[0], int(slices[0].Columns), int(slices[0].Rows)
        down, across = (float(size) for size in first.PixelSpacing)
        x, y = _axes(first)
        matrix = np.eye(4)
        matrix[:3, :3] = np.column_stack([x * across, y * down, step])
        matrix[:3, 3] = _position(first)
        fault = fault_of(matrix)
        if fault:
            raise ScanError(f"{path}: the orientation of the series cannot be used, because {fault}")
        _report_tilt(x, y, step, warnings)
        placement = Placement(RAS_OF_LPS @ matrix, "DICOM image orientation and position", warnings)
        shape = (columns, rows, self._places[-1] + 1)
        super().__init__(shape, (across, down, np.linalg.norm(step)), placement)

    def load(self):
        pydicom = _pydicom()
        stack = [self._pixels(pydicom, file) for file in self._files]
        kind = np.result_type(*(pixels.dtype for pixels in stack))
        # Interpolated slices of integers are rounded, as the scanner would round them.
        volume = np.empty((self.shape[0], self.shape[1], self.shape[2]), kind, order="F")
        for place, pixels in zip(self._places, stack):
            volume[:, :, place] = pixels.T
        for k, (low, high) in enumerate(zip(self._places, self._places[1:])):
            for missing in range(low + 1, high):
                share = (missing - low) / (high - low)
                between = (1 - share) * stack[k].T + share * stack[k + 1].T
                volume[:, :, missing] = between if kind.kind == "f" else np.rint(between)
        return volume

    def _pixels(self, pydicom, file):
        try:
            item = pydicom.dcmread(file)
            pixels = item.pixel_array
            slope, intercept = _number(item, "RescaleSlope", 1.0), _number(item, "RescaleIntercept", 0.0)
        except (ImportError, RuntimeError, NotImplementedError) as error:
            # pydicom's message names its handlers (since version 3: plugins), which helps nobody.
            absent = "handlers" in str(error) or "plugins" in str(error)
            raise ScanError(
                f"{file}: its compression, {item.file_meta.TransferSyntaxUID.name}, cannot be read here (the package "
                f"python3-gdcm brings most of them): {CONVERTER}{'' if absent else f'. {error}'}"
            ) from None
        except Exception as error:  # decoders have exceptions of their own for damaged files
            raise ScanError(f"{file}: the pixels cannot be read, the file may be damaged: {error}") from None
        if pixels.ndim != 2:
            raise ScanError(f"{file}: an image has {pixels.ndim} dimensions, not 2: {CONVERTER}")
        return _true_values(pixels, slope, intercept)


def _true_values(pixels, slope, intercept):
    """Slope and intercept applied: integers that remain integers, as the Hounsfield units of a CT, in 32 bits if these
    hold them; other numbers in single precision if that holds the stored ones."""
    integers = all(number.is_integer() and abs(number) < 1 << 30 for number in (slope, intercept))  # within 64 bits
    if pixels.dtype.kind == "f" or not integers:
        return (pixels * slope + intercept).astype(np.float32 if pixels.dtype.itemsize <= 2 else np.float64)
    values = pixels.astype(np.int64) * int(slope) + int(intercept)
    limits = np.iinfo(np.int32)
    fits = limits.min <= values.min() and values.max() <= limits.max
    return values.astype(np.int32) if fits else values


def _number(item, name, usual):
    """A number of a header, which may be absent or empty."""
    value = item.get(name)
    return usual if value in (None, "") else float(value)


def _pydicom():
    try:
        import pydicom
    except ImportError:
        raise ScanError(
            "the orientation of a DICOM series is read by pydicom, which this Python does not have: install "
            "the package python3-pydicom"
        ) from None
    return pydicom


def _series(path, warnings):
    """The headers of a series, and the chosen one among them: the series of the file @path and this file, or the
    longest series in the folder @path and None."""
    folder = path if os.path.isdir(path) else os.path.dirname(os.path.abspath(path))
    images, faults = _headers(folder)
    if faults:
        name, reason = next(iter(faults.items()))
        warnings.append(
            f"{_count(faults, 'file')} could not be read (the first: {name}: {reason}): slices may be missing"
        )
    series = {}
    for item in images:
        series.setdefault(item.SeriesInstanceUID, []).append(item)
    if not os.path.isdir(path):
        chosen = _chosen(images, faults, path)
        return series[chosen.SeriesInstanceUID], chosen
    if not series:
        reason = "; ".join(warnings) or f"if they have no preamble, {CONVERTER}"
        raise ScanError(f"{path}: there are no DICOM images: {reason}")
    found = max(series.values(), key=len)
    if len(series) > 1:
        warnings.append(
            f"the folder has {len(series)} series: the longest, of {len(found)} images, is taken "
            f"({found[0].get('SeriesDescription', found[0].SeriesInstanceUID)}); choose a file of another"
        )
    return found, None


def _headers(folder):
    """The headers of the images in a folder, and the reasons why others cannot be read, by their names."""
    pydicom = _pydicom()
    images, faults = [], {}
    for name in sorted(os.listdir(folder)):
        file = os.path.join(folder, name)
        if os.path.exists(file) and not os.path.isfile(file):
            continue
        try:
            item = _header(file)
        except pydicom.errors.InvalidDicomError:
            continue  # not a DICOM file
        except PermissionError:
            raise ScanError(
                f"{file}: there is no permission to read the file: give it, or take the file out of the folder"
            ) from None
        except OSError as error:  # a link that leads nowhere
            faults[name] = error.strerror or str(error)
        except Exception:  # pydicom has many for damaged files
            faults[name] = "its header is damaged or cut short"
        else:
            images += [] if item is None else [item]
    return images, faults


def _header(file):
    """The header of an image; None for other DICOM files, such as reports. Raises what pydicom raises."""
    item = _pydicom().dcmread(file, stop_before_pixels=True)
    item.filename = file  # pydicom has none for deflated files
    if "Rows" in item and "SeriesInstanceUID" in item:
        return item
    kind = item.file_meta.get("MediaStorageSOPClassUID") or item.get("SOPClassUID")
    if kind is None or "Image Storage" in kind.name:
        raise ValueError("pydicom reads what there is of a header that is cut short")
    return None


def _chosen(images, faults, path):
    """The header of the file @path."""
    for item in images:
        if os.path.samefile(item.filename, path):
            return item
    fault = faults.get(os.path.basename(path))
    if fault:
        raise ScanError(f"{path}: the file cannot be read: {fault}")
    raise ScanError(
        f"{path}: this is no DICOM image (if it has no preamble, {CONVERTER}), nor of another format that is known by "
        "its extension"
    )


def _count(items, noun):
    return f"{len(items)} {noun}{'' if len(items) == 1 else 's'}"


def _stack(images, chosen, path, warnings):
    """The images that lie in parallel planes, sorted along their normal, one for each position."""
    if any(int(item.get("NumberOfFrames", 1) or 1) > 1 for item in images):
        raise ScanError(f"{path}: these files have several frames each: {CONVERTER}")
    if any("MOSAIC" in (item.get("ImageType") or []) for item in images):
        raise ScanError(f"{path}: each of these images is a mosaic of several slices: {CONVERTER}")
    parallel = _parallel(images, chosen, path)
    known = {id(item) for item in parallel}
    others = [item for item in images if id(item) not in known]
    if others:
        warnings.append(
            f"{_count(others, 'image')} of another size or direction, or without a place, "
            f"{'is' if len(others) == 1 else 'are'} left out (the first: {os.path.basename(others[0].filename)}); "
            "choose one of these for a volume of theirs"
        )
    x, y = _axes(parallel[0])
    if not abs(x @ y) < PERPENDICULAR:
        raise ScanError(f"{path}: the orientation cannot be used, because rows and columns are not at right angles")
    stack = _one_each(parallel, np.cross(x, y))
    if len(stack) < len(parallel):
        warnings.append(
            f"{len(parallel) - len(stack)} images lie where another one does, as in a series over time: the first "
            "at each position is taken"
        )
    if len(stack) < 2:
        remedy = "choose the folder of a volume"
        if others:
            remedy = f"choose one of the other images of the series, such as {others[0].filename}"
        raise ScanError(f"{path}: the series has one slice of this size and direction: {remedy}")
    return stack


def _parallel(images, chosen, path):
    """The images of the size and direction of the chosen one, or, without one, of the most frequent."""
    placed = [item for item in images if all(item.get(name) for name in PLACE)]
    if not placed or (chosen is not None and not all(chosen.get(name) for name in PLACE)):
        raise ScanError(f"{path}: the images do not say where they lie in the patient: {CONVERTER}")
    if chosen is not None:
        return [item for item in placed if _same_grid(item, chosen)]
    groups = []
    for item in placed:
        for group in groups:
            if _same_grid(item, group[0]):
                group.append(item)
                break
        else:
            groups.append([item])
    return max(groups, key=len)


def _same_grid(one, other):
    return (
        (one.Rows, one.Columns) == (other.Rows, other.Columns)
        and np.allclose(one.PixelSpacing, other.PixelSpacing, rtol=SAME_SIZE, atol=0)
        and np.abs(np.subtract(one.ImageOrientationPatient, other.ImageOrientationPatient)).max() < SAME_DIRECTION
    )


def _one_each(images, normal):
    """The images sorted along the normal; of several at one position the first by their numbers in the series."""
    positions = []
    for item in sorted(images, key=lambda item: _position(item) @ normal):
        if positions and (_position(item) - _position(positions[-1][0])) @ normal <= SAME_POSITION:
            positions[-1].append(item)
        else:
            positions.append([item])
    return [min(found, key=lambda item: (int(item.get("InstanceNumber") or 0), item.filename)) for found in positions]


def _places(slices, warnings):
    """The index of each slice, and the way from one index to the next, in mm (LPS+)."""
    positions = np.array([_position(item) for item in slices])
    normal = np.cross(*_axes(slices[0]))
    heights = (positions - positions[0]) @ normal
    gaps = np.diff(heights)
    spacing = np.median(gaps)
    counts = np.maximum(np.rint(gaps / spacing), 1)
    if (np.abs(gaps / spacing - counts) > SPACING_AGREES).any():
        odd = int(np.argmax(np.abs(gaps / spacing - counts)))
        raise ScanError(
            f"{slices[odd].filename}: the distance to the next slice is {gaps[odd]:.4g} mm, where others are "
            f"{spacing:.4g} mm apart: slices that are not evenly spaced are no volume. {CONVERTER}"
        )
    places = [0, *np.cumsum(counts).astype(int).tolist()]
    if places[-1] >= len(places):
        after = int(np.argmax(counts > 1))
        missing = places[-1] + 1 - len(places)
        warnings.append(
            f"{missing} {'slice is' if missing == 1 else 'slices are'} missing (the first after slice {after + 1} of "
            f"{len(slices)}): their place is filled by interpolation"
        )
    step = (positions[-1] - positions[0]) / places[-1]
    _require_row(slices, positions, places, step, SPACING_AGREES * spacing)
    return places, step


def _require_row(slices, positions, places, step, tolerance):
    """Raises ScanError if a slice lies farther than the tolerance, in mm, from its place in a row of even steps. Its
    height along the normal does not show that: the slice may lie aside."""
    if np.linalg.norm(positions - positions[0] - np.outer(places, step), axis=1).max() <= tolerance:
        return
    # A slice that lies aside tilts the whole row, so that the greatest distance may be that of another one.
    counts = np.diff(places)[:, None]
    ways = np.diff(positions, axis=0)
    aside = np.linalg.norm(ways - counts * np.median(ways / counts, axis=0), axis=1)
    odd = int(np.argmax(aside))
    raise ScanError(
        f"{slices[odd].filename}: the next slice, {slices[odd + 1].filename}, lies {aside[odd]:.4g} mm from where the "
        "steps between the others lead, as if the patient had been moved or the series had several parts: such slices "
        "are no volume. Put the files of one part into a folder of their own"
    )


def _report_tilt(x, y, step, warnings):
    cosine = abs(step @ np.cross(x, y)) / np.linalg.norm(step)
    tilt = np.degrees(np.arccos(min(cosine, 1.0)))
    if tilt > LEAST_TILT:
        warnings.append(
            f"the way from slice to slice is tilted by {tilt:.2f} degrees, as by a tilted gantry: the voxels are sheared, "
            "and areas are right only after Patient Space"
        )


def _axes(item):
    cosines = np.array([float(number) for number in item.ImageOrientationPatient])
    x, y = cosines[:3], cosines[3:]
    return x / np.linalg.norm(x), y / np.linalg.norm(y)


def _position(item):
    return np.array([float(number) for number in item.ImagePositionPatient])
