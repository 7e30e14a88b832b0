# SPDX-License-Identifier: GPL-3.0-or-later
"""Scan In Patient Space puts every value where nibabel says that it lies in the patient; slices of a scan, shown where
the patient is, and scans that cannot be shown there."""

import os
import tempfile

import nibabel
import numpy as np
from ImageBaseline import expect_baseline, expect_not_baseline
from paraview import servermanager, simple
from surfaceflattening_orientation import nearest_ras
from surfaceflattening_patient_volume import PatientVolumeError, in_patient_space
from surfaceflattening_scan_slices import show_scan_slices
from surfaceflattening_scans import place, read_scan
from surfaceflattening_volume import isosurface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

SHAPE = (21, 25, 19)


def turn(degrees, axis=(1, 2, 0.5)):
    axis = np.array(axis) / np.linalg.norm(axis)
    cross, angle = -np.cross(np.eye(3), axis), np.radians(degrees)
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)


def affine_of(linear):
    affine = np.eye(4)
    affine[:3, :3], affine[:3, 3] = linear, (-31.0, 17.25, 40.5)
    return affine


SHEAR = np.array([[1.0, 0, 0.3], [0, 1.1, 0.2], [0, 0, 1.4]])
AFFINES = {
    "upright": affine_of(np.diag([1.0, 1.0, 3.0])),
    "stored to the left, the back and the bottom": affine_of(np.diag([-1.0, -0.5, -2.0])),
    "sagittal": affine_of(np.array([[0, 0, 1.0], [1, 0, 0], [0, -1, 0]])),
    "oblique": affine_of(turn(17)),
    "oblique, sheared and mirrored": affine_of(turn(17) @ SHEAR @ np.diag([-1.0, 1, 1])),
}
SLOPES = np.array([0.7, -1.3, 0.4])


def ramp(affine):
    """A value that grows evenly along a slanted line in the patient: linear interpolation gives it exactly."""
    grid = np.stack(np.meshgrid(*map(np.arange, SHAPE), indexing="ij"), -1)
    return (nibabel.affines.apply_affine(affine, grid) @ SLOPES).astype(np.float32)


def saved(folder, values, affine, name="scan.nii"):
    image = nibabel.Nifti1Image(values, None)
    image.set_sform(affine, 2)
    image.header["pixdim"][1:4] = nibabel.affines.voxel_sizes(affine)
    path = os.path.join(folder, name)
    nibabel.save(image, path)
    return path


def values_and_places(volume):
    """The values of a vtkImageData, and where their voxels lie by origin and spacing."""
    values = vtk_to_numpy(volume.GetPointData().GetScalars())
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in volume.GetDimensions()), indexing="ij"), -1)
    places = grid.reshape(-1, 3, order="F") * volume.GetSpacing() + volume.GetOrigin()
    return values, places


def field(data, name):
    return data.GetFieldData().GetArray(name)


def check_places(folder):
    for name, affine in AFFINES.items():
        values = ramp(affine)
        scan = simple.OpenDataFile(saved(folder, values, affine))
        moved = simple.ScanInPatientSpace(Input=scan)
        moved.UpdatePipelineInformation()  # before anything was read, as when a state is loaded
        moved.UpdatePipeline()
        volume = servermanager.Fetch(moved)
        found, places = values_and_places(volume)
        index = nibabel.affines.apply_affine(np.linalg.inv(affine), places)
        inside = ((index > 1e-3) & (index < np.array(SHAPE) - 1 - 1e-3)).all(axis=1)
        error = np.abs(found - places @ SLOPES)[inside].max()
        print(f"{name}: {volume.GetDimensions()}, {inside.sum()} voxels inside, greatest error {error:.1e}")
        assert error < 1e-4 and inside.sum() > 0.4 * np.prod(SHAPE), (name, error, inside.sum())
        # All of the scan is in it, and what is around it is air.
        corners = nibabel.affines.apply_affine(affine, [(i, j, k) for i in (0, 20) for j in (0, 24) for k in (0, 18)])
        bounds = np.reshape(volume.GetBounds(), (3, 2))
        assert (bounds[:, 0] < corners.min(axis=0) + 1e-3).all() and (bounds[:, 1] > corners.max(axis=0) - 1e-3).all()
        outside = ((index < -1) | (index > np.array(SHAPE))).any(axis=1)
        assert (found[outside] == values.min()).all() and outside.any() == ("oblique" in name)
        assert field(volume, "InPatientSpace").GetTuple1(0) == 1 and field(volume, "PatientMatrix")
        if "oblique" not in name:
            canonical = nibabel.as_closest_canonical(nibabel.load(scan.FileName))
            assert np.array_equal(found.reshape(volume.GetDimensions(), order="F"), canonical.get_fdata())
            assert np.array_equal(volume.GetOrigin(), canonical.affine[:3, 3])
        # Once more it stays as it is.
        again = simple.ScanInPatientSpace(Input=moved)
        again.UpdatePipeline()
        assert servermanager.Fetch(again).GetOrigin() == volume.GetOrigin()
        for proxy in (again, moved, scan):
            simple.Delete(proxy)


