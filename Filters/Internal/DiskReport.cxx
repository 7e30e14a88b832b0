// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/DiskReport.h"

#include "Core/Base/Errors.h"
#include "Internal/ReportRows.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// A hole of fewer mean triangles is worth a warning. Measured on spheres with a hole of 0.1 % of the
// area: 31 % of the triangles keep their areas within 2 % with a hole as large as 0.7 of them, 75 % with
// 10, 92 % with 39, and 98 % on a brain with 260.
constexpr double FewestHoleFaces = 50.0;

// A handle whose loop could surround more than this share of the surface is no noise. A convention, a
// hundredth of the surface's size: it lies between the loops of noise on scans of heads, which are some
// millimetres long, and the loop around a zygomatic arch, of 43 mm.
constexpr double SmallestHandle = 1e-4;

// Dropped components with more than this share of the area of the surface are no noise. A convention.
constexpr double SmallestDropped = 1e-3;

// Remeshing that changes the area by more than this share is worth a warning. A convention: the steps of
// voxels on scans that were not smoothed are noise, and cost 3 to 5 %.
constexpr double GreatestAreaChange = 0.06;

double longestLoop(const SurfaceToDiskReport& report)
{
  const std::vector<double>& lengths = report.Handles.LoopLengths;
  return lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
}

void addRepair(ReportRows& rows, const SurfaceToDiskReport& report)
{
  rows.addChange(report.Repair.MergedPoints, "points merged into others", "Merge Tolerance");
  rows.addChange(report.Repair.DegenerateFaces, "triangles without area dropped", "");
  rows.addChange(report.Repair.DuplicateFaces, "repeated triangles dropped", "");
  rows.addChange(report.Repair.ClosedTJunctions, "cracks closed", "Merge Tolerance");
  rows.addChange(report.Repair.SplitPoints, "points split where sheets meet", "");
  rows.addChange(report.Components - 1, "other components dropped", "Component");
  rows.addChange(report.DroppedComponentArea, "area of these components", "Component");
  rows.addChange(report.ReorientedFaces, "triangles turned over", "");
  rows.addChange(report.Folds.Spikes, "spikes and pits flattened", "Flatten Folds");
  rows.addChange(report.Folds.Fins, "fins flattened", "Flatten Folds");
  rows.addChange(report.Folds.AreaChange, "change of the area by that", "Flatten Folds");
  rows.addChange(report.FilledHoles, "holes filled", "Fill Length Limit");
  rows.addChange(report.FilledArea, "area of the patches", "Fill Length Limit");
  rows.addChange(report.Handles.Handles, "handles removed", "Handles");
  rows.addChange(longestLoop(report), "length of the longest loop that was cut", "Handles");
  rows.addChange(report.Handles.RemovedArea, "area lost at handles", "Handles");
  rows.addChange(report.Handles.AddedArea, "area of the caps", "Handles");
  rows.addChange(report.Handles.GreatestDisplacement, "greatest shift of a point", "Handles");
  rows.addChange(report.RemeshEdgeLength, "edge length of the new triangles", "Remesh");
  rows.addChange(report.RemeshAreaChange, "change of the area by that", "Remesh");
}

} // namespace

void setReportTable(vtkTable* table, const SurfaceToDiskReport& report)
{
  ReportRows rows;
  addRepair(rows, report);
  rows.addChange(report.RemovedArea, "area cut off", "Cut");
  rows.addChange(report.HoleRadius, "radius of the hole", "Hole Area Fraction");
  rows.addChange(report.ReliefBranches, "branches of the relief", "Relief Gain");
  rows.add(report.SeamLength, "length of all seams", "Cut");
  rows.add(report.BoundaryLength, "length of the boundary of the disk", "Cut");
  rows.add(report.SurfaceArea, "area of the disk", "");
  rows.add(report.SmallestAngle, "smallest angle of a triangle, in degrees", "Smallest Angle");
  rows.addChange(report.SelfIntersections, "pairs of triangles intersect", "");
  rows.fill(table);
}

std::vector<std::string> warningsOf(const SurfaceToDiskReport& report)
{
  std::vector<std::string> warnings;
  const double loop = longestLoop(report);
  if (loop * loop / (4.0 * EIGEN_PI) > SmallestHandle * report.SurfaceArea)
  {
    const bool one = report.Handles.Handles == 1;
    warnings.push_back((one ? "a handle or tunnel was"
                            : std::to_string(report.Handles.Handles) + " handles or tunnels were") +
                       " cut through and capped; the " + (one ? "" : "longest ") + "loop is " +
                       formatted(loop) + " long, and the caps have an area of " +
                       formatted(report.Handles.AddedArea) +
                       ". If that is anatomy and no noise, set Handles to Cut, or smooth the scan less. "
                       "The caps have Filled 1");
  }
  if (report.DroppedComponentArea > SmallestDropped * report.SurfaceArea)
  {
    warnings.push_back(counted(report.Components - 1, "other component") + " with an area of " +
                       formatted(report.DroppedComponentArea) + " " +
                       (report.Components == 2 ? "was" : "were") + " dropped, beside " +
                       formatted(report.SurfaceArea) +
                       " that were kept. If one of them is meant, choose it by Component");
  }
  const double kept = report.SurfaceArea + report.RemovedArea;
  if (std::abs(report.RemeshAreaChange) > GreatestAreaChange * kept)
  {
    warnings.push_back("remeshing changed the area from " + formatted(kept - report.RemeshAreaChange) +
                       " to " + formatted(kept) +
                       ", as the surface has folds or corners that are sharper than the new triangles "
                       "can be: set a smaller edge length, or turn Remesh off");
  }
  if (report.RemovedRegionPoints > 0)
  {
    warnings.push_back(
      "the hole took " + std::to_string(report.RemovedRegionPoints) +
      " points of the region of interest, which leaves it no other place: mark a smaller "
      "region or lower the hole's area");
  }
  if (report.HoleFaces > 0.0 && report.HoleFaces < FewestHoleFaces)
  {
    warnings.push_back(
      "the hole is as large as " + formatted(report.HoleFaces) +
      " triangles only, and a flat map cannot keep the areas around so small a hole: set "
      "Cut to Seam, or raise the hole's area, or set Remesh with a smaller edge length");
  }
  if (report.SeamRegionPoints > 0)
  {
    warnings.push_back("the cut of handles, or of a tube from end to end, runs through " +
                       std::to_string(report.SeamRegionPoints) +
                       " points of the region of interest: set Handles to Remove, or choose points for "
                       "the seam, to keep it whole");
  }
  return warnings;
}

} // namespace flattening
