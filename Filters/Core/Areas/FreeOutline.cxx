// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FreeOutline.h"

#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementPatches.h"
#include "Areas/RefinementRounds.h"
#include "Areas/RefinementTerms.h"
#include "Areas/SmoothDeformation.h"
#include "Areas/TargetAreas.h"
#include "Base/EigenVersions.h"
#include "Conformal/NaturalOutline.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/VertexFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace flattening
{
namespace
{

// The share of the faces that a free outline may leave wrong beyond those that are wrong in the domain.
constexpr double GreatestLoss = 0.01;
// The share of wrong faces that tells that parts of the outline press against each other: such maps
// mostly have a fifth of their faces wrong or more, and others up to a twentieth.
constexpr double PressedShare = 0.1;
// A limit of the time: maps to begin with until no part of the outline presses against another. Parts of
// the first one do on 12 of 132 generated surfaces, and those of all three on 5 of these.
constexpr int MostStarts = 3;
// The greatest weight of areas against shapes in the deformations. A choice: with more the deformations
// are small, with less the refinement has to correct more.
constexpr double GreatestAreaWeight = 300.0;
// Deformations on a lattice end after MostDeformations, or when one and the round after it lower the
// distortion of shapes by less than LeastDeformationGain of it. A compromise: on half a brain, 0.01
// makes the mean angle error 8.2 instead of 8.3 degrees and takes a fifth more time.
constexpr int MostDeformations = 10;
constexpr double LeastDeformationGain = 0.05;
// The areas go to their targets in steps of about LogAreaStep, in logarithms of the ratios. A
// compromise: where these differ by 3, 93.2, 94.7 and 95.7 % of the faces of a folded brain were within
// 2 % after 5, 10 and 20 steps.
constexpr double LogAreaStep = 0.3;
// A limit of the time: the least share of the way that a step goes.
constexpr double LeastStep = 0.01;
// Areas whose ratios have logarithms of a smaller deviation need no step. A choice: rounds of the
// refinement set them right.
constexpr double Negligible = 0.02;
// The greatest fineness of the lattice of the deformations (smoothlyDeformed). The lattice becomes twice
// as fine when deformations on it end, unless the first one on the finer lattice hardly helped either.
// Measured: white matter with the cut of Automatic has 18.9 and 18.1 degrees of mean angle error with 2
// and 4, and half a brain without a relief gains nothing.
constexpr int GreatestFineness = 4;
// A limit of the time; the rounds mostly end earlier, when they no longer help (RefinementRounds). A
// head of 650,000 points with many narrow protrusions has 2.1 % of its faces off with 16 and 1.8 %
// with 24.
constexpr int MostRounds = 24;
// A map whose distortion of shapes is below NearlyKept is taken for that of a surface that can be
// unrolled; the halves of a brain have 0.08. Such a map is brought to the last digits by steps of the
// whole mesh: at most MostWholeRounds rounds of them, until one lowers the energy by less than the share
// LeastRoundGain.
constexpr double NearlyKept = 0.005;
constexpr int MostWholeRounds = 20;
constexpr double LeastRoundGain = 0.1;
// The share of what is left of the progress that a start shows. A choice: mostly it is the only one.
constexpr double StartShownShare = 0.95;

class OutlineFreeing
{
public:
  OutlineFreeing(const TriangleMesh& surface,
    const std::vector<int>& loop,
    const Points2& start,
    const Eigen::VectorXd& faceTargets,
    double area,
    double shapeWeight)
    : Surface(surface)
    , Loop(loop)
    , Area(area)
    , AreaWeight(std::min(GreatestAreaWeight, 1.0 / shapeWeight))
    , FacesOf(surface.Faces, surface.vertexCount())
    , Dofs(surface.vertexCount())
    , Targets(scaledTargets(faceTargets, area))
    , Terms(surface, loop, 1.0, shapeWeight)
    , Rounds(surface,
        this->Terms,
        this->FacesOf,
        this->Dofs,
        start,
        faceTargets,
        RefinementStart::Transport,
        true)
    , Map{ start, {} }
  {
    this->Terms.Gaps.clear();
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      this->Terms.Outline.push_back({ loop[k], loop[(k + 1) % loop.size()] });
    }
    this->Rounds.setStage(this->Targets, 0.0);
  }

  FreeOutlineMap run(const ProgressCallback& progress)
  {
    this->Map.Positions *= std::sqrt(this->Area / this->covered());
    FreeOutlineMap result;
    result.Deformations = this->approachAreas(subrange(progress, 0.0, 0.4));
    result.Deformations += this->deform(subrange(progress, 0.4, 0.7));
    this->refine(subrange(progress, 0.7, 1.0));
    result.ShareOff = this->shareOff();
    result.Positions = this->centred();
    result.Rounds = this->Rounds.count();
    result.FlippedFaces = countFlippedFaces(result.Positions, this->Surface.Faces);
    result.Bijective = result.FlippedFaces == 0 && isSimpleOutline(result.Positions, this->Loop);
    return result;
  }

private:
  // Brings the areas of the faces from those of the map to the targets. Returns the number of
  // deformations.
  int approachAreas(const ProgressCallback& progress)
  {
    const Eigen::ArrayXd first = this->logAreas();
    const Eigen::ArrayXd last = this->Targets.array().log();
    const double whole = this->distanceFromTargets();
    double share = whole > Negligible ? 0.0 : 1.0; // of the way
    int steps = 0;
    const double step = std::max(LogAreaStep / whole, LeastStep);
    while (share < 1.0)
    {
      const double begin = std::exchange(share, std::min(share + step, 1.0));
      this->Rounds.setStage(
        scaledTargets(((1.0 - share) * first + share * last).exp().matrix(), this->Area), 0.0);
      this->deformOnce(subrange(progress, begin, share));
      ++steps;
    }
    this->Rounds.setStage(this->Targets, 0.0);
    return steps;
  }

  // An area that rounding makes 0 or less counts as the least positive number, to have a logarithm.
  Eigen::ArrayXd logAreas() const
  {
    const Eigen::ArrayXd areas = signedFaceAreas(this->Map.Positions, this->Surface.Faces).array();
    return areas.max(std::numeric_limits<double>::min()).log();
  }

  // The standard deviation of the logarithms of the area ratios, by target area.
  double distanceFromTargets() const
  {
    const Eigen::ArrayXd ratios = this->logAreas() - this->Targets.array().log();
    const Eigen::ArrayXd weights = this->Targets.array() / this->Targets.sum();
    return std::sqrt((weights * (ratios - (weights * ratios).sum()).square()).sum());
  }

  // A deformation and a round of the refinement, without which errors of areas and stretched faces would
  // add up and keep the next one from going on. A round with fewer steps takes a fifth less time, but
  // leaves skulls at 19 degrees of mean angle error instead of 17. Returns false if the map could not be
  // deformed.
  bool deformOnce(const ProgressCallback& progress)
  {
    if (this->Rounds.lowerDistortion(this->Map, this->AreaWeight, 1, subrange(progress, 0.0, 0.5)) == 0)
    {
      return false;
    }
    this->Rounds.favourShapes(1);
    this->Rounds.run(this->Map, 1, RefinementRounds::Until::AllRounds, subrange(progress, 0.5, 1.0));
    return true;
  }

  // Deforms the map on finer and finer lattices. Returns the number of deformations.
  int deform(const ProgressCallback& progress)
  {
    const int vertices = this->Surface.vertexCount();
    int count = 0;
    for (int fineness = 1; fineness <= GreatestFineness; fineness *= 2)
    {
      const bool isFirst = fineness == 1;
      if (!isFirst && latticeSquares(vertices, fineness) == latticeSquares(vertices, fineness / 2))
      {
        break;
      }
      const double begin = 1.0 - 1.0 / fineness;
      this->Rounds.setFineness(fineness);
      const int done = this->deformOnLattices(subrange(progress, begin, 0.5 * (begin + 1.0)));
      count += done;
      if (done < (isFirst ? 1 : 2))
      {
        break;
      }
    }
    this->Rounds.setFineness(1);
    return count;
  }

  // Deforms the map on lattices of the same fineness until one of the deformations hardly helps. One
  // that leaves more areas wrong than before is taken back: parts of the outline press against each
  // other then, and faces beside them find no place. Returns the number of deformations.
  int deformOnLattices(const ProgressCallback& progress)
  {
    double distortion = this->Rounds.distortion(this->Map);
    double off = this->shareOff();
    for (int k = 0; k < MostDeformations; ++k)
    {
      const double begin = static_cast<double>(k) / MostDeformations;
      const DomainMap before = this->Map;
      if (!this->deformOnce(subrange(progress, begin, begin + 1.0 / MostDeformations)))
      {
        return k;
      }
      const double offBefore = std::exchange(off, this->shareOff());
      if (off > offBefore)
      {
        this->Map = before;
        return k;
      }
      const double distortionBefore = std::exchange(distortion, this->Rounds.distortion(this->Map));
      if (distortionBefore - distortion < LeastDeformationGain * distortionBefore)
      {
        return k + 1;
      }
    }
    return MostDeformations;
  }

  void refine(const ProgressCallback& progress)
  {
    this->Rounds.run(
      this->Map, MostRounds, RefinementRounds::Until::Enough, subrange(progress, 0.0, 0.6));
    this->Rounds.balance(
      this->Map, RefinementRounds::FinalRegionTolerance, subrange(progress, 0.6, 0.7));
    this->Rounds.polish(this->Map, subrange(progress, 0.7, 0.9));
    if (this->Rounds.distortion(this->Map) < NearlyKept)
    {
      this->Rounds.settle(this->Map, LeastRoundGain, MostWholeRounds, subrange(progress, 0.9, 1.0));
    }
  }

  // The share of the faces whose area is off by more than the tolerance.
  double shareOff() const
  {
    return shareOfWrongFaces(
      this->Map.Positions, this->Surface.Faces, this->Targets, RefinementPatches::AreaTolerance);
  }

  double covered() const { return signedFaceAreas(this->Map.Positions, this->Surface.Faces).sum(); }

  // The map with its centroid in the origin and its whole area.
  Points2 centred() const
  {
    const Eigen::VectorXd areas = signedFaceAreas(this->Map.Positions, this->Surface.Faces);
    Eigen::RowVector2d moment = Eigen::RowVector2d::Zero();
    for (int f = 0; f < this->Surface.faceCount(); ++f)
    {
      moment += areas[f] / 3.0 *
                this->Map.Positions(this->Surface.Faces.row(f), flattening::all).colwise().sum();
    }
    const Eigen::RowVector2d centroid = moment / areas.sum();
    return std::sqrt(this->Area / areas.sum()) * (this->Map.Positions.rowwise() - centroid);
  }

  const TriangleMesh& Surface;
  const std::vector<int>& Loop;
  double Area;
  double AreaWeight;
  VertexFaces FacesOf;
  DegreesOfFreedom Dofs;
  Eigen::VectorXd Targets;
  RefinementTerms Terms;
  RefinementRounds Rounds;
  DomainMap Map;
};

} // namespace

