// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/MapDeformation.h"

#include "Areas/SmoothDeformation.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Untangling/MapUntangling.h"
#include "Untangling/OutlineUntangling.h"
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
// parted, only if the boundary moves. So the second attempt frees it there.
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
  untangleWithOutline(this->Surface.Faces,
    this->FacesOf,
    this->Terms.Outline,
    before.Positions,
    triangles,
    map.Positions,
    options,
    subrange(progress, 0.5, 1.0));
  return this->countFlipped(map) == 0 && !edgesCross(map.Positions, this->Terms.Outline);
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

} // namespace flattening
