# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the gallery: panels drawn by ParaView, put side by side with captions."""

import os
import tempfile

import matplotlib
from paraview import simple
from PIL import Image, ImageDraw, ImageFont

INK = (26, 26, 26)
OVERSAMPLING = 2  # lines and points are drawn larger and scaled down
MARGIN = 14  # pixels
CAPTION_SIZE = 17
GREATEST_FILE = 250_000  # bytes


def font(size):
    return ImageFont.truetype(os.path.join(matplotlib.get_data_path(), "fonts/ttf/DejaVuSans.ttf"), size)


def new_view():
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.CameraParallelProjection = 1
    return view


def look(view, bounds, size, direction=(0, 0, -1), up=(0, 1, 0), margin=0.03):
    """Points a parallel camera along @p direction at the box @p bounds and fits it into the picture."""
    centre = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
    extent = [bounds[2 * k + 1] - bounds[2 * k] for k in range(3)]
    side = (
        direction[1] * up[2] - direction[2] * up[1],
        direction[2] * up[0] - direction[0] * up[2],
        direction[0] * up[1] - direction[1] * up[0],
    )
    height = sum(e * abs(u) for e, u in zip(extent, up))
    width = sum(e * abs(s) for e, s in zip(extent, side))
    distance = 3 * max(extent)
    view.CameraFocalPoint = centre
    view.CameraPosition = [c - distance * d for c, d in zip(centre, direction)]
    view.CameraViewUp = list(up)
    view.CameraParallelScale = (1 + 2 * margin) * max(height, width * size[1] / size[0]) / 2


def screenshot(view, size):
    """An image of @p view in @p size pixels; the view is deleted."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "panel.png")
        view.ViewSize = [OVERSAMPLING * s for s in size]
        simple.SaveScreenshot(path, view, ImageResolution=[OVERSAMPLING * s for s in size])
        with Image.open(path) as image:
            panel = image.convert("RGB").resize(size, Image.LANCZOS)
    simple.Delete(view)
    return panel


def show_flat(source, view):
    """Shown without light: what lies in the plane has the colours it is given."""
    display = simple.Show(source, view)
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    display.InterpolateScalarsBeforeMapping = 0
    return display


def show_solid(source, view):
    display = simple.Show(source, view)
    display.Ambient, display.Diffuse, display.Specular = 0.25, 0.8, 0.0
    return display


def one_colour(display, colour):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = list(colour)


def show_lines(source, view, colour, width):
    display = show_flat(source, view)
    display.SetRepresentationType("Wireframe")
    one_colour(display, colour)
    display.LineWidth = OVERSAMPLING * width
    return display


def show_points(source, view, colour, size):
    display = show_flat(source, view)
    display.SetRepresentationType("Points")
    one_colour(display, colour)
    display.RenderPointsAsSpheres = 1
    display.PointSize = OVERSAMPLING * size
    return display


def categories(array, colours):
    """Colours @p array, of whole numbers, by category: {value: (red, green, blue)}."""
    table = simple.GetColorTransferFunction(array)
    table.InterpretValuesAsCategories = 1
    table.AnnotationsInitialized = 1
    table.Annotations = [text for value in colours for text in (str(value), str(value))]
    table.IndexedColors = [channel for colour in colours.values() for channel in colour]
    return table


def colour_by(display, association, array):
    """Without the rescaling and the bar that ColorBy adds."""
    display.ColorArrayName = [association, array]
    display.LookupTable = simple.GetColorTransferFunction(array)


def ring(image, centre, radius, colour=(220, 30, 30), width=3):
    """Draws a circle on a panel, in pixels."""
    box = [centre[0] - radius, centre[1] - radius, centre[0] + radius, centre[1] + radius]
    ImageDraw.Draw(image).ellipse(box, outline=colour, width=width)


def frame(image, box, colour=(220, 30, 30), width=3):
    ImageDraw.Draw(image).rectangle(list(box), outline=colour, width=width)


def compose(path, rows, smooth=False):
    """Writes one PNG: rows of (image, caption), captions below, lines broken at newlines. Smooth: shades
    count more than rare colours."""
    face = font(CAPTION_SIZE)
    line = CAPTION_SIZE + 5

    def caption_height(row):
        return line * max(caption.count("\n") + 1 for _, caption in row) + 6

    width = max(sum(image.width for image, _ in row) + MARGIN * (len(row) + 1) for row in rows)
    height = MARGIN + sum(
        max(image.height for image, _ in row) + caption_height(row) + MARGIN for row in rows
    )
    sheet = Image.new("RGB", (width, height), "white")
    draw = ImageDraw.Draw(sheet)
    top = MARGIN
    for row in rows:
        tallest = max(image.height for image, _ in row)
        left = (width - sum(image.width for image, _ in row) - MARGIN * (len(row) - 1)) // 2
        for image, caption in row:
            sheet.paste(image, (left, top + (tallest - image.height) // 2))
            for number, text in enumerate(caption.split("\n")):
                wide = draw.textlength(text, font=face)
                place = (left + (image.width - wide) / 2, top + tallest + 4 + number * line)
                draw.text(place, text, fill=INK, font=face)
            left += image.width + MARGIN
        top += tallest + caption_height(row) + MARGIN
    save_small(sheet, path, smooth)


def save_small(image, path, smooth):
    """Saves the image with as many colours as the greatest size of a file allows."""
    method = Image.Quantize.MEDIANCUT if smooth else Image.Quantize.MAXCOVERAGE
    for colours in (256, 128, 64, 32, 16):
        image.quantize(colours, method, dither=Image.Dither.NONE).save(path, optimize=True)
        if os.path.getsize(path) <= GREATEST_FILE:
            return
    raise RuntimeError(f"{path} is larger than {GREATEST_FILE} bytes: make the panels smaller")
