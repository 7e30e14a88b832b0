# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers of scans that know where the patient is: NIfTI, DICOM, MetaImage, NRRD, FreeSurfer and InVesalius.

    from surfaceflattening_scans import open_scan
    scan = open_scan("head.nii.gz")  # a source in ParaView's pipeline browser

Voxels have the values of the header (slope and intercept). They are put in the order that is nearest to right,
front and top (RAS+), which loses nothing, so that no view shows a mirror image. What is left, a turn, a shear and
the place of the first voxel, is in the field array PatientMatrix, which all filters pass on; the filter Patient Space
carries a surface there.
"""

import os

import numpy as np
import surfaceflattening_orientation as orientation
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkOutputWindow, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOImage import vtkNIFTIImageReader


class ScanError(ValueError):
    """Why a file cannot be read, in words for the user."""


class Scan:
    """A volume in a file. It has a shape (i, j, k), sizes of voxels in mm, a Placement, and load(), which gives
    the voxels as an array [i, j, k] or [i, j, k, component]."""

    name = "Values"

    def __init__(self, shape, sizes, placement):
        self.shape = tuple(shape)
        self.sizes = np.array(sizes, float)
        self.placement = placement

    def load(self):
        raise NotImplementedError


class _VTKScan(Scan):
    """A volume that a reader of VTK reads."""

    def __init__(self, reader, path):
        self._reader, self._path, self._errors, self._vtk_warnings = reader, path, [], []
        for event, texts in (("ErrorEvent", self._errors), ("WarningEvent", self._vtk_warnings)):
            for item in (reader, reader.GetExecutive()):
                item.AddObserver(event, _recorder(texts))
        reader.SetFileName(os.fsencode(path))  # VTK refuses a str that is not UTF-8
        reader.UpdateInformation()
        self._raise_errors()
        information = reader.GetOutputInformation(0)
        extent = information.Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
        shape = [extent[2 * k + 1] - extent[2 * k] + 1 for k in range(3)]
        super().__init__(shape, information.Get(vtkDataObject.SPACING()), None)

    def _raise_errors(self):
        if self._errors:
            raise ScanError(f"{self._path}: {self._errors[0]}")

    def load(self):
        self._reader.Update()
        self._raise_errors()
        scalars = self._reader.GetOutput().GetPointData().GetScalars()
        if scalars is None:
            raise ScanError(f"{self._path}: there are no voxels")
        self.name = scalars.GetName() or self.name
        values = vtk_to_numpy(scalars)
        return values.reshape(*reversed(self.shape), *values.shape[1:]).swapaxes(0, 2)


def _recorder(texts):
    def record(_caller, _event, text=""):
        text = text or "VTK's message quotes the file or its name, and that is not UTF-8"
        texts.append(" ".join(text.split()).split("): ", 1)[-1])

    record.CallDataType = "string0"
    return record


class NIfTIScan(_VTKScan):
    name = "NIFTI"

    def __init__(self, path, volume=0):
        super().__init__(vtkNIFTIImageReader(), path)
        reader = self._reader
        header = reader.GetNIFTIHeader()
        self.sizes *= orientation.nifti_unit(header)
        self.placement = orientation.nifti_placement(header, self.shape)
        # What VTK says of the forms is said in more detail there.
        self.placement.warnings += [text for text in self._vtk_warnings if "FormMatrix" not in text]
        if self.placement.matrix is not None and reader.GetQFac() < 0:
            # VTK reads such files with the last slice first.
            flip = [False, False, True]
            self.placement.matrix = orientation.reordered_matrix(
                self.placement.matrix, self.shape, [0, 1, 2], flip
            )
        self._volume, count = volume, max(reader.GetTimeDimension(), 1)
        if not 0 <= volume < count:
            raise ScanError(f"{path}: there is no volume {volume}, but those from 0 to {count - 1}")
        if count > 1:
            reader.TimeAsVectorOn()
            self.placement.warnings.append(
                f"the file has {count} volumes, one for each time: volume {volume} is taken"
            )

    def load(self):
        values = super().load()
        if self._reader.GetTimeAsVector() and values.ndim == 4:
            parts = values.shape[3] // self._reader.GetTimeDimension()
            values = values[..., self._volume * parts : (self._volume + 1) * parts]
            values = values[..., 0] if parts == 1 else values
        return true_values(values, self._reader.GetRescaleSlope(), self._reader.GetRescaleIntercept())


def true_values(values, slope, intercept):
    """Slope and intercept applied; a slope of 0 or none means that there are none (NIfTI)."""
    if not np.isfinite([slope, intercept]).all() or slope == 0 or (slope, intercept) == (1, 0):
        return values
    # Single precision holds 16 bits and a slope to 6e-8 of the value.
    kind = np.float32 if values.dtype.itemsize <= 2 else np.float64
    return (values * np.float64(slope) + intercept).astype(kind)


def scan_of(path, volume=0):
    """The Scan in a file, or in a folder of DICOM files. Raises ScanError."""
    path = os.fspath(path)
    if not os.path.exists(path):
        raise ScanError(f"{path}: there is no such file")
    name = path.lower()
    if name.endswith((".nii", ".nii.gz", ".hdr", ".img")):
        return NIfTIScan(path, volume)
    if name.endswith((".mha", ".mhd", ".nrrd", ".nhdr")):
        from surfaceflattening_voxel_files import MetaImageScan, NRRDScan

        return (MetaImageScan if name.endswith((".mha", ".mhd")) else NRRDScan)(path)
    if name.endswith((".mgz", ".mgh")):
        from surfaceflattening_mgh import MGHScan

        return MGHScan(path, volume)
    if name.endswith(".inv3"):
        from surfaceflattening_invesalius import InVesaliusScan

        return InVesaliusScan(path)
    from surfaceflattening_dicom import DICOMScan

    return DICOMScan(path)


def image_of(scan, patient_space=True):
    """The Scan as vtkImageData in the order nearest to RAS+, or, without @patient_space or a placement, as it is
    stored. The first voxel is at the origin."""
    values, matrix = scan.load(), scan.placement.matrix
    sizes = scan.sizes
    image = vtkImageData()
    if matrix is not None and patient_space:
        order, flips = orientation.nearest_ras(matrix)
        matrix = orientation.reordered_matrix(matrix, scan.shape, order, flips)
        values = values.transpose(*order, *range(3, values.ndim))
        values = values[tuple(slice(None, None, -1 if flip else 1) for flip in flips)]
        sizes = orientation.voxel_sizes(matrix)
        place(image, matrix @ np.diag([*(1 / sizes), 1.0]), scan.placement.source)
    image.SetDimensions(values.shape[:3])
    image.SetSpacing(sizes)
    tuples = np.ascontiguousarray(values.swapaxes(0, 2)).reshape(-1, *values.shape[3:])
    array = numpy_to_vtk(tuples, deep=True)
    array.SetName(scan.name)
    image.GetPointData().SetScalars(array)
    return image


def place(data, matrix, source):
    """Writes the field arrays that tell where data lie in the patient."""
    array = vtkDoubleArray()
    array.SetName("PatientMatrix")
    array.SetNumberOfComponents(16)
    array.InsertNextTuple(np.asarray(matrix, float).ravel())
    data.GetFieldData().AddArray(array)
    words = vtkStringArray()
    words.SetName("PatientMatrixSource")
    words.InsertNextValue(source)
    data.GetFieldData().AddArray(words)


def read_scan(path, patient_space=True, volume=0, warn=print):
    """The volume in a file as vtkImageData. @warn: is told what is odd about the file, a sentence each. Raises
    ScanError."""
    try:
        scan = scan_of(path, volume)
        for warning in scan.placement.warnings:
            warn(f"{path}: {warning}")
        return image_of(scan, patient_space)
    except OSError as error:
        raise ScanError(f"{path}: the file cannot be read: {error.strerror or error}") from error


def open_scan(path, patient_space=True):
    """A source in ParaView with the reader of scans, whatever other readers ParaView has for the file."""
    from paraview import simple
    from surfaceflattening_volume import _filter

    path = os.fspath(path)
    if not os.path.exists(path):
        raise ScanError(f"{path}: there is no such file")
    return _filter("ScanReader")(
        registrationName=os.path.basename(path.rstrip("/")), FileName=path, PatientSpace=int(patient_space)
    )


class ScanReader(VTKPythonAlgorithmBase):
    """The source behind the proxies NIFTIImageReader and ScanReader in VolumePreparation.xml."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self._path, self._patient_space, self._volume = None, True, 0
        self._scan, self._image, self._warned = None, None, None

    def SetFileName(self, path):
        self._set("_path", path)

    def SetPatientSpace(self, on):
        self._set("_patient_space", bool(on))

    def SetVolume(self, volume):
        self._set("_volume", int(volume))

    def _set(self, name, value):
        if getattr(self, name) != value:
            setattr(self, name, value)
            self._image = None
            self.Modified()

    def _load(self):
        """The image is read when its information is asked for: filters that follow have to know the type of its
        values before they run. The output shares its memory."""
        if self._image is None:
            self._scan = scan_of(self._path, self._volume)
            self._image = image_of(self._scan, self._patient_space)

    def RequestInformation(self, _request, _inputs, outputs):
        def header():
            self._load()
            information = outputs.GetInformationObject(0)
            scalars = self._image.GetPointData().GetScalars()
            information.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), self._image.GetExtent(), 6)
            information.Set(vtkDataObject.SPACING(), self._image.GetSpacing(), 3)
            information.Set(vtkDataObject.ORIGIN(), [0.0, 0.0, 0.0], 3)
            information.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
            vtkDataObject.SetPointDataActiveScalarInfo(
                information, scalars.GetDataType(), scalars.GetNumberOfComponents()
            )

        return self._attempt(header)

    def RequestData(self, _request, _inputs, outputs):
        def data():
            self._load()
            if self._warned != (self._path, self._volume):
                self._warned = (self._path, self._volume)
                for warning in self._scan.placement.warnings:
                    vtkOutputWindow.GetInstance().DisplayWarningText(f"{self._path}: {warning}\n")
            image = vtkImageData()
            image.ShallowCopy(self._image)
            # Processes that share a volume want a part of it each.
            image.Crop(outputs.GetInformationObject(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_EXTENT()))
            vtkImageData.GetData(outputs, 0).ShallowCopy(image)

        return self._attempt(data)

    def _attempt(self, step):
        try:
            step()
            return 1
        except (ScanError, OSError, MemoryError) as error:
            self._image = None
            vtkOutputWindow.GetInstance().DisplayErrorText(f"{error}\n")
            return 0
