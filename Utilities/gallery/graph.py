# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 9: a network with its core or its surroundings magnified, and a conformal magnifier beside."""

import numpy as np
import meshes
import panels
import plane_lens
from paraview import simple
from scipy.spatial import Delaunay

TITLE = "Network (Figure 9)"
PICTURE = "graph.png"
SIZE = (440, 440)
RADIUS = 1.0
CORE = 0.3  # radius of the region
EDGE = 0.06  # width over which its weight fades
FACTOR = 5.0
SHRUNK = 0.2
LIFT = 0.3  # of the conformal magnifier's core
EDGE_COLOUR = (0.62, 0.66, 0.72)


def network():
    """A generated network: a dense core, whose stations are linked with their neighbours, and branches."""
    random = np.random.default_rng(4)
    radius = np.concatenate([0.27 * np.sqrt(random.random(70)), 0.36 + 0.6 * random.random(150)])
    angle = 2 * np.pi * random.random(len(radius))
    points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    edges = set()
    for triangle in Delaunay(points).simplices:
        for a, b in zip(triangle, np.roll(triangle, 1)):
            length = np.hypot(*(points[a] - points[b]))
            if random.random() < (0.75 if length < 0.15 else 0.35) and length < 0.5:
                edges.add((min(a, b), max(a, b)))
    for k in range(25):  # long links to the core
        edges.add((int(random.integers(0, 70)), 70 + 6 * k))
    points = np.column_stack([points, np.zeros(len(points))])
    stations = meshes.source_of(
        meshes.poly_data(points, vertices=True, point_arrays={"Core": (radius < CORE).astype(np.int32)}),
        "stations.vtp",
    )
    links = meshes.source_of(meshes.poly_data(points, lines=np.array(sorted(edges))), "links.vtp")
    return stations, links


def conformal_magnifier(mesh):
    """The core enlarged in its plane and lifted, joined to the rim by a slope, and the whole flattened conformally
    (after Zhao et al., "Conformal Magnifier", TVCG 2012); as a flat map of the plane."""
    scale = np.sqrt(FACTOR)
    share = f"min(1, max(0, (mag(coords) - {CORE})/{RADIUS - CORE:.6g}))"  # of the way from core to rim
    radius = f"({scale:.9g}*min(mag(coords), {CORE}) + {share}*{RADIUS - scale * CORE:.9g})"
    lifted = simple.Calculator(
        Input=mesh,
        CoordinateResults=1,
        ResultArrayName="Lifted",
        Function=f"coords*{radius}/max(1e-12, mag(coords)) + kHat*{LIFT}*(1 - {share})",
    )
    places = simple.Calculator(Input=mesh, ResultArrayName="Plane", Function="coords")
    plane = simple.AppendAttributes(Input=[lifted, places])
    flat = plane_lens.conformal_disk(plane, RADIUS)
    flat.NormalizeTo = "Unit Domain"
    return simple.Calculator(Input=flat, ResultArrayName="SurfacePoints", Function="Plane")


def core(points):
    return np.hypot(points[:, 0], points[:, 1]) <= CORE


def surroundings(points):
    return ~core(points)


def nearest_distances(stations, of_core):
    """Median distance of a station to the nearest other one."""
    data = meshes.fetched(stations)
    points = np.asarray(data.Points)[np.asarray(data.PointData["Core"]) == int(of_core)]
    distance = np.hypot(*(points[:, None, :2] - points[None, :, :2]).transpose(2, 0, 1))
    np.fill_diagonal(distance, np.inf)
    return np.median(distance.min(axis=1))


def panel(stations, links, outline):
    view = panels.new_view()
    panels.show_lines(links, view, EDGE_COLOUR, 1)
    display = panels.show_points(stations, view, (0, 0, 0), 7)
    panels.colour_by(display, "POINTS", "Core")
    panels.show_lines(outline, view, (0.85, 0.2, 0.15), 1.5)
    panels.look(view, [-RADIUS, RADIUS, -RADIUS, RADIUS, 0, 0], SIZE)
    return panels.screenshot(view, SIZE)