def check_labels(folder):
    labels = np.random.default_rng(3).choice([0, 7, 41, 300], SHAPE).astype(np.int16)
    scan = simple.OpenDataFile(saved(folder, labels, AFFINES["oblique"], "labels.nii"))
    nearest = servermanager.Fetch(simple.ScanInPatientSpace(Input=scan, Interpolation="Nearest"))
    found, places = values_and_places(nearest)
    index = np.rint(nibabel.affines.apply_affine(np.linalg.inv(AFFINES["oblique"]), places)).astype(int)
    inside = ((index > 0) & (index < np.array(SHAPE) - 1)).all(axis=1)
    assert np.mean(found[inside] == labels[tuple(index[inside].T)]) > 0.999  # halfway between two voxels either is right
    assert set(np.unique(found)) == {0, 7, 41, 300}
    assert len(np.unique(vtk_to_numpy(in_patient_space(read_scan(scan.FileName)).GetPointData().GetScalars()))) > 4


def ball(affine):
    """A ball of 6 mm around the middle of the volume, brighter on the patient's right."""
    grid = nibabel.affines.apply_affine(affine, np.stack(np.meshgrid(*map(np.arange, SHAPE), indexing="ij"), -1))
    middle = nibabel.affines.apply_affine(affine, (np.array(SHAPE) - 1) / 2)
    away = np.linalg.norm(grid - middle, axis=-1)
    right = 1 + 0.06 * (grid[..., 0] - middle[0])
    return (np.clip(100 * (7 - away), 0, 200) * right).astype(np.float32), middle


def picture(folder, name, surface, slices, middle):
    view = simple.GetActiveView()
    view.CameraParallelProjection, view.CameraParallelScale = 1, 11.0
    view.CameraFocalPoint, view.CameraViewUp = middle, [0, 0, 1]
    view.CameraPosition = middle + np.array([30.0, 60.0, 40.0])
    for item in slices:
        simple.Show(item, view)
    display = simple.Show(surface, view)
    display.ColorArrayName = ["POINTS", ""]  # none
    display.SetRepresentationType("Wireframe")
    display.AmbientColor, display.LineWidth = [0.9, 0.5, 0.1], 1
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    path = os.path.join(folder, name + ".png")
    simple.SaveScreenshot(path, view, ImageResolution=[200, 200])
    for item in (surface, *slices):
        simple.Hide(item, view)
    return path


