from vtkmodules.vtkIOXML import *
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy as V
r=vtkXMLPolyDataReader(); r.SetFileName('/tmp/t/h2/brain.vtp'); c=vtkCleanPolyData(); c.SetInputConnection(r.GetOutputPort()); c.PointMergingOff(); c.Update(); d=c.GetOutput()
w=vtkXMLPolyDataWriter(); w.SetInputData(d); w.SetFileName('/tmp/t/h2/brain.vtp'); w.Write()
P=V(d.GetPoints().GetData()).astype(float); F=V(d.GetPolys().GetConnectivityArray()).reshape(-1,3).astype(np.int32)
with open('/tmp/t/h2/brain.bin','wb') as o: np.array([len(P),len(F)],np.int32).tofile(o); P.tofile(o); F.tofile(o)
