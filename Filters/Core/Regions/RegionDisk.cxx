// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/RegionDisk.h"

#include "Base/Errors.h"
#include "Geodesics/DijkstraDistance.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/FaceFlags.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceComponents.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// One flag per vertex: 1 for the corners of the flagged faces.
std::vector<char> cornersOf(const TriangleMesh& mesh, const std::vector<char>& faces)
{
  std::vector<char> corners(mesh.vertexCount(), 0);
  for (const int f : flagged(faces))
  {
    for (int k = 0; k < 3; ++k)
    {
      corners[mesh.Faces(f, k)] = 1;
    }
  }
  return corners;
}

// A set of faces that is turned into a disk.
class GrowingRegion
{
public:
  GrowingRegion(const TriangleMesh& mesh, std::vector<char> inside)
    : Mesh(mesh)
    , Inside(std::move(inside))
    , Areas(faceAreas(mesh.Vertices, mesh.Faces))
  {
    const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
    this->OnBoundary.assign(mesh.vertexCount(), 0);
    for (const std::vector<int>& loop : topology.BoundaryLoops)
    {
      for (const int v : loop)
      {
        this->OnBoundary[v] = 1;
      }
    }
  }

  const std::vector<char>& faces() const { return this->Inside; }

  double area() const
  {
    const std::vector<int> faces = flagged(this->Inside);
    return std::accumulate(
      faces.begin(), faces.end(), 0.0, [this](double sum, int f) { return sum + this->Areas[f]; });
  }

  void keepLargestPiece(RegionDisk& report)
  {
    const std::vector<int> faces = flagged(this->Inside);
    const DerivedMesh part = extractFaces(this->Mesh, faces);
    const SurfaceComponents pieces = connectedComponents(part.Mesh);
    const double before = this->area();
    report.Pieces = pieces.Count;
    this->Inside.assign(this->Inside.size(), 0);
    for (const int f : pieces.faces(largestComponent(part.Mesh, pieces)))
    {
      this->Inside[faces[f]] = 1;
    }
    report.DroppedArea = std::max(before - this->area(), 0.0);
  }

  // Adds the faces around vertices where the region touches itself.
  void openPinches() { flagAroundPinches(this->Mesh, this->Inside, true); }

  // Adds the parts of the rest that the region surrounds. Returns their number.
  int fillHoles(double largest, double& filledArea)
  {
    const std::vector<int> faces = flagged(this->Inside, false);
    if (faces.empty())
    {
      return 0;
    }
    const DerivedMesh rest = extractFaces(this->Mesh, faces);
    const SurfaceComponents parts = connectedComponents(rest.Mesh);
    const Eigen::VectorXd areas = componentAreas(rest.Mesh, parts);
    std::vector<char> isOpen(parts.Count, 0); // whether the part reaches the boundary of the surface
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        isOpen[parts.OfFace[f]] |= this->OnBoundary[this->Mesh.Faces(faces[f], k)];
      }
    }
    if (std::none_of(isOpen.begin(), isOpen.end(), [](char open) { return open; }))
    {
      isOpen[largestComponent(rest.Mesh, parts)] = 1;
    }
    int holes = 0;
    for (int part = 0; part < parts.Count; ++part)
    {
      holes += !isOpen[part];
      filledArea += isOpen[part] ? 0.0 : areas[part];
    }
    if (filledArea > largest * this->area())
    {
      std::ostringstream text;
      text
        << "the region surrounds " << holes << " part" << (holes == 1 ? "" : "s")
        << " of the surface that do not belong to it, of area " << filledArea
        << " in all, more than its holes may have: raise the share of holes that are filled, choose a "
           "smaller margin, or give these parts the label of the region";
      throw TopologyError(text.str());
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      this->Inside[faces[f]] = !isOpen[parts.OfFace[f]];
    }
    return holes;
  }

  // Adds the faces whose corners are within a distance of the region along edges.
  void grow(double margin)
  {
    const std::vector<char> corners = cornersOf(this->Mesh, this->Inside);
    const Eigen::VectorXd distance = distancesFromFlagged(toSurfaceMesh(this->Mesh), corners);
    for (int f = 0; f < this->Mesh.faceCount(); ++f)
    {
      const auto face = this->Mesh.Faces.row(f);
      const double farthest = std::max({ distance[face[0]], distance[face[1]], distance[face[2]] });
      this->Inside[f] |= static_cast<char>(farthest <= margin);
    }
  }

private:
  const TriangleMesh& Mesh;
  std::vector<char> Inside;
  std::vector<char> OnBoundary; // one flag per vertex: 1 on the boundary of the whole surface
  Eigen::VectorXd Areas;
};

void requireRegionIsDisk(const TriangleMesh& mesh, const std::string& name, const std::string& remedy)
{
  try
  {
    requireDisk(mesh);
  }
  catch (const FlatteningError& error)
  {
    throw TopologyError(name + " is not a disk (" + error.what() + "); here: " + remedy);
  }
}

} // namespace

RegionDisk regionDisk(const TriangleMesh& mesh,
  const std::vector<char>& inRegion,
  const RegionDiskOptions& options)
{
  if (!(options.Margin >= 0.0) || !std::isfinite(options.Margin) || !(options.LargestHoles >= 0.0) ||
      !std::isfinite(options.LargestHoles))
  {
    throw InvalidInput("the margin and the share of holes of a region must not be negative or infinite");
  }
  if (flagged(inRegion).empty())
  {
    throw InvalidInput("the region has no triangle: choose another, or one with more points");
  }
  RegionDisk result;
  GrowingRegion region(mesh, inRegion);
  region.keepLargestPiece(result);
  region.openPinches();
  result.FilledHoles = region.fillHoles(options.LargestHoles, result.FilledArea);
  const std::vector<char> core = region.faces();
  requireRegionIsDisk(extractFaces(mesh, flagged(core)).Mesh,
    "the region",
    "remove handles with Surface To Disk before, or choose a smaller region");
  if (options.Margin > 0.0)
  {
    region.grow(options.Margin);
    region.openPinches();
    double filled = 0.0;
    region.fillHoles(options.LargestHoles, filled);
  }
  result.Disk = extractFaces(mesh, flagged(region.faces()));
  requireRegionIsDisk(result.Disk.Mesh, "the region with its margin", "choose a smaller margin");
  for (const int f : result.Disk.Faces)
  {
    result.InRegion.push_back(core[f]);
  }
  return result;
}

} // namespace flattening
