# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo's ParaView pipeline: a scan and its labels in, a measured flat map out.

Every step is a source or filter that a user can pick from ParaView's menus. Lengths are in mm: the
volumes have voxels of 1 mm.
"""

from dataclasses import dataclass

from paraview import simple
from surfaceflattening_volume import cast_to_float, contour, pad, smooth

ISOVALUE = 40.0
SMOOTHING = 2.0  # standard deviation
SHADING_SMOOTHING = 4.0  # the surroundings over which sulci and gyri are told apart
EDGE_LENGTH = 1.2
LABEL_REACH = 4.0  # labels do not quite reach the surface: how far they are carried

REGION = "Region"
SHADE = "Surroundings"


@dataclass
class FlatteningPipeline:
    """The proxies that the pictures and files are made of."""

    surface: object
    conformal: object
    area_preserving: object


def left_half(surface, mid_plane):
    """The part of the surface with x below the mid-plane: the left, as x points to the right."""
    clip = simple.Clip(registrationName="Left half", Input=surface, ClipType="Plane")
    clip.ClipType.Origin = [mid_plane, 0.0, 0.0]
    clip.ClipType.Normal = [1.0, 0.0, 0.0]
    return simple.ExtractSurface(registrationName="Left half surface", Input=clip)


def with_labels(surface, path):
    """Adds the point array Region: the label of the nearest voxel that has one of the left half, 0 where
    none is near. AAL gives the left half odd labels up to 107; 109 to 116 are the vermis between."""
    atlas = simple.NIfTIImageReader(registrationName="AAL labels", FileName=path)
    atlas.UpdatePipeline()
    label = atlas.PointData.keys()[0]
    left = simple.Calculator(
        registrationName="Left labels",
        Input=atlas,
        ResultArrayName="NearestRegion",
        Function=f"if({label} > 108, {label}, {label}*({label} - 2*floor({label}/2)))",
    )
    labelled = simple.Threshold(
        registrationName="Labelled voxels",
        Input=left,
        Scalars=["POINTS", "NearestRegion"],
        ThresholdMethod="Above Upper Threshold",
        UpperThreshold=0.5,
    )
    positions = simple.Calculator(
        registrationName="Positions of labels",
        Input=labelled,
        ResultArrayName="LabelPosition",
        Function="coords",
    )
    nearest = simple.PointDatasetInterpolator(
        registrationName="Nearest label",
        Input=positions,
        Source=surface,
        Kernel="VoronoiKernel",
        PassPointArrays=1,
    )
    return simple.Calculator(
        registrationName="Labelled surface",
        Input=nearest,
        ResultArrayName=REGION,
        ResultArrayType="Int",
        Function=f"if(mag(coords-LabelPosition) < {LABEL_REACH:g}, NearestRegion, 0)",
    )


def with_shade(surface, volume):
    """Adds the point array Surroundings: the scan smoothed widely, which is bright in a sulcus (tissue
    on all sides) and dark on a gyrus."""
    wide = smooth(volume, SHADING_SMOOTHING)
    wide.UpdatePipeline()
    renamed = simple.Calculator(
        registrationName="Surroundings",
        Input=wide,
        ResultArrayName=SHADE,
        Function=wide.PointData.keys()[0],
    )
    return simple.ResampleWithDataset(
        registrationName="Shaded surface",
        SourceDataArrays=renamed,
        DestinationMesh=surface,
        PassPointArrays=1,
    )


def build(scan_path, labels_path, run):
    """Builds the pipeline and executes it stage by stage: `run(proxy, title)` updates the proxy."""
    scan = simple.NIfTIImageReader(registrationName="Brain MRI", FileName=scan_path)
    volume = pad(cast_to_float(scan))
    smoothed = smooth(volume, SMOOTHING)
    run(smoothed, "smoothed volume")
    surface = contour(smoothed, ISOVALUE, name="Brain surface")
    run(surface, "surface of the brain")
    bounds = volume.GetDataInformation().GetBounds()
    mid_plane = (bounds[0] + bounds[1]) / 2
    half = with_shade(left_half(surface, mid_plane), volume)
    run(half, "left half")
    labelled = with_labels(half, labels_path)
    run(labelled, "AAL labels")

    disk = simple.SurfaceToDisk(
        registrationName="Surface to disk",
        Input=labelled,
        Remesh=1,
        TargetEdgeLength=EDGE_LENGTH,
    )
    run(disk, "one clean disk")
    # The back of the head to the right end of the disk, as in the lateral view; y points to the front.
    bounds = disk.GetDataInformation().GetBounds()
    conformal = simple.ConformalDisk(
        registrationName="Conformal disk",
        Input=disk,
        UseBoundaryPoint=1,
        BoundaryPoint=[mid_plane, bounds[2], (bounds[4] + bounds[5]) / 2],
    )
    run(conformal, "conformal map")
    area_preserving = simple.OMTAreaPreserving(
        registrationName="Area-preserving disk", Input=conformal
    )
    run(area_preserving, "optimal mass transport")
    maps = []
    for name, flattened in (("Conformal", conformal), ("Area-preserving", area_preserving)):
        metrics = simple.DistortionMetrics(
            registrationName=f"{name} map, measured",
            Input=flattened,
            UseRegionArray=1,
            RegionArray=["POINTS", REGION],
        )
        run(metrics, f"distortion of the {name.lower()} map")
        maps.append(metrics)
    return FlatteningPipeline(disk, *maps)
