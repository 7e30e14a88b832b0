// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FaceRefinement.h"

#include "Areas/RefinementRounds.h"
#include "Areas/ResolvableAreas.h"
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

// Of the mean target: a face without area on the surface asks for so much.
constexpr double LeastTarget = 1e-6;
// Of the target area: how far the first stage lets faces flip.
constexpr double FirstEpsilon = 0.1;
constexpr int FirstStageRounds = 16;
constexpr int SecondStageRounds = 24;
// More rounds of the first stage where faces remain flipped: how many at a time, and how often, as long
// as not more than a share of those faces is left. Far-off areas of horns come in over many rounds.
constexpr int MoreRounds = 4;
constexpr int LeastFirstStages = 2;
constexpr int MostFirstStages = 16;
constexpr double GreatestLeft = 0.8;
// In the end, for regions are what people measure (RefinementRounds::balance).
constexpr double FinalRegionTolerance = 2e-4;
// The shape weight without and with AngleWeight (times AngleWeight / (1 - AngleWeight)).
constexpr double LeastShapeWeight = 1e-3;
constexpr double ShapeWeightScale = 0.03;
// Of flipped faces after the first stage: patches may be a share of the mesh, as those around a small
// hole are, and take a share of the time that the stage took.
constexpr double LargestPatchShare = 0.25;
constexpr double RepairWork = 30.0;
constexpr double RepairAreaWeight = 1.0;
// Where to look for a start without flipped faces between the conformal and the transported map.
constexpr double StartShares[] = { 0.97, 0.9, 0.7, 0.4, 0.0 };

class Refinement
{
public:
  Refinement(const TriangleMesh& surface,
    const TransportedMap& map,
    const Eigen::VectorXd& faceTargets,
    const FaceRefinementOptions& options)
    : Surface(surface)
    , Map(map)
    , FacesOf(surface.Faces, surface.vertexCount())
    , Unknowns(surface.vertexCount(), map.Domain, map.Loop, map.Corners)
    , Targets(faceTargets.cwiseMax(LeastTarget * faceTargets.mean()))
    , Terms(surface, map.Loop, map.Domain->perimeter(), shapeWeight(options))
    , Rounds(surface,
        this->Terms,
        this->FacesOf,
        this->Unknowns,
        map.IsContinued ? RefinementRounds::Start::Refined : RefinementRounds::Start::Transported)
    , OnBoundary(surface.vertexCount(), 0)
  {
    this->Targets *= map.Domain->area() / this->Targets.sum();
    for (const int v : map.Loop)
    {
      this->OnBoundary[v] = 1;
    }
  }

  FaceRefinementResult run(const ProgressCallback& progress)
  {
    FlatState state = this->stateAt(this->Map.Positions);
    if (!this->Map.IsContinued || countFlippedFaces(state.Positions, this->Surface.Faces) > 0)
    {
      this->firstStage(state, subrange(progress, 0.0, 0.5));
    }
    if (!this->untangle(state, subrange(progress, 0.5, 0.65)))
    {
      this->startOver(state, subrange(progress, 0.65, 0.7));
    }
    if (countFlippedFaces(state.Positions, this->Surface.Faces) == 0)
    {
      this->secondStage(state, subrange(progress, 0.7, 1.0));
    }
    this->Result.Rounds = this->Rounds.count();
    this->Result.FlippedFaces = countFlippedFaces(state.Positions, this->Surface.Faces);
    this->Result.Bijective = this->Result.FlippedFaces == 0 && this->inOrder(state);
    this->Result.Positions = std::move(state.Positions);
    return std::move(this->Result);
  }

private:
  using Until = RefinementRounds::Until;
  enum class PatchSizes
  {
    Small,
    Large
  };

  static double shapeWeight(const FaceRefinementOptions& options)
  {
    if (!(options.AngleWeight >= 0.0 && options.AngleWeight < 1.0))
    {
      throw InvalidInput("the angle weight is " + std::to_string(options.AngleWeight) +
                         ": it must be at least 0 and below 1");
    }
    return LeastShapeWeight + ShapeWeightScale * options.AngleWeight / (1.0 - options.AngleWeight);
  }

