# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts pictures out of xwd's dumps of the screen and joins them side by side.

    grab.py picture.png left,top,right,bottom dump...
"""

import struct
import sys

from PIL import Image


def screen(dump):
    with open(dump, "rb") as file:
        data = file.read()
    header = struct.unpack(">25I", data[:100])
    size, width, height = header[0], header[4], header[5]
    bits, bytes_per_line, colours = header[11], header[12], header[19]
    pixels = data[size + 12 * colours :]
    mode = "BGRX" if bits == 32 else "BGR"
    return Image.frombuffer("RGB", (width, height), pixels, "raw", mode, bytes_per_line, 1)


picture, box, *dumps = sys.argv[1:]
parts = [screen(dump).crop([int(edge) for edge in box.split(",")]) for dump in dumps]
joined = Image.new("RGB", (sum(part.width for part in parts), parts[0].height))
left = 0
for part in parts:
    joined.paste(part, (left, 0))
    left += part.width
# 255 colours: a quarter of the size, and no difference that one sees.
joined.quantize(255, dither=Image.Dither.NONE).save(picture, optimize=True)
