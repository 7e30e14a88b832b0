// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ProtrusionSpreading.h"

#include "Conformal/CotangentWeights.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/GraphLaplacian.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

// Logarithm of the scale, relative to the map's mean scale, at which a protrusion begins: -log(1e5). A
// choice: 1e-5 of the mean leaves ten digits for positions; where it begins later, the transport no
// longer gets through, and where it begins earlier, more of the map is not conformal.
constexpr double LogScaleOfProtrusions = -11.512925464970229;
// Power p of the scale by which weights are multiplied. On a tube of radius a, weights s^p make a
// harmonic map fall like exp(-k x / a) instead of the conformal scale s = exp(-x / a), with
// k = sqrt(1 + p^2 / 4) - p / 2: about a quarter for p = 4. A greater power spreads more, by weights
// that differ more.
constexpr double WeightPower = 4.0;
// The weights at this depth, in logarithms of the scale, are the smallest: exp(WeightPower * DeepestPoint)
// is 1e-174, far from where doubles underflow.
constexpr double DeepestPoint = -100.0;
// Logarithm of the scale, relative to where protrusions begin, up to which vertices may move: 20 times
// the scale there. The effect of a spread protrusion falls with the square of the scale: it is less than
// 1/400 of the scale where the vertices stay.
constexpr double NeckDepth = 3.0;

// The protrusions of a map to a convex region whose boundary stays.
class Protrusions
{
public:
  Protrusions(const IntrinsicTriangulation& t,
    const IntrinsicTriangulation::Factors& logFactors,
    double logMeanFactor)
    : Triangulation(t)
    , Depth(t.vertexCount())
    , Fixed(t.vertexCount(), 1)
  {
    for (int h = 0; h < t.halfedgeCount(); ++h)
    {
      this->Fixed[t.origin(h)] = 0;
    }
    for (const auto& edge : t.boundaryEdges())
    {
      if (edge.Origin >= 0)
      {
        this->Fixed[edge.Origin] = 1;
      }
    }
    for (int v = 0; v < t.vertexCount(); ++v)
    {
      this->Depth[v] = std::max(DeepestPoint,
        static_cast<double>(logFactors[v]) - logMeanFactor - LogScaleOfProtrusions);
    }
  }

  // The number of vertices in protrusions among the first vertices.
  int countAmong(int first) const
  {
    int count = 0;
    for (int v = 0; v < first; ++v)
    {
      count += !this->Fixed[v] && this->Depth[v] < 0.0;
    }
    return count;
  }

  void spread(const IntrinsicTriangulation::Factors& metric, ComplexVector& disk) const
  {
    std::vector<NeighbourWeight> weights = cotangentWeights(this->Triangulation, metric);
    for (NeighbourWeight& w : weights)
    {
      const double depth = std::min(this->Depth[w.From], 0.0) + std::min(this->Depth[w.To], 0.0);
      w.Weight *= std::exp(0.5 * WeightPower * depth);
    }
    std::vector<char> fixed = this->Fixed;
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      fixed[v] |= this->Depth[v] > NeckDepth;
    }
    ComplexVector spread = disk;
    WeightedMeans(weights, WeightSymmetry::Symmetric, fixed).extend(spread);
    // The rim of the vertices that move need not be convex, unlike the boundary of the map.
    if (this->flippedFaces(fixed, spread) > 0)
    {
      spread = disk;
      WeightedMeans(weights, WeightSymmetry::Symmetric, this->Fixed).extend(spread);
    }
    disk = spread;
  }

private:
  // Number of flipped faces with a vertex that is not fixed.
  int flippedFaces(const std::vector<char>& fixed, const ComplexVector& disk) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    FaceMatrix moved(t.faceCount(), 3);
    int count = 0;
    for (int f = 0; f < t.faceCount(); ++f)
    {
      const Eigen::RowVector3i face(t.origin(3 * f), t.origin(3 * f + 1), t.origin(3 * f + 2));
      if (!fixed[face[0]] || !fixed[face[1]] || !fixed[face[2]])
      {
        moved.row(count++) = face;
      }
    }
    moved.conservativeResize(count, 3);
    return countFlippedFaces(pointsOf(disk), moved);
  }

  const IntrinsicTriangulation& Triangulation;
  std::vector<double> Depth; // log of the scale relative to where protrusions begin: below 0 in them
  std::vector<char> Fixed;
};

} // namespace

int spreadProtrusions(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& metric,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& positions,
  int given)
{
  const Protrusions protrusions(t, logFactors, logMeanFactor);
  if (protrusions.countAmong(t.vertexCount()) > 0)
  {
    protrusions.spread(metric, positions);
  }
  return protrusions.countAmong(given);
}

} // namespace flattening
