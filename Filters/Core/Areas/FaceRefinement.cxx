// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FaceRefinement.h"

#include "Areas/RefinementRounds.h"
#include "Areas/TargetAreas.h"
#include "Base/Errors.h"
#include "Mesh/FaceOrientation.h"
#include "Untangling/MapUntangling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// Limits of the time; the stages mostly end earlier, when their rounds no longer help
// (RefinementRounds).
constexpr int FirstStageRounds = 16;
constexpr int SecondStageRounds = 40;
// Where faces remain flipped, the first stage goes on MoreRounds at a time: at least LeastFirstStages
// times, and up to MostFirstStages times while at most GreatestLeft of the flipped faces are left. The
// areas in protrusions, which are far off, converge over many rounds.
constexpr int MoreRounds = 4;
constexpr int LeastFirstStages = 2;
constexpr int MostFirstStages = 16;
constexpr double GreatestLeft = 0.8;
// The weight of areas in deformations that lower the distortion of shapes. A compromise: with more each
// brings less, with less the rounds have to correct more.
constexpr double ShapingAreaWeight = 10.0;
// The same for the only one after a warm start. A compromise: with 10 to 300 the angle error is the same
// within 0.15 degrees, with 10 a change takes a sixth longer.
constexpr double WarmShapingAreaWeight = 30.0;
// A limit of the time: mostly these deformations end earlier (RefinementRounds).
constexpr int MostShapingDeformations = 20;
// The shape weight is LeastShapeWeight + ShapeWeightScale * a / (1 - a) for AngleWeight a. The least one
// makes the map unique; the scale is a choice that spreads the trade of areas for angles over a in [0,
// 1).
constexpr double LeastShapeWeight = 1e-3;
constexpr double ShapeWeightScale = 0.03;
// Limits of the large patches in which a map at one of StartShares is untangled: a patch's share of the
// mesh, which patches around a small hole need, and the work per vertex, which bounds the time: by that
// of the first stage where the mesh has some ten thousand vertices, but by minutes where it has a
// million.
constexpr double LargestPatchShare = 0.25;
constexpr double RepairWork = 30.0;
// Shares of the way from the conformal to the transported map at which to look for a map that can be
// untangled, if the transported map cannot. The first is a compromise: farther on, fewer maps can be
// untangled, and nearer to the conformal map the next transport has farther to go. Six hard maps took 20
// s with 0.4, 32 s with 0.5 and 27 s with 0.25. 0, the conformal map, has few flipped faces or none.
constexpr double StartShares[] = { 0.4, 0.0 };

class Refinement
{
public:
  Refinement(const TriangleMesh& surface,
    const TransportedMap& map,
    const Eigen::VectorXd& faceTargets,
    const FaceRefinementOptions& options)
    : Surface(surface)
    , Map(map)
    , Options(options)
    , AsksForAreas(options.AngleWeight == 0.0)
    , FacesOf(surface.Faces, surface.vertexCount())
    , Dofs(surface.vertexCount(), map.Domain, map.Loop, map.Corners)
    , Targets(scaledTargets(faceTargets, map.Domain->area()))
    , Terms(surface, map.Loop, map.Domain->perimeter(), shapeWeight(options))
    , Rounds(surface,
        this->Terms,
        this->FacesOf,
        this->Dofs,
        map.Conformal,
        faceTargets,
        map.Start,
        this->AsksForAreas)
    , OnBoundary(surface.vertexCount(), 0)
  {
    for (const int v : map.Loop)
    {
      this->OnBoundary[v] = 1;
    }
  }

  FaceRefinementResult run(const ProgressCallback& progress)
  {
    DomainMap map = this->mapTo(this->Map.Positions);
    if (this->Map.Start == RefinementStart::Transport || this->countFlipped(map) > 0)
    {
      this->firstStage(map, subrange(progress, 0.0, 0.5));
    }
    if (!this->untangle(map, subrange(progress, 0.5, 0.65)))
    {
      this->startOver(map, subrange(progress, 0.65, 0.7));
    }
    const bool stops = this->Options.StopsOnTheWay && this->Result.isOnTheWay();
    if (!stops && this->countFlipped(map) == 0)
    {
      this->secondStage(map, subrange(progress, 0.7, 1.0));
    }
    this->Result.Rounds = this->Rounds.count();
    this->Result.FlippedFaces = this->countFlipped(map);
    this->Result.Bijective =
      this->Result.FlippedFaces == 0 && this->Map.Domain->areInOrder(map.BoundaryParameters);
    this->Result.Positions = std::move(map.Positions);
    return std::move(this->Result);
  }

private:
  using Until = RefinementRounds::Until;
  // How large the patches may be in which faces are untangled.
  enum class PatchSizes
  {
    Small,
    Large
  };

  DomainMap mapTo(const Points2& positions) const
  {
    return { positions, this->Map.Domain->parametersOf(positions, this->Map.Loop) };
  }

  int countFlipped(const DomainMap& map) const
  {
    return countFlippedFaces(map.Positions, this->Surface.Faces);
  }

  void firstStage(DomainMap& map, const ProgressCallback& progress)
  {
    const bool isRound = this->Dofs.domain().isRound();
    this->Rounds.setStage(
      isRound
        ? resolvableAreas(this->Surface.Faces, this->Map.Conformal, this->Map.Positions, this->Targets)
        : this->Targets,
      RefinementRounds::FlippingEpsilon);
    this->Rounds.lowerDistortion(
      map, ShapingAreaWeight, MostShapingDeformations, subrange(progress, 0.0, 0.2));
    this->Rounds.run(map, FirstStageRounds, Until::Enough, subrange(progress, 0.2, 1.0));
  }

