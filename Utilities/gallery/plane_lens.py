# SPDX-License-Identifier: GPL-3.0-or-later
"""Planar meshes that weights deform, and what came of the factors asked for."""

import numpy as np
from meshes import fetched, flat_areas, poly_data, source_of, triangles
from paraview import simple
from scipy.spatial import Delaunay


def rectangle(width, height, columns, rows, name=None):
    """Triangles on [0, width] x [0, height], alternating so that no direction is preferred."""
    x, y = np.meshgrid(np.linspace(0, width, columns + 1), np.linspace(0, height, rows + 1))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    faces = []
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            faces += [[a, b, c], [a, c, d]] if (row + column) % 2 else [[a, b, d], [b, c, d]]
    return source_of(poly_data(points, faces), name)


def disk(radius, rings, name=None):
    """Triangles in rings of points around the origin."""
    points = [[0.0, 0.0]]
    for ring in range(1, rings + 1):
        angles = 2 * np.pi * np.arange(6 * ring) / (6 * ring)
        points += (radius * ring / rings * np.column_stack([np.cos(angles), np.sin(angles)])).tolist()
    points = np.array(points)
    faces = Delaunay(points).simplices
    u, v = (points[faces[:, k]] - points[faces[:, 0]] for k in (1, 2))
    turned = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    faces[turned < 0] = faces[turned < 0][:, ::-1]
    faces = faces[np.abs(turned) > 1e-9 * radius**2]  # slivers of the hull
    return source_of(poly_data(np.column_stack([points, np.zeros(len(points))]), faces), name)


def conformal_rectangle(mesh, width, height):
    """The plane mapped to itself, as it lies."""
    return simple.ConformalDisk(
        Input=mesh,
        Domain="Rectangle",
        UseCorners=1,
        LowerLeftCorner=[0, 0, 0],
        LowerRightCorner=[width, 0, 0],
        UpperRightCorner=[width, height, 0],
        UpperLeftCorner=[0, height, 0],
    )


def conformal_disk(mesh, radius):
    """The round mesh mapped to itself, as it lies."""
    return simple.ConformalDisk(
        Input=mesh, NormalizeTo="Surface Area", UseBoundaryPoint=1, BoundaryPoint=[radius, 0, 0]
    )


def magnify(conformal, centre, radius, factor, edge_width=0.0, inside_out=False):
    """Area Weights: the round region around @p centre on the undeformed mesh gets @p factor times its area."""
    weights = simple.AreaWeights(
        Input=conformal,
        WeightsFrom="Implicit Function",
        ImplicitFunction="Sphere",
        PositionArray=["POINTS", "SurfacePoints"],
        FactorMeaning="Magnification",
        Factor=factor,
        EdgeWidth=edge_width,
        InsideOut=int(inside_out),
    )
    weights.ImplicitFunction.Center = list(centre)
    weights.ImplicitFunction.Radius = radius
    return weights


def transport(weights):
    """Without refinement: the mesh is regular, so that faces are right as they are, and lines stay smooth."""
    return simple.OMTAreaPreserving(
        Input=weights, UseAreaWeight=1, AreaWeightArray=["POINTS", "AreaWeight"], FaceRefinement=0
    )


def carried(flat, data, **properties):
    proxy = simple.PlanarWarp(Input=flat, Carried=data, **properties)
    proxy.UpdatePipeline()
    if proxy.GetDataInformation().GetNumberOfPoints() == 0:
        raise RuntimeError("nothing was carried; see the error above")
    return proxy


def face_factor(flat, within):
    """The magnification of the faces with all corners in a region of the undeformed mesh: @p within(points)
    tells which points belong to it."""
    data = fetched(flat)
    before, after = np.asarray(data.PointData["SurfacePoints"]), np.asarray(data.Points)
    faces = triangles(data)
    whole = within(before)[faces].all(axis=1)
    return flat_areas(after, faces)[whole].sum() / flat_areas(before, faces)[whole].sum()


def cell_factor(flat, within):
    """The magnification of the power cells of a region's points."""
    data = fetched(flat)
    before = np.asarray(data.PointData["SurfacePoints"])
    faces = triangles(data)
    own = np.zeros(len(before))
    for k in range(3):
        np.add.at(own, faces[:, k], flat_areas(before, faces) / 3)
    inside = within(before)
    return np.asarray(data.PointData["CellArea"])[inside].sum() / own[inside].sum()
