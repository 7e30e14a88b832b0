# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader and the writer of files of FreeSurfer and GIFTI behind the proxies in NeuroFiles.xml."""

from surfaceflattening_neuro import CortexError, read_cortex
from surfaceflattening_neuro_writers import write_cortex
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData


def _reported(step):
    try:
        step()
        return 1
    except (CortexError, OSError, MemoryError) as error:
        vtkOutputWindow.GetInstance().DisplayErrorText(f"{error}\n")
        return 0


def _warn(text):
    vtkOutputWindow.GetInstance().DisplayWarningText(f"{text}\n")


class CortexReader(VTKPythonAlgorithmBase):
    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self._path, self._overlays = None, []

    def SetFileName(self, path):
        self._path = path
        self.Modified()

    def AddOverlay(self, path):
        if path:
            self._overlays.append(path)
        self.Modified()

    def ClearOverlays(self):
        self._overlays = []
        self.Modified()

    def RequestData(self, _request, _inputs, outputs):
        output = vtkPolyData.GetData(outputs, 0)
        return _reported(lambda: output.ShallowCopy(read_cortex(self._path, self._overlays, _warn)))


class CortexWriter(VTKPythonAlgorithmBase):
    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=0, inputType="vtkPolyData")
        self._path, self._array = None, None

    def SetFileName(self, path):
        self._path = path
        self.Modified()

    def SetPointArray(self, name):
        self._array = name or None
        self.Modified()

    def RequestData(self, _request, inputs, _outputs):
        data = vtkPolyData.GetData(inputs[0], 0)
        return _reported(lambda: write_cortex(self._path, data, self._array, _warn))

    def Write(self):
        self.Modified()
        self.Update()
