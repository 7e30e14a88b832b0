# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 7: the earth, cut open in the Pacific and flattened with the true areas of its continents."""

import numpy as np
import meshes
import panels
from paraview import servermanager, simple
from PIL import Image, ImageDraw
from scipy.spatial import ConvexHull
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersHybrid import vtkEarthSource

TITLE = "Earth (Figure 7)"
PICTURE = "earth.png"
SIZE = (440, 440)
RADIUS = 6371.0  # km
POINTS = 16000
HOLE = 0.03  # share of the sphere
CENTRE = (20.0, 12.0)  # longitude and latitude of the middle of the maps; the cut is opposite
SHEET = (2880, 1440)  # pixels of the world image, longitude by latitude
# A place in each of the largest pieces of land that VTK's earth has.
LANDS = {
    "Eurasia and Africa": (20, 5),
    "North and South America": (-60, -10),
    "Antarctica": (60, -80),
    "Australia": (135, -25),
    "Greenland": (-40, 72),
}


def outlines():
    """Longitudes and latitudes (degrees) of every coast, unwrapped."""
    source = vtkEarthSource()
    source.SetOnRatio(1)
    source.OutlineOff()
    source.Update()
    land = source.GetOutput()
    for cell in range(land.GetNumberOfCells()):
        points = vtk_to_numpy(land.GetCell(cell).GetPoints().GetData()).astype(float)
        points /= np.linalg.norm(points, axis=1)[:, None]
        longitude = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
        yield np.degrees(longitude), np.degrees(np.arcsin(points[:, 2]))


def world():
    """Two images of longitude by latitude, north on top: colours, and the number of the piece of land."""
    pieces = Image.new("L", SHEET, 0)
    pen = ImageDraw.Draw(pieces)
    scale = SHEET[0] / 360
    for number, (longitude, latitude) in enumerate(outlines(), start=1):
        if abs(longitude[-1] - longitude[0]) > 180:  # around a pole
            pole = np.sign(latitude.mean()) * 90
            longitude = np.concatenate([longitude, longitude[[-1, 0]]])
            latitude = np.concatenate([latitude, [pole, pole]])
        for turn in (-720, -360, 0, 360, 720):
            corners = np.column_stack([(longitude + turn + 180) * scale, (90 - latitude) * scale])
            pen.polygon([tuple(corner) for corner in corners], fill=number)
    pieces = np.asarray(pieces)
    latitude = 90 - (np.arange(SHEET[1]) + 0.5) / scale
    warm = np.clip(1 - np.abs(latitude) / 75, 0, 1)[:, None, None]
    dry = np.exp(-(((np.abs(latitude) - 24) / 9) ** 2))[:, None, None]
    green = (1 - dry) * np.array([112, 158, 86]) + dry * np.array([214, 190, 130])
    colours = np.where(
        pieces[:, :, None] > 0, warm * green + (1 - warm) * np.array([236, 238, 240]), [104, 152, 196]
    )
    lines = np.zeros(SHEET[::-1], bool)
    for degrees in range(0, 180, 30):
        lines[[max(0, round(degrees * scale) - 1), round(degrees * scale)]] = True
    for degrees in range(0, 360, 30):
        lines[:, [round(degrees * scale) - 1, round(degrees * scale)]] = True
    colours[lines] = 0.75 * colours[lines] + 0.25 * 255
    return colours.astype(np.uint8), pieces


def pixel_of(points):
    """Row and column in the world image of points on the sphere."""
    unit = points / np.linalg.norm(points, axis=-1)[..., None]
    longitude = np.degrees(np.arctan2(unit[..., 1], unit[..., 0]))
    latitude = np.degrees(np.arcsin(np.clip(unit[..., 2], -1, 1)))
    row = np.clip((90 - latitude) * SHEET[1] / 180, 0, SHEET[1] - 1).astype(int)
    return row, ((longitude + 180) * SHEET[0] / 360).astype(int) % SHEET[0]


def unit_vector(longitude, latitude):
    a, b = np.radians([longitude, latitude])
    return np.array([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)])


def sphere(pieces):
    """Evenly spread points and their hull, with the number of the piece of land at each point."""
    k = np.arange(POINTS) + 0.5
    z, angle = 1 - 2 * k / POINTS, np.pi * (1 + 5**0.5) * k
    points = np.column_stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z])
    faces = ConvexHull(points).simplices
    normals = np.cross(*(points[faces[:, k]] - points[faces[:, 0]] for k in (1, 2)))
    inward = (normals * points[faces[:, 0]]).sum(axis=1) < 0
    faces[inward] = faces[inward][:, ::-1]
    land = pieces[pixel_of(points)].astype(np.int32)
    return meshes.source_of(meshes.poly_data(RADIUS * points, faces, point_arrays={"Land": land}), "earth.vtp")


