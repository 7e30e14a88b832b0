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

// Of the mean scale: -log(1e5).
constexpr double HornLogScale = -11.512925464970229;
// On a tube of radius a, springs of weight s^p make a harmonic map fall like exp(-k x / a) instead of
// the conformal scale s = exp(-x / a), k = sqrt(1 + p^2 / 4) - p / 2.
constexpr double SpringPower = 4.0;

// Vertices whose scale is less than exp(3) = 20 times that of a horn's beginning may move as well. What
// reaches farther falls with the square of the scale: it is less than 1/400 of the scale there.
constexpr double NeckDepth = 3.0;

// Horns of a map to a convex region whose boundary stays.
class Horns
{
public:
  Horns(const IntrinsicTriangulation& t,
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
      this->Depth[v] = static_cast<double>(logFactors[v]) - logMeanFactor - HornLogScale;
      this->Count += !this->Fixed[v] && this->Depth[v] < 0.0;
    }
  }

  int vertexCount() const { return this->Count; }

  void spread(const IntrinsicTriangulation::Factors& metric, ComplexVector& disk) const
  {
    std::vector<Spring> springs = springsOf(this->Triangulation, metric);
    for (Spring& s : springs)
    {
      const double depth = std::min(this->Depth[s.From], 0.0) + std::min(this->Depth[s.To], 0.0);
      s.Weight *= std::exp(0.5 * SpringPower * depth);
    }
    std::vector<char> fixed = this->Fixed;
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      fixed[v] |= this->Depth[v] > NeckDepth;
    }
    ComplexVector spread = disk;
    relaxSprings(springs, fixed, spread);
    // The rim of the necks need not be convex, as the boundary of the whole is.
    if (this->flippedFaces(fixed, spread) > 0)
    {
      spread = disk;
      relaxSprings(springs, this->Fixed, spread);
    }
    disk = spread;
  }

private:
  // With a vertex that is not fixed.
  int flippedFaces(const std::vector<char>& fixed, const ComplexVector& disk) const
  {
    const IntrinsicTriangulation& t = this->Triangulation;
    std::vector<Eigen::RowVector3i> moved;
    for (int f = 0; f < t.faceCount(); ++f)
    {
      const Eigen::RowVector3i face(t.origin(3 * f), t.origin(3 * f + 1), t.origin(3 * f + 2));
      if (!fixed[face[0]] || !fixed[face[1]] || !fixed[face[2]])
      {
        moved.push_back(face);
      }
    }
    FaceMatrix faces(moved.size(), 3);
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      faces.row(i) = moved[i];
    }
    return countFlippedFaces(pointsOf(disk), faces);
  }

  const IntrinsicTriangulation& Triangulation;
  std::vector<double> Depth; // below 0 in horns
  std::vector<char> Fixed;
  int Count = 0;
};

int spread(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& metric,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk)
{
  const Horns horns(t, logFactors, logMeanFactor);
  if (horns.vertexCount() > 0)
  {
    horns.spread(metric, disk);
  }
  return horns.vertexCount();
}

} // namespace

int spreadProtrusions(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk)
{
  return spread(t, logFactors, logFactors, logMeanFactor, disk);
}

int spreadProtrusionsInOwnMetric(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk)
{
  const IntrinsicTriangulation::Factors none = IntrinsicTriangulation::Factors::Zero(t.vertexCount());
  return spread(t, none, logFactors, logMeanFactor, disk);
}

} // namespace flattening
