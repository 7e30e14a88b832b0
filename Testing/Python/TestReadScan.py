# SPDX-License-Identifier: GPL-3.0-or-later
"""Without ParaView: a scan of any format becomes a surface where its header says that the patient lies, a flat map of it
knows that place, and a cortex is read, measured and written."""

import os
import tempfile

import numpy as np
import surfaceflattening
import VolumeFiles
from surfaceflattening_patient_volume import in_patient_space
from surfaceflattening_region_table import region_table, write_csv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource

try:
    import nibabel
except ImportError:
    nibabel = None

LPS = np.diag([-1.0, -1.0, 1.0, 1.0])
ANGLE = np.radians(17)
OBLIQUE = np.array(
    [
        [-np.cos(ANGLE), -np.sin(ANGLE), 0, 21.0],  # stored from right to left
        [-np.sin(ANGLE), np.cos(ANGLE), 0, -7.5],
        [0, 0, 2.0, 40.0],
        [0, 0, 0, 1],
    ]
)
CENTRE = np.array([4.0, 12.0, 58.0])  # of a ball, in RAS+ mm
RADIUS = 8.0


def ball():
    """Values fall by 10 per mm from the surface of a ball, where they are 100."""
    index = np.stack(np.meshgrid(*map(np.arange, (40, 42, 20)), indexing="ij"), -1)
    places = index @ OBLIQUE[:3, :3].T + OBLIQUE[:3, 3]
    return np.rint(100 + 10 * (RADIUS - np.linalg.norm(places - CENTRE, axis=-1))).astype(np.int16)


def check_surface(path):
    said = []
    scan = surfaceflattening.read_scan(path, warn=said.append)
    surface = surfaceflattening.isosurface(scan, 100, smoothing_mm=0)
    points = vtk_to_numpy(surface.GetPoints().GetData())
    error = abs(np.linalg.norm(points - CENTRE, axis=1) - RADIUS).max()
    print(os.path.basename(path), f"{len(points)} points, greatest distance from the ball {error:.3f} mm")
    # A cell of 1 x 1 x 2 mm is interpolated linearly: 2^2 / (8 r); rounded values add 0.05.
    assert error < 0.12 and not said, (path, error, said)
    assert surface.GetFieldData().GetArray("InPatientSpace").GetTuple1(0) == 1
    in_voxels = surfaceflattening.isosurface(scan, 100, smoothing_mm=0, patient_space=False)
    assert not in_voxels.GetFieldData().GetArray("InPatientSpace")
    moved = in_patient_space(scan)
    assert abs(moved.GetPointData().GetScalars().GetTuple1(moved.FindPoint(CENTRE)) - 180) < 15
    return surface


def check_scans(folder):
    values = ball()
    paths = [os.path.join(folder, name) for name in ("ball.mha", "ball.nrrd")]
    VolumeFiles.write_metaimage(paths[0], values.T, None, LPS @ OBLIQUE)
    VolumeFiles.write_nrrd(paths[1], values.T, None, LPS @ OBLIQUE)
    if nibabel:
        paths += [os.path.join(folder, name) for name in ("ball.nii.gz", "ball.mgz")]
        nibabel.save(nibabel.Nifti1Image(values, OBLIQUE), paths[2])
        nibabel.save(nibabel.MGHImage(values, OBLIQUE), paths[3])
    for path in paths:
        surface = check_surface(path)
    flat = surfaceflattening.flatten(surface)
    assert flat.GetFieldData().GetArray("InPatientSpace").GetTuple1(0) == 1
    rows = region_table(with_sides(flat), "Side", names={0: "left", 1: "right"})
    areas = {row["Name"]: row["SurfaceArea"] for row in rows}
    # A cap of a ball has the area 2 pi r h.
    assert abs(areas["right"] / (2 * np.pi * RADIUS * (RADIUS + CENTRE[0])) - 1) < 0.02, areas
    write_csv(os.path.join(folder, "regions.csv"), rows)
    try:
        surfaceflattening.read_scan(os.path.join(folder, "none.nii"))
        raise AssertionError("a file that is not there was read")
    except ValueError as error:
        assert "no such file" in str(error)


def with_sides(flat):
    places = vtk_to_numpy(flat.GetPointData().GetArray("SurfacePoints"))
    array = numpy_to_vtk((places[:, 0] > 0).astype(np.int32), deep=True)
    array.SetName("Side")
    flat.GetPointData().AddArray(array)
    return flat


def check_cortex(folder):
    from surfaceflattening_neuro import read_cortex
    from surfaceflattening_neuro_writers import write_cortex

    source = vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(40)
    source.Update()
    for name in ("lh.pial", "lh.pial.surf.gii"):
        path = os.path.join(folder, name)
        write_cortex(path, source.GetOutput())
        back = read_cortex(path, warn=lambda text: None)
        expected = vtk_to_numpy(source.GetOutput().GetPoints().GetData()).astype(np.float32)
        assert np.array_equal(vtk_to_numpy(back.GetPoints().GetData()), expected)
    flat = surfaceflattening.flatten(back)
    write_cortex(os.path.join(folder, "lh.flat.patch.3d"), flat)
    assert os.path.getsize(os.path.join(folder, "lh.flat.patch.3d")) > 16 * 1000


with tempfile.TemporaryDirectory() as scratch:
    check_scans(scratch)
    if nibabel:
        check_cortex(scratch)