def axes():
    """East and north on the picture, and towards the viewer, at the middle of the maps."""
    towards = unit_vector(*CENTRE)
    east = np.cross([0, 0, 1], towards)
    east /= np.linalg.norm(east)
    return east, np.cross(towards, east), towards


def globe(colours, shaded):
    """The half of the earth that one sees from far away."""
    side = 2 * SIZE[0]
    x, y = np.meshgrid(*(1.04 * (2 * (np.arange(side) + 0.5) / side - 1),) * 2)
    inside = x * x + y * y <= 1
    z = np.sqrt(np.where(inside, 1 - x * x - y * y, 0))
    east, north, towards = axes()
    points = x[..., None] * east + y[..., None] * north + z[..., None] * towards
    image = colours[pixel_of(np.where(inside[..., None], points, towards))].astype(float)
    if shaded:
        light = np.clip((-0.45 * x + 0.45 * y + 0.77 * z), 0, 1)
        image *= (0.3 + 0.75 * light)[..., None]
    image[~inside] = 255
    return picture(np.clip(image, 0, 255))


def picture(image):
    return Image.fromarray(np.ascontiguousarray(image[::-1].astype(np.uint8))).resize(SIZE, Image.LANCZOS)


def map_picture(flat, colours):
    """The flat map drawn from the world image: Flat Map Image tells where every pixel comes from."""
    side, border = 2 * SIZE[0], 16
    image = simple.FlatMapImage(Input=flat, Size=side - 2 * border, Margin=0)
    image.UpdatePipeline()
    values = servermanager.Fetch(image).GetPointData()
    shape = (side - 2 * border,) * 2
    inside = vtk_to_numpy(values.GetArray("InMap")).reshape(shape) == 1
    points = vtk_to_numpy(values.GetArray("SurfacePoints")).reshape(*shape, 3)
    drawn = np.full((side, side, 3), 255, np.uint8)
    drawn[border:-border, border:-border][inside] = colours[pixel_of(points[inside])]
    return picture(drawn)


def flat_maps(earth):
    east, _, towards = axes()
    disk = simple.SurfaceToDisk(
        Input=earth, Cut="Hole", UseHolePoint=1, HolePoint=list(-RADIUS * towards), HoleAreaFraction=HOLE
    )
    # The eastern part of the picture goes to the right end of the map.
    conformal = simple.ConformalDisk(
        Input=disk,
        NormalizeTo="Surface Area",
        UseBoundaryPoint=1,
        BoundaryPoint=list(RADIUS * (-0.94 * towards + 0.34 * east)),
    )
    return conformal, simple.OMTAreaPreserving(Input=conformal)


def make(path):
    colours, pieces = world()
    earth = sphere(pieces)
    conformal, preserving = flat_maps(earth)
    top = [
        (globe(colours, True), "(a) the earth"),
        (globe(colours, False), "(b) direct projection: one half of it"),
    ]
    bottom = [
        (map_picture(conformal, colours), "(c) conformal map"),
        (map_picture(preserving, colours), "(d) area-preserving map"),
    ]
    panels.compose(path, [top, bottom], smooth=True)
    rows = [
        "| | on the sphere (million km²) | on the conformal map | on the area-preserving map | error |",
        "|---|---|---|---|---|",
    ]
    areas, areas_preserved = (meshes.region_areas(flat, "Land") for flat in (conformal, preserving))
    for name, place in LANDS.items():
        number = int(pieces[pixel_of(unit_vector(*place))])
        on_sphere, on_conformal = areas[number]
        on_map = areas_preserved[number][1]
        rows.append(
            f"| {name} | {on_sphere / 1e6:.3f} | {on_conformal / 1e6:.3f} | {on_map / 1e6:.3f} "
            f"| {100 * (on_map / on_sphere - 1):+.2f} % |"
        )
    hole = " ".join(f"{x:.0f}" for x in -RADIUS * unit_vector(*CENTRE))
    return [
        f"The coasts of VTK's earth source on a sphere of {POINTS:,} points, cut open at a hole of {HOLE:.0%} of its area in the "
        "Pacific. The maps are drawn from an image of longitude and latitude by the inverse map. Areas are those of the "
        "triangles with two corners or more on the piece of land, by *Distortion Metrics*:",
        "",
        *rows,
        "",
        "In the GUI: *File > Open* `gallery-output/earth.vtp`, *Apply*; *Surface To Disk* with *Use Hole Point*, *Hole Point* "
        f"{hole} (scroll to it) and *Hole Area Fraction* {HOLE:g} (the gear shows it), "
        "*Conformal Disk*, *OMT Area Preserving*, *Flat Map Image*, each with *Apply*; *Reset Camera*; colour by `Land`. For the areas click "
        "*Area-Preserving Disk*; *Distortion Metrics* with *Use Region Array* and *Region Array* `Land`, *Apply*; *Split Horizontal Axis* above the "
        "view, *SpreadSheet View*, the eye of *Summary*.",
    ]
