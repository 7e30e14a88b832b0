// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ProtrusionSpreading.h"

#include "Conformal/CotangentWeights.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/GraphLaplacian.h"

#include <algorithm>
#include <cmath>
#include <utility>
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
// That k: the share of the scale's fall that is left.
const double FallOfSpread = std::sqrt(1.0 + 0.25 * WeightPower * WeightPower) - 0.5 * WeightPower;
// The weights at this depth, in logarithms of the scale, are the smallest: exp(WeightPower *
// DeepestPoint) is 1e-174, far from where doubles underflow.
constexpr double DeepestPoint = -100.0;
// Logarithm of the scale, relative to where protrusions begin, up to which vertices may move: 20 times
// the scale there. The effect of a spread protrusion falls with the square of the scale: it is less than
// 1/400 of the scale where the vertices stay.
constexpr double NeckDepth = 3.0;
// A map with more flipped faces than one in so many is not spread along the circle. A choice: in
// surfaces that are nearly all protrusion the vertices of each cross-section lie on one line then, which
// takes the transport a minute to find out.
constexpr Eigen::Index FacesPerFlippedFace = 100;

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
      this->Depth[v] = std::max(
        DeepestPoint, static_cast<double>(logFactors[v]) - logMeanFactor - LogScaleOfProtrusions);
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

  // Moves the vertices of the boundary's protrusions apart along the unit circle. Returns whether there
  // are any.
  bool spreadCircle(const IntrinsicTriangulation::Factors& logFactors, ComplexVector& disk) const
  {
    const std::vector<std::vector<int>> runs = this->boundaryRuns();
    for (const std::vector<int>& run : runs)
    {
      this->spreadRun(run, logFactors, disk);
    }
    return !runs.empty();
  }

  void spread(const IntrinsicTriangulation::Factors& metric, ComplexVector& disk) const
  {
    std::vector<NeighbourWeight> weights = cotangentWeights(this->Triangulation, metric);
    for (NeighbourWeight& w : weights)
    {
      w.Weight *= std::exp(WeightPower * this->depthOfEdge(w.From, w.To));
    }
    std::vector<char> fixed = this->Fixed;
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      fixed[v] |= this->stays(static_cast<int>(v));
    }
    ComplexVector spread = disk;
    WeightedMeans(weights, WeightSymmetry::Symmetric, fixed).extend(spread);
    // The rim of the vertices that move need not be convex, unlike the boundary of the map. Where faces
    // are flipped by rounding, deep in protrusions, moving all vertices flips as many or more.
    if (this->flippedFaces(fixed, spread) > this->flippedFaces(fixed, disk))
    {
      spread = disk;
      WeightedMeans(std::move(weights), WeightSymmetry::Symmetric, this->Fixed).extend(spread);
    }
    disk = spread;
  }

private:
  bool stays(int v) const { return this->Depth[v] > NeckDepth; }

  // Runs of boundary edges, each from one vertex that stays to the next, that have vertices of
  // protrusions between.
  std::vector<std::vector<int>> boundaryRuns() const
  {
    const auto& boundary = this->Triangulation.boundaryEdges();
    std::vector<std::vector<int>> runs;
    for (int first = 0; first < static_cast<int>(boundary.size()); ++first)
    {
      if (boundary[first].Origin < 0 || !this->stays(boundary[first].Origin))
      {
        continue;
      }
      std::vector<int> run{ first };
      bool isProtrusion = false;
      int b = boundary[first].Next;
      for (; !this->stays(boundary[b].Origin); b = boundary[b].Next)
      {
        isProtrusion |= this->Depth[boundary[b].Origin] < 0.0;
        run.push_back(b);
      }
      if (isProtrusion && b != first)
      {
        runs.push_back(run);
      }
    }
    return runs;
  }

  // The angle of a run stays; its edges take shares of it by lengths that fall about a quarter as fast
  // in the protrusions as on the map.
  void spreadRun(const std::vector<int>& run,
    const IntrinsicTriangulation::Factors& logFactors,
    ComplexVector& disk) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    const auto& boundary = t.boundaryEdges();
    std::vector<double> ends{ 0.0 }; // of the edges, by the new lengths up to them
    for (const int b : run)
    {
      const int from = boundary[b].Origin;
      const int to = t.tipOfBoundaryEdge(b);
      const long double logLength = boundary[b].LogLength + 0.5L * (logFactors[from] + logFactors[to]);
      ends.push_back(ends.back() + std::exp(static_cast<double>(logLength) -
                                            (1.0 - FallOfSpread) * this->depthOfEdge(from, to)));
    }
    const std::complex<double> begin = disk[boundary[run.front()].Origin];
    double angle = std::arg(disk[t.tipOfBoundaryEdge(run.back())] / begin);
    angle += angle < 0.0 ? 2.0 * EIGEN_PI : 0.0;
    for (std::size_t k = 1; k < run.size(); ++k)
    {
      disk[boundary[run[k]].Origin] = begin * std::polar(1.0, angle * ends[k] / ends.back());
    }
  }

  // The mean depth of its ends, 0 for one outside of the protrusions.
  double depthOfEdge(int from, int to) const
  {
    return 0.5 * (std::min(this->Depth[from], 0.0) + std::min(this->Depth[to], 0.0));
  }

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

ComplexVector spreadAlongCircle(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  const FaceMatrix& faces,
  const ComplexVector& conformal,
  const ComplexVector& spread)
{
  const Protrusions protrusions(t, logFactors, logMeanFactor);
  ComplexVector alongCircle = conformal;
  if (!protrusions.spreadCircle(logFactors, alongCircle))
  {
    return spread;
  }
  protrusions.spread(IntrinsicTriangulation::Factors::Zero(t.vertexCount()), alongCircle);
  const Eigen::Index flipped = countFlippedFaces(pointsOf(alongCircle), faces);
  const bool isBetter = flipped <= countFlippedFaces(pointsOf(spread), faces) &&
                        flipped * FacesPerFlippedFace <= faces.rows();
  return isBetter ? alongCircle : spread;
}

} // namespace flattening