  void secondStage(DomainMap& map, const ProgressCallback& progress)
  {
    this->Rounds.setStage(this->Targets, 0.0);
    const Points2 before = map.Positions;
    // The shapes of the map before are not the best ones for the new areas: without this deformation the
    // angle error of a region that is enlarged 16 times in six steps grows to 20.4 degrees, not 17.6.
    if (this->Map.Start == RefinementStart::WarmStart && !this->Rounds.isNearlyRight(map))
    {
      this->Rounds.lowerDistortion(map, WarmShapingAreaWeight, 1, subrange(progress, 0.0, 0.3));
    }
    this->Rounds.run(map, SecondStageRounds, Until::Enough, subrange(progress, 0.3, 0.8));
    this->Rounds.balance(map, RefinementRounds::FinalRegionTolerance, subrange(progress, 0.8, 0.85));
    const bool isSame = this->Map.Start == RefinementStart::WarmStart && map.Positions == before;
    if (this->AsksForAreas && !isSame)
    {
      this->Rounds.polish(map, subrange(progress, 0.85, 1.0));
    }
  }

  // Most faces that are flipped after the first stage untangle in more of its rounds, and the rest in
  // patches of a few vertices.
  bool untangle(DomainMap& map, const ProgressCallback& progress)
  {
    constexpr double part = 1.0 / MostFirstStages; // of the progress
    int flipped = this->countFlipped(map);
    for (int more = 0; more < MostFirstStages; ++more)
    {
      const double begin = more * part;
      if (this->untangleIn(PatchSizes::Small, map, subrange(progress, begin, begin + 0.5 * part)))
      {
        return true;
      }
      const int before = std::exchange(flipped, this->countFlipped(map));
      if (more >= LeastFirstStages && flipped > GreatestLeft * before)
      {
        break;
      }
      this->Rounds.favourShapes(RefinementRounds::FirstShapeRounds);
      this->Rounds.run(
        map, MoreRounds, Until::AllRounds, subrange(progress, begin + 0.5 * part, begin + part));
    }
    return false;
  }

  // Returns false and leaves the map as it was if faces remain flipped. The boundary stays as it is:
  // where its vertices are out of order, faces could not be untangled.
  bool untangleIn(PatchSizes patches, DomainMap& map, const ProgressCallback& progress)
  {
    if (!this->Map.Domain->areInOrder(map.BoundaryParameters))
    {
      return false;
    }
    UntanglingOptions options;
    options.AreaWeight = UntanglingOptions::EqualAreaWeight;
    options.AllOrNone = true;
    if (patches == PatchSizes::Large)
    {
      const int share = static_cast<int>(LargestPatchShare * this->Surface.vertexCount());
      options.LargestPatch = std::max(options.LargestPatch, share);
      options.WorkPerVertex = RepairWork;
    }
    Points2 positions = map.Positions;
    const UntanglingReport report = untangleMap(this->Surface.Faces,
      this->OnBoundary,
      trianglesOfArea(this->Surface, this->Targets),
      positions,
      options,
      progress);
    if (report.FlippedFaces > 0)
    {
      return false;
    }
    map.Positions = std::move(positions);
    this->Result.RepairedFaces += report.RepairedFaces;
    return true;
  }

  // A map between two monotone maps is monotone: its faces are flipped by little only, and by the less
  // the nearer it is to the conformal map.
  void startOver(DomainMap& map, const ProgressCallback& progress)
  {
    const DomainMap conformal = this->mapTo(this->Map.OnDomain);
    DomainMap transported = this->mapTo(this->Map.Positions);
    const double turn = this->Dofs.domain().perimeter();
    const double apart = transported.BoundaryParameters[0] - conformal.BoundaryParameters[0];
    transported.BoundaryParameters.array() -= turn * std::round(apart / turn);
    double fraction = 0.0;
    for (const double share : StartShares)
    {
      const double begin = fraction;
      fraction += 1.0 / std::size(StartShares);
      DomainMap between = this->Dofs.between(conformal, transported, share);
      if (this->untangleIn(PatchSizes::Large, between, subrange(progress, begin, fraction)))
      {
        map = std::move(between);
        this->Result.StartShare = share;
        return;
      }
    }
  }

  const TriangleMesh& Surface;
  const TransportedMap& Map;
  const FaceRefinementOptions& Options;
  bool AsksForAreas;
  VertexFaces FacesOf;
  DegreesOfFreedom Dofs;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
  RefinementRounds Rounds;
  std::vector<char> OnBoundary;
  FaceRefinementResult Result;
};

} // namespace

double shapeWeight(const FaceRefinementOptions& options)
{
  if (!(options.AngleWeight >= 0.0 && options.AngleWeight < 1.0))
  {
    throw InvalidInput(
      "the angle weight is " + formatted(options.AngleWeight) + ": it must be at least 0 and below 1");
  }
  return LeastShapeWeight + ShapeWeightScale * options.AngleWeight / (1.0 - options.AngleWeight);
}

FaceRefinementResult refineFaces(const TriangleMesh& surface,
  const TransportedMap& map,
  const Eigen::VectorXd& faceTargets,
  const FaceRefinementOptions& options,
  const ProgressCallback& progress)
{
  Refinement refinement(surface, map, faceTargets, options);
  return refinement.run(progress);
}

} // namespace flattening
