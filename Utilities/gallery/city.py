# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 8: a street map with a lens in which a map of higher resolution fits without landmarks."""

import numpy as np
import meshes
import panels
import plane_lens
from paraview import servermanager
from PIL import Image, ImageDraw
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

TITLE = "City map (Figure 8)"
PICTURE = "city.png"
WIDTH, HEIGHT = 12.0, 8.0  # km
CENTRE, RADIUS = (6.6, 4.3, 0.0), 1.15
FACTOR = 6.0
SIZE = (600, 400)
COARSE = 50  # pixels per km
FINE = 8  # times as many in the detailed map
OVERSAMPLING = 2
PARKS = (
    ((7.9, 5.3), (9.4, 5.45), (9.6, 6.9), (8.2, 6.8)),
    ((2.0, 5.2), (3.0, 5.0), (3.1, 5.8), (2.2, 6.0)),
)
NORTH, SOUTH = 0.14, -0.35  # directions of the districts' streets, radians


def avenue(a, b, width):
    """A straight street: its ends and its width (km)."""
    return np.array(a), np.array(b), width


def district(step, turn, width, seed, share):
    """Streets across the whole city in two directions, @p turn (radians) from the axes; some left out."""
    random = np.random.default_rng(seed)
    along = np.array([np.cos(turn), np.sin(turn)])
    across = np.array([-np.sin(turn), np.cos(turn)])
    middle = np.array([WIDTH, HEIGHT]) / 2
    for one, other, gap in ((along, across, step[0]), (across, along, step[1])):
        for k in np.arange(-9, 9, gap):
            if random.random() < share:
                yield avenue(middle + k * one - 9 * other, middle + k * one + 9 * other, width)


def boulevards():
    angles = np.linspace(0, 2 * np.pi, 60)
    circle = np.column_stack([6.0 + 2.9 * np.cos(angles), 4.4 + 2.5 * np.sin(angles)])
    yield from (avenue(a, b, 0.1) for a, b in zip(circle, circle[1:]))
    yield avenue((0.0, 7.6), (12.0, 0.9), 0.1)
    yield avenue((1.2, 0.0), (9.6, 8.0), 0.08)


def river():
    x = np.linspace(-0.5, WIDTH + 0.5, 600)
    return np.column_stack([x, 1.6 + 0.9 * np.sin(0.55 * x + 0.6) + 0.16 * x])


def houses():
    """Ground plans in the northern district, each with a shade of its own."""
    random = np.random.default_rng(5)
    turn = np.array([[np.cos(NORTH), np.sin(NORTH)], [-np.sin(NORTH), np.cos(NORTH)]])
    middle = np.array([WIDTH, HEIGHT]) / 2
    for x in np.arange(-3, 3, 0.05):
        for y in np.arange(-3, 3, 0.044):
            if random.random() < 0.75:
                size = 0.016 + 0.022 * random.random(2)
                corners = np.array([[x, y], [x + size[0], y], [x + size[0], y + size[1]], [x, y + size[1]]])
                yield middle + corners @ turn, int(random.integers(3))


def draw(box, scale, detailed):
    """The part of the city in a box (km), as an array with row 0 at the bottom."""
    left, bottom, right, top = box
    size = (round((right - left) * scale), round((top - bottom) * scale))
    scale *= OVERSAMPLING

    def sheet(colour):
        image = Image.new("RGB", tuple(OVERSAMPLING * s for s in size), colour)
        return image, ImageDraw.Draw(image)

    def places(points):
        return [((p[0] - left) * scale, (top - p[1]) * scale) for p in points]

    def line(pen, points, width, colour):
        pen.line(places(points), fill=colour, width=max(OVERSAMPLING, round(width * scale)), joint="curve")

    def roads(pen, avenues):
        avenues = list(avenues)
        for a, b, width in avenues:
            line(pen, [a, b], width + 0.024, (214, 164, 96))
        for a, b, width in avenues:
            line(pen, [a, b], width, (252, 218, 152))

    ground = (241, 238, 230)
    north, pen = sheet(ground)
    for park in PARKS:
        pen.polygon(places(park), fill=(190, 221, 170))
    if detailed:
        for corners, shade in houses():
            colour = ((206, 184, 164), (194, 172, 158), (218, 202, 178))[shade]
            pen.polygon(places(corners), fill=colour)
        for a, b, width in district((0.2, 0.176), NORTH, 0.022, 3, 0.9):
            line(pen, [a, b], width, (255, 255, 255))
    roads(pen, district((1.0, 0.88), NORTH, 0.05, 1, 0.95))
    south, pen = sheet(ground)
    roads(pen, district((0.8, 1.1), SOUTH, 0.05, 2, 0.95))
    mask = Image.new("L", north.size, 0)
    bank = river()
    ImageDraw.Draw(mask).polygon(places([*bank, (WIDTH + 1, -1), (-1, -1)]), fill=255)
    north.paste(south, mask=mask)
    pen = ImageDraw.Draw(north)
    for x, y in places(bank):  # without the gaps that wide lines have at their joints
        reach = 0.17 * scale
        pen.ellipse([x - reach, y - reach, x + reach, y + reach], fill=(150, 190, 222))
    roads(pen, boulevards())
    return np.asarray(north.resize(size, Image.BOX))[::-1]


