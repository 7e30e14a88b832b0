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

// Shapes count so many times as much in the first rounds: what they gain there, over a long way, is not
// lost again. In the horns of large surfaces, repeating that is the way out of what is tangled.
constexpr int FirstShapeRounds = 2;
constexpr double FirstShapeFactor = 10.0;
// A stage ends when so few faces are off by more than the patches' tolerance, or when rounds in a row
// bring neither their number nor how far they are off in sum down by this share.
constexpr double EnoughShare = 0.003;
constexpr double LeastProgress = 0.02;
constexpr int MostIdleRounds = 2;
// The same from a refined map.
constexpr double LeastContinuedProgress = 0.2;
constexpr int MostIdleContinuedRounds = 1;
// Faces with less of their target, flipped ones among them, count as if they had this share of it.
constexpr double LeastRatio = 1e-3;
// Every other round looks whether regions of the size of a patch have their area to this share.
constexpr double RegionAngle = 0.5;
constexpr double RegionTolerance = 0.01;
constexpr int RoundsPerBalance = 2;

} // namespace

// The faces whose area is off by more than the tolerance.
struct RefinementRounds::WrongFaces
{
  double Share = 0.0;    // of all faces
  double Distance = 0.0; // the sum of how far they are off, by the logarithms of their area ratios
};

RefinementRounds::RefinementRounds(const TriangleMesh& surface,
  const RefinementTerms& terms,
  const VertexFaces& facesOf,
  const DegreesOfFreedom& unknowns,
  Start start)
  : Surface(surface)
  , Unknowns(unknowns)
  , Energy(terms, facesOf, unknowns)
  , Patches(terms, facesOf, unknowns)
  , Begin(start)
  , LastShapeRound(start == Start::Refined ? 0 : FirstShapeRounds)
{
}

void RefinementRounds::setStage(const Eigen::VectorXd& targets, double epsilon)
{
  this->Energy.setTargets(targets);
  this->Energy.setEpsilon(epsilon);
  this->Epsilon = epsilon;
}

void RefinementRounds::startAgain()
{
  this->LastShapeRound = this->Count + FirstShapeRounds;
  if (this->Descent)
  {
    this->Descent->resetDamping();
  }
}

RefinementRounds::WrongFaces RefinementRounds::wrongFaces(const FlatState& state)
{
  this->Energy.setEnclosed(state);
  const Eigen::VectorXd ratios = this->Energy.areaRatios(state);
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

Eigen::VectorXd RefinementRounds::presentTargets(const FlatState& state)
{
  this->Energy.setEnclosed(state);
  Eigen::VectorXd targets(this->Surface.faceCount());
  for (int f = 0; f < this->Surface.faceCount(); ++f)
  {
    targets[f] = this->Energy.targetOf(f);
  }
  return targets;
}

// The largest share by which a region's area is wrong.
double RefinementRounds::imbalance(const FlatState& state, const Eigen::VectorXd& targets) const
{
  const FaceMatrix& faces = this->Surface.Faces;
  const int n = this->Surface.vertexCount();
  const Eigen::VectorXd areas = vertexAreas(faces, signedFaceAreas(state.Positions, faces), n);
  const Eigen::VectorXd wanted = vertexAreas(faces, targets, n);
  double largest = 0.0;
  for (const std::vector<int>& region :
    recursiveBisection(state.Positions, RefinementPatches::LargestPatch, RegionAngle))
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

// Area that must travel farther than a patch reaches takes steps of the whole mesh.
void RefinementRounds::balance(FlatState& state, double tolerance, const ProgressCallback& progress)
{
  if (this->imbalance(state, this->presentTargets(state)) < tolerance)
  {
    return;
  }
  if (!this->Descent)
  {
    this->Descent.emplace(
      this->Energy, this->Unknowns, this->Surface.Faces, SparseCholesky::Kernel::Blocks, progress);
  }
  this->Descent->keepOrientation(this->Epsilon == 0.0);
  this->Descent->round(state, progress);
}

void RefinementRounds::run(FlatState& state, int most, Until until, const ProgressCallback& progress)
{
  const bool isRefined = this->Begin == Start::Refined;
  const double progressShare = isRefined ? LeastContinuedProgress : LeastProgress;
  const int mostIdle = isRefined ? MostIdleContinuedRounds : MostIdleRounds;
  WrongFaces before = this->wrongFaces(state);
  int idle = 0;
  for (int round = 0; round < most && (before.Share > EnoughShare || until == Until::AllRounds); ++round)
  {
    ++this->Count;
    const double begin = static_cast<double>(round) / most;
    const double end = (round + 1.0) / most;
    const double middle = 0.5 * (begin + end);
    if (round % RoundsPerBalance == RoundsPerBalance - 1)
    {
      this->balance(state, RegionTolerance, subrange(progress, begin, middle));
    }
    RefinementPatches::Pass pass;
    pass.Targets = this->presentTargets(state);
    pass.Epsilon = this->Epsilon;
    pass.KeepsOrientation = this->Epsilon == 0.0;
    pass.ShapeFactor = this->Count <= this->LastShapeRound ? FirstShapeFactor : 1.0;
    const int patches = this->Patches.run(pass, state, subrange(progress, middle, end));
    const WrongFaces next = this->wrongFaces(state);
    const bool isIdle = next.Share > (1.0 - progressShare) * before.Share &&
                        next.Distance > (1.0 - progressShare) * before.Distance;
    idle = isIdle ? idle + 1 : 0;
    if (patches == 0 || (until == Until::Enough && idle == mostIdle))
    {
      return;
    }
    before = next;
  }
}

} // namespace flattening
