// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementRounds.h"

#include "Mesh/RecursiveBisection.h"

#include <algorithm>
#include <cmath>
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
// Where faces may not flip, the round after one that brought little begins with steps of the whole mesh:
// long rows of faces of a stretched map are right only together, which patches do not see. As these
// steps cost about as much as several rounds, they have to bring LeastWholeProgress. A compromise: with
// LeastProgress they go on for a handful of faces in protrusions, which stay wrong, and without these
// steps a hemisphere in a quadrilateral 30 times as long as wide keeps up to 2.6 % of its faces wrong,
// depending on the last bits.
constexpr double LeastWholeProgress = 0.1;
// The same after a warm start and for a rough map: rounds that bring little are not worth the wait for a
// small change, or for a map that is deformed afterwards.
constexpr double LeastQuickProgress = 0.2;
constexpr int MostIdleQuickRounds = 1;
// The least area ratio of a face in the sum of errors. A guard: the logarithm of a flipped face's ratio
// does not exist.
constexpr double LeastRatio = 1e-3;
// The direction of the lines between regions, in radians. A convention: other than that of the patches.
constexpr double RegionAngle = 0.5;
// Every RoundsPerBalance rounds, regions of the size of a patch must have their area up to
// RegionTolerance, or steps of the whole mesh follow. These cost about as much as several rounds,
// patches cannot replace them.
constexpr double RegionTolerance = 0.01;
constexpr int RoundsPerBalance = 2;

} // namespace

// The faces whose area is off by more than the tolerance.
struct RefinementRounds::WrongFaces
{
  double Share = 0.0;    // their share of all faces
  double Distance = 0.0; // the sum of the logarithms of their area ratios, absolute values
};

RefinementRounds::RefinementRounds(const TriangleMesh& surface,
  const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& dofs,
  RefinementStart start)
  : Surface(surface)
  , Terms(terms)
  , Dofs(dofs)
  , Energy(terms, facesOf, dofs)
  , Patches(terms, facesOf, dofs)
  , Start(start)
  , LastShapeRound(start == RefinementStart::WarmStart ? 0 : FirstShapeRounds)
{
}

void RefinementRounds::setStage(const Eigen::VectorXd& targets, double epsilon)
{
  this->Energy.setTargets(targets);
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

RefinementRounds::WrongFaces RefinementRounds::wrongFaces(const DomainMap& map)
{
  this->Energy.setEnclosed(map);
  const Eigen::VectorXd ratios = this->Energy.areaRatios(map);
  WrongFaces wrong;
  for (const double ratio : ratios)
  {
    if (std::abs(ratio - 1.0) > RefinementPatches::AreaTolerance)
    {
      wrong.Share += 1.0 / this->Surface.faceCount();
      wrong.Distance += std::abs(std::log(std::max(ratio, LeastRatio)));
    }
  }
  return wrong;
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

void RefinementRounds::balance(DomainMap& map, double tolerance, const ProgressCallback& progress)
{
  if (this->imbalance(map) >= tolerance)
  {
    this->descend(map, progress);
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
  return this->Descent->round(map, progress);
}

bool RefinementRounds::run(DomainMap& map, int most, Until until, const ProgressCallback& progress)
{
  const bool isQuick = this->Start == RefinementStart::WarmStart || until == Until::Roughly;
  const int mostIdle = isQuick ? MostIdleQuickRounds : MostIdleRounds;
  WrongFaces before = this->wrongFaces(map);
  int idle = 0;
  for (int round = 0; round < most && (before.Share > EnoughShare || until == Until::AllRounds); ++round)
  {
    ++this->Count;
    const double begin = static_cast<double>(round) / most;
    const double end = (round + 1.0) / most;
    const double middle = 0.5 * (begin + end);
    const bool isWhole = idle > 0 && this->Epsilon == 0.0;
    if (isWhole)
    {
      this->Energy.setEnclosed(map);
      this->descend(map, subrange(progress, begin, middle));
    }
    else if (round % RoundsPerBalance == RoundsPerBalance - 1)
    {
      this->balance(map, RegionTolerance, subrange(progress, begin, middle));
    }
    RefinementPatches::Pass pass;
    this->Energy.setEnclosed(map);
    pass.Targets = this->Energy.targets();
    pass.Epsilon = this->Epsilon;
    pass.KeepsOrientation = this->Epsilon == 0.0;
    pass.ShapeFactor = this->Count <= this->LastShapeRound ? FirstShapeFactor : 1.0;
    const int patches = this->Patches.run(pass, map, subrange(progress, middle, end));
    const WrongFaces next = this->wrongFaces(map);
    const double leastProgress = isWhole   ? LeastWholeProgress
                                 : isQuick ? LeastQuickProgress
                                           : LeastProgress;
    const bool isIdle = next.Share > (1.0 - leastProgress) * before.Share &&
                        next.Distance > (1.0 - leastProgress) * before.Distance;
    idle = isIdle ? idle + 1 : 0;
    if (patches == 0 || (until != Until::AllRounds && idle == mostIdle))
    {
      return isWhole && idle == mostIdle;
    }
    before = next;
  }
  return false;
}

} // namespace flattening
