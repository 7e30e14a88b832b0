// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementRounds.h"

#include "Areas/OutlineScaffold.h"
#include "Areas/ShapeDistortion.h"
#include "Areas/TargetAreas.h"
#include "Mesh/RecursiveBisection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// In the first rounds (FirstShapeRounds) shapes count FirstShapeFactor times as much: the shape that
// faces gain over the long way is not lost again. Repeating these rounds untangles faces in the
// protrusions of large surfaces. Both are choices by trial; with 1 more faces stay flipped after the
// first stage.
constexpr double FirstShapeFactor = 10.0;
// A stage ends when at most the share EnoughShare of the faces is off by more than AreaTolerance, or
// after MostIdleRounds rounds in a row that lower neither their number nor the sum of their errors by
// LeastProgress. A compromise: lower values bring the last faces nearer in many rounds.
constexpr double EnoughShare = 0.003;
constexpr double LeastProgress = 0.02;
constexpr int MostIdleRounds = 2;
// If at most the share FewWrong of the faces is off, only the vertices within MovingRings rings of faces
// around these move, unless the round before did not help. A compromise: a whole brain with a small hole
// takes a fifth less time than if all vertices move, and 98.8 % of its faces are right with either; a
// brain of 340,000 points with a free outline takes a tenth less. With 4 rings more faces stay wrong.
constexpr double FewWrong = 0.05;
constexpr int MovingRings = 6;
// Rounds of steps in a patch per pass. A compromise: the next pass gains more, since it frees the
// vertices in between, but a whole brain with a small hole has 6 instead of 2 % of its faces wrong with
// one.
constexpr int PatchRounds = 2;
// EnoughShare and PatchRounds after a warm start, for a change of one weight: each further pass is a
// tenth of the wait, and with one round in a patch the maps have the same errors in four fifths of the
// time.
constexpr double WarmEnoughShare = 0.005;
constexpr int WarmPatchRounds = 1;
// The direction of the lines between regions, in radians. A convention: other than that of the patches.
constexpr double RegionAngle = 0.5;
// Every RoundsPerBalance rounds, regions of the size of a patch must have their area up to
// RegionTolerance, or the domain is deformed: patches cannot move area so far.
constexpr double RegionTolerance = 0.01;
constexpr int RoundsPerBalance = 2;
// Deformations that lower the distortion of shapes end when one lowers it by less than this share of it.
// A compromise: each costs a tenth of a round.
constexpr double LeastShapingGain = 0.01;
// The weight of areas in deformations that set the areas of regions right and keep the shapes of the
// map, and how many follow each other. A choice: with less the shapes keep areas from their targets,
// with more Newton's steps get short. Later ones correct what the first leaves, because faces do not
// bend.
constexpr double BalancingAreaWeight = 1000.0;
constexpr int MostBalances = 2;
// Deformations that leave a larger share of the region error are of no use, and steps of the whole mesh
// follow. A choice: mostly a tenth is left.
constexpr double LeastBalanceShare = 0.5;
// The factor of the shape weights in the last rounds. A compromise: on half a brain, remeshed, the mean
// area error is 0.22, 0.21 and 0.20 % with 1, 0.5 and 0.1, and the angle error 11.1, 11.2 and 11.4
// degrees.
constexpr double PolishingShapeFactor = 0.5;
// In these rounds, the vertices within PolishingRings rings around faces that are off by more than
// PolishingTolerance move. Compromises: half a brain has 19 instead of 38 faces off if it is remeshed,
// and 89 instead of 108 if it is raw, against two rounds of all vertices, and takes no longer. After a
// warm start the other faces were right before, and what is near wrong faces moves, as in the rounds
// before.
constexpr int PolishingRounds = 3;
constexpr int PolishingRings = 4;
constexpr double PolishingTolerance = 0.004;
// Before these rounds, if the greatest weight is more than WideRange times the least, steps of the whole
// mesh are made until one round of these lowers the energy by less than LeastWeightedGain: patches
// hardly reach a region whose faces are thousands of times as small as others. With weights of six
// decades in one mesh, the area of the smallest region is 0.02 % off with these steps and 2 % without
// them. For smaller ranges they would take time, and a map that starts from another one would have
// larger angle errors than one from the beginning.
constexpr double WideRange = 100.0;
constexpr double LeastWeightedGain = 0.01;
constexpr int MostWeightedSteps = 10; // a limit of the time

} // namespace

