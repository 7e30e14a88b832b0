# SPDX-License-Identifier: GPL-3.0-or-later
"""After Figure 4: a power diagram and its dual, the power Delaunay triangulation, of a transport."""

import numpy as np
import meshes
import panels
import plane_lens
from paraview import simple
from scipy.spatial import ConvexHull

TITLE = "Power diagram (Figure 4)"
PICTURE = "power_diagram.png"
SIZE = (440, 440)
BOUNDS = [-1.02, 1.02, -1.02, 1.02, 0, 0]
CELL_EDGES, DUAL_EDGES, SITES = (0.15, 0.45, 0.70), (0.85, 0.45, 0.15), (0.1, 0.1, 0.1)
DOT = 0.011  # radius


def hill():
    """A round mesh lifted to a hill off its middle: its conformal map is uneven."""
    plane = plane_lens.disk(1.0, 9)
    return simple.Calculator(
        Input=plane,
        CoordinateResults=1,
        ResultArrayName="Lifted",
        Function="coords + kHat*1.6*exp(-9*((coordsX - 0.3)^2 + (coordsY - 0.15)^2))",
    )


def power_delaunay(sites, weights):
    """The lower hull of the sites lifted to |x|^2 - w."""
    hull = ConvexHull(np.column_stack([sites, (sites**2).sum(axis=1) - weights]))
    return hull.simplices[hull.equations[:, 2] < -1e-12]


def dots_at(points):
    """Small polygons in front of what lies in the plane."""
    angles = 2 * np.pi * np.arange(12) / 12
    outline = DOT * np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]) + [0, 0, 0.3]
    corners = (points[:, None, :] + outline[None, :, :]).reshape(-1, 3)
    return meshes.source_of(meshes.poly_data(corners, np.arange(len(corners)).reshape(-1, 12)))


def make(path):
    surface = hill()
    meshes.INPUTS["hill.vtp"] = surface
    conformal = simple.ConformalDisk(
        Input=surface, NormalizeTo="Unit Domain", UseBoundaryPoint=1, BoundaryPoint=[1, 0, 0]
    )
    flat = simple.OMTAreaPreserving(Input=conformal, NormalizeTo="Unit Domain", FaceRefinement=0)
    sites = np.asarray(meshes.fetched(conformal).Points)
    transported = meshes.fetched(flat)
    dual = power_delaunay(sites[:, :2], np.asarray(transported.PointData["PowerWeight"]))
    dots = dots_at(sites)
    edges = np.unique(np.sort(dual[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0)
    cells = simple.OutputPort(flat, 1)

    view = panels.new_view()
    panels.show_lines(cells, view, CELL_EDGES, 1.5)
    panels.one_colour(panels.show_flat(dots, view), SITES)
    panels.look(view, BOUNDS, SIZE)
    first = panels.screenshot(view, SIZE)
    view = panels.new_view()
    panels.show_lines(cells, view, [0.5 + 0.5 * c for c in CELL_EDGES], 1)
    panels.show_lines(meshes.source_of(meshes.poly_data(sites, lines=edges)), view, DUAL_EDGES, 1.5)
    panels.one_colour(panels.show_flat(dots, view), SITES)
    panels.look(view, BOUNDS, SIZE)
    second = panels.screenshot(view, SIZE)
    panels.compose(path, [[(first, "(a) power diagram"), (second, "(b) power Delaunay triangulation")]])

    areas = np.asarray(transported.PointData["CellArea"])
    figures = {name: flat.FieldData[name].GetRange()[0] for name in ("MaxCellAreaError", "NewtonIterations")}
    return [
        f"The transport of a hill of {len(sites)} points: black the sites, where the conformal map puts the points; each "
        "blue cell has the area that its point has on the surface. Where the conformal map crowds points, a cell need not "
        f"contain its own site. Largest relative error of a cell {figures['MaxCellAreaError']:.0e} after "
        f"{figures['NewtonIterations']:.0f} Newton steps; sum of the cells {areas.sum():.12f} (pi = {np.pi:.12f}); the "
        f"triangulation has {len(dual)} triangles.",
        "",
        "In the GUI: *File > Open* `gallery-output/hill.vtp`, *Apply*. *Conformal Disk* with *Normalize To* Unit Domain, *Use Boundary Point*, *Boundary Point* 1 0 0, *Apply*. *OMT Area "
        "Preserving* with *Normalize To* Unit Domain, uncheck *Face Refinement*, *Apply*, *Reset Camera*; hide *Area-Preserving Disk*; the eye of *Power Diagram* shows the cells, with *Representation* Surface With Edges. The sites are those of "
        "*ConformalDisk1*, by its eye, with *Representation* Points. *Information* has `MaxCellAreaError` and `NewtonIterations`.",
    ]
