# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a surface, or a volume, from one file into VTK; what goes wrong is an exception."""

import os
import re

import plugin_modules  # noqa: F401
from file_lengths import FileLengthError, check_length
from surfaceflattening_scans import ScanError, read_scan, scan_of
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

SURFACE_READERS = {
    ".vtk": vtkPolyDataReader,
    ".vtp": vtkXMLPolyDataReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".obj": vtkOBJReader,
}
SCANS = (".nii", ".nii.gz", ".mha", ".mhd", ".nrrd", ".nhdr")  # which say where they lie in the patient
VOLUMES = (*SCANS, ".vti")
TEXT_HEADERS = (".mha", ".mhd", ".nrrd", ".nhdr")  # which may name other files that have the voxels
NO_TEXT = "VTK's message quotes the file or its name, and that is not UTF-8"


class CaseError(Exception):
    """Why a case has no result, in words for the summary."""


class Messages:
    """The errors and warnings of some algorithms while it is open, or with none those of all VTK."""

    def __init__(self, *algorithms):
        self.errors = []
        self.warnings = []
        self._tags = []
        observed = [a for algorithm in algorithms for a in (algorithm, algorithm.GetExecutive())]
        observed = observed or [vtkOutputWindow.GetInstance()]
        for event, texts in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
            for item in observed:
                self._tags.append((item, item.AddObserver(event, self._recorder(texts))))

    @staticmethod
    def _recorder(texts):
        def record(_caller, _event, text=""):
            texts.append(cause(text or NO_TEXT))

        record.CallDataType = "string0"
        return record

    def __enter__(self):
        return self

    def __exit__(self, *_exception):
        for item, tag in self._tags:
            item.RemoveObserver(tag)


def cause(text):
    """The message in one line, without VTK's source file, class and address before it."""
    text = " ".join(text.split()).split("): ", 1)[-1]
    return re.sub(r"^Generic Warning: In \S+, line \d+ ", "", text)


def extension(path):
    name = path.lower()
    return ".nii.gz" if name.endswith(".nii.gz") else os.path.splitext(name)[1]


def is_volume(path):
    """Tells by its extension whether the file is a volume. Raises CaseError if the extension is unknown."""
    if extension(path) in VOLUMES:
        return True
    if extension(path) in SURFACE_READERS:
        return False
    known = ", ".join([*SURFACE_READERS, *VOLUMES])
    raise CaseError(f"unknown kind of file {extension(path) or path}: known are {known}")


def voxel_files(path):
    """The files beside this one that its header names; none for other kinds of files, and if the header is damaged,
    which is the reason of the case when it is read."""
    if extension(path) not in TEXT_HEADERS:
        return []
    try:
        return [file for file in scan_of(path).files if file != path]
    except Exception:  # whatever is wrong with one header, the other cases go on
        return []


def _scan(path, warnings):
    try:
        return read_scan(path, warn=lambda text: warnings.append(text.removeprefix(f"{path}: ")))
    except ScanError as error:
        text = str(error).removeprefix(f"{path}: ")
        raise CaseError(f"cannot be read, the file may be damaged: {text}") from None


def read(path, warnings):
    """The polydata or image in a file. Raises CaseError.

    @warnings: gets what the user should know of a file that was read.
    """
    volume = is_volume(path)
    if not os.path.isfile(path):
        raise CaseError(f"there is no file {path}")
    try:
        warnings += check_length(path, extension(path))
    except FileLengthError as error:
        raise CaseError(str(error)) from None
    except OSError as error:
        raise CaseError(f"cannot read the file: {error.strerror or error}") from None
    with Messages() as messages:  # readers warn of a truncated file, and go on with what was in memory
        if extension(path) in SCANS:
            data = _scan(path, warnings)
        else:
            reader = vtkXMLImageDataReader() if volume else SURFACE_READERS[extension(path)]()
            reader.SetFileName(os.fsencode(path))  # VTK refuses a str that is not UTF-8
            reader.Update()
            data = reader.GetOutput()
    for text in messages.errors + messages.warnings:
        raise CaseError(f"cannot be read, the file may be damaged: {text}")
    if data is None or data.GetNumberOfPoints() == 0:
        raise CaseError("there are no points in it; the file may be damaged")
    return data