RefinementRounds::RefinementRounds(const TriangleMesh& surface,
  const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& dofs,
  const Points2& chart,
  const Eigen::VectorXd& targets,
  RefinementStart start,
  bool asksForAreas)
  : Surface(surface)
  , Terms(terms)
  , FacesOf(facesOf)
  , Dofs(dofs)
  , Chart(chart)
  , Energy(terms, facesOf, dofs)
  , Deformation(surface, terms, facesOf, dofs)
  , Start(start)
  , AsksForAreas(asksForAreas)
  , AreaWeights(areaWeights(faceAreas(surface.Vertices, surface.Faces)))
  , Counts(faceCounts(surface, targets))
  , LastShapeRound(start == RefinementStart::WarmStart ? 0 : FirstShapeRounds)
{
}

void RefinementRounds::setStage(const Eigen::VectorXd& targets, double epsilon)
{
  this->Energy.setTargets(targets, this->AreaWeights, this->Counts);
  this->Energy.setEpsilon(epsilon);
  this->Epsilon = epsilon;
}

void RefinementRounds::favourShapes(int rounds)
{
  this->LastShapeRound = this->Count + rounds;
  if (this->Descent)
  {
    this->Descent->resetDamping();
  }
}

WrongFaces RefinementRounds::wrongFaces(const DomainMap& map, double tolerance)
{
  this->Energy.setEnclosed(map);
  return { this->Energy.areaRatios(map), tolerance };
}

std::vector<char> RefinementRounds::nearWrongFaces(const DomainMap& map, double tolerance, int rings)
{
  return verticesNear(this->wrongFaces(map, tolerance).Faces, this->Surface.Faces, this->FacesOf, rings);
}

// The largest relative error of a region's area.
double RefinementRounds::imbalance(const DomainMap& map)
{
  this->Energy.setEnclosed(map);
  const FaceMatrix& faces = this->Surface.Faces;
  const int n = this->Surface.vertexCount();
  const Eigen::VectorXd areas = vertexAreas(faces, signedFaceAreas(map.Positions, faces), n);
  const Eigen::VectorXd wanted = vertexAreas(faces, this->Energy.targets(), n);
  double largest = 0.0;
  for (const std::vector<int>& region :
    recursiveBisection(map.Positions, RefinementPatches::LargestPatch, RegionAngle))
  {
    double has = 0.0;
    double wants = 0.0;
    for (const int v : region)
    {
      has += areas[v];
      wants += wanted[v];
    }
    largest = std::max(largest, std::abs(has / wants - 1.0));
  }
  return largest;
}

// Returns false if the map must not be deformed: if angles are asked for, or the mesh of a map to a
// domain is no larger than a patch, or thin faces would flip, now or earlier: mostly they would again,
// and trying to untangle them takes as long as several rounds.
bool RefinementRounds::deform(DomainMap& map,
  DeformationEnergy::Shapes shapes,
  double areaWeight,
  const ProgressCallback& progress)
{
  const bool isOnePatch = this->Surface.vertexCount() <= RefinementPatches::LargestPatch;
  if ((isOnePatch && !this->isFree()) || !this->AsksForAreas || this->FlipsIfDeformed)
  {
    return false;
  }
  this->Energy.setEnclosed(map);
  this->FlipsIfDeformed = !this->Deformation.deform(
    map, this->Energy.targets(), { shapes, areaWeight, this->Epsilon > 0.0 }, progress);
  return !this->FlipsIfDeformed;
}

