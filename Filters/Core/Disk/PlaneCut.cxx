// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/PlaneCut.h"

#include "Base/Errors.h"
#include "Disk/IsolineCut.h"
#include "Geodesics/GeodesicDistance.h"
#include "Mesh/EditableSurface.h"
#include "Remeshing/BoundaryConditioning.h"
#include "Remeshing/LongestEdgeBisection.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

void requireValid(const CuttingPlane& plane, int boundaryVertices)
{
  if (!plane.Origin.allFinite() || !plane.Normal.allFinite())
  {
    throw InvalidInput("the cutting plane's origin or normal is not finite: set all coordinates");
  }
  if (!(plane.Normal.stableNorm() > 0.0))
  {
    throw InvalidInput("the cutting plane's normal is zero: point it to the side that stays");
  }
  if (boundaryVertices < 3)
  {
    throw InvalidInput("a boundary of " + std::to_string(boundaryVertices) +
                       " vertices was asked for: ask for 3 at least");
  }
}

// Signed distances of the vertices; positive on the side that stays.
std::vector<double> heightsOver(const CuttingPlane& plane, const Points3& points)
{
  const Eigen::Vector3d normal = plane.Normal.stableNormalized();
  std::vector<double> heights(points.rows());
  for (Eigen::Index v = 0; v < points.rows(); ++v)
  {
    heights[v] = (points.row(v).transpose() - plane.Origin).dot(normal);
  }
  return heights;
}

// A plane through a corner, an edge or a face has vertices on either side by rounding alone.
void requireBothSides(const std::vector<double>& heights, double rounding)
{
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  if (std::min(-*low, *high) > rounding)
  {
    return;
  }
  std::ostringstream message;
  message << "the cutting plane misses the surface or only touches it: from " << *low << " to " << *high
          << " along the plane's normal, all of it would be " << (*high > rounding ? "kept" : "removed")
          << "; move the plane's origin into the surface";
  throw InvalidInput(message.str());
}

void requireLongCut(double length, int boundaryVertices, double shortestEdge)
{
  if (length > boundaryVertices * shortestEdge)
  {
    return;
  }
  std::ostringstream message;
  message << "the cutting plane only grazes the surface, along a curve of length " << length
          << ", which double precision cannot divide into " << boundaryVertices
          << " edges: move the plane's origin into the surface";
  throw InvalidInput(message.str());
}

// Refines the faces along the plane if it crosses too few edges for the boundary wanted, so that
// conditioning moves vertices little. The longest edges are halved round by round: big faces are refined
// near the plane only.
void refineAlongPlane(EditableSurface& surface,
  std::vector<double>& heights,
  const CuttingPlane& plane,
  int boundaryVertices,
  double shortestEdge)
{
  if (static_cast<int>(edgesAcrossIsoline(surface.mesh(), heights, 0.0).size()) >= boundaryVertices)
  {
    return;
  }
  const double length = levelCurveLength(toTriangleMesh(surface.mesh()),
    Eigen::Map<const Eigen::VectorXd>(heights.data(), static_cast<Eigen::Index>(heights.size())),
    0.0);
  requireLongCut(length, boundaryVertices, shortestEdge);
  const double wanted = length / boundaryVertices;
  while (!crossesMoreThanEnough(surface.mesh(), heights, 0.0, boundaryVertices))
  {
    const auto faces = longFacesAtIsoline(surface, heights, 0.0, 0.0, EdgeLengthSlack * wanted);
    if (faces.empty())
    {
      return;
    }
    halveLongEdges(surface, faces, wanted);
    heights = heightsOver(plane, toTriangleMesh(surface.mesh()).Vertices);
    raiseValuesAt(heights, 0.0);
  }
}

std::vector<int> facesAbove(const TriangleMesh& mesh, const std::vector<double>& heights)
{
  std::vector<int> faces;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const double low =
      std::min({ heights[mesh.Faces(f, 0)], heights[mesh.Faces(f, 1)], heights[mesh.Faces(f, 2)] });
    if (low >= 0.0)
    {
      faces.push_back(f);
    }
  }
  return faces;
}

// Removes the slivers along the cut.
DerivedMesh conditioned(const TriangleMesh& part, const std::vector<char>& onCut)
{
  constexpr int smallestLoop = 3; // the boundary is refined afterwards
  EditableSurface surface(part);
  conditionCut(surface, onCut, smallestLoop);
  return surface.derived();
}

} // namespace

PlaneCutSurface cutAtPlane(const TriangleMesh& mesh,
  const CuttingPlane& plane,
  int boundaryVertices,
  const ProgressCallback& progress)
{
  requireValid(plane, boundaryVertices);
  report(progress, 0.0, "cutting at the plane");
  std::vector<double> heights = heightsOver(plane, mesh.Vertices);
  const double shortestEdge = ShortestBisected * mesh.Vertices.cwiseAbs().maxCoeff();
  requireBothSides(heights, shortestEdge);

  PlaneCutSurface cut;
  EditableSurface surface(mesh);
  raiseValuesAt(heights, 0.0);
  refineAlongPlane(surface, heights, plane, boundaryVertices, shortestEdge);
  snapToIsoline(surface, heights, 0.0);
  splitAtIsoline(surface, heights, 0.0);
  cut.Surface = surface.derived();

  report(progress, 0.4, "cutting at the plane");
  DerivedMesh part = extractFaces(cut.Surface.Mesh, facesAbove(cut.Surface.Mesh, heights));
  cut.RemovedArea =
    faceAreas(mesh.Vertices, mesh.Faces).sum() - faceAreas(part.Mesh.Vertices, part.Mesh.Faces).sum();
  std::vector<char> onCut(part.Mesh.vertexCount());
  for (int v = 0; v < part.Mesh.vertexCount(); ++v)
  {
    onCut[v] = heights[VertexOrigins::InnerIterator(part.Vertices, v).col()] == 0.0 ? 1 : 0;
  }
  follow(cut.Surface, std::move(part));

  report(progress, 0.6, "conditioning the cut");
  follow(cut.Surface, conditioned(cut.Surface.Mesh, onCut));
  report(progress, 0.8, "refining the cut");
  follow(cut.Surface, refineBoundary(cut.Surface.Mesh, boundaryVertices));
  report(progress, 1.0, "refining the cut");
  return cut;
}

} // namespace flattening
