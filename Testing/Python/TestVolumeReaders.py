# SPDX-License-Identifier: GPL-3.0-or-later
"""One phantom in every format that scans come in becomes the same disk: the readers that OpenDataFile takes, which are
those that keep the orientation, the recipe of surfaceflattening_volume and Surface To Disk."""

import math
import os
import tarfile
import tempfile

import numpy as np
import VolumeFiles
from paraview import servermanager, simple
from paraview.simple import OpenDataFile, SurfaceToDisk
from surfaceflattening_volume import cast_to_float, contour, isosurface, metaimage_of_invesalius, pad, smooth
from vtkmodules.util.numpy_support import vtk_to_numpy

SPACING = (1.0, 1.0, 1.5)  # mm
RADIUS = 13.0
ISOVALUE = 300


def folded_ball():
    """Folds of 2 mm on a ball; intensity falls by 100 per mm. No symmetry, so that a volume which is turned
    or upside down gives another surface."""
    z, y, x = np.meshgrid(*(np.arange(n) for n in (25, 38, 40)), indexing="ij")
    x, y, z = x * SPACING[0] - 18.0, y * SPACING[1] - 19.0, z * SPACING[2] - 17.0
    folds = 1.5 * np.sin(0.5 * x + 1.0) * np.sin(0.45 * y) + 0.15 * z
    depth = RADIUS + folds - np.sqrt(x * x + y * y + z * z)
    return np.clip(ISOVALUE + 100.0 * depth, -1000, 2000).astype(np.int16)


