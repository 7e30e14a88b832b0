// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/MapDeformation.h"

#include "Areas/SmoothDeformation.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/OutlineGaps.h"
#include "Untangling/MapUntangling.h"
#include "Untangling/TargetTriangles.h"

#include <iterator>
#include <utility>

namespace flattening
{
namespace
{

// The shares of a deformation to try: with the smaller ones fewer faces flip.
constexpr double DeformationShares[] = { 1.0, 0.5, 0.25 };
// The share of all faces that a deformation may flip where they are free to. A guard: one that flips
// more bends thin faces, and the rounds take longer than without it.
constexpr double MostNewlyFlipped = 1e-4;
// In stages in which faces may not flip, these are the greatest share of the faces that a deformation
// may flip before they are untangled, and the greatest number of vertices that are moved together to
// untangle them. Guards for the time: beyond them a smaller share of the deformation is tried.
constexpr double MostFlipped = 0.05;
constexpr int LargestUntangledPatch = 200;

TargetTriangle triangleOf(const Eigen::RowVector3i& face, const Points2& positions)
{
  const auto first = positions.row(face[0]);
  return { positions.row(face[1]) - first, positions.row(face[2]) - first };
}

} // namespace

MapDeformation::MapDeformation(const TriangleMesh& surface,
  const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& dofs)
  : Surface(surface)
  , Terms(terms)
  , FacesOf(facesOf)
  , Dofs(dofs)
{
}

int MapDeformation::countFlipped(const DomainMap& map) const
{
  return countFlippedFaces(map.Positions, this->Surface.Faces);
}

bool MapDeformation::deform(DomainMap& map,
  const Eigen::VectorXd& targets,
  const Request& request,
  const ProgressCallback& progress) const
{
  const int faces = this->Surface.faceCount();
  const int most = request.MayFlip ? this->countFlipped(map) + static_cast<int>(MostNewlyFlipped * faces)
                                   : static_cast<int>(MostFlipped * faces);
  constexpr double smooth = 0.7; // of the progress
  const DomainMap deformed = smoothlyDeformed(this->Terms,
    this->Dofs,
    map,
    targets,
    request.Shapes,
    request.AreaWeight,
    request.Fineness,
    subrange(progress, 0.0, smooth));
  double end = smooth;
  for (const double share : DeformationShares)
  {
    const double begin = end;
    end += (1.0 - smooth) / std::size(DeformationShares);
    DomainMap next = this->Dofs.between(map, deformed, share);
    if (this->countFlipped(next) <= most &&
        (request.MayFlip || this->untangle(map, next, targets, subrange(progress, begin, end))))
    {
      map = std::move(next);
      return true;
    }
  }
  return false;
}

// Makes the deformed map @p map one-to-one again, near where faces are flipped or edges of the outline
// cross. Faces that have all their vertices on a free boundary can be untangled, and edges that cross be
// parted, only if the boundary moves. So the second attempt frees it there. The gaps beside it, as they
// were @p before, count as faces then, so that no part of the outline moves across another.
bool MapDeformation::untangle(const DomainMap& before,
  DomainMap& map,
  const Eigen::VectorXd& targets,
  const ProgressCallback& progress) const
{
  const int flipped = this->countFlipped(map);
  if (flipped == 0 && !edgesCross(map.Positions, this->Terms.Outline))
  {
    return true;
  }
  UntanglingOptions options;
  options.AreaWeight = UntanglingOptions::EqualAreaWeight;
  options.LargestPatch = LargestUntangledPatch;
  const TargetTriangles triangles = trianglesOfArea(this->Surface, targets);
  if (flipped > 0)
  {
    const UntanglingReport report = untangleMap(this->Surface.Faces,
      this->onBoundary(),
      triangles,
      map.Positions,
      options,
      subrange(progress, 0.0, 0.5));
    if (report.FlippedFaces == 0 && !edgesCross(map.Positions, this->Terms.Outline))
    {
      return true;
    }
  }
  if (this->Terms.Outline.empty())
  {
    return false;
  }
  const std::vector<char> fixed = this->onBoundaryFarFromFaults(map.Positions);
  const FaceMatrix faces = this->withGaps(before.Positions, fixed);
  untangleMap(
    faces,
    fixed,
    [&](int f) {
      return f < this->Surface.faceCount() ? triangles(f) : triangleOf(faces.row(f), before.Positions);
    },
    map.Positions,
    options,
    subrange(progress, 0.5, 1.0));
  return this->countFlipped(map) == 0 && !edgesCross(map.Positions, this->Terms.Outline);
}

// The faces, and the gaps of the outline that free vertices bound.
FaceMatrix MapDeformation::withGaps(const Points2& positions, const std::vector<char>& fixed) const
{
  const FaceMatrix gaps = outlineGaps(positions, this->Terms.Outline);
  FaceMatrix faces(this->Surface.faceCount() + gaps.rows(), 3);
  faces.topRows(this->Surface.faceCount()) = this->Surface.Faces;
  Eigen::Index count = this->Surface.faceCount();
  for (Eigen::Index gap = 0; gap < gaps.rows(); ++gap)
  {
    if (!fixed[gaps(gap, 0)] || !fixed[gaps(gap, 1)] || !fixed[gaps(gap, 2)])
    {
      faces.row(count++) = gaps.row(gap);
    }
  }
  faces.conservativeResize(count, 3);
  return faces;
}

std::vector<char> MapDeformation::onBoundary() const
{
  std::vector<char> flags(this->Surface.vertexCount(), 0);
  for (const int v : this->Dofs.loop())
  {
    flags[v] = 1;
  }
  for (const FlatEdge& edge : this->Terms.Outline)
  {
    flags[edge[0]] = 1;
  }
  return flags;
}

// The boundary vertices that are not near faces that are flipped or edges that cross.
std::vector<char> MapDeformation::onBoundaryFarFromFaults(const Points2& positions) const
{
  std::vector<char> isNear(this->Surface.vertexCount(), 0);
  const std::vector<signed char> orientations = faceOrientations(positions, this->Surface.Faces);
  for (int f = 0; f < this->Surface.faceCount(); ++f)
  {
    for (const int corner : this->Surface.Faces.row(f))
    {
      isNear[corner] = isNear[corner] || orientations[f] <= 0;
    }
  }
  const std::vector<char> crossing = crossingEdges(positions, this->Terms.Outline);
  for (std::size_t k = 0; k < crossing.size(); ++k)
  {
    for (const int v : this->Terms.Outline[k])
    {
      isNear[v] = isNear[v] || crossing[k];
    }
  }
  std::vector<char> fixed = this->onBoundary();
  for (int v = 0; v < this->Surface.vertexCount(); ++v)
  {
    if (!isNear[v])
    {
      continue;
    }
    for (const int face : this->FacesOf[v])
    {
      for (const int corner : this->Surface.Faces.row(face))
      {
        fixed[corner] = 0;
      }
    }
  }
  return fixed;
}

} // namespace flattening
