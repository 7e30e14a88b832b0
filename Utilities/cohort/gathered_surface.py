# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens a surface that lies in pieces over the ranks of a parallel run, by ParaView's stock filters:

    PV_PLUGIN_PATH=build/plugins mpiexec -n 4 pvbatch Utilities/cohort/gathered_surface.py \\
        surface.pvtp flat.vtp

Without a file it takes ParaView's Sphere, of which each rank makes its part. Aggregate Dataset brings the pieces to
one rank, Clean joins the points that two of them have; the filters of the flattening then run there, and say nothing
on the other ranks, which have no points.
"""

import argparse

from paraview import simple


def gathered(surface):
    """The whole surface on the first rank, in one piece."""
    whole = simple.AggregateDataset(Input=surface, NumberOfTargetProcesses=1)
    return simple.Clean(Input=whole)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("surface", nargs="?", help="a file that ParaView opens")
    parser.add_argument("flat", nargs="?", help="the flat map, .vtp")
    arguments = parser.parse_args()
    if arguments.surface:
        surface = simple.OpenDataFile(arguments.surface)
    else:
        surface = simple.Sphere(ThetaResolution=60, PhiResolution=60)
    disk = simple.SurfaceToDisk(Input=gathered(surface))
    flat = simple.OMTAreaPreserving(Input=simple.ConformalDisk(Input=disk))
    measured = simple.DistortionMetrics(Input=flat)
    measured.UpdatePipeline()
    if measured.GetDataInformation().GetNumberOfCells() == 0:
        raise SystemExit("nothing came out; see the error above")
    for name in ("SurfaceArea", "FlatArea", "FacesWithin2Percent", "FlippedFaces"):
        print(name, repr(measured.FieldData[name].GetRange()[0]))
    if arguments.flat:
        simple.SaveData(arguments.flat, measured, DataMode="Binary")


if __name__ == "__main__":
    main()
