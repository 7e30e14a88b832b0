// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FreedMap.h"

#include "Areas/RefinementPatches.h"
#include "Areas/TargetAreas.h"

#include <utility>

namespace flattening
{
namespace
{

// The share of the faces that a free outline may leave wrong beyond those that are wrong in the domain:
// where more are, area weights or thin protrusions ask for more than a free outline can give, and the
// map stays in its domain.
constexpr double GreatestLoss = 0.01;

} // namespace

FreedMap freedMap(const TriangleMesh& surface,
  const TransportedMap& map,
  const Eigen::VectorXd& faceTargets,
  const FaceRefinementOptions& options,
  const ProgressCallback& progress)
{
  FaceRefinementOptions rough = options;
  rough.IsRough = true;
  FreedMap result;
  result.OnDomain = refineFaces(surface, map, faceTargets, rough, subrange(progress, 0.0, 0.25));
  if (options.StopsOnTheWay && result.OnDomain.isOnTheWay())
  {
    return result;
  }
  FreeOutlineResult freed = freeOutline(surface,
    map.Loop,
    result.OnDomain.Positions,
    faceTargets,
    map.Domain->area(),
    shapeWeight(options),
    subrange(progress, 0.25, 0.95));
  const bool isFreed = freed.Deformations > 0;
  double allowed = GreatestLoss;
  if (!isFreed || freed.ShareOff > allowed)
  {
    result.OnDomain = refineFaces(surface, map, faceTargets, options, subrange(progress, 0.95, 1.0));
    allowed += shareOfWrongFaces(result.OnDomain.Positions,
      surface.Faces,
      scaledTargets(faceTargets, map.Domain->area()),
      RefinementPatches::AreaTolerance);
  }
  if (isFreed && freed.ShareOff <= allowed)
  {
    result.Freed = std::move(freed);
  }
  return result;
}

} // namespace flattening
