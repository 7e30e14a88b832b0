# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of a triangle surface, counted from its triangles alone and independent of the code under test."""

import math
from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy


@dataclass
class SurfaceFigures:
    vertices: int
    faces: int
    components: int
    euler_number: int
    boundary_loops: int
    manifold: bool
    faces_without_area: int
    smallest_angle: float  # degrees
    area: float

    @property
    def genus(self):
        """Summed over the components; of a manifold."""
        return (2 * self.components - self.boundary_loops - self.euler_number) // 2

    @property
    def is_disk(self):
        shape = (self.components, self.euler_number, self.boundary_loops)
        return self.manifold and shape == (1, 1, 1) and self.faces_without_area == 0


def measure(polydata):
    points = vtk_to_numpy(polydata.GetPoints().GetData()).astype(float)
    faces = vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)
    halfedges = _Halfedges(faces, len(points))
    vertices = len(np.unique(faces))
    areas, smallest_angle = _areas_and_smallest_angle(points, faces)
    return SurfaceFigures(
        vertices=vertices,
        faces=len(faces),
        components=halfedges.components(),
        euler_number=vertices - halfedges.edge_count() + len(faces),
        boundary_loops=halfedges.boundary_loops(),
        manifold=vertices == len(points) and halfedges.is_manifold(),
        faces_without_area=int(np.count_nonzero(areas == 0)),
        smallest_angle=smallest_angle,
        area=float(areas.sum()),
    )


class _Halfedges:
    """Half-edge 3 f + k runs from corner k of face f to corner k + 1."""

    def __init__(self, faces, point_count):
        self.face_count = len(faces)
        self.start = faces.ravel()
        self.end = np.roll(faces, -1, axis=1).ravel()
        forward = self.start * point_count + self.end
        backward = self.end * point_count + self.start
        order = np.argsort(forward, kind="stable")
        keys = forward[order]
        place = np.minimum(np.searchsorted(keys, backward), len(keys) - 1)
        self.unique = len(keys) < 2 or bool(np.all(keys[1:] != keys[:-1]))
        self.twin = np.where(keys[place] == backward, order[place], -1)

    def edge_count(self):
        return int(np.count_nonzero(self.twin < 0) + np.count_nonzero(self.twin >= 0) // 2)

    def is_manifold(self):
        """No edge is used twice in one direction and the faces around each vertex are one fan."""
        if not self.unique:
            return False
        # The corners where h and the half-edge after its twin start are at one vertex.
        inner = np.flatnonzero(self.twin >= 0)
        twin = self.twin[inner]
        fans = _component_count(inner, twin - twin % 3 + (twin + 1) % 3, 3 * self.face_count)
        return fans == len(np.unique(self.start))

    def components(self):
        inner = np.flatnonzero(self.twin >= 0)
        return _component_count(inner // 3, self.twin[inner] // 3, self.face_count)

    def boundary_loops(self):
        border = self.twin < 0
        following = dict(zip(self.start[border].tolist(), self.end[border].tolist()))
        loops = 0
        while following:
            loops += 1
            vertex = next(iter(following))
            while vertex in following:
                vertex = following.pop(vertex)
        return loops


def _component_count(ends, other_ends, count):
    """The number of components of the graph with @count nodes and these edges. Every node takes the least label among its neighbours
    and then its label's label, until nothing changes."""
    nodes = np.concatenate([ends, other_ends])
    neighbours = np.concatenate([other_ends, ends])
    order = np.argsort(nodes, kind="stable")
    neighbours = neighbours[order]
    linked, first = np.unique(nodes[order], return_index=True)
    label = np.arange(count)
    while len(linked):
        before = label.copy()
        least = np.minimum.reduceat(label[neighbours], first)
        label[linked] = np.minimum(label[linked], least)
        label = label[label]
        if np.array_equal(before, label):
            break
    return len(np.unique(label))


def _areas_and_smallest_angle(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    double_areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    smallest = math.pi
    for u, v in ((b - a, c - a), (c - b, a - b), (a - c, b - c)):
        angles = np.arctan2(double_areas, np.einsum("ij,ij->i", u, v))
        smallest = min(smallest, float(angles.min()))
    return double_areas / 2, math.degrees(smallest)
