// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RoughFreeMap.h"

#include "Areas/CoarseDisk.h"
#include "Areas/RefinementTerms.h"
#include "Areas/ScaffoldDescent.h"
#include "Areas/ShapeDistortion.h"
#include "Areas/TargetAreas.h"
#include "Base/EigenVersions.h"
#include "Mesh/OutlineCrossings.h"
#include "Untangling/OutlineUntangling.h"
#include "Untangling/TargetTriangles.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// Surfaces of at most so many vertices need no coarse disk. A compromise of time.
constexpr int FewVertices = 4000;
// A chart whose distortion of shapes is greater is poor: the triangles of a coarse disk in it are long
// and narrow on the surface. A choice: conformal charts have 0.001, those of outlines that had to be
// made rounder 0.1 to 1.
constexpr double PoorChart = 0.05;
// How many vertices there are for each inner one of the coarse disks that are made one after the other:
// the map that one makes is the chart of the next. A compromise: with half as many vertices in a single
// disk, the mean angle error of a head is 16.4 instead of 16.1 degrees, and the whole map takes an
// eighth less time; with one disk, two and three in a poor chart, that of a brain is 19.0, 16.0 and 15.3
// degrees, after 52, 51 and 61 seconds.
const std::vector<int> ThinningInGoodChart{ 8 };
const std::vector<int> ThinningInPoorChart{ 32, 8, 8 };
// The same where none of these maps can be untangled.
constexpr int LastThinning = 2;
// The bound on the work for flipped faces (UntanglingOptions). A choice: with 1, flipped faces of a
// brain with 25,600 boundary edges remained; with 10 there were none, and it took no longer.
constexpr double UntanglingWork = 10.0;
// The least number of inner vertices of a coarse disk. A choice.
constexpr int LeastCoarseVertices = 1000;
// The weight of shapes at first, against that of areas: the outline takes its shape. Measured on a head:
// with 0.01, 0.03, 0.1 and 0.3 the mean angle error is 19.0, 18.2, 16.9 and 18.6 degrees.
constexpr double FirstShapeWeight = 0.1;
// The share of the shape weight that small surfaces end with, as in the last rounds of the refinement.
constexpr double LastShapeShare = 0.5;

// Whether points of the outline may become needles (RefinementTerms). In a poor chart most faces of the
// outline are needles at first, and are not to be held as such. A brain of 1.2 million vertices has a
// mean angle error of 14.5 degrees if needles are kept off on the last coarse disk alone, 14.8 degrees
// if on none, and 19.2 if on all three.
enum class Needles
{
  Allowed,
  KeptOff
};

void freeBoundary(RefinementTerms& terms, const std::vector<int>& loop, Needles needles)
{
  needles == Needles::Allowed ? terms.freeBoundary(loop) : terms.freeBoundaryWithoutNeedles(loop);
}

Points2 mapOfFewVertices(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& faceTargets,
  double shapeWeight,
  Needles firstNeedles,
  const ProgressCallback& progress)
{
  Points2 positions = chart;
  double begin = 0.0; // of the progress
  for (const auto& [weight, needles] :
    { std::pair(std::max(FirstShapeWeight, shapeWeight), firstNeedles),
      std::pair(LastShapeShare * shapeWeight, Needles::KeptOff) })
  {
    RefinementTerms terms(surface, {}, 1.0, weight);
    freeBoundary(terms, loop, needles);
    positions = descendInScaffold(terms, positions, faceTargets, subrange(progress, begin, begin + 0.5));
    begin = 0.5;
  }
  return positions;
}

Points2 coarseMap(const CoarseDisk& disk,
  std::size_t boundarySize,
  const Points2& chart,
  Needles needles,
  const ProgressCallback& progress)
{
  std::vector<int> loop(boundarySize);
  std::iota(loop.begin(), loop.end(), 0);
  RefinementTerms terms;
  terms.Faces = disk.Faces;
  terms.Cotangents = disk.Cotangents;
  terms.ShapeWeights = Eigen::VectorXd::Constant(disk.Faces.rows(), FirstShapeWeight);
  freeBoundary(terms, loop, needles);
  return descendInScaffold(terms, chart(disk.Vertices, flattening::all), disk.Targets, progress);
}

// The map of a coarse disk in @p chart, carried to the surface; nothing if it cannot be untangled.
std::optional<Points2> mapByCoarseDisk(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& faceTargets,
  int thinning,
  Needles needles,
  const ProgressCallback& progress)
{
  const int vertices = std::max(LeastCoarseVertices, surface.vertexCount() / thinning);
  const CoarseDisk disk =
    coarseDisk(surface, loop, chart, faceTargets, vertices, subrange(progress, 0.0, 0.2));
  Points2 positions =
    disk.carried(coarseMap(disk, loop.size(), chart, needles, subrange(progress, 0.2, 0.9)));
  UntanglingOptions options;
  options.AreaWeight = UntanglingOptions::EqualAreaWeight;
  options.WorkPerVertex = UntanglingWork;
  const double area = signedFaceAreas(positions, surface.Faces).sum();
  const bool isOneToOne = makeOneToOne(surface.Faces,
    loop,
    trianglesOfArea(surface, scaledTargets(faceTargets, area)),
    positions,
    options,
    subrange(progress, 0.9, 1.0));
  return isOneToOne ? std::optional<Points2>(std::move(positions)) : std::nullopt;
}

bool isPoor(const TriangleMesh& surface, const Points2& chart, const Eigen::VectorXd& faceTargets)
{
  const RefinementTerms terms(surface, {}, 1.0, 1.0);
  return shapeDistortion(terms, chart, faceTargets) > PoorChart;
}

} // namespace

std::optional<Points2> roughFreeMap(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& faceTargets,
  double shapeWeight,
  const ProgressCallback& progress)
{
  const bool isPoorChart = isPoor(surface, chart, faceTargets);
  const Needles first = isPoorChart ? Needles::Allowed : Needles::KeptOff;
  if (surface.vertexCount() <= FewVertices)
  {
    return mapOfFewVertices(surface, loop, chart, faceTargets, shapeWeight, first, progress);
  }
  const std::vector<int>& thinnings = isPoorChart ? ThinningInPoorChart : ThinningInGoodChart;
  constexpr double lastBegin = 0.8; // of the progress
  const double part = lastBegin / static_cast<double>(thinnings.size());
  double begin = 0.0;
  std::optional<Points2> positions;
  for (std::size_t k = 0; k < thinnings.size(); ++k)
  {
    const bool isLast = k + 1 == thinnings.size();
    std::optional<Points2> next = mapByCoarseDisk(surface,
      loop,
      positions ? *positions : chart,
      faceTargets,
      thinnings[k],
      isLast ? Needles::KeptOff : Needles::Allowed,
      subrange(progress, begin, begin + part));
    positions = next ? std::move(next) : std::move(positions);
    begin += part;
  }
  if (!positions)
  {
    positions = mapByCoarseDisk(
      surface, loop, chart, faceTargets, LastThinning, first, subrange(progress, lastBegin, 1.0));
  }
  return positions;
}

} // namespace flattening
