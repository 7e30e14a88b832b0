# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat map as an image by paraview.simple, a picture brought to the surface, and OBJ, PLY and glTF files
with texture, written and read again."""

import base64
import json
import math
import os
import struct
import zlib

from paraview import servermanager
from paraview.simple import (
    Calculator,
    Clip,
    ColorBy,
    ConformalDisk,
    CreateRenderView,
    CreateTexture,
    ExportView,
    ExtractSurface,
    FlatMapImage,
    GetColorTransferFunction,
    GetParaViewVersion,
    OMTAreaPreserving,
    OpenDataFile,
    PNGSeriesReader,
    Render,
    SaveData,
    Show,
    Sphere,
    SurfaceToDisk,
)
from surfaceflattening_texture import sampled, save_textured_obj, save_texture, surface_of

folder = os.path.join(os.environ["TEMPORARY_DIRECTORY"], "Textures")
os.makedirs(folder, exist_ok=True)


def file(name):
    return os.path.join(folder, name)


def fetched(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def point_array(data, name):
    array = data.GetPointData().GetArray(name)
    assert array is not None, name
    return array


def slope(point):
    return point[0] + 2 * point[1] + 3 * point[2]


ball = Sphere(Radius=20, ThetaResolution=80, PhiResolution=80)
upper = Clip(Input=ball, ClipType="Plane")
upper.ClipType.Normal, upper.ClipType.Origin = [0, 0, -1], [0, 0, 0]
disk = SurfaceToDisk(Input=ExtractSurface(Input=upper))
# No rotated or mirrored picture of this array looks the same.
ramp = Calculator(Input=disk, ResultArrayName="Ramp", Function="coordsX+2*coordsY+3*coordsZ")
flat = OMTAreaPreserving(Input=ConformalDisk(Input=ramp))

# Every property of the image.
image = FlatMapImage(Input=flat, Size=300, Margin=4)
pixels = fetched(image)
assert pixels.GetDimensions() == (300, 300, 1)
values, inside = point_array(pixels, "Ramp"), point_array(pixels, "InMap")
points, cells = point_array(pixels, "SurfacePoints"), point_array(pixels, "CellId")
seen = 0
for i in range(pixels.GetNumberOfPoints()):
    assert (cells.GetTuple1(i) >= 0) == (inside.GetTuple1(i) == 1)
    if inside.GetTuple1(i):
        seen += 1
        assert abs(slope(points.GetTuple3(i)) - values.GetTuple1(i)) < 1e-9
        assert 19.9 < math.hypot(*points.GetTuple3(i)) < 20.001
length = pixels.GetFieldData().GetArray("PixelLength").GetTuple1(0)
assert math.isclose(seen * length**2, 2 * math.pi * 400, rel_tol=0.01)
fine = FlatMapImage(Input=flat, PixelLength=0.5)
assert fetched(fine).GetDimensions()[0] == math.ceil(40 * math.sqrt(2) / 0.5)
assert not set(FlatMapImage(Input=flat).ListProperties()) - {"Input", "Size", "PixelLength", "Margin"}

# The image is saved in the colours of the array: blue where it is low, red where it is high.
colours = GetColorTransferFunction("Ramp")
colours.RGBPoints = [-45, 0, 0, 1, 75, 1, 0, 0]
colours.ColorSpace = "RGB"
save_texture(image, "Ramp", file("ramp.png"))

# The picture on the map and its surface, as an array: red is 0 at -45, 255 at 75.
opened = OpenDataFile(file("ramp.png"))
if opened.SMProxy.GetXMLName() != "PNGSeriesReader":  # ParaView 5.11 opens it with GDAL
    try:
        sampled(opened, flat)
        raise AssertionError("GDAL's values at cells were taken")
    except ValueError as error:
        assert "PNGSeriesReader" in str(error)
coloured = surface_of(sampled(PNGSeriesReader(FileNames=[file("ramp.png")]), flat))
data = fetched(coloured)
assert data.GetNumberOfPoints() == fetched(flat).GetNumberOfPoints()
red = point_array(data, "PNGImage")
greatest = 0.0
for i in range(data.GetNumberOfPoints()):
    asked = 255 * (slope(data.GetPoint(i)) + 45) / 120
    greatest = max(greatest, abs(red.GetTuple(i)[0] - asked))
print(f"a picture of 300 pixels, on the surface: red is off by {greatest:.2f} of 255 at most")
# The tolerance is half a step of rounding plus the curvature over the width of a pixel.
assert greatest < 2, greatest

# Written with ParaView's writers and read again: the texture coordinates of every point.
surface = surface_of(flat)
expected = point_array(fetched(surface), "TCoords")
save_textured_obj(surface, file("ramp.png"), file("textured.obj"))
SaveData(file("plain.obj"), surface)
SaveData(file("plain.ply"), surface)
for name in ("textured.obj", "plain.obj", "plain.ply"):
    again = fetched(OpenDataFile(file(name)))
    assert again.GetNumberOfPoints() == expected.GetNumberOfTuples(), name
    assert again.GetNumberOfCells() == fetched(surface).GetNumberOfCells(), name
    coordinates = again.GetPointData().GetTCoords()
    for i in range(again.GetNumberOfPoints()):
        for k in range(2):
            assert abs(coordinates.GetComponent(i, k) - expected.GetComponent(i, k)) < 1e-5, name
for write in (
    lambda: save_texture(image, "Ramp", file("missing/ramp.png")),
    lambda: save_textured_obj(surface, file("ramp.png"), file("missing/textured.obj")),
):
    try:
        write()
        raise AssertionError("a file in a folder that is missing")
    except OSError as error:
        assert "missing/" in str(error) and "cannot be written (No such file or directory)" in str(error), error
with open(file("textured.obj"), encoding="ascii") as lines:
    assert "mtllib textured.mtl" in lines.read()
with open(file("textured.mtl"), encoding="ascii") as lines:
    material = [line.split() for line in lines if line.strip()]
assert ["map_Kd", "ramp.png"] in material, material

# glTF holds the picture itself. Its images begin at the top, VTK's at the bottom.
view = CreateRenderView()
display = Show(surface, view)
ColorBy(display, None)  # else the exporter writes the colour map as the texture
display.Texture = CreateTexture(file("ramp.png"))
display.Texture.FileName = file("ramp.png")  # which CreateTexture of ParaView 5.13 forgets
Render(view)
ExportView(file("textured.gltf"), view=view)
with open(file("textured.gltf"), encoding="utf-8") as stream:
    scene = json.load(stream)


def view_of(index):
    part = scene["bufferViews"][index]
    uri = scene["buffers"][part["buffer"]]["uri"]
    if uri.startswith("data:"):
        whole = base64.b64decode(uri.split(",", 1)[1])
    else:
        with open(file(uri), "rb") as stream:
            whole = stream.read()
    return whole[part.get("byteOffset", 0) :][: part["byteLength"]]


primitive = scene["meshes"][0]["primitives"][0]
accessor = scene["accessors"][primitive["attributes"]["TEXCOORD_0"]]
assert accessor["count"] == expected.GetNumberOfTuples()
written = struct.unpack(f"<{2 * accessor['count']}f", view_of(accessor["bufferView"]))
for i in range(accessor["count"]):
    for k in range(2):
        assert abs(written[2 * i + k] - expected.GetComponent(i, k)) < 1e-6
texture = scene["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorTexture"]
picture = view_of(scene["images"][scene["textures"][texture["index"]]["source"]]["bufferView"])
assert picture[:8] == b"\x89PNG\r\n\x1a\n"
with open(file("in_gltf.png"), "wb") as stream:
    stream.write(picture)
original, turned = (fetched(PNGSeriesReader(FileNames=[file(f)])) for f in ("ramp.png", "in_gltf.png"))
if turned.GetDimensions() == (300, 1, 1) and GetParaViewVersion() >= (5, 12):
    print("this ParaView writes one row of the picture alone to glTF")
else:
    assert turned.GetDimensions() == (300, 300, 1)
    different = 0
    for row in range(300):
        for column in range(300):
            there = turned.GetScalarComponentAsDouble(column, 299 - row, 0, 0)
            different += original.GetScalarComponentAsDouble(column, row, 0, 0) != there
    assert different == 0, different