bool FreeOutlineMap::keepsAreas(double shareOff) const
{
  return this->Bijective && this->ShareOff <= shareOff + GreatestLoss;
}

std::optional<FreeOutlineMap> freeOutlineMap(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& before,
  const Eigen::VectorXd& faceTargets,
  double area,
  double shapeWeight,
  const ProgressCallback& progress)
{
  const auto freedFrom = [&](const Points2& start, const ProgressCallback& part)
  { return OutlineFreeing(surface, loop, start, faceTargets, area, shapeWeight).run(part); };
  if (before.rows() == surface.vertexCount() && countFlippedFaces(before, surface.Faces) == 0 &&
      isSimpleOutline(before, loop))
  {
    FreeOutlineMap map = freedFrom(before, progress);
    map.WarmStarted = true;
    return map;
  }
  constexpr double naturalEnd = 0.05; // of the progress
  MapsNearNaturalOutline starts(surface, loop, subrange(progress, 0.0, naturalEnd));
  std::optional<FreeOutlineMap> best;
  double shown = naturalEnd;
  for (int k = 0; k < MostStarts && !(best && best->Bijective && best->ShareOff <= PressedShare); ++k)
  {
    const double begin = std::exchange(shown, shown + StartShownShare * (1.0 - shown));
    const ProgressCallback part = subrange(progress, begin, shown);
    const std::optional<Points2> start = starts.next(subrange(part, 0.0, naturalEnd));
    if (!start)
    {
      break;
    }
    FreeOutlineMap map = freedFrom(*start, subrange(part, naturalEnd, 1.0));
    if (!best || (map.Bijective && (!best->Bijective || map.ShareOff < best->ShareOff)))
    {
      best = std::move(map);
    }
  }
  return best;
}

} // namespace flattening