bool RefinementRounds::isNearlyRight(const DomainMap& map)
{
  return this->wrongFaces(map).Share <= EnoughShare && this->imbalance(map) < RegionTolerance;
}

int RefinementRounds::lowerDistortion(DomainMap& map,
  double areaWeight,
  int most,
  const ProgressCallback& progress)
{
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most; ++k)
  {
    const double begin = static_cast<double>(k) / most;
    const double end = begin + 1.0 / most;
    if (!this->deform(
          map, DeformationEnergy::Shapes::OfSurface, areaWeight, subrange(progress, begin, end)))
    {
      return k;
    }
    const double after = this->distortion(map);
    if (before - after < LeastShapingGain * before)
    {
      return k + 1;
    }
    before = after;
  }
  return most;
}

double RefinementRounds::distortion(const DomainMap& map) const
{
  return shapeDistortion(this->Terms, map.Positions, this->Energy.targets());
}

void RefinementRounds::balance(DomainMap& map, double tolerance, const ProgressCallback& progress)
{
  constexpr double deformations = 0.5; // of the progress; the rest is for steps of the whole mesh
  const ProgressCallback rest = subrange(progress, deformations, 1.0);
  const double first = this->imbalance(map);
  double now = first;
  for (int k = 0; k < MostBalances && now >= tolerance; ++k)
  {
    const double begin = deformations * k / MostBalances;
    const ProgressCallback part = subrange(progress, begin, begin + deformations / MostBalances);
    const DomainMap before = map;
    const double wrong = this->wrongFaces(map).Share;
    if (!this->deform(map, DeformationEnergy::Shapes::OfMap, BalancingAreaWeight, part))
    {
      this->descend(map, rest);
      return;
    }
    // Near a hole a deformation bends thin faces. Where no rounds follow that set them right, the share
    // of the faces that it puts wrong must not be larger than what regions gain.
    const double after = this->imbalance(map);
    const double loss = tolerance < RegionTolerance ? this->wrongFaces(map).Share - wrong : 0.0;
    if (!(loss <= now - after))
    {
      map = before;
      break;
    }
    now = after;
  }
  if (now >= std::max(tolerance, RegionTolerance) && now > LeastBalanceShare * first)
  {
    // Small area weights make regions that are smaller than the squares of a deformation.
    this->descend(map, rest);
  }
}

RefinementPatches::Pass RefinementRounds::pass(const DomainMap& map)
{
  this->Energy.setEnclosed(map);
  RefinementPatches::Pass pass;
  pass.Targets = this->Energy.targets();
  pass.AreaWeights = this->AreaWeights;
  pass.Counts = this->Counts;
  pass.Epsilon = this->Epsilon;
  pass.KeepsOrientation = this->Epsilon == 0.0;
  pass.MostRounds = this->isWarm() ? WarmPatchRounds : PatchRounds;
  return pass;
}

// Returns the number of patches that needed it. With a free boundary, gaps beside the outline are faces
// too. Where the outline crosses itself in a shallow bay afterwards, the pass is made anew with gaps
// there.
int RefinementRounds::runPatches(RefinementPatches::Pass& pass,
  DomainMap& map,
  const ProgressCallback& progress)
{
  pass.Number = this->Passes++;
  if (!this->isFree())
  {
    return RefinementPatches(this->Terms, this->FacesOf, this->Dofs, this->Chart)
      .run(pass, map, progress);
  }
  using ShallowBays = OutlineScaffold::ShallowBays;
  double begin = 0.0; // of the progress
  for (const ShallowBays bays : { ShallowBays::Open, ShallowBays::Filled })
  {
    const OutlineScaffold scaffold(this->Terms, map.Positions, pass.Targets, bays);
    RefinementPatches::Pass withGaps = pass;
    withGaps.Targets = scaffold.targets(pass.Targets);
    withGaps.AreaWeights = scaffold.areaWeights(pass.AreaWeights);
    withGaps.Counts = scaffold.counts(pass.Counts);
    RefinementPatches patches(scaffold.terms(), scaffold.facesOf(), this->Dofs, this->Chart);
    DomainMap next = map;
    const int worked = patches.run(withGaps, next, subrange(progress, begin, 0.5 * (1.0 + begin)));
    begin = 0.5;
    if (!edgesCross(next.Positions, this->Terms.Outline))
    {
      map = std::move(next);
      return worked;
    }
  }
  return 0;
}

