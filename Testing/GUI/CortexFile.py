# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the file that CortexToNumber.xml opens: a brain as a PLY file, of every second voxel of Debian's example MRI."""

import os
import sys

from surfaceflattening import isosurface
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkIOPLY import vtkPLYWriter

scan = vtkNIFTIImageReader()
scan.SetFileName("/usr/share/mricron/templates/ch2bet.nii.gz")
half = vtkImageShrink3D()
half.SetInputConnection(scan.GetOutputPort())
half.SetShrinkFactors(2, 2, 2)
half.Update()
os.makedirs(os.path.dirname(sys.argv[1]), exist_ok=True)
writer = vtkPLYWriter()
writer.SetInputData(isosurface(half.GetOutput(), smoothing_mm=2, component="Largest"))
writer.SetFileName(sys.argv[1])
writer.Write()
