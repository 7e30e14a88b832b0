# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 10: the middle of a radial graph magnified 2, 4 and 8 times, one within the other."""

import matplotlib
import numpy as np
import meshes
import panels
import plane_lens
from paraview import simple
from scipy.spatial import cKDTree

TITLE = "Hierarchical magnification (Figure 10)"
PICTURE = "hierarchy.png"
SIZE = (440, 440)
BOUNDS = [-1.02, 1.02, -1.02, 1.02, 0, 0]
RADII = (0.3687, 0.2062, 0.0937)  # between rings of the mesh: of what is magnified twice, four and eight times
FACTORS = (2, 4, 8)
NODE = 0.04  # diameter
LENS = 0.258  # radius of the region of the table of factors


def radial_graph():
    """A tree in rings: every node has its children on the next ring; the middle is crowded."""
    random = np.random.default_rng(2)
    points, edges, ring = [np.zeros(2)], [], [0]
    for level, (radius, count) in enumerate(
        ((0.03, 7), (0.06, 12), (0.1, 20), (0.16, 30), (0.25, 40), (0.4, 60), (0.65, 80), (0.95, 100))
    ):
        angles = 2 * np.pi * (np.arange(count) + 0.35 * random.random(count)) / count + 0.4 * level
        children = list(range(len(points), len(points) + count))
        for child, angle in zip(children, angles):
            points.append(radius * np.array([np.cos(angle), np.sin(angle)]))
            gaps = [np.hypot(*(points[child] - points[parent])) for parent in ring]
            edges.append((ring[int(np.argmin(gaps))], child))
        ring = children
    points = np.column_stack([np.array(points), np.zeros(len(points))])
    nodes = meshes.source_of(meshes.poly_data(points, vertices=True), "nodes.vtp")
    return nodes, meshes.source_of(meshes.poly_data(points, lines=np.array(edges)), "branches.vtp")


def overlaps(nodes):
    """The number of other nodes that each node overlaps if all are drawn equally large."""
    points = np.asarray(meshes.fetched(nodes).Points)[:, :2]
    tree = cKDTree(points)
    return np.array([len(tree.query_ball_point(p, NODE)) - 1 for p in points])


def panel(nodes, links):
    counts = overlaps(nodes)
    points = np.asarray(meshes.fetched(nodes).Points)
    coloured = meshes.source_of(
        meshes.poly_data(points, vertices=True, point_arrays={"Overlaps": np.minimum(counts, 6)})
    )
    view = panels.new_view()
    panels.show_lines(links, view, (0.7, 0.72, 0.76), 1)
    pixels = NODE * SIZE[0] / (BOUNDS[1] - BOUNDS[0]) / 1.06
    panels.colour_by(panels.show_points(coloured, view, (0, 0, 0), pixels), "POINTS", "Overlaps")
    panels.look(view, BOUNDS, SIZE)
    return panels.screenshot(view, SIZE), counts


def factor_table():
    """One region, and what comes of every factor asked for."""
    plane = plane_lens.conformal_disk(plane_lens.disk(1.0, 60), 1.0)
    rows = ["| asked | cells | faces |", "|---|---|---|"]
    for factor in (0.25, 1, 2, 4, 8):
        flat = plane_lens.transport(plane_lens.magnify(plane, [0, 0, 0], LENS, factor))
        cells, faces = (
            measure(flat, lambda points: np.hypot(points[:, 0], points[:, 1]) <= LENS)
            for measure in (plane_lens.cell_factor, plane_lens.face_factor)
        )
        rows.append(f"| {factor:g} | {cells:.6f} | {faces:.4f} |")
    return rows


def make(path):
    nodes, links = radial_graph()
    hues = matplotlib.colormaps["rainbow_r"]
    panels.categories("Overlaps", {k: hues(k / 6)[:3] for k in range(7)})
    plane = plane_lens.conformal_disk(plane_lens.disk(1.0, 80, "branches_mesh.vtp"), 1.0)
    image, counts = panel(nodes, links)
    images = [(image, f"(a) the graph: {np.mean(counts > 0):.0%} of the nodes overlap")]
    rows = ["| | ring | asked | cells | faces |", "|---|---|---|---|---|"]
    for depth in (1, 2, 3):
        radii, factors = RADII[:depth], FACTORS[:depth]
        level = " + ".join(f"(mag(SurfacePoints) < {radius})" for radius in radii)
        weights = simple.AreaWeights(
            Input=simple.Calculator(
                Input=plane, ResultArrayName="Level", ResultArrayType="Int", Function=level
            ),
            WeightsFrom="Label Table",
            WeightArray=["POINTS", "Level"],
            FactorMeaning="Magnification",
            LabelFactors=[x for k, factor in enumerate(factors) for x in (k + 1, factor)],
        )
        flat = plane_lens.transport(weights)
        image, counts = panel(*(plane_lens.carried(flat, data) for data in (nodes, links)))
        title = ", ".join(map(str, factors))
        images.append((image, f"({'abcd'[depth]}) {title} times: {np.mean(counts > 0):.0%} overlap"))
        for k, factor in enumerate(factors):
            outer, inner = radii[k], radii[k + 1] if k + 1 < depth else -1.0

            def within(points, outer=outer, inner=inner):
                radius = np.hypot(points[:, 0], points[:, 1])
                return (radius < outer) & (radius >= inner)

            cells, faces = (
                measure(flat, within) for measure in (plane_lens.cell_factor, plane_lens.face_factor)
            )
            place = f"{max(inner, 0):g} to {outer:g}"
            rows.append(f"| ({'abcd'[depth]}) | {place} | {factor} | {cells:.6f} | {faces:.4f} |")
    panels.compose(path, [images[:2], images[2:]])
    return [
        "A generated radial graph; colours tell how many others a node overlaps, from red (none) to violet (six or more). "
        "The middle is magnified twice, within that four times, within that eight times, in one transport: a magnifier "
        "applied to its own result. Factors are flat over original area in the ring between two radii:",
        "",
        *rows,
        "",
        f"A single lens of radius {LENS:g} in the unit disk (10,981 points):",
        "",
        *factor_table(),
        "",
        "In the GUI: *File > Open* `gallery-output/branches.vtp`, `nodes.vtp` and `branches_mesh.vtp`, each with *Apply*. *Filters > Common > Calculator*: "
        f"`{' + '.join(f'(mag(coords) < {radius})' for radius in RADII)}`, *Apply*: the labels 0 to 3. *Area Weights*: *Weights From* Label Table, *Weight "
        "Array* `Result`, *Filters > Surface Flattening > Fill Region Factors*; click the row of label 0 and press *-*: the surroundings make room; double-click the other factors and type 2, 4 and 8; *Factor Meaning* "
        "Magnification, *Apply*. *Conformal Disk*: *Use Boundary Point*, *Boundary Point* 1 0 0, *Apply*. *OMT Area Preserving*: uncheck *Face Refinement*, "
        "*Apply*. *Planar Warp*: *Carried*, *branches.vtp*, *OK*, *Apply*. Click *Area-Preserving Disk* in the *Pipeline Browser*; *Planar Warp* again for *nodes.vtp*. "
        "[area_weights.md](area_weights.md#in-the-gui) shows more of such tables.",
    ]
