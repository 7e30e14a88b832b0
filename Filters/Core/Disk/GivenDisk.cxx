// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/GivenDisk.h"

#include "Base/Errors.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/MeshTopology.h"
#include "Repair/CoincidentPoints.h"

namespace flattening
{

bool isDisk(const TriangleMesh& soup)
{
  try
  {
    requireDisk(soup);
  }
  catch (const InvalidInput&)
  {
    return false;
  }
  catch (const TopologyError&)
  {
    return false;
  }
  return faceAreas(soup.Vertices, soup.Faces).minCoeff() > 0.0;
}

std::vector<char> pointsKeptApart(const TriangleMesh& soup, const SurfaceToDiskOptions& options)
{
  return options.MergeTolerance == 0.0 && isDisk(soup) ? std::vector<char>(soup.vertexCount(), 1)
                                                       : options.Banks;
}

bool passesUnchanged(const TriangleMesh& soup, const SurfaceToDiskOptions& options)
{
  const bool nothingAsked =
    (options.Cut == CutMode::Automatic || options.Cut == CutMode::Hole || options.Cut == CutMode::Seam) &&
    options.SeamPoints.empty() && !options.Hole.Centre && !options.Remesh &&
    options.Boundary.By != BoundaryChoice::Rule::None;
  return nothingAsked && !options.Banks.empty() && isDisk(soup);
}

DiskSurface givenDisk(const TriangleMesh& soup, const SurfaceToDiskOptions& options)
{
  DiskSurface disk;
  disk.Surface = derivedFromItself(soup);
  disk.Seam = options.Banks;
  disk.SeamPoint = coincidentPoints(soup.Vertices, 0.0);
  for (int v = 0; v < soup.vertexCount(); ++v)
  {
    if (!disk.Seam[v])
    {
      disk.SeamPoint[v] = -1;
    }
  }
  disk.Report.Components = 1;
  disk.Report.ReasonOfCut = "the surface is a disk already, with the seams of an earlier cut";
  return disk;
}

} // namespace flattening
