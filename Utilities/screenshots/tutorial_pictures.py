# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes PNG pictures of what was on the virtual screen: run by tutorial.sh, in pvpython.

    pvpython tutorial_pictures.py folder picture.xwd ...
"""

import os
import struct
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

# Fields of an X window dump's header, by their place among its 32-bit numbers; XWDFile.h has them all.
HEADER_SIZE, WIDTH, HEIGHT, BITS_PER_PIXEL, BYTES_PER_LINE, COLOURS = 0, 4, 5, 11, 12, 19
COLOUR_SIZE = 12


def read_dump(path):
    """Rows of red, green and blue, from the top down."""
    with open(path, "rb") as stream:
        data = stream.read()
    header = struct.unpack(">25I", data[:100])
    if header[BITS_PER_PIXEL] != 32:
        raise ValueError(f"{path} has {header[BITS_PER_PIXEL]} bits per pixel: 32 can be read")
    begin = header[HEADER_SIZE] + COLOUR_SIZE * header[COLOURS]
    rows = numpy.frombuffer(data, numpy.uint8, header[HEIGHT] * header[BYTES_PER_LINE], begin)
    rows = rows.reshape(header[HEIGHT], -1)[:, : 4 * header[WIDTH]]
    return rows.reshape(header[HEIGHT], header[WIDTH], 4)[:, :, 2::-1]


def without_background(picture):
    """The part of the screen that is not black, which is the window."""
    lit = picture.any(axis=2)
    rows, columns = numpy.flatnonzero(lit.any(axis=1)), numpy.flatnonzero(lit.any(axis=0))
    return picture[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]


def write(picture, path):
    height, width, _ = picture.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    pixels = numpy.ascontiguousarray(picture[::-1]).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(9)
    writer.SetFileName(path)
    writer.Write()


folder = sys.argv[1]
for dump in sys.argv[2:]:
    png = os.path.join(folder, os.path.splitext(os.path.basename(dump))[0] + ".png")
    write(without_background(read_dump(dump)), png)
    print(png, os.path.getsize(png), "bytes")
