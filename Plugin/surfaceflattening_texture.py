# SPDX-License-Identifier: GPL-3.0-or-later
"""Textures of flat maps: an image of a flat map saved as a picture, a picture brought to the surface, and
both written to files that other programs read.

    from surfaceflattening_texture import save_texture, surface_of, sampled, save_textured_obj

    image = FlatMapImage(Input=flat, Size=1024)
    save_texture(image, "AreaDistortion", "texture.png")
    surface = surface_of(flat)  # in space, with the texture coordinates of the map
    texture = CreateTexture("texture.png")
    texture.FileName = "texture.png"  # which CreateTexture of ParaView 5.13 forgets
    Show(surface).Texture = texture

The module comes with the plugin: once that is loaded, ParaView's Python Shell and pvpython can import it.
docs/textures.md has the same as clicks.
"""

import os

from paraview import servermanager, simple
from surfaceflattening_whole_file import whole_file


def surface_of(flat):
    """The surface that the map @flat is of, in space, with all arrays of the map: stock Calculator, whose
    result SurfacePoints becomes the coordinates."""
    return simple.Calculator(
        registrationName="Surface", Input=flat, CoordinateResults=1, Function="SurfacePoints"
    )


def save_texture(image, array, path):
    """Writes the @array of a Flat Map Image as a PNG file, in the colours that ParaView shows it in.

    Arrays of three or four bytes are colours as they are. Pixels without a number get the colour that
    the colour map has for NaN. Raises ValueError, and OSError if the file cannot be written.
    """
    from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkPNGWriter

    image.UpdatePipeline()
    data = servermanager.Fetch(image)
    values = data.GetPointData().GetArray(array) if data.GetNumberOfPoints() else None
    if values is None:
        raise ValueError(f"the image has no array {array}: pass a Flat Map Image and one of its arrays")
    if not (isinstance(values, vtkUnsignedCharArray) and values.GetNumberOfComponents() in (3, 4)):
        table = simple.GetColorTransferFunction(array)
        values = table.GetClientSideObject().MapScalars(values, 0, -1)
    picture = vtkImageData()
    picture.SetExtent(data.GetExtent())
    picture.GetPointData().SetScalars(values)
    writer = vtkPNGWriter()
    writer.SetInputData(picture)
    with whole_file(path) as part:
        writer.SetFileName(part)
        writer.Write()


def sampled(picture, flat):
    """The arrays of @picture at every point of the flat map @flat, as point arrays of the map.

    @picture: a proxy of an image of any size that covers the texture coordinates of the map from 0 to 1,
        with values at points, such as PNGSeriesReader(FileNames=["picture.png"]). OpenDataFile takes GDAL
        for pictures, which has the values at cells.

    Stock filters do it: Calculator brings the map over the picture by its texture coordinates, the points
    in the outermost half pixel to the centres of the outermost pixels; Resample With Dataset interpolates
    there; Append Attributes brings the result to the map. surface_of() shows it in space.
    """
    picture.UpdatePipeline()
    flat.UpdatePipeline()
    information = picture.GetDataInformation()
    if information.GetDataSetTypeAsString() not in ("vtkImageData", "vtkUniformGrid"):
        raise ValueError("this is no image: check that the file could be read")
    if information.GetPointDataInformation().GetNumberOfArrays() == 0:
        raise ValueError("the image has no values at its points: open it with PNGSeriesReader")
    coordinates = flat.PointData.GetArray("TCoords")
    if coordinates is None or coordinates.GetNumberOfComponents() != 2:
        raise ValueError("the map has no texture coordinates TCoords: pass the output of OMT Area Preserving")
    bounds, extent = information.GetBounds(), information.GetExtent()

    def over(axis, letter):
        low, high = bounds[2 * axis], bounds[2 * axis + 1]
        pixels = extent[2 * axis + 1] - extent[2 * axis] + 1
        if pixels < 2:
            raise ValueError("the image is less than 2 pixels wide or high")
        pixel = (high - low) / (pixels - 1)
        place = f"{low!r}+{pixel!r}*({pixels}*TCoords_{letter}-0.5)"
        return f"max({low!r},min({high!r},{place}))"

    placed = simple.Calculator(
        registrationName="Map over the picture",
        Input=flat,
        CoordinateResults=1,
        ResultTCoords=0,
        Function=f"({over(0, 'X')})*iHat+({over(1, 'Y')})*jHat+({bounds[4]!r})*kHat",
    )
    return simple.AppendAttributes(
        registrationName="Map with the picture",
        Input=[flat, simple.ResampleWithDataset(SourceDataArrays=picture, DestinationMesh=placed)],
    )


def save_textured_obj(surface, texture, path):
    """Writes @surface with its texture coordinates to @path (.obj) and beside it a material (.mtl) that
    names the picture @texture. ParaView's own OBJ writer leaves the material out. Raises ValueError, and OSError
    if the files cannot be written."""
    from vtkmodules.vtkIOGeometry import vtkOBJWriter

    surface.UpdatePipeline()
    data = servermanager.Fetch(surface)
    if data.GetNumberOfPoints() == 0 or data.GetPointData().GetTCoords() is None:
        raise ValueError("the surface has no texture coordinates: pass surface_of(map)")
    if not os.path.exists(texture):
        raise ValueError(f"there is no file {texture}: write it with save_texture first")
    writer = vtkOBJWriter()
    writer.SetInputData(data)
    writer.SetTextureFileName(os.path.relpath(texture, os.path.dirname(os.path.abspath(path))))
    with whole_file(path) as part:
        writer.SetFileName(part)
        writer.Write()