def check_slices(folder):
    """Slices of an oblique scan lie in its surface, which is elsewhere than the voxels are."""
    values, middle = ball(AFFINES["oblique"])
    scan = simple.OpenDataFile(saved(folder, values, AFFINES["oblique"], "ball.nii"))
    recipe = isosurface(scan, 100, smoothing_mm=0)
    view = simple.CreateView("RenderView")
    view.ViewSize = [200, 200]
    view.OrientationAxesVisibility = view.UseColorPaletteForBackground = view.UseFXAA = 0
    view.Background = [1.0, 1.0, 1.0]
    simple.Show(scan, view)
    slices = show_scan_slices(recipe.surface, view)
    assert simple.GetActiveSource() == recipe.surface and not simple.GetRepresentation(scan, view).Visibility
    of_surface = np.reshape(recipe.surface.GetDataInformation().GetBounds(), (3, 2)).mean(axis=1)
    assert np.abs(of_surface - middle).max() < 1
    for k, item in enumerate(slices):
        bounds = np.reshape(item.GetDataInformation().GetBounds(), (3, 2))
        assert np.abs(bounds[k] - of_surface[k]).max() < 1e-3, (k, bounds, of_surface)
        assert (np.delete(np.ptp(bounds, axis=1), k) > 18).all()
        assert item.Input.Input == scan  # not the smoothed or padded one
        # Where the surface crosses the slice, the scan has its isovalue.
        cut = simple.Slice(Input=recipe.surface)
        cut.SliceType.Origin, cut.SliceType.Normal = item.SliceType.Origin, item.SliceType.Normal
        probe = servermanager.Fetch(simple.ResampleWithDataset(SourceDataArrays=item, DestinationMesh=cut))
        met = vtk_to_numpy(probe.GetPointData().GetArray("NIFTI"))[vtk_to_numpy(probe.GetPointData().GetArray("vtkValidPointMask")) == 1]
        # Twice interpolated.
        assert len(met) > 40 and abs(np.median(met) - 100) < 8, (k, len(met), np.median(met))
    more = show_scan_slices(scan, view)
    assert more[0].Input == slices[0].Input == simple.GetActiveSource()
    for item in (*more, *slices):
        simple.Hide(item, view)
    expect_baseline(picture(folder, "PatientVolume", recipe.surface, slices, middle), "PatientVolume")
    in_voxels = isosurface(scan, 100, smoothing_mm=0, patient_space=False).surface
    expect_not_baseline(picture(folder, "in_voxels", in_voxels, slices, middle), "PatientVolume", "a surface in voxels")
    mirrored = simple.OpenDataFile(saved(folder, values[::-1], AFFINES["oblique"], "mirrored.nii"))
    wrong = show_scan_slices(mirrored, view)
    expect_not_baseline(picture(folder, "mirrored", recipe.surface, wrong, middle), "PatientVolume", "left for right")


def message(error, function, *arguments):
    try:
        function(*arguments)
    except error as raised:
        return str(raised)
    raise AssertionError(f"{function.__name__}: no {error.__name__}")


def check_errors():
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    image.AllocateScalars(10, 1)
    assert "does not say where it lies" in message(PatientVolumeError, in_patient_space, image)
    flat = np.diag([1.0, 1, 0, 1])
    place(image, flat, "test")
    assert "singular" in message(PatientVolumeError, in_patient_space, image)
    flat[0, 0] = np.nan
    place(image, flat, "test")
    assert "not finite" in message(PatientVolumeError, in_patient_space, image)
    simple.SetActiveSource(None)
    assert "select a scan" in message(ValueError, show_scan_slices)
    assert "no scan before this" in message(ValueError, show_scan_slices, simple.Sphere())
    wavelet = simple.Wavelet()
    assert "no scan before this" in message(ValueError, show_scan_slices, wavelet)
    moved = simple.ScanInPatientSpace(Input=wavelet)  # says why, and has no values
    moved.UpdatePipeline()
    assert moved.GetDataInformation().GetPointDataInformation().GetNumberOfArrays() == 0


def check_atlas():
    """A brain and its atlas, both in Debian's package mricron-data, lie over each other where nibabel says."""
    folder = "/usr/share/mricron/templates"
    if not os.path.isdir(folder):
        return
    places = np.random.default_rng(5).uniform((-60, -90, -40), (60, 60, 60), (2000, 3))
    for name in ("ch2bet.nii.gz", "aal.nii.gz"):
        path = os.path.join(folder, name)
        volume = servermanager.Fetch(simple.ScanInPatientSpace(Input=simple.OpenDataFile(path)))
        image = nibabel.load(path)
        index = np.rint(nibabel.affines.apply_affine(np.linalg.inv(image.affine), places)).astype(int)
        expected = np.asarray(image.dataobj)[tuple(index.T)]
        values = vtk_to_numpy(volume.GetPointData().GetScalars())
        found = [values[volume.FindPoint(point)] for point in places]
        assert np.mean(found == expected) > 0.999, name  # points halfway between two voxels
        print(f"{name}: {np.sum(found == expected)} of {len(places)} places in the patient agree with nibabel")


with tempfile.TemporaryDirectory(dir=os.environ.get("TEMPORARY_DIRECTORY")) as scratch:
    check_places(scratch)
    check_labels(scratch)
    check_errors()
    check_atlas()
    check_slices(scratch)
