// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/MapDeformation.h"

#include "Areas/SmoothDeformation.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Untangling/MapUntangling.h"
#include "Untangling/TargetTriangles.h"

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
  const DomainMap deformed = smoothlyDeformed(this->Terms,
    this->Dofs,
    map,
    targets,
    request.Shapes,
    request.AreaWeight,
    subrange(progress, 0.0, 0.7));
  for (const double share : DeformationShares)
  {
    DomainMap next = this->Dofs.between(map, deformed, share);
    if (this->countFlipped(next) <= most && !edgesCross(next.Positions, this->Terms.Outline) &&
        (request.MayFlip || this->untangle(next, targets, subrange(progress, 0.7, 1.0))))
    {
      map = std::move(next);
      return true;
    }
  }
  return false;
}

// Faces that have all their vertices on a free boundary can be untangled only if the boundary moves. So
// the second attempt frees the boundary vertices near flipped faces. This may let the boundary cross
// itself, which is tested afterwards.
bool MapDeformation::untangle(DomainMap& map,
  const Eigen::VectorXd& targets,
  const ProgressCallback& progress) const
{
  if (this->countFlipped(map) == 0)
  {
    return true;
  }
  UntanglingOptions options;
  options.AreaWeight = UntanglingOptions::EqualAreaWeight;
  options.LargestPatch = LargestUntangledPatch;
  const TargetTriangles triangles = trianglesOfArea(this->Surface, targets);
  const auto untangled = [&](const std::vector<char>& fixed, const ProgressCallback& part)
  {
    return untangleMap(this->Surface.Faces, fixed, triangles, map.Positions, options, part)
             .FlippedFaces == 0;
  };
  return untangled(this->onBoundary(), subrange(progress, 0.0, 0.5)) ||
         (!this->Terms.Outline.empty() &&
           untangled(this->onBoundaryFarFromFlipped(map.Positions), subrange(progress, 0.5, 1.0)) &&
           !edgesCross(map.Positions, this->Terms.Outline));
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

std::vector<char> MapDeformation::onBoundaryFarFromFlipped(const Points2& positions) const
{
  std::vector<char> fixed = this->onBoundary();
  const std::vector<signed char> orientations = faceOrientations(positions, this->Surface.Faces);
  for (int f = 0; f < this->Surface.faceCount(); ++f)
  {
    if (orientations[f] > 0)
    {
      continue;
    }
    for (const int corner : this->Surface.Faces.row(f))
    {
      for (const int face : this->FacesOf[corner])
      {
        for (const int v : this->Surface.Faces.row(face))
        {
          fixed[v] = 0;
        }
      }
    }
  }
  return fixed;
}

} // namespace flattening
