# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten and Compare on what it cannot flatten, and Show Seams on what has none: one sentence that names the cause, and
nothing is left."""

# First, for it lets Python find the modules of plugins.
from paraview import servermanager, simple  # isort: skip

import surfaceflattening_commands
from surfaceflattening_outlines import label_array, label_outlines
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

ARRAY = """
from vtkmodules.vtkCommonCore import vtk{kind}Array
array = vtk{kind}Array()
array.SetName("Array")
array.SetNumberOfComponents({components})
array.SetNumberOfTuples(self.GetInput().{count}())
for i in range(array.GetNumberOfValues()):
    array.SetValue(i, {value})
self.GetOutput().ShallowCopy(self.GetInput())
"""
POINTS = """
from vtkmodules.vtkCommonCore import vtkPoints
points = vtkPoints()
for k in range(3):
    points.InsertNextPoint(k, k * k, 0)
self.GetOutput().SetPoints(points)
"""
SCALARS = "self.GetOutput().GetPointData().SetScalars(array)"
LABELS = "self.GetOutput().GetCellData().AddArray(array)"


def said_by(command):
    """What the command says, line by line, without what VTK writes before a message."""
    window = vtkStringOutputWindow()
    earlier = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    surfaceflattening_commands.run(command)
    vtkOutputWindow.SetInstance(earlier)
    lines = [line.split("): ", 1)[-1] for line in window.GetOutput().splitlines()]
    return [line for line in lines if line.strip() and not line.startswith(("ERROR:", "Warning:"))]


def expect(words, source, command="flatten_and_compare"):
    simple.SetActiveSource(source)
    before = (set(simple.GetSources()), len(simple.GetLayouts()))
    said = said_by(command)
    assert len(said) == 1 and words in said[0], (words, said)
    assert (set(simple.GetSources()), len(simple.GetLayouts())) == before, words


def with_array(source, addition, **parts):
    made = simple.ProgrammableFilter(Input=source, Script=ARRAY.format(**parts) + addition)
    made.UpdatePipeline()
    return made


expect("no source is selected", None)
expect("no source is selected", None, "show_seams")
wavelet = simple.Wavelet()
expect("has no seams", wavelet, "show_seams")
expect("has no seams", simple.SurfaceToDisk(Input=simple.Sphere(EndPhi=90)), "show_seams")  # a disk as it is
expect("a single slice, of 21 x 21 x 1 voxels", simple.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0]))
expect(
    "all voxels have the value 7",
    with_array(wavelet, SCALARS, kind="Double", components=1, count="GetNumberOfPoints", value=7),
)
expect(
    "has 4 values",
    with_array(wavelet, SCALARS, kind="Double", components=4, count="GetNumberOfPoints", value="i"),
)
expect("the surface has no triangles", simple.PointSource(NumberOfPoints=50))
expect("points and no triangles", simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=POINTS))
expect("neither a surface nor a scan", simple.Tetrahedralize(Input=wavelet))

# Several sources are selected.
sphere, cone = simple.Sphere(EndPhi=90, ThetaResolution=64), simple.Cone()
simple.SetActiveSource(sphere)
selected = servermanager.ProxyManager().GetSelectionModel("ActiveSources")
selected.Select(cone.SMProxy, 2)  # adds
assert selected.GetNumberOfSelectedProxies() == 2, selected.GetNumberOfSelectedProxies()
assert any("several sources are selected" in line for line in said_by("flatten_and_compare"))

# Labels that are strings are no outlines, and no error. The input is a disk.
names = with_array(sphere, LABELS, kind="String", components=1, count="GetNumberOfCells", value="'ab'[i % 2]")
simple.SetActiveSource(names)
assert said_by("flatten_and_compare") == []
assert len(simple.GetLayouts()) == 1

# The name of an array is no code, whatever it holds.
NAME = 'a"b\'c\\ {0} " + missing + "'
script = ARRAY.replace('"Array"', repr(NAME).replace("{", "{{").replace("}", "}}")) + LABELS
script = script.format(kind="Int", components=1, count="GetNumberOfCells", value="i % 2")
quoted = simple.ProgrammableFilter(Input=sphere, Script=script)
quoted.UpdatePipeline()
assert label_array(quoted) == ("CELLS", NAME), label_array(quoted)
outlines = label_outlines(quoted, *label_array(quoted))
outlines.UpdatePipeline()
drawn = servermanager.Fetch(outlines)
assert drawn.GetNumberOfLines() > 0 and drawn.GetNumberOfPolys() == 0  # a script that fails leaves its input
