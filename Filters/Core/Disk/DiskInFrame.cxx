// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/DiskInFrame.h"

#include "Mesh/MeshMeasures.h"

namespace flattening
{

SurfaceToDiskOptions normalised(const SurfaceToDiskOptions& options, const CoordinateFrame& frame)
{
  SurfaceToDiskOptions result = options;
  result.MergeTolerance = frame.normalisedLength(options.MergeTolerance);
  result.FillLengthLimit = frame.normalisedLength(options.FillLengthLimit);
  result.TargetEdgeLength = frame.normalisedLength(options.TargetEdgeLength);
  result.Component.Point = frame.normalisedPoint(options.Component.Point);
  result.Boundary.Point = frame.normalisedPoint(options.Boundary.Point);
  result.Plane.Origin = frame.normalisedPoint(options.Plane.Origin);
  if (options.Hole.Centre)
  {
    result.Hole.Centre = frame.normalisedPoint(*options.Hole.Centre);
  }
  for (Eigen::Vector3d& point : result.SeamPoints)
  {
    point = frame.normalisedPoint(point);
  }
  return result;
}

void restoreUnits(DiskSurface& disk, const CoordinateFrame& frame)
{
  disk.Surface.Mesh.Vertices = frame.restored(disk.Surface.Mesh.Vertices);
  SurfaceToDiskReport& report = disk.Report;
  // Far from the origin new points are rounded: the figures are those of the positions that are put out.
  const TriangleMesh rounded = frame.normalised(disk.Surface.Mesh);
  report.SurfaceArea = faceAreas(rounded.Vertices, rounded.Faces).sum();
  report.BoundaryLength = loopLength(rounded.Vertices, disk.Boundary);
  report.SmallestAngle = smallestAngle(rounded);
  for (double* area : { &report.DroppedComponentArea,
         &report.Folds.AreaChange,
         &report.FilledArea,
         &report.Handles.RemovedArea,
         &report.Handles.AddedArea,
         &report.RemeshAreaChange,
         &report.RemovedArea,
         &report.SurfaceArea })
  {
    *area = frame.restoredArea(*area);
  }
  for (double* length : { &report.Handles.GreatestDisplacement,
         &report.RemeshEdgeLength,
         &report.HoleRadius,
         &report.SeamLength,
         &report.ReliefLength,
         &report.BoundaryLength })
  {
    *length = frame.restoredLength(*length);
  }
  for (double& length : report.Handles.LoopLengths)
  {
    length = frame.restoredLength(length);
  }
  if (report.HoleRadius > 0.0)
  {
    report.HoleCentre = frame.restoredPoint(report.HoleCentre);
  }
}

} // namespace flattening
