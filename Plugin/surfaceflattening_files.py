# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat map in files that other programs read.

    from surfaceflattening_files import save_flat_map

    save_flat_map(measured, "flat.vtp")  # and flat_Summary.csv

The module comes with the plugin. The command "Save Flat Map..." calls it for the source that is selected in the
pipeline browser.
"""

import os

from paraview import servermanager, simple


def save_flat_map(source, path):
    """Writes the first output of @source to @path, as VTK XML with binary data if it ends in .vtp, and each of its
    tables beside it as CSV, with the name of the output. Returns the paths.

    @raise ValueError if there is no source or its first output is empty.
    @raise OSError if the folder cannot be written.
    """
    if source is None:
        raise ValueError("no source is selected: click a flat map in the pipeline browser first")
    source.UpdatePipeline()
    if source.GetDataInformation().GetNumberOfCells() == 0:
        raise ValueError("the selected source is empty: select a flat map in the pipeline browser, and press Apply")
    stem, ending = os.path.splitext(path)
    folder = os.path.dirname(os.path.abspath(path))
    if not os.access(folder, os.W_OK):
        raise OSError(f"{folder} cannot be written: choose another folder")
    simple.SaveData(path, proxy=source, **({"DataMode": "Binary"} if ending == ".vtp" else {}))
    paths = [path]
    for port in range(1, source.SMProxy.GetNumberOfOutputPorts()):
        table = servermanager.Fetch(source, idx=port)
        if table is not None and table.IsA("vtkTable") and table.GetNumberOfRows() > 0:
            paths.append(f"{stem}_{source.SMProxy.GetOutputPortName(port)}.csv")
            simple.SaveData(paths[-1], proxy=simple.OutputPort(source, port), Precision=9)
    return paths
