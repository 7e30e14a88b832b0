// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceToDisk.h"

#include "BorderStitching.h"
#include "ConsistentOrientation.h"
#include "Errors.h"
#include "HoleFilling.h"
#include "IsotropicRemeshing.h"
#include "MeshTopology.h"
#include "SurfaceComponents.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

void requireValid(const SurfaceToDiskOptions& options)
{
  if (!(options.MergeTolerance >= 0.0) || !std::isfinite(options.MergeTolerance))
  {
    throw InvalidInput("the merge tolerance is " + std::to_string(options.MergeTolerance) +
                       ": set it to 0 or a small length in the units of the surface");
  }
  if (options.ComponentPoint && !options.ComponentPoint->allFinite())
  {
    throw InvalidInput("the component's point is not finite: set all of its coordinates");
  }
}

// Takes one component and gives it one side that is the outer one.
MeshTopology chooseComponent(DiskSurface& disk,
  RepairedSurface&& repaired,
  const SurfaceToDiskOptions& options)
{
  disk.Surface = std::move(repaired.Surface);
  const SurfaceComponents components = connectedComponents(disk.Surface.Mesh);
  const std::vector<int> faces = components.faces(
    options.ComponentPoint ? closestComponent(disk.Surface.Mesh, components, *options.ComponentPoint)
                           : largestComponent(disk.Surface.Mesh, components));
  disk.Report.Components = components.Count;

  std::vector<char> reversed;
  reversed.reserve(faces.size());
  for (const int f : faces)
  {
    reversed.push_back(repaired.Reversed[f]);
    if (repaired.OneSided[f])
    {
      throw TopologyError("the surface is one-sided, like a Moebius strip, at face " +
                          std::to_string(disk.Surface.Faces[f]) +
                          ": cut it open there first, e.g. with Clip");
    }
  }
  follow(disk.Surface, extractFaces(disk.Surface.Mesh, faces));
  if (disk.Report.Repair.SplitPoints > 0)
  {
    follow(disk.Surface, stitchCoincidentBorders(disk.Surface.Mesh));
  }
  TriangleMesh& mesh = disk.Surface.Mesh;
  MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  disk.Report.ReorientedFaces = orientOutward(mesh, reversed, topology.BoundaryLoops.empty());
  return topology;
}

void requireNoHandles(int genus)
{
  if (genus > 0)
  {
    throw TopologyError("the surface has genus " + std::to_string(genus) + ", that is " +
                        std::to_string(genus) +
                        (genus > 1 ? " handles or tunnels" : " handle or tunnel") +
                        ": smooth the volume more before Contour (a Gaussian of 2 voxels or "
                        "more), change the isovalue, or cut the handles off with Clip");
  }
}

std::vector<std::vector<int>>::iterator longestLoop(const Points3& vertices,
  std::vector<std::vector<int>>& loops)
{
  return std::max_element(loops.begin(),
    loops.end(),
    [&vertices](const auto& a, const auto& b)
    { return loopLength(vertices, a) < loopLength(vertices, b); });
}

// Shorter than a circle around the area of the hole that would be cut: a defect or a puncture, of too
// few edges to become the boundary of the flat disk.
bool isSmallerThanHole(const TriangleMesh& mesh, const std::vector<int>& loop, double areaFraction)
{
  constexpr double pi = 3.14159265358979323846;
  const double length = loopLength(mesh.Vertices, loop);
  return length * length < 4.0 * pi * areaFraction * faceAreas(mesh.Vertices, mesh.Faces).sum();
}

Eigen::Vector3d centreOfLoop(const Points3& vertices, const std::vector<int>& loop)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const int v : loop)
  {
    sum += vertices.row(v);
  }
  return sum.transpose() / static_cast<double>(loop.size());
}

} // namespace

DiskSurface surfaceToDisk(const TriangleMesh& soup,
  const SurfaceToDiskOptions& options,
  const ProgressCallback& progress)
{
  requireValid(options);
  DiskSurface disk;
  SurfaceToDiskReport& figures = disk.Report;

  report(progress, 0.0, "repairing");
  RepairedSurface repaired = repairTriangleSoup(soup, options.MergeTolerance);
  figures.Repair = repaired.Report;
  report(progress, 0.2, "choosing the component");
  MeshTopology topology = chooseComponent(disk, std::move(repaired), options);
  figures.Genus = topology.Genus;
  requireNoHandles(figures.Genus);

  report(progress, 0.25, "filling holes");
  std::vector<std::vector<int>>& loops = topology.BoundaryLoops;
  GeodesicHoleOptions hole = options.Hole;
  bool mustOpen = loops.empty();
  if (!mustOpen)
  {
    const auto longest = longestLoop(disk.Surface.Mesh.Vertices, loops);
    mustOpen = isSmallerThanHole(disk.Surface.Mesh, *longest, hole.AreaFraction);
    if (!mustOpen)
    {
      loops.erase(longest);
    }
    else if (!hole.Centre)
    {
      hole.Centre = centreOfLoop(disk.Surface.Mesh.Vertices, *longest);
    }
  }
  if (!loops.empty())
  {
    FilledSurface filled = fillHoles(disk.Surface.Mesh, loops, subrange(progress, 0.25, 0.35));
    figures.FilledHoles = filled.FilledHoles;
    figures.FilledArea = filled.FilledArea;
    follow(disk.Surface, std::move(filled.Surface));
  }

  if (options.RemeshEdgeLength)
  {
    const double length = *options.RemeshEdgeLength;
    figures.RemeshEdgeLength = length == 0.0 ? meanEdgeLength(disk.Surface.Mesh) : length;
    follow(disk.Surface,
      remeshIsotropically(
        disk.Surface.Mesh, figures.RemeshEdgeLength, 3, subrange(progress, 0.35, 0.65)));
  }

  if (mustOpen)
  {
    OpenedSurface opened = cutGeodesicHole(disk.Surface.Mesh, hole, subrange(progress, 0.65, 0.95));
    figures.HoleCentre = opened.Centre;
    figures.HoleRadius = opened.Radius;
    figures.RemovedArea = opened.RemovedArea;
    follow(disk.Surface, std::move(opened.Surface));
  }

  report(progress, 0.95, "checking the disk");
  const TriangleMesh& mesh = disk.Surface.Mesh;
  const std::vector<int> boundary = requireDisk(mesh);
  figures.BoundaryVertices = static_cast<int>(boundary.size());
  figures.BoundaryLength = loopLength(mesh.Vertices, boundary);
  figures.SurfaceArea = faceAreas(mesh.Vertices, mesh.Faces).sum();
  report(progress, 1.0, "done");
  return disk;
}

} // namespace flattening
