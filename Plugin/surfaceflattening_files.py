# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat map in files that other programs read.

    from surfaceflattening_files import save_flat_map

    save_flat_map(measured, "flat.vtp")  # and flat_Summary.csv

The module comes with the plugin. The command "Save Flat Map..." calls it for the source that is selected in the
pipeline browser.
"""

import os

from paraview import servermanager, simple
from surfaceflattening_whole_file import whole_file


def save_flat_map(source, path):
    """Writes the first output of @source to @path, as VTK XML with binary data if it ends in .vtp, and each of its
    tables beside it as CSV, with the name of the output. Returns the paths.

    @raise ValueError if there is no source, its first output is empty, or the name tells no format.
    @raise OSError if a file cannot be written: an earlier one of its name stays as it was.
    """
    if source is None:
        raise ValueError("no source is selected: click a flat map in the pipeline browser first")
    source.UpdatePipeline()
    if source.GetDataInformation().GetNumberOfCells() == 0:
        raise ValueError("the selected source is empty: select a flat map in the pipeline browser, and press Apply")
    stem, ending = os.path.splitext(path)
    _save(path, source, **({"DataMode": "Binary"} if ending == ".vtp" else {}))
    paths = [path]
    for port in range(1, source.SMProxy.GetNumberOfOutputPorts()):
        table = servermanager.Fetch(source, idx=port)
        if table is not None and table.IsA("vtkTable") and table.GetNumberOfRows() > 0:
            paths.append(f"{stem}_{source.SMProxy.GetOutputPortName(port)}.csv")
            _save(paths[-1], simple.OutputPort(source, port), Precision=9)
    return paths


def _save(path, output, **settings):
    """SaveData(), which says nothing if it writes nothing."""
    with whole_file(path) as part:
        try:
            writer = simple.CreateWriter(part, output, **settings)
        except (AttributeError, RuntimeError):  # as ParaView has it where there is no writer
            writer = None
        if not writer:
            raise ValueError(f"{path}: the name does not end as a format for this data does: end it with .vtp, say")
        writer.UpdateVTKObjects()
        writer.UpdatePipeline()