  // The places of the boundary vertices grow over less than a turn from that of the first.
  FlatState stateAt(const Points2& positions) const
  {
    const ConvexDomain& domain = this->Unknowns.domain();
    const std::vector<int>& loop = this->Map.Loop;
    FlatState state{ positions, Eigen::VectorXd(static_cast<Eigen::Index>(loop.size())) };
    const double turn = domain.perimeter();
    const double first = domain.placeOf(positions.row(loop.front()).transpose());
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const double along = domain.placeOf(positions.row(loop[k]).transpose()) - first;
      state.Places[k] = first + along - turn * std::floor(along / turn);
    }
    return state;
  }

  bool inOrder(const FlatState& state) const
  {
    const Eigen::Index last = state.Places.size() - 1;
    for (Eigen::Index k = 0; k < last; ++k)
    {
      if (!(state.Places[k] < state.Places[k + 1]))
      {
        return false;
      }
    }
    return state.Places[last] - state.Places[0] < this->Unknowns.domain().perimeter();
  }

  void firstStage(FlatState& state, const ProgressCallback& progress)
  {
    const bool isRound = this->Unknowns.domain().isRound();
    this->Rounds.setStage(
      isRound
        ? resolvableAreas(this->Surface.Faces, this->Map.Conformal, this->Map.Positions, this->Targets)
        : this->Targets,
      FirstEpsilon);
    this->Rounds.run(state, FirstStageRounds, Until::Enough, progress);
  }

  void secondStage(FlatState& state, const ProgressCallback& progress)
  {
    this->Rounds.setStage(this->Targets, 0.0);
    if (this->Map.IsContinued)
    {
      // What is off is so a little and everywhere, which steps of the whole mesh mend at once.
      this->Rounds.balance(state, FinalRegionTolerance, subrange(progress, 0.0, 0.3));
    }
    this->Rounds.run(state, SecondStageRounds, Until::Enough, subrange(progress, 0.3, 0.8));
    this->Rounds.balance(state, FinalRegionTolerance, subrange(progress, 0.8, 1.0));
  }

  // Most of what is flipped after the first stage turns over in more of its rounds, and the rest in
  // patches of a few vertices. Large patches lose much of the areas, which a few rounds more may get
  // back: they come last.
  bool untangle(FlatState& state, const ProgressCallback& progress)
  {
    constexpr double rounds = 0.9; // of the progress
    constexpr double part = rounds / MostFirstStages;
    int flipped = countFlippedFaces(state.Positions, this->Surface.Faces);
    for (int more = 0; more < MostFirstStages; ++more)
    {
      const double begin = more * part;
      if (this->turnOver(state, PatchSizes::Small, subrange(progress, begin, begin + 0.5 * part)))
      {
        return true;
      }
      const int before = std::exchange(flipped, countFlippedFaces(state.Positions, this->Surface.Faces));
      if (more >= LeastFirstStages && flipped > GreatestLeft * before)
      {
        break;
      }
      this->Rounds.startAgain();
      this->Rounds.run(
        state, MoreRounds, Until::AllRounds, subrange(progress, begin + 0.5 * part, begin + part));
    }
    if (!this->turnOver(state, PatchSizes::Large, subrange(progress, rounds, 0.95)))
    {
      return false;
    }
    FlatState again = state;
    this->Rounds.run(again, MoreRounds, Until::AllRounds, subrange(progress, 0.95, 0.98));
    if (this->turnOver(again, PatchSizes::Small, subrange(progress, 0.98, 1.0)))
    {
      state = std::move(again);
    }
    return true;
  }

  // Leaves the state as it was if faces remain flipped.
  bool turnOver(FlatState& state, PatchSizes patches, const ProgressCallback& progress)
  {
    UntanglingOptions options;
    options.AreaWeight = RepairAreaWeight;
    if (patches == PatchSizes::Large)
    {
      const int share = static_cast<int>(LargestPatchShare * this->Surface.vertexCount());
      options.LargestPatch = std::max(options.LargestPatch, share);
      options.WorkPerVertex = RepairWork;
    }
    Points2 positions = state.Positions;
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
    state.Positions = std::move(positions);
    this->Result.RepairedFaces = report.RepairedFaces;
    return true;
  }

  // The points between two monotone maps are a monotone map: what is flipped is so by a little only, and
  // less the nearer to the conformal map.
  void startOver(FlatState& state, const ProgressCallback& progress)
  {
    const FlatState conformal = this->stateAt(this->Map.OnDomain);
    const FlatState transported = this->stateAt(this->Map.Positions);
    const double turn = this->Unknowns.domain().perimeter();
    const double apart = transported.Places[0] - conformal.Places[0];
    const double shift = -turn * std::round(apart / turn);
    double fraction = 0.0;
    for (const double share : StartShares)
    {
      const double begin = fraction;
      fraction += 1.0 / std::size(StartShares);
      FlatState between;
      between.Positions = (1.0 - share) * conformal.Positions + share * transported.Positions;
      between.Places =
        (1.0 - share) * conformal.Places.array() + share * (transported.Places.array() + shift);
      for (std::size_t k = 0; k < this->Map.Loop.size(); ++k)
      {
        between.Positions.row(this->Map.Loop[k]) = this->Unknowns.domain().at(between.Places[k]);
      }
      if (this->turnOver(between, PatchSizes::Large, subrange(progress, begin, fraction)))
      {
        state = std::move(between);
        this->Result.StartShare = share;
        return;
      }
    }
  }

  const TriangleMesh& Surface;
  const TransportedMap& Map;
  VertexFaces FacesOf;
  DegreesOfFreedom Unknowns;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
  RefinementRounds Rounds;
  std::vector<char> OnBoundary;
  FaceRefinementResult Result;
};

} // namespace

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