def image_source(pixels, box, name):
    """An image in the pipeline; pixels lie within the box (km), not on its sides."""
    height, width, _ = pixels.shape
    spacing = (box[2] - box[0]) / width
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    data.SetSpacing(spacing, spacing, 1)
    data.SetOrigin(box[0] + spacing / 2, box[1] + spacing / 2, 0)
    array = numpy_to_vtk(np.ascontiguousarray(pixels.reshape(-1, 3)), deep=1)
    array.SetName("Map")
    data.GetPointData().SetScalars(array)
    return meshes.source_of(data, name)


def warped(flat, source):
    """Pixels of a map carried to the whole picture, and which of them it covers."""
    data = servermanager.Fetch(plane_lens.carried(flat, source, ImageSize=[2 * s for s in SIZE]))
    pixels = vtk_to_numpy(data.GetPointData().GetArray("Map")).reshape(2 * SIZE[1], 2 * SIZE[0], 3)
    covered = vtk_to_numpy(data.GetPointData().GetArray("InMap")).reshape(2 * SIZE[1], 2 * SIZE[0])
    return pixels, covered


def panel(pixels):
    return Image.fromarray(np.ascontiguousarray(pixels[::-1])).resize(SIZE, Image.LANCZOS)


def mark(image, bounds):
    box = [v * s for v, s in zip(bounds, (SIZE[0] / WIDTH, SIZE[1] / HEIGHT) * 2)]
    panels.frame(image, (box[0], SIZE[1] - box[3], box[2], SIZE[1] - box[1]))
    return image


def region(points):
    return np.hypot(points[:, 0] - CENTRE[0], points[:, 1] - CENTRE[1]) <= RADIUS


def make(path):
    whole = (0, 0, WIDTH, HEIGHT)
    part = (CENTRE[0] - 1.6, CENTRE[1] - 1.6, CENTRE[0] + 1.6, CENTRE[1] + 1.6)
    coarse = draw(whole, COARSE, False)
    fine = draw(part, COARSE * FINE, True)
    mesh = plane_lens.rectangle(WIDTH, HEIGHT, 120, 80, "city_mesh.vtp")
    plane = plane_lens.conformal_rectangle(mesh, WIDTH, HEIGHT)
    flat = plane_lens.transport(plane_lens.magnify(plane, CENTRE, RADIUS, FACTOR, edge_width=0.8))

    overview, _ = warped(flat, image_source(coarse, whole, "city.vti"))
    detail, covered = warped(flat, image_source(fine, part, "city_detail.vti"))
    merged = np.where(covered[:, :, None] == 1, detail, overview)
    lens = [CENTRE[0] - RADIUS, CENTRE[1] - RADIUS, CENTRE[0] + RADIUS, CENTRE[1] + RADIUS]
    images = [
        (mark(panel(coarse), lens), "(a) the map; framed: the region"),
        (panel(overview), f"(b) the region {FACTOR:g} times as large, the same map"),
        (panel(merged), f"(c) with a map of {FINE} times the resolution"),
    ]
    close = merged[SIZE[1] // 2 : 3 * SIZE[1] // 2, SIZE[0] // 2 : 3 * SIZE[0] // 2]
    images.append((Image.fromarray(np.ascontiguousarray(close[::-1])), "(d) the middle of (c), pixel by pixel"))
    panels.compose(path, [images[:2], images[2:]])
    cells, faces = plane_lens.cell_factor(flat, region), plane_lens.face_factor(flat, region)
    points = meshes.fetched(flat)
    moved = np.abs(points.Points[:, :2].max(axis=0) - [WIDTH, HEIGHT]).max()
    return [
        f"A generated city of {WIDTH:g} km x {HEIGHT:g} km. The map is drawn twice, as a whole with {COARSE} "
        f"pixels per km and around the region with {COARSE * FINE}, lanes and houses included. Both are "
        "carried by the same deformed mesh (9,801 points), so that they fit without landmarks: streets run on "
        "from one to the other.",
        "",
        "| region: asked | cells | faces |",
        "|---|---|---|",
        f"| {FACTOR:g} | {cells:.6f} | {faces:.4f} |",
        "",
        f"The sides of the map stay where they are to {max(moved, 1e-15):.0e} km.",
        "",
        "In the GUI: *File > Open* `gallery-output/city.vti`, *Apply*; `city_detail.vti`, *Apply*; `city_mesh.vtp`, *Apply*. *Area Weights*: *Weights From* Implicit Function, "
        f"*Center* {CENTRE[0]:g} {CENTRE[1]:g} 0, *Radius* {RADIUS:g}, *Factor* {FACTOR:g}, *Factor Meaning* Magnification, *Edge Width* 0.8, *Apply*. *Conformal Disk*: *Domain* Rectangle, *Use "
        f"Corners*, *Lower Left* 0 0 0, *Lower Right* {WIDTH:g} 0 0, *Upper Right* {WIDTH:g} {HEIGHT:g} 0, *Upper Left* 0 {HEIGHT:g} 0, *Apply*. *OMT Area Preserving*: leave *Use Area Weight* checked, "
        "uncheck *Face Refinement*, *Apply*. *Planar Warp*: *Carried*, *city.vti*, *OK*, *Apply*. Click *Area-Preserving Disk* in the *Pipeline Browser*; *Planar Warp* "
        f"again, *Carried*, *city_detail.vti*, *OK*, *Image Size* {4 * SIZE[0]} {4 * SIZE[1]}, *Apply*; *Threshold* of `InMap` with *Lower Threshold* 1, *Apply*; hide PlanarWarp2. "
        "Type `map scalars` in the search box of the panel and uncheck *Map Scalars* of Threshold1 and of PlanarWarp1: their own colours.",
    ]