def fetch(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def figure(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def disk_of(image):
    return fetch(SurfaceToDisk(Input=isosurface(image, ISOVALUE).surface))


def message_of(error, function, *arguments):
    try:
        function(*arguments)
    except error as raised:
        return str(raised)
    raise AssertionError(f"{function.__name__}{arguments}: no {error.__name__}")


def close(one, other):
    return math.isclose(one, other, rel_tol=1e-6)


def check_readers(folder, phantom):
    def path(name):
        return os.path.join(folder, name)

    VolumeFiles.write_nifti(path("phantom.nii"), phantom, SPACING)
    VolumeFiles.write_metaimage(path("phantom.mha"), phantom, SPACING)
    VolumeFiles.write_nrrd(path("phantom.nrrd"), phantom, SPACING)
    VolumeFiles.write_vti(path("phantom.vti"), phantom, SPACING)
    # ParaView's DICOM reader turns a volume about x by half a turn (which is no mirror image); so do we.
    VolumeFiles.write_dicom_series(path("series"), phantom[::-1, ::-1], SPACING)
    VolumeFiles.write_invesalius(path("phantom.inv3"), phantom, SPACING)
    images = {
        "VTK image": OpenDataFile(path("phantom.vti")),
        "NIfTI": OpenDataFile(path("phantom.nii")),
        "MetaImage": OpenDataFile(path("phantom.mha")),
        "NRRD": OpenDataFile(path("phantom.nrrd")),
        "DICOM series": simple.DICOMReaderdirectory(FileName=path("series")),
        "InVesalius": OpenDataFile(metaimage_of_invesalius(path("phantom.inv3"), path("unpacked"))),
    }
    slices = os.listdir(path("series"))
    scans = [images[name] for name in ("MetaImage", "NRRD", "InVesalius")]
    for image in (*scans, OpenDataFile(path("phantom.inv3")), OpenDataFile(os.path.join(path("series"), slices[0]))):
        assert image.GetXMLName() == "AnatomicalScanReader", (image.FileName, image.GetXMLName())
    expected = None
    for name, image in images.items():
        volume = fetch(image)
        assert volume.GetDimensions() == phantom.shape[::-1], (name, volume.GetDimensions())
        for size, true_size in zip(volume.GetSpacing(), SPACING):
            assert close(size, true_size), (name, volume.GetSpacing())
        values = vtk_to_numpy(volume.GetPointData().GetScalars()).reshape(phantom.shape)
        assert np.array_equal(values, phantom), name

        disk = disk_of(image)
        box = disk.GetBounds()
        found = {
            "points": disk.GetNumberOfPoints(),
            "faces": disk.GetNumberOfCells(),
            "area": figure(disk, "SurfaceArea"),
            "removed": figure(disk, "RemovedArea"),
            **{f"size {axis}": box[2 * k + 1] - box[2 * k] for k, axis in enumerate("xyz")},
        }
        print(name, found)
        expected = expected or found
        for key in expected:
            assert close(found[key], expected[key]), (name, key, found[key], expected[key])
        # Euler number 1 with one boundary: V - (3 F + B) / 2 + F.
        boundary = figure(disk, "BoundaryVertices")
        assert found["points"] - (3 * found["faces"] + boundary) / 2 + found["faces"] == 1
    # Areas are in mm^2; the folds add to the area of the ball.
    assert 1.0 < (expected["area"] + expected["removed"]) / (4 * math.pi * RADIUS**2) < 1.2
    return images["VTK image"]


def check_steps(image):
    # The single steps give what the filter gives, and none of them is needed.
    floating = cast_to_float(image)
    padded = pad(floating, 4, -1024)
    smoothed = smooth(padded, 1.5)
    assert list(smoothed.StandardDeviations) == [1.5, 1.5, 1.0]  # voxels
    assert list(padded.OutputWholeExtent) == [-4, 43, -4, 41, -4, 28]
    assert padded.Constant == -1024
    steps = fetch(contour(smoothed, ISOVALUE, "Single steps"))
    names = {name for name, _id in simple.GetSources()}
    assert {"Float", "Padded", "Smoothed, 1.5 mm", "Single steps"} <= names, names
    whole = fetch(isosurface(image, ISOVALUE, smoothing_mm=1.5, padding=4, background=-1024).surface)
    assert whole.GetNumberOfPoints() == steps.GetNumberOfPoints() > 1000
    # The points come in another order.
    one, other = (np.sort(vtk_to_numpy(surface.GetPoints().GetData()), axis=0) for surface in (whole, steps))
    assert np.abs(one - other).max() < 1e-4, np.abs(one - other).max()
    unsmoothed = isosurface(image, ISOVALUE, smoothing_mm=0, padding=0)
    assert fetch(SurfaceToDisk(Input=unsmoothed.surface)).GetNumberOfCells() > 0


def check_errors(folder, image):
    assert "greatest value" in message_of(ValueError, contour, image, 5000)
    assert "standard deviation" in message_of(ValueError, smooth, image, 0)
    assert "margin" in message_of(ValueError, pad, image, 0)
    assert "not an image" in message_of(ValueError, isosurface, simple.Sphere(), 1)
    coloured = simple.ProgrammableFilter(
        Input=image,
        Script="from vtkmodules.vtkCommonCore import vtkUnsignedCharArray\n"
        "rgb = vtkUnsignedCharArray()\n"
        "rgb.SetNumberOfComponents(3)\n"
        "rgb.SetNumberOfTuples(self.GetOutput().GetNumberOfPoints())\n"
        "rgb.SetName('RGB')\n"
        "self.GetOutput().GetPointData().SetScalars(rgb)\n",
    )
    assert "3 values" in message_of(ValueError, isosurface, coloured, 1)
    slice_only = simple.ExtractSubset(Input=image, VOI=[0, 39, 0, 37, 5, 5])
    assert "flat" in message_of(ValueError, isosurface, slice_only, 1)
    broken = os.path.join(folder, "broken.inv3")
    with tarfile.open(broken, "w"):
        pass
    assert "main.plist" in message_of(ValueError, metaimage_of_invesalius, broken, folder)


with tempfile.TemporaryDirectory() as scratch:
    vtk_image = check_readers(scratch, folded_ball())
    check_steps(vtk_image)
    check_errors(scratch, vtk_image)
