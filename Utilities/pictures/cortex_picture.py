#!/usr/bin/env pvpython
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the picture of docs/cortex.md: the left half of Debian's example brain in files of FreeSurfer, lh.pial and an
annotation by AAL region, taken to a flat map by flatten_cortex. What has no region of the left half is its medial wall.

    PV_PLUGIN_PATH=build/plugins pvpython --force-offscreen-rendering \\
        Utilities/pictures/cortex_picture.py <folder for lh.pial and the map> docs/pictures/cortex.png
"""

import os
import sys

import nibabel
import numpy as np
from nibabel.freesurfer import io as freesurfer
from paraview import servermanager, simple
from surfaceflattening_cortex import flatten_cortex
from surfaceflattening_region_table import read_names
from surfaceflattening_volume import isosurface
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("demo", "gallery"):
    sys.path.insert(0, os.path.join(HERE, "..", folder))
import aal_atlas  # noqa: E402
import panels  # noqa: E402

TEMPLATES = "/usr/share/mricron/templates"  # Debian's package mricron-data
EDGE_LENGTH = 1.5  # mm
REACH = 4.0  # mm from the surface to the nearest voxel with a label; beyond it a vertex has none
MEDIAL = -1.5  # mm; vertices right of it are at the middle
SIZE = (420, 380)  # pixels


def labelled_voxels():
    """Where the voxels of the left half with a label are in the patient, and their labels."""
    atlas = nibabel.load(os.path.join(TEMPLATES, "aal.nii.gz"))
    labels = np.asarray(atlas.dataobj)
    indices = np.argwhere((labels > 0) & ((labels % 2 == 1) | (labels > 108)))
    return nibabel.affines.apply_affine(atlas.affine, indices), labels[tuple(indices.T)].astype(int)


def labels_at(points):
    places, labels = labelled_voxels()
    voxels = vtkPolyData()
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(places, deep=True))
    voxels.SetPoints(positions)
    locator = vtkStaticPointLocator()
    locator.SetDataSet(voxels)
    locator.BuildLocator()
    nearest = np.array([locator.FindClosestPoint(point) for point in points])
    found = labels[nearest]
    found[np.linalg.norm(places[nearest] - points, axis=1) > REACH] = 0
    found[points[:, 0] > MEDIAL] = 0
    return found


def write_hemisphere(folder):
    os.makedirs(folder, exist_ok=True)
    scan = simple.OpenDataFile(os.path.join(TEMPLATES, "ch2bet.nii.gz"))
    brain = isosurface(scan, 40, smoothing_mm=2).surface
    plane = {"Cut": "Plane", "PlaneOrigin": [-0.5, 0, 0], "PlaneNormal": [-1, 0, 0]}
    half = simple.SurfaceToDisk(Input=brain, Remesh=1, TargetEdgeLength=EDGE_LENGTH, **plane)
    data = servermanager.Fetch(half)
    points = vtk_to_numpy(data.GetPoints().GetData())
    freesurfer.write_geometry(
        os.path.join(folder, "lh.pial"), points, vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    )
    labels = labels_at(points)
    names = {0: "unknown", **read_names(os.path.join(TEMPLATES, "aal.nii.txt"))}
    used = sorted({0, *labels})
    colours = [[round(255 * c) for c in aal_atlas.colour_of(names[label])] for label in used]
    # FreeSurfer knows a region by its colour: no two are the same.
    table = np.array([[r, g, min(b + k % 7, 255), 0, 0] for k, (r, g, b) in enumerate(colours)])
    freesurfer.write_annot(
        os.path.join(folder, "lh.aal.annot"),
        np.searchsorted(used, labels),
        table,
        [names[label] for label in used],
        fill_ctab=True,
    )
    return table[:, :3] / 255


def main(folder, picture):
    colours = write_hemisphere(folder)
    surface = os.path.join(folder, "lh.pial")
    cortex = flatten_cortex(surface, annotation=os.path.join(folder, "lh.aal.annot"), folder=folder)
    table = simple.GetColorTransferFunction("aal")
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for k in range(len(colours)) for text in (str(k), str(k))]
    table.IndexedColors = colours.ravel().tolist()
    images = []
    for source, direction, up, flat, title in (
        (cortex.surface, (1, 0, 0), (0, 0, 1), False, "(a) lh.pial with its annotation, lateral"),
        (cortex.measured, (0, 0, -1), (0, 1, 0), True, "(b) the flat map"),
    ):
        view = panels.new_view()
        display = panels.show_flat(source, view) if flat else panels.show_solid(source, view)
        panels.colour_by(display, "POINTS", "aal")
        panels.look(view, source.GetDataInformation().GetBounds(), SIZE, direction, up)
        images.append((panels.screenshot(view, SIZE), title))
    panels.compose(picture, [images], smooth=True)
    for name in ("SurfaceArea", "FacesWithin2Percent", "AreaWeightedMeanAngleError", "FlippedFaces"):
        print(name, cortex.measured.FieldData[name].GetRange()[0])


main(*sys.argv[1:])
