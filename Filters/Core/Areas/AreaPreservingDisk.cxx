// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/AreaPreservingDisk.h"

#include "Areas/DomainTarget.h"
#include "Areas/FreeOutline.h"
#include "Areas/MapByTransport.h"
#include "Areas/RefinementPatches.h"
#include "Areas/WrongFaces.h"
#include "Base/Errors.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace flattening
{
namespace
{

// Area weights whose greatest is more than so many times the least are reached in steps, of which each
// starts from the map of the one before. One transport over six decades squeezes the region with the
// least weight to faces 100,000 times as long as wide, which no refinement sets right.
constexpr double WidestStep = 32.0;
// A step whose map has a greater mean error of areas is made again in halves, unless it is narrower than
// NarrowestStep. Maps of good steps have 1.2 % or less, and failed ones 3 % or more.
constexpr double GreatestStepError = 0.02;
constexpr double NarrowestStep = 4.0;
// The share of the progress that a step or another transport shows of what is left for the way from the
// map before to its own. A choice: the rest is for what follows a failed one.
constexpr double ShownShare = 0.9;
// The same of the first transport, which mostly is the only one.
constexpr double FirstShownShare = 0.97;
// A map that did not reach the transported one is transported again, up to MostTransports times in all.
// A limit of the time: maps that get there mostly do so the second or third time. Some disks around a
// small hole, most of whose vertices lie near it, need this: of one, 4 % of the faces are within 2 %
// after the first transport, and 73 % after the second.
constexpr int MostTransports = 4;

// The greatest weight over the least one that the refinement takes. At a hundred million, areas of the
// least weight were 600 times too large on 469 points; at ten million a map of 2,791 points took a
// minute.
constexpr double GreatestWeightRatio = 1e6;

// The logarithm of the greatest over the least weight.
double rangeOf(const Eigen::VectorXd& weights)
{
  return weights.size() == 0 ? 0.0 : std::log(weights.maxCoeff()) - std::log(weights.minCoeff());
}

// The mean of the relative errors of the areas of the faces, at most 1 each, by area on the surface: by
// area on the map, regions with small weights would be no part of it.
double meanAreaError(const TriangleMesh& mesh, const Points2& positions, const Eigen::VectorXd& weights)
{
  const Eigen::VectorXd surface = faceAreas(mesh.Vertices, mesh.Faces);
  const Eigen::VectorXd targets = faceTargets(mesh, weights);
  const Eigen::VectorXd areas = signedFaceAreas(positions, mesh.Faces);
  const double scale = targets.sum() / areas.sum();
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const double error = std::abs(scale * areas[f] - targets[f]);
    sum += surface[f] * (error < targets[f] ? error / targets[f] : 1.0);
  }
  return sum / surface.sum();
}

// The share of the faces whose area is off by more than the tolerance of the refinement.
double shareOff(const TriangleMesh& mesh,
  const Points2& positions,
  const Eigen::VectorXd& weights,
  const ConvexDomain& domain)
{
  return shareOfWrongFaces(positions,
    mesh.Faces,
    scaledTargets(faceTargets(mesh, weights), domain.area()),
    RefinementPatches::AreaTolerance);
}

void requireNarrow(const Eigen::VectorXd& weights)
{
  constexpr double slack = 1e-9; // of the logarithm, for rounding
  if (rangeOf(weights) > std::log(GreatestWeightRatio) + slack)
  {
    std::ostringstream message;
    message << "the area weights run from " << weights.minCoeff() << " to " << weights.maxCoeff()
            << ", and the face refinement keeps areas up to a factor of " << GreatestWeightRatio
            << " between weights: bring them nearer together, or turn FaceRefinement off";
    throw InvalidInput(message.str());
  }
}

// Transports the map until the transported map is reached (FaceRefinementResult::StartShare), or until
// none nearer to it can be.
AreaPreservingResult mapByTransports(const MapProblem& problem,
  const MapStart& start,
  const ProgressCallback& progress)
{
  AreaPreservingOptions next = problem.Options;
  const MapProblem changed{ problem.Mesh, problem.Target, problem.Weights, next }; // as next changes
  next.Refinement.StopsOnTheWay = true;
  AreaPreservingResult result = mapByTransport(changed, start, subrange(progress, 0.0, FirstShownShare));
  next.Start = {};
  double shown = FirstShownShare;
  for (int transports = 2; transports <= MostTransports; ++transports)
  {
    if (result.Map.StartShare == 0.0 || result.Map.StartShare == 1.0)
    {
      break;
    }
    next.Refinement.StopsOnTheWay = transports < MostTransports;
    const double begin = std::exchange(shown, shown + ShownShare * (1.0 - shown));
    const Points2 reached = result.Map.OnDomain;
    result = mapByTransport(changed, { reached, reached }, subrange(progress, begin, shown));
  }
  report(progress, 1.0, "Area-preserving map");
  return result;
}

// The map, by way of maps for weights of less range where it is wide. A step whose map is not one-to-one
// or far from its areas is made again in halves, as long as it is wide enough.
AreaPreservingResult mapInSteps(const MapProblem& problem,
  const MapStart& start,
  const ProgressCallback& progress)
{
  const Eigen::VectorXd& weights = problem.Weights;
  const double range = rangeOf(weights);
  if (!problem.Options.RefineFaces || range <= std::log(WidestStep))
  {
    return mapByTransports(problem, start, progress);
  }
  AreaPreservingOptions before = problem.Options;
  before.Start = {};
  Points2 last = start.Conformal; // the map of the last step
  Points2 lastOnDomain = start.OnDomain;
  double reached = 0.0; // the exponent of the weights of the last map
  double step = 1.0 / std::ceil(range / std::log(WidestStep));
  double shown = 0.0; // progress
  while (true)
  {
    const bool isLast = reached + step > 1.0 - 1e-9;
    const double exponent = isLast ? 1.0 : reached + step;
    const Eigen::VectorXd part = isLast ? weights : Eigen::VectorXd(weights.array().pow(exponent));
    const double begin = shown;
    shown += ShownShare * (1.0 - shown) * (exponent - reached) / (1.0 - reached);
    AreaPreservingResult result =
      mapByTransports({ problem.Mesh, problem.Target, part, isLast ? problem.Options : before },
        { last, lastOnDomain },
        subrange(progress, begin, shown));
    const AreaPreservingMap& map = result.Map;
    const bool failed =
      !map.Bijective || meanAreaError(problem.Mesh, map.OnDomain, part) > GreatestStepError;
    if (failed && step * range > std::log(NarrowestStep))
    {
      step *= 0.5;
      continue;
    }
    if (isLast)
    {
      return result;
    }
    last = map.Positions;
    lastOnDomain = map.Positions;
    reached = exponent;
  }
}

// @p positions turned so that they come nearest to @p others, around the centroid of either.
Points2 turnedTowards(const Points2& others, const Points2& positions)
{
  const Points2 from = positions.rowwise() - positions.colwise().mean();
  const Points2 to = others.rowwise() - others.colwise().mean();
  const double cosine = from.cwiseProduct(to).sum();
  const double sine = (from.col(0).cwiseProduct(to.col(1)) - from.col(1).cwiseProduct(to.col(0))).sum();
  Eigen::Matrix2d turn;
  turn << cosine, -sine, sine, cosine;
  const double length = std::hypot(cosine, sine);
  return length > 0.0 ? Points2(positions * (turn / length).transpose()) : positions;
}

void take(const FreeOutlineMap& freed, AreaPreservingMap& map)
{
  map.Positions = freed.Positions;
  map.FlippedFaces = freed.FlippedFaces;
  map.Bijective = freed.Bijective;
  map.WarmStarted = freed.WarmStarted;
  map.RefinementRounds = freed.Rounds;
  map.RepairedFaces = 0;
  map.StartShare = 1.0;
  map.IsFree = true;
}

// The map with a free outline; nothing if the outline cannot be freed. It lies as the conformal map
// does.
std::optional<FreeOutlineMap> freedOutline(const MapProblem& problem,
  const Points2& conformal,
  const ProgressCallback& progress)
{
  const auto& [mesh, target, weights, options] = problem;
  const std::vector<int>& loop = target.Boundary.Vertices;
  // The angle weight of an earlier map is not known, and one in the domain is no start.
  const Points2& before = options.Start.Positions;
  const bool isStart = options.Refinement.AngleWeight == 0.0 && before.rows() == mesh.vertexCount() &&
                       before.allFinite() && !areOnBoundary(before, loop, *target.Domain);
  std::optional<FreeOutlineMap> freed = freeOutlineMap(mesh,
    loop,
    isStart ? before : Points2(),
    faceTargets(mesh, weights),
    target.Domain->area(),
    shapeWeight(options.Refinement),
    progress);
  if (freed)
  {
    freed->Positions = turnedTowards(conformal, freed->Positions);
  }
  return freed;
}

// The map with a free outline. If it loses too many areas, the map to the domain stays.
AreaPreservingResult freedMap(const MapProblem& problem,
  const MapStart& start,
  const ProgressCallback& progress)
{
  constexpr double freedEnd = 0.7; // of the progress
  const std::optional<FreeOutlineMap> freed =
    freedOutline(problem, start.Conformal, subrange(progress, 0.0, freedEnd));
  const ConvexDomain& domain = *problem.Target.Domain;
  if (freed && freed->keepsAreas(0.0))
  {
    // The transport only makes the cells. It begins with this map, as the conformal map of a surface
    // with a long boundary may be too uneven for it.
    const double scale = domain.innerRadius() / freed->Positions.rowwise().norm().maxCoeff();
    AreaPreservingResult result =
      transportedMap(problem, scale * freed->Positions, subrange(progress, freedEnd, 1.0));
    take(*freed, result.Map);
    return result;
  }
  AreaPreservingResult result = mapInSteps(problem, start, subrange(progress, freedEnd, 1.0));
  const double offInDomain = shareOff(problem.Mesh, result.Map.Positions, problem.Weights, domain);
  if (freed && freed->keepsAreas(offInDomain))
  {
    take(*freed, result.Map);
  }
  return result;
}

AreaPreservingResult areaPreservingMap(const MapProblem& problem,
  const MapStart& start,
  const ProgressCallback& progress)
{
  const auto& [mesh, target, weights, options] = problem;
  targetAreas(mesh, weights); // throws if the weights are no such numbers
  if (options.RefineFaces)
  {
    requireNarrow(weights);
  }
  else if (options.FreeOutline)
  {
    throw InvalidInput("a free outline needs the face refinement: turn FaceRefinement on, or "
                       "FreeOutline off");
  }
  AreaPreservingResult result =
    options.FreeOutline ? freedMap(problem, start, progress) : mapInSteps(problem, start, progress);
  result.Map.ShareOff = shareOff(mesh, result.Map.Positions, weights, *target.Domain);
  return result;
}

} // namespace

AreaPreservingResult areaPreservingDiskMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  const DomainTarget target = diskTarget(mesh, conformal);
  return areaPreservingMap({ mesh, target, weights, options }, { conformal, conformal }, progress);
}

AreaPreservingResult areaPreservingRectangleMap(const TriangleMesh& mesh,
  const Points2& conformal,
  double width,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  const DomainTarget target = rectangleTarget(mesh, conformal, width);
  return areaPreservingMap({ mesh, target, weights, options }, { conformal, conformal }, progress);
}

AreaPreservingResult areaPreservingPolygonMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const ConvexDomain& source,
  const PolygonTarget& polygon,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  const DomainTarget target = polygonTarget(mesh, conformal, source, polygon);
  const double scale = target.Domain->innerRadius() / conformal.rowwise().norm().maxCoeff();
  const Points2 scaled = scale * conformal;
  const Points2 onDomain = stretchedAlongRays(conformal, source, *target.Domain);
  return areaPreservingMap({ mesh, target, weights, options }, { scaled, onDomain }, progress);
}

} // namespace flattening
