# SPDX-License-Identifier: GPL-3.0-or-later
"""A marker comes out where nibabel says that it lies in the patient, from every format and orientation."""

import contextlib
import importlib
import os
import tempfile

import gdcm
import nibabel
import numpy as np
import pydicom
import VolumeFiles
from paraview import servermanager, simple
from surfaceflattening_scans import ScanError, open_scan, read_scan, scan_of
from surfaceflattening_volume import isosurface
from vtkmodules.util.numpy_support import vtk_to_numpy

SHAPE = (14, 17, 12)
LPS = np.diag([-1.0, -1.0, 1.0, 1.0])
SIZES = {
    "0.5 mm": np.diag([0.5, 0.5, 0.5]),
    "1 x 1 x 3 mm": np.diag([1.0, 1.0, 3.0]),
    "sheared": np.array([[1.0, 0.0, 0.3], [0.0, 1.1, 0.2], [0.0, 0.0, 1.4]]),
}


def rotation(axis, degrees):
    axis = np.array(axis) / np.linalg.norm(axis)
    cross = np.cross(np.eye(3), axis)
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * -cross + (1 - np.cos(angle)) * (cross @ cross)


ORIENTATIONS = {
    "axial": np.eye(3),
    "sagittal": np.array([[0, 0, 1.0], [1, 0, 0], [0, 1, 0]]),
    "coronal": np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]]),
    "oblique": rotation((1, 2, 0.5), 17),
    "flipped": np.diag([-1.0, 1, 1]),
    "qfac -1": np.diag([1.0, 1, -1]),
}


def marker():
    """An L with a thick foot: no turn and no reflection takes it to itself. The isovalue, 50, becomes 49.5 in a volume
    of integers, half of the marker's value: the surface is halfway between voxels."""
    values = np.zeros(SHAPE, np.int16)
    values[3:5, 3:13, 3:6] = 99
    values[3:10, 3:5, 3:6] = 99
    values[8:10, 3:5, 3:9] = 99
    return values


def surface_in_voxels(values):
    """Where the edges between neighbouring voxels cross the surface, as indices."""
    inside = values > 50
    points = []
    for axis in range(3):
        low = np.argwhere(np.diff(inside.astype(int), axis=axis)).astype(float)
        low[:, axis] += 0.5
        points.append(low)
    return np.concatenate(points)


def affine_of(orientation, sizes):
    affine = np.eye(4)
    affine[:3, :3] = orientation @ sizes
    affine[:3, 3] = -31.0, 17.25, 40.5
    return affine


def points_and_faces(proxy):
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(data.GetPoints().GetData()), cells, data


def clear():
    for source in list(simple.GetSources().values()):
        simple.Delete(source)


def greatest_difference(found, expected):
    assert found.shape == expected.shape, (found.shape, expected.shape)
    nearest = [np.linalg.norm(expected - point, axis=1).min() for point in found]
    back = [np.linalg.norm(found - point, axis=1).min() for point in expected]
    return max(max(nearest), max(back))


