// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RoughFreeMap.h"

#include "Areas/CoarseDisk.h"
#include "Areas/RefinementTerms.h"
#include "Areas/ScaffoldDescent.h"
#include "Areas/TargetAreas.h"
#include "Base/EigenVersions.h"
#include "Mesh/OutlineCrossings.h"
#include "Untangling/OutlineUntangling.h"
#include "Untangling/TargetTriangles.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{

// Surfaces of at most so many vertices need no coarse disk. A compromise of time.
constexpr int FewVertices = 4000;
// How many vertices there are for each inner one of a coarse disk, at first and if the map that it makes
// cannot be untangled. A compromise: with half as many, the mean angle error of a head is 16.4 instead
// of 16.1 degrees, and the whole map takes an eighth less time.
constexpr int VerticesPerCoarseOne[] = { 8, 2 };
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

Points2 mapOfFewVertices(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& faceTargets,
  double shapeWeight,
  const ProgressCallback& progress)
{
  Points2 positions = chart;
  double begin = 0.0; // of the progress
  for (const double weight : { std::max(FirstShapeWeight, shapeWeight), LastShapeShare * shapeWeight })
  {
    RefinementTerms terms(surface, {}, 1.0, weight);
    terms.Outline = outlineEdges(loop);
    positions = descendInScaffold(terms, positions, faceTargets, subrange(progress, begin, begin + 0.5));
    begin = 0.5;
  }
  return positions;
}

Points2 coarseMap(const CoarseDisk& disk,
  std::size_t boundarySize,
  const Points2& chart,
  const ProgressCallback& progress)
{
  std::vector<int> loop(boundarySize);
  std::iota(loop.begin(), loop.end(), 0);
  RefinementTerms terms;
  terms.Faces = disk.Faces;
  terms.Cotangents = disk.Cotangents;
  terms.ShapeWeights = Eigen::VectorXd::Constant(disk.Faces.rows(), FirstShapeWeight);
  terms.Outline = outlineEdges(loop);
  return descendInScaffold(terms, chart(disk.Vertices, flattening::all), disk.Targets, progress);
}

} // namespace

std::optional<Points2> roughFreeMap(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& faceTargets,
  double shapeWeight,
  const ProgressCallback& progress)
{
  const int n = surface.vertexCount();
  if (n <= FewVertices)
  {
    return mapOfFewVertices(surface, loop, chart, faceTargets, shapeWeight, progress);
  }
  UntanglingOptions options;
  options.AreaWeight = UntanglingOptions::EqualAreaWeight;
  options.WorkPerVertex = UntanglingWork;
  double begin = 0.0; // of the progress
  for (const int verticesPerCoarseOne : VerticesPerCoarseOne)
  {
    const ProgressCallback part = subrange(progress, begin, 0.5 * (1.0 + begin));
    begin = 0.5;
    const int coarse = std::max(LeastCoarseVertices, n / verticesPerCoarseOne);
    const CoarseDisk disk =
      coarseDisk(surface, loop, chart, faceTargets, coarse, subrange(part, 0.0, 0.2));
    Points2 positions = disk.carried(coarseMap(disk, loop.size(), chart, subrange(part, 0.2, 0.9)));
    const double area = signedFaceAreas(positions, surface.Faces).sum();
    if (makeOneToOne(surface.Faces,
          loop,
          trianglesOfArea(surface, scaledTargets(faceTargets, area)),
          positions,
          options,
          subrange(part, 0.9, 1.0)))
    {
      return positions;
    }
  }
  return std::nullopt;
}

} // namespace flattening