void RefinementRounds::polish(DomainMap& map, const ProgressCallback& progress)
{
  if (this->Counts.maxCoeff() > WideRange * this->Counts.minCoeff() && !this->isWarm())
  {
    this->settle(map, LeastWeightedGain, MostWeightedSteps, subrange(progress, 0.0, 0.4));
  }
  for (int round = 0; round < PolishingRounds; ++round)
  {
    RefinementPatches::Pass pass = this->pass(map);
    pass.ShapeFactor = PolishingShapeFactor;
    // Here faces with large weights count by their target areas: they are few, and the rounds before end
    // without them.
    pass.Counts = pass.Counts.cwiseMax(1.0);
    pass.Moving = this->isWarm()
                    ? this->nearWrongFaces(map, RefinementPatches::AreaTolerance, MovingRings)
                    : this->nearWrongFaces(map, PolishingTolerance, PolishingRings);
    const double begin = 0.4 + 0.6 * round / PolishingRounds;
    this->runPatches(pass, map, subrange(progress, begin, begin + 0.6 / PolishingRounds));
    ++this->Count;
  }
}

void RefinementRounds::settle(DomainMap& map,
  double leastGain,
  int most,
  const ProgressCallback& progress)
{
  for (int round = 0; round < most; ++round)
  {
    this->Energy.setEnclosed(map);
    const double begin = static_cast<double>(round) / most;
    if (this->descend(map, subrange(progress, begin, begin + 1.0 / most)) < leastGain)
    {
      return;
    }
  }
}

// A round of steps of the whole mesh; returns the relative decrease of the energy.
double RefinementRounds::descend(DomainMap& map, const ProgressCallback& progress)
{
  if (!this->Descent)
  {
    this->Descent.emplace(
      this->Energy, this->Dofs, this->Terms, SparseCholesky::Kernel::Blocks, progress);
  }
  this->Descent->keepOrientation(this->Epsilon == 0.0);
  this->Descent->endAfterShortStep(true);
  return this->Descent->round(map, progress);
}

void RefinementRounds::run(DomainMap& map, int most, Until until, const ProgressCallback& progress)
{
  const double enough = this->isWarm() ? WarmEnoughShare : EnoughShare;
  WrongFaces before = this->wrongFaces(map);
  int idle = 0;
  for (int round = 0; round < most && (before.Share > enough || until == Until::AllRounds); ++round)
  {
    ++this->Count;
    const double begin = static_cast<double>(round) / most;
    const double end = (round + 1.0) / most;
    const double middle = 0.5 * (begin + end);
    if (round % RoundsPerBalance == RoundsPerBalance - 1)
    {
      this->balance(map, RegionTolerance, subrange(progress, begin, middle));
    }
    RefinementPatches::Pass pass = this->pass(map);
    const bool favoursShapes = this->Count <= this->LastShapeRound;
    pass.ShapeFactor = favoursShapes ? FirstShapeFactor : 1.0;
    if (!favoursShapes && before.Share < FewWrong && idle == 0)
    {
      pass.Moving = this->nearWrongFaces(map, RefinementPatches::AreaTolerance, MovingRings);
    }
    const int patches = this->runPatches(pass, map, subrange(progress, middle, end));
    const WrongFaces next = this->wrongFaces(map);
    const double left = 1.0 - LeastProgress;
    const bool helps = next.Share <= left * before.Share || next.Distance <= left * before.Distance;
    idle = helps ? 0 : idle + 1;
    if (patches == 0 || (until != Until::AllRounds && idle >= MostIdleRounds))
    {
      return;
    }
    before = next;
  }
}

} // namespace flattening