def volume_and_area(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    cross = np.cross(b - a, c - a)
    return (np.einsum("ij,ij->i", a, np.cross(b, c))).sum() / 6, np.linalg.norm(cross, axis=1).sum() / 2


def check_surface(name, path, values, affine):
    """The marker in the file comes out where @affine says; returns its area."""
    scan = open_scan(path)
    recipe = isosurface(scan, 50, smoothing_mm=0, padding=0)
    points, faces, data = points_and_faces(recipe.surface)
    expected = nibabel.affines.apply_affine(affine, surface_in_voxels(values))
    error = greatest_difference(points, expected)
    assert error < 1e-5, (name, error)
    unmoved = isosurface(scan, 50, smoothing_mm=0, padding=0, patient_space=False)
    voxels, voxel_faces, _data = points_and_faces(unmoved.surface)
    volume, area = volume_and_area(points, faces)
    in_voxels, _area = volume_and_area(voxels, voxel_faces)
    # A mirror image has a volume of the other sign. So has a surface that is inside out.
    assert np.sign(volume) == np.sign(in_voxels), (name, volume, in_voxels)
    assert data.GetFieldData().GetArray("InPatientSpace").GetTuple1(0) == 1
    print(f"{name}: {error:.1e} mm, area {area:.4f} mm2")
    return area


def check_nifti(folder):
    values = marker()
    for size_name, sizes in SIZES.items():
        areas = []
        for name, turn in ORIENTATIONS.items():
            for forms in ("both", "sform only", "qform only"):
                if size_name == "sheared" and forms == "qform only":
                    continue  # a quaternion cannot shear
                image = nibabel.Nifti1Image(values, None)
                affine = affine_of(turn, sizes)
                if forms != "qform only":
                    image.set_sform(affine, 2)
                if forms == "sform only" or size_name == "sheared":
                    image.header["pixdim"][1:4] = nibabel.affines.voxel_sizes(affine)
                else:
                    image.set_qform(affine, 1)
                path = os.path.join(folder, f"{size_name} {name} {forms}.nii.gz".replace(" ", "_"))
                nibabel.save(image, path)
                areas.append(
                    check_surface(f"{size_name}, {name}, {forms}", path, values, nibabel.load(path).affine)
                )
                clear()
        if size_name != "sheared":
            # The same marker; ambiguous cubes are triangulated by the order of the voxels.
            assert max(areas) / min(areas) < 1 + 1e-2, (size_name, areas)


def check_same_place(folder):
    """One scan, stored with its axes in all 48 orders and directions, is one volume."""
    affine = affine_of(rotation((1, 2, 0.5), 17), SIZES["sheared"])
    reference = nibabel.Nifti1Image(marker(), affine)
    found = set()
    first = None
    for axes in np.array(np.meshgrid(*[(-1, 1)] * 3)).T.reshape(-1, 3):
        for order in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
            image = reference.as_reoriented(np.array([order, axes]).T)
            path = os.path.join(folder, "stored.nii")
            nibabel.save(image, path)
            found.add("".join(nibabel.aff2axcodes(image.affine)))
            volume = read_scan(path, warn=lambda text: None)
            matrix = np.reshape(volume.GetFieldData().GetArray("PatientMatrix").GetTuple(0), (4, 4))
            values = vtk_to_numpy(volume.GetPointData().GetScalars()).copy()
            first = first or (volume.GetDimensions(), values, matrix)
            assert volume.GetDimensions() == first[0]
            assert np.array_equal(values, first[1])
            assert np.abs(matrix - first[2]).max() < 1e-5, matrix - first[2]
    assert len(found) == 48, found


def check_values(folder):
    values = marker()
    image = nibabel.Nifti1Image(values, np.diag([1, 1, 1, 1.0]))
    image.header.set_slope_inter(1653 / 255, -3)
    path = os.path.join(folder, "slope.nii")
    nibabel.save(image, path)
    stored = bytearray(open(path, "rb").read())
    stored[112:120] = np.array([6.5, -3], "<f4").tobytes()  # as nibabel saves scaled values as integers anew
    open(path, "wb").write(stored)
    volume = read_scan(path)
    found = vtk_to_numpy(volume.GetPointData().GetScalars()).reshape(SHAPE[::-1]).T
    assert np.array_equal(found, nibabel.load(path).get_fdata().astype(np.float32)), (found.min(), found.max())
    image = nibabel.Nifti1Image(values.astype(">i2"), np.diag([1, 1, 1, 1.0]), nibabel.Nifti1Header(endianness=">"))
    nibabel.save(image, path)
    volume = read_scan(path)
    assert np.array_equal(vtk_to_numpy(volume.GetPointData().GetScalars()).reshape(SHAPE[::-1]).T, values)


def nifti(folder, sform=None, qform=None, sizes=(1, 1, 1), shape=SHAPE):
    image = nibabel.Nifti1Image(np.zeros(shape, np.int16), None)
    image.header["pixdim"][1:4] = sizes
    if qform is not None:
        image.set_qform(qform, 1)
    path = os.path.join(folder, "odd.nii")
    nibabel.save(image, path)
    if sform is not None:  # by hand, as nibabel corrects what it saves
        with open(path, "r+b") as stream:
            stream.seek(254)  # sform_code
            stream.write(np.array(1, "<i2").tobytes())
            stream.seek(280)  # srow_x, srow_y, srow_z
            stream.write(np.array(sform)[:3].astype("<f4").tobytes())
    return path


def check_units(folder):
    """Voxels are in mm whatever the unit of the header, with an orientation and without, in patient space or not."""
    for unit, size in (("micron", 500), ("meter", 5e-4), ("mm", 0.5), ("unknown", 0.5)):
        for placed in (False, True):
            image = nibabel.Nifti1Image(marker(), None)
            image.header["pixdim"][1:4] = size
            if placed:
                image.set_sform(affine_of(np.eye(3), np.eye(3) * size), 1)
            image.header.set_xyzt_units(unit)
            path = os.path.join(folder, "units.nii")
            nibabel.save(image, path)
            for patient_space in (False, True):
                found = read_scan(path, patient_space, warn=lambda text: None).GetSpacing()
                assert np.allclose(found, 0.5, rtol=1e-6), (unit, placed, patient_space, found)


def messages_of(path):
    scan = scan_of(path)
    return scan, "; ".join(scan.placement.warnings)


def check_odd_headers(folder):
    good = affine_of(np.eye(3), np.eye(3))
    scan, text = messages_of(nifti(folder))
    assert scan.placement.matrix is None and "neither an sform nor a qform" in text, text
    flat = good.copy()
    flat[2, 2] = 0
    scan, text = messages_of(nifti(folder, sform=flat, qform=good))
    assert scan.placement.source == "qform" and "singular" in text, text
    flat[0, 3] = np.nan
    scan, text = messages_of(nifti(folder, sform=flat))
    assert scan.placement.matrix is None and "not finite" in text, text
    moved = good.copy()
    moved[0, 3] += 4
    scan, text = messages_of(nifti(folder, sform=good, qform=moved))
    assert scan.placement.source == "sform" and "differ by up to 4 mm" in text, text
    scan, text = messages_of(nifti(folder, sform=good, sizes=(1, 1, 2)))
    assert "1 x 1 x 1 mm, and the header says 1 x 1 x 2" in text, text
    scan, text = messages_of(nifti(folder, sform=good, shape=(*SHAPE, 3)))
    assert "3 volumes" in text and scan.shape == SHAPE, text
    scan, text = messages_of(nifti(folder, sform=good))
    assert text == "", text
    for name, cut in (("cut.nii", 2000), ("cut.nii.gz", 60)):
        path = os.path.join(folder, name)
        values = np.random.default_rng(1).integers(0, 99, SHAPE, np.int16)
        nibabel.save(nibabel.Nifti1Image(values, good), path)
        os.truncate(path, os.path.getsize(path) - cut)
        try:
            read_scan(path)
            raise AssertionError(f"{name} was read")
        except ScanError as error:
            print(error)


def check_other_formats(folder):
    """DICOM, MetaImage and NRRD say the same in their own ways: LPS+ instead of RAS+."""
    values = marker()
    for size_name, sizes in SIZES.items():
        for name, turn in ORIENTATIONS.items():
            affine = affine_of(turn, sizes)
            stem = os.path.join(folder, f"{size_name}_{name}".replace(" ", "_"))
            files = {
                "MetaImage": stem + ".mha",
                "NRRD": stem + ".nrrd",
                "NRRD in RAS": stem + "_ras.nrrd",
                "FreeSurfer": stem + ".mgz",
                "DICOM": stem,
            }
            nibabel.save(nibabel.MGHImage(values, affine), files["FreeSurfer"])
            VolumeFiles.write_metaimage(files["MetaImage"], values.T, None, LPS @ affine)
            VolumeFiles.write_nrrd(files["NRRD"], values.T, None, LPS @ affine)
            VolumeFiles.write_nrrd(files["NRRD in RAS"], values.T, None, affine, "RAS")
            if size_name != "sheared" and np.linalg.det(turn) < 0:
                del files["DICOM"]  # whose slices are sorted along the normal
            elif size_name == "sheared":
                del files["DICOM"]  # which can shear along the slices only
            else:
                VolumeFiles.write_dicom_series(files["DICOM"], values.T, None, LPS @ affine)
            for kind, path in files.items():
                check_surface(f"{kind}, {size_name}, {name}", path, values, affine)
                clear()
    for kind, path in (("MetaImage", "plain.mha"), ("NRRD", "plain.nrrd")):
        path = os.path.join(folder, path)
        write = VolumeFiles.write_metaimage if kind == "MetaImage" else VolumeFiles.write_nrrd
        write(path, values.T, (1, 1, 1.5))
        scan, text = messages_of(path)
        assert scan.placement.matrix is None and "left and right" in text, (kind, text)


def check_mgh(folder):
    values, path = marker(), os.path.join(folder, "odd.mgz")
    image = nibabel.MGHImage(np.stack([values, values + 1], -1), affine_of(np.eye(3), np.eye(3)))
    nibabel.save(image, path)
    scan, text = messages_of(path)
    assert "2 volumes: volume 0 is taken" in text and np.array_equal(scan.load(), values), text
    assert np.array_equal(scan_of(path, 1).load(), values + 1)
    os.truncate(path, os.path.getsize(path) // 2)
    assert "cut short" in refusal(path)
    path = os.path.join(folder, "plain.mgh")
    nibabel.save(image, path)
    with open(path, "r+b") as stream:
        stream.seek(28)  # goodRASFlag
        stream.write(bytes(2))
    scan, text = messages_of(path)
    assert scan.placement.matrix is None and "left and right" in text, text


def check_dicom(folder):
    values = marker()
    tilted = np.array([[1.0, 0, 0], [0, 1, 3 * np.tan(np.radians(12))], [0, 0, 3]])
    affine = affine_of(np.eye(3), tilted)
    path = os.path.join(folder, "tilted")
    VolumeFiles.write_dicom_series(path, values.T, None, LPS @ affine)
    _scan, text = messages_of(path)
    assert "12.00 degrees" in text, text
    check_surface("DICOM, tilted gantry", path, values, affine)
    clear()
    # A missing slice within the marker, whose neighbours are the same.
    os.remove(VolumeFiles.dicom_slice_path(path, 4, SHAPE[2]))
    scan, text = messages_of(path)
    assert "1 slice is missing" in text and scan.shape == SHAPE, text
    check_surface("DICOM, a slice missing", path, values, affine)
    path = os.path.join(folder, "half")
    VolumeFiles.write_dicom_series(path, values.T, None, LPS @ affine, move={5: 0.5})
    assert "evenly spaced" in refusal(path)
    check_odd_dicom(folder, values, affine)


def refusal(path):
    try:
        read_scan(path)
    except ScanError as error:
        assert str(error).startswith(path), error
        return str(error)
    raise AssertionError(f"{path} was read")


def check_odd_dicom(folder, values, affine):
    """Series that are no volume, or not one that can be placed, say what to do."""
    path = os.path.join(folder, "odd")
    for words, change in (
        ("mosaic of several slices: dcm2niix", {"ImageType": ["ORIGINAL", "PRIMARY", "M", "MOSAIC"]}),
        ("several frames each: dcm2niix", {"NumberOfFrames": 2}),
        ("do not say where they lie in the patient: dcm2niix", {"ImageOrientationPatient": None}),
        ("cannot be understood", {"ImagePositionPatient": [1.0, 2.0]}),
        ("not at right angles", {"ImageOrientationPatient": [1, 0, 0, 1, 0, 0]}),
        ("one slice", {"ImagePositionPatient": [1.0, 2.0, 3.0]}),
        ("may be damaged", {"PixelData": bytes(100)}),
    ):
        VolumeFiles.write_dicom_series(path, values.T, None, LPS @ affine)
        for name in os.listdir(path):
            item = pydicom.dcmread(os.path.join(path, name))
            for key, value in change.items():
                if value is None:
                    delattr(item, key)
                else:
                    setattr(item, key, value)
            item.save_as(os.path.join(path, name))
        text = refusal(path)
        assert words in text, (words, text)
        print(text)
    with open(os.path.join(folder, "no.dcm"), "wb") as stream:
        stream.write(b"nothing")
    assert "no DICOM image" in refusal(os.path.join(folder, "no.dcm"))


def series(folder, changes):
    """Writes six slices that are 2 mm apart, each with its number as its values. @changes: slice to attributes of its
    header."""
    path = tempfile.mkdtemp(dir=folder)
    values = np.repeat(np.arange(6, dtype=np.int16), 20).reshape(6, 4, 5)
    VolumeFiles.write_dicom_series(path, values, (1.0, 1.0, 2.0))
    for k, change in changes.items():
        file = VolumeFiles.dicom_slice_path(path, k, 6)
        item = pydicom.dcmread(file)
        for name, value in change.items():
            setattr(item, name, value)
        item.save_as(file)
    return path


def check_slices_aside(folder):
    """Slices that are evenly spaced along their normal, of which some lie aside, are no volume."""
    for moved, distance in (((3, 4, 5), 40), ((5,), 5), ((2,), 5), ((1, 2, 3), 0.3)):
        path = series(folder, {k: {"ImagePositionPatient": [distance, 0, 2 * k]} for k in moved})
        text = refusal(path)
        before, odd = (VolumeFiles.dicom_slice_path(path, moved[0] + k, 6) for k in (-1, 0))
        assert text.startswith(before) and f"{odd}, lies {distance} mm" in text and "folder of their own" in text, text
        print(text)
    scan, text = messages_of(series(folder, {2: {"ImagePositionPatient": [0.1, 0, 4]}}))
    assert np.allclose(scan.sizes, (1, 1, 2)) and not text, text


@contextlib.contextmanager
def without_permission(path):
    """Takes the permission to read a file, for a while; the superuser becomes another user for that."""
    os.chmod(os.path.dirname(path), 0o755)
    os.chmod(path, 0)
    user = os.geteuid()
    os.seteuid(user or 65534)
    try:
        yield
    finally:
        os.seteuid(user)
        os.chmod(path, 0o644)


def check_unreadable_slices(folder):
    """Slices that cannot be read are named; files that are not DICOM, and reports, are passed over in silence."""
    for k, words in ((5, "slices may be missing"), (2, "1 slice is missing")):
        path = series(folder, {})
        file = VolumeFiles.dicom_slice_path(path, k, 6)
        os.truncate(file, 300)
        scan, text = messages_of(path)
        said = f"1 file could not be read (the first: {os.path.basename(file)}: its header"
        assert said in text and words in text, text
        assert "cut short" in refusal(file)
        print(text)
    path = series(folder, {0: {"SeriesInstanceUID": "2.25.7"}})
    os.symlink("nowhere", os.path.join(path, "z.dcm"))
    scan, text = messages_of(path)
    assert "1 file could not be read (the first: z.dcm: No such file" in text and "2 series" in text, text
    path = series(folder, {})
    report = pydicom.dcmread(VolumeFiles.dicom_slice_path(path, 0, 6))
    report.file_meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.88.11"  # Basic Text SR Storage
    del report.Rows, report.PixelData
    report.save_as(os.path.join(path, "report.dcm"))
    with open(os.path.join(path, "notes.txt"), "wb") as stream:
        stream.write(b"no preamble")
    scan, text = messages_of(path)
    assert scan.shape == (5, 4, 6) and not text, text
    os.chmod(folder, 0o755)
    file = VolumeFiles.dicom_slice_path(path, 3, 6)
    with without_permission(file):
        text = refusal(path)
    assert text.startswith(f"{file}: there is no permission"), text
    for name in os.listdir(path):
        os.truncate(os.path.join(path, name), 300)
    text = refusal(path)
    assert "no DICOM images: 6 files could not be read" in text, text


def check_scouts(folder):
    """Of a series with images of several directions the chosen stack is read, or the largest."""
    def with_scouts(*directions):
        path = series(folder, {k: {"PixelSpacing": [1.00001, 1]} for k in (2, 3)})
        for k, direction in enumerate(directions):
            scout = pydicom.dcmread(VolumeFiles.dicom_slice_path(path, 0, 6))
            scout.ImageOrientationPatient, scout.ImagePositionPatient = direction, [5 * k, 0, 0]
            scout.save_as(os.path.join(path, f"a scout {k}.dcm"))
        return path

    sagittal, coronal = [0, 1, 0, 0, 0, -1], [1, 0, 0, 0, 0, -1]
    for directions, left_out in (((sagittal,), "1 image of"), ((sagittal, sagittal, coronal), "3 images of")):
        path = with_scouts(*directions)
        for chosen in (path, VolumeFiles.dicom_slice_path(path, 3, 6)):
            scan, text = messages_of(chosen)
            assert scan.shape == (5, 4, 6) and left_out in text and "(the first: a scout 0.dcm)" in text, text
    scan, text = messages_of(os.path.join(path, "a scout 1.dcm"))
    assert scan.shape == (5, 4, 2) and "7 images of" in text, text
    text = refusal(os.path.join(path, "a scout 2.dcm"))
    assert "one slice of this size and direction: choose one of the other images of the series, such as" in text, text
    print(text)


def check_times(folder):
    """Of a series over time the first time is read, even if rounding moves its slices behind those of another time."""
    path = series(folder, {k: {"ImagePositionPatient": [0, 0, 2 * k + 4e-4 * (k % 2)]} for k in range(6)})
    for k in range(6):
        item = pydicom.dcmread(VolumeFiles.dicom_slice_path(path, k, 6))
        item.InstanceNumber += 6
        item.ImagePositionPatient = [0, 0, 2 * k + 4e-4 * ((k + 1) % 2)]
        item.PixelData = (item.pixel_array + 100).tobytes()
        item.save_as(os.path.join(path, f"a{k}.dcm"))
    scan, text = messages_of(path)
    assert np.array_equal(scan.load()[0, 0], range(6)), scan.load()
    assert "6 images lie where another one does" in text, text


def check_dicom_values(folder):
    """Slopes that are empty, and numbers that 32 bits with a sign do not hold."""
    path = series(folder, {k: {"RescaleSlope": None, "RescaleIntercept": None} for k in range(6)})
    values = scan_of(path).load()
    assert values.dtype == np.int32 and np.array_equal(values[0, 0], range(6)), values
    unsigned = {"BitsAllocated": 32, "BitsStored": 32, "HighBit": 31, "PixelRepresentation": 0}
    stored = np.full((4, 5), 3_000_000_000, np.uint32)
    for change, expected in (
        ({"PixelData": stored.tobytes()}, 3e9),
        ({"PixelData": (stored // 1000).tobytes(), "RescaleSlope": 2, "RescaleIntercept": -1}, 6e6 - 1),
        ({"PixelData": stored.tobytes(), "RescaleSlope": 0.5}, 1.5e9),
        ({"PixelData": stored.tobytes(), "RescaleSlope": "1e99"}, 3e108),
    ):
        scan = scan_of(series(folder, {k: {**unsigned, **change} for k in range(6)}))
        assert np.allclose(scan.load(), expected, rtol=1e-12), (change, scan.load())
    path = series(folder, {})
    file = VolumeFiles.dicom_slice_path(path, 2, 6)
    with open(file, "r+b") as stream:
        content = stream.read().replace(b"\x28\0\x53\x10DS\2\0001 ", b"\x28\0\x53\x10DS\2\0x ")
        stream.seek(0)
        stream.write(content)
    text = refusal(path)
    assert text.startswith(file) and "may be damaged" in text, text


def check_compressed(folder):
    """Slices compressed without loss, as archives send them, made by GDCM."""
    values, affine = marker(), affine_of(np.eye(3), SIZES["1 x 1 x 3 mm"])
    path = os.path.join(folder, "compressed")
    VolumeFiles.write_dicom_series(path, values.T, None, LPS @ affine)
    for syntax in (
        gdcm.TransferSyntax.JPEGLosslessProcess14_1,
        gdcm.TransferSyntax.JPEG2000Lossless,
        gdcm.TransferSyntax.JPEGLSLossless,
        gdcm.TransferSyntax.RLELossless,
        gdcm.TransferSyntax.DeflatedExplicitVRLittleEndian,
    ):
        for name in os.listdir(path):
            reader, change, writer = gdcm.ImageReader(), gdcm.ImageChangeTransferSyntax(), gdcm.ImageWriter()
            file = os.path.join(path, name)
            reader.SetFileName(file)
            assert reader.Read()
            change.SetTransferSyntax(gdcm.TransferSyntax(syntax))
            change.SetInput(reader.GetImage())
            assert change.Change()
            writer.SetFileName(file)
            writer.SetFile(reader.GetFile())
            writer.SetImage(change.GetOutput())
            assert writer.Write()
        check_surface(f"DICOM, {gdcm.TransferSyntax(syntax)}", path, values, affine)
        clear()
        if syntax == gdcm.TransferSyntax.JPEGLSLossless:
            check_without_decoder(path)


def check_without_decoder(path):
    """Without GDCM the message says which compression it is, and what to install or to do."""
    with without_gdcm():
        try:
            read_scan(path)
            raise AssertionError("JPEG-LS was read without a decoder")
        except ScanError as error:
            for word in ("JPEG-LS Lossless", "package python3-gdcm", "package dcm2niix"):
                assert word in str(error), error
            assert "plugins" not in str(error) and "handlers" not in str(error), error
            print(error)


@contextlib.contextmanager
def without_gdcm():
    if int(pydicom.__version__.split(".", maxsplit=1)[0]) < 3:
        handlers = pydicom.config.pixel_data_handlers
        pydicom.config.pixel_data_handlers = [importlib.import_module("pydicom.pixel_data_handlers.numpy_handler")]
        yield
        pydicom.config.pixel_data_handlers = handlers
    else:
        decoder = importlib.import_module("pydicom.pixels").get_decoder(pydicom.uid.JPEGLSLossless)
        decoder.remove_plugin("gdcm")
        yield
        decoder.add_plugin("gdcm", ("pydicom.pixels.decoders.gdcm", "_decode_frame"))


with tempfile.TemporaryDirectory() as scratch:
    check_nifti(scratch)
    check_same_place(scratch)
    check_values(scratch)
    check_odd_headers(scratch)
    check_units(scratch)
    check_other_formats(scratch)
    check_mgh(scratch)
    check_dicom(scratch)
    check_slices_aside(scratch)
    check_unreadable_slices(scratch)
    check_scouts(scratch)
    check_times(scratch)
    check_dicom_values(scratch)
    check_compressed(scratch)