def make(path):
    stations, links = network()
    panels.categories("Core", {0: (0.13, 0.35, 0.6), 1: (0.85, 0.4, 0.1)})
    circle = 2 * np.pi * np.arange(121) / 120
    ends = np.column_stack([np.arange(120), np.arange(1, 121)])
    outline = meshes.source_of(
        meshes.poly_data(
            np.column_stack([CORE * np.cos(circle), CORE * np.sin(circle), 0 * circle]), lines=ends
        )
    )
    mesh = plane_lens.disk(RADIUS, 60, "links_mesh.vtp")
    plane = plane_lens.conformal_disk(mesh, RADIUS)
    centre = plane_lens.transport(plane_lens.magnify(plane, [0, 0, 0], CORE + 1e-6, FACTOR, EDGE))
    outer = plane_lens.transport(plane_lens.magnify(plane, [0, 0, 0], CORE + 1e-6, SHRUNK, EDGE))
    conformal = conformal_magnifier(mesh)

    row = [(panel(stations, links, outline), "(a) the network")]
    figures = [("as it is", 1.0, 1.0, stations)]
    for flat, title, asked in (
        (centre, f"(b) core, {FACTOR:g} times", FACTOR),
        (outer, f"(c) core {SHRUNK:g} times: the rest grows", SHRUNK),
        (conformal, "(d) conformal magnifier", FACTOR),
    ):
        moved = [plane_lens.carried(flat, data) for data in (stations, links, outline)]
        row.append((panel(*moved), title))
        faces = [plane_lens.face_factor(flat, region) for region in (core, surroundings)]
        figures.append((title[4:], asked, *faces, moved[0]))
    panels.compose(path, [row[:2], row[2:]])

    rows = [
        "| | core: asked | delivered | surroundings | distance to the nearest station: core | surroundings |",
        "|---|---|---|---|---|---|",
    ]
    for title, asked, *faces, moved in figures:
        distances = [nearest_distances(moved, of_core) for of_core in (True, False)]
        got = [f"{faces[0]:.3f}", f"{faces[-1]:.3f}"]
        rows.append(f"| {title} | {asked:g} | {got[0]} | {got[1]} | {distances[0]:.3f} | {distances[1]:.3f} |")
    return [
        "A generated network of 220 stations (70 of them in the core) on a disk of 10,981 points. Lines bend with the "
        "mesh. The conformal magnifier enlarges the core five times in space and maps that surface "
        "conformally: shapes are kept, but what the core becomes in the plane is not what was asked for.",
        "",
        *rows,
        "",
        "Factors are flat over original area of the faces in the region.",
        "",
        "In the GUI: *File > Open* `gallery-output/links.vtp`, `stations.vtp` and `links_mesh.vtp`, each with *Apply*. *Area Weights*: *Weights From* Implicit Function, *Center* 0 0 0, "
        f"*Radius* {CORE + 0.005:g} (between two rings of points), *Factor* {FACTOR:g}, *Factor Meaning* Magnification, *Edge Width* {EDGE:g}, *Apply*. *Conformal Disk*: *Use Boundary Point*, "
        f"*Boundary Point* {RADIUS:g} 0 0, *Apply*. *OMT Area Preserving*: leave *Use Area Weight* checked, uncheck *Face Refinement*, *Apply*. *Planar Warp*: *Carried*, *links.vtp*, *OK*, *Apply*. "
        "Click *Area-Preserving Disk* in the *Pipeline Browser*; *Planar Warp* again, *Carried*, *stations.vtp*, *OK*, *Apply*; *Representation* Point Gaussian, coloured by `Core`; hide the data that were "
        f"there before. For (c) *Factor* {SHRUNK:g} in *Area Weights*. [planar_warp.md](planar_warp.md) has more.",
    ]
