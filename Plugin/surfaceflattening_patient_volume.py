# SPDX-License-Identifier: GPL-3.0-or-later
"""Scans where the patient is: the filter Scan In Patient Space.

Readers give voxels in rows and columns, because the filters of images need them so, and say by PatientMatrix where these
lie. ParaView draws such a volume at its rows and columns. This filter makes a volume whose axes are the patient's right,
front and top, so that its slices lie in surfaces in patient space.
"""

import numpy as np
import surfaceflattening_orientation as orientation
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkImagingCore import vtkImageReslice

# How far the outermost voxel may lie from a grid along the patient's axes, in shares of the smallest voxel, so that the
# voxels are that grid and keep their values. Headers are in single precision, which moves it by some 1e-5; a turn that
# can be seen moves it by more than 0.1.
SAME_GRID = 1e-3

NEAREST, LINEAR = 0, 1


class PatientVolumeError(ValueError):
    """Why a volume has no place in the patient, in words for the user."""


class Grid:
    """The voxels of a volume in patient space: @shape, @sizes in mm and @origin, and whether they are those of the scan
    (@same) or have to be interpolated."""

    def __init__(self, matrix, extent, origin, sizes):
        """@matrix: the coordinates of the scan to RAS+ mm. The rest is that of the scan."""
        first = np.array(origin) + np.array(extent[::2]) * sizes
        shape = np.array(extent[1::2]) - extent[::2] + 1
        to_patient = matrix @ _translation(first) @ np.diag([*sizes, 1.0])
        self.sizes = orientation.voxel_sizes(to_patient)
        upright = _translation(to_patient[:3, 3]) @ np.diag([*self.sizes, 1.0])
        moved = orientation.greatest_distance(to_patient, upright, shape)
        self.same = moved < SAME_GRID * self.sizes.min()
        self.shape, self.origin = shape, to_patient[:3, 3]
        if not self.same:
            corners = (orientation.corners(shape) @ to_patient.T)[:, :3]
            self.origin = corners.min(axis=0)
            self.shape = np.ceil(np.ptp(corners, axis=0) / self.sizes - SAME_GRID).astype(int) + 1

    def extent(self):
        return [number for n in self.shape for number in (0, int(n) - 1)]


def _translation(vector):
    matrix = np.eye(4)
    matrix[:3, 3] = vector
    return matrix


def patient_matrix(data):
    """The 4 x 4 array of PatientMatrix; the identity for data in patient space. Raises PatientVolumeError."""
    field = data.GetFieldData()
    placed, array = field.GetArray("InPatientSpace"), field.GetArray("PatientMatrix")
    if placed and placed.GetTuple1(0):
        return np.eye(4)
    if not array:
        raise PatientVolumeError(
            "the volume does not say where it lies in the patient: open the scan with a reader of Surface Flattening, "
            "and look whether its file has an orientation"
        )
    numbers = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
    if len(numbers) != 16:
        raise PatientVolumeError("the field array PatientMatrix does not have 16 numbers: read the scan again")
    matrix = np.reshape(numbers, (4, 4))
    fault = orientation.fault_of(matrix)
    if fault:
        raise PatientVolumeError(f"the field array PatientMatrix is no place in the patient, because {fault}")
    return matrix


def in_patient_space(image, interpolation=LINEAR, extent=None):
    """The volume @image along the patient's axes. @extent: the part of it that is wanted."""
    matrix = patient_matrix(image)
    grid = Grid(matrix, image.GetExtent(), image.GetOrigin(), image.GetSpacing())
    if grid.same:
        output = vtkImageData()
        output.ShallowCopy(image)
        output.SetExtent(grid.extent())
        output.SetOrigin(grid.origin)
        output.SetSpacing(grid.sizes)
    else:
        output = _resampled(image, matrix, grid, interpolation)
    if extent is not None:
        output.Crop(extent)
    output.GetFieldData().ShallowCopy(image.GetFieldData())
    flag = vtkIdTypeArray()
    flag.SetName("InPatientSpace")
    flag.InsertNextValue(1)
    output.GetFieldData().AddArray(flag)
    return output


def _resampled(image, matrix, grid, interpolation):
    to_scan = vtkMatrix4x4()
    to_scan.DeepCopy(np.linalg.inv(matrix).ravel())
    reslice = vtkImageReslice()
    reslice.SetInputData(image)
    reslice.SetResliceAxes(to_scan)
    reslice.SetOutputExtent(grid.extent())
    reslice.SetOutputOrigin(grid.origin)
    reslice.SetOutputSpacing(grid.sizes)
    if interpolation == LINEAR:
        reslice.SetInterpolationModeToLinear()
    else:
        reslice.SetInterpolationModeToNearestNeighbor()
    # Air, where the corners of the new volume lie outside of the scan.
    reslice.SetBackgroundLevel(image.GetScalarRange()[0])
    reslice.Update()
    output = vtkImageData()
    output.ShallowCopy(reslice.GetOutput())
    output.GetPointData().GetScalars().SetName(image.GetPointData().GetScalars().GetName())
    return output


class ScanInPatientSpace(VTKPythonAlgorithmBase):
    """The filter behind the proxy ScanInPatientSpace in PatientVolume.xml."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, inputType="vtkImageData", outputType="vtkImageData")
        self._interpolation = LINEAR

    def SetInterpolation(self, interpolation):
        self._interpolation = int(interpolation)
        self.Modified()

    def RequestInformation(self, _request, inputs, outputs):
        # The place is in the field data, which are there once the scan has been read; a process may have a part of it.
        self.GetInputAlgorithm(0, 0).Update(self.GetInputConnection(0, 0).GetIndex())
        image = vtkImageData.GetData(inputs[0], 0)
        try:
            matrix = patient_matrix(image)
        except PatientVolumeError:
            return 1  # RequestData says so
        grid = Grid(matrix, self._whole_extent(inputs), image.GetOrigin(), image.GetSpacing())
        information = outputs.GetInformationObject(0)
        information.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), grid.extent(), 6)
        information.Set(vtkDataObject.SPACING(), list(grid.sizes), 3)
        information.Set(vtkDataObject.ORIGIN(), list(grid.origin), 3)
        information.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
        return 1

    def RequestUpdateExtent(self, _request, inputs, _outputs):
        # A part of the output may need any part of the scan.
        information = inputs[0].GetInformationObject(0)
        information.Set(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT(), self._whole_extent(inputs), 6)
        information.Set(vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER(), 0)
        information.Set(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_PIECES(), 1)
        return 1

    def _whole_extent(self, inputs):
        return inputs[0].GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())

    def RequestData(self, _request, inputs, outputs):
        image = vtkImageData.GetData(inputs[0], 0)
        output = vtkImageData.GetData(outputs, 0)
        if image.GetNumberOfPoints() == 0:
            return 1
        extent = outputs.GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT())
        try:
            if image.GetPointData().GetScalars() is None:
                raise PatientVolumeError("the volume has no values")
            output.ShallowCopy(in_patient_space(image, self._interpolation, extent))
        except PatientVolumeError as error:
            vtkOutputWindow.GetInstance().DisplayErrorText(f"Scan In Patient Space: {error}\n")
        return 1
