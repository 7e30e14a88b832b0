# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a small surface or volume in each format that the project reads."""

import gzip
import os
import sys

import numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Testing", "Python"))

import VolumeFiles

SPACING = (1.0, 1.0, 1.5)
ISOVALUE = 300.0
SLICES = 8  # the writer of DICOM files allows no multiple of 7; fewer than 10 columns are components to VTK in NRRD


def write_small_files(folder):
    """Returns lists of paths by format; a DICOM series is a folder."""
    os.makedirs(folder, exist_ok=True)
    found = {}
    for closed in (False, True):
        for extension, writer, settings in (
            ("vtk", vtkPolyDataWriter, "SetFileTypeToASCII"),
            ("vtk", vtkPolyDataWriter, "SetFileTypeToBinary"),
            ("vtp", vtkXMLPolyDataWriter, "SetDataModeToAscii"),
            ("vtp", vtkXMLPolyDataWriter, "SetDataModeToBinary"),
            ("vtp", vtkXMLPolyDataWriter, "SetDataModeToAppended"),
            ("ply", vtkPLYWriter, "SetFileTypeToASCII"),
            ("ply", vtkPLYWriter, "SetFileTypeToBinary"),
            ("stl", vtkSTLWriter, "SetFileTypeToASCII"),
            ("stl", vtkSTLWriter, "SetFileTypeToBinary"),
            ("obj", vtkOBJWriter, None),
        ):
            paths = found.setdefault(extension, [])
            paths.append(os.path.join(folder, f"surface{int(closed)}{len(paths)}.{extension}"))
            writer = writer()
            writer.SetInputData(_sphere(closed))
            writer.SetFileName(paths[-1])
            if settings:
                getattr(writer, settings)()
            assert writer.Write()
    values = _ball()
    for extension, write in (
        ("nii", VolumeFiles.write_nifti),
        ("mha", VolumeFiles.write_metaimage),
        ("nrrd", VolumeFiles.write_nrrd),
        ("vti", VolumeFiles.write_vti),
        ("dicom", VolumeFiles.write_dicom_series),
    ):
        found[extension] = [os.path.join(folder, f"ball.{extension}")]
        write(found[extension][0], values, SPACING)
    found["nii.gz"] = [os.path.join(folder, "ball.nii.gz")]
    with open(found["nii"][0], "rb") as stream, open(found["nii.gz"][0], "wb") as packed:
        packed.write(gzip.compress(stream.read(), mtime=0))
    return found


def _sphere(closed):
    source = vtkSphereSource()
    source.SetEndPhi(180 if closed else 100)
    source.SetThetaResolution(8)
    source.SetPhiResolution(6)
    source.Update()
    return source.GetOutput()


def _ball():
    z, y, x = numpy.indices((SLICES, 8, 12)).astype(float)
    distance = numpy.sqrt((1.5 * (z - 3.6)) ** 2 + (y - 3.6) ** 2 + (x - 5.4) ** 2)
    return numpy.clip(ISOVALUE + 100.0 * (2.4 - distance), -1000, 2000).astype(numpy.int16)
