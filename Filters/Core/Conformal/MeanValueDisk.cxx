// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/MeanValueDisk.h"

#include "Conformal/BoundaryAngles.h"
#include "Conformal/ConvexCombinationDisk.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/ComplexPositions.h"

#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

// The weight of an edge at its origin: the sum over the two faces beside it of tan(angle / 2) / length,
// with the face's angle at the origin.
std::vector<NeighbourWeight> meanValueWeights(const IntrinsicTriangulation& t)
{
  const IntrinsicTriangulation::Factors none = IntrinsicTriangulation::Factors::Zero(t.vertexCount());
  std::vector<NeighbourWeight> weights;
  weights.reserve(2 * t.halfedgeCount());
  for (int f = 0; f < t.faceCount(); ++f)
  {
    const TriangleAngles angles = t.scaledAngles(f, none);
    for (int k = 0; k < 3; ++k)
    {
      const int opposite = 3 * f + k;
      const int out = t.next(t.next(opposite));
      const int in = t.next(opposite);
      const double tangent = std::tan(0.5 * angles.Angle[k]);
      const int corner = t.origin(out);
      weights.push_back(
        { corner, t.tip(out), tangent * std::exp(-static_cast<double>(t.logLength(out))) });
      weights.push_back(
        { corner, t.origin(in), tangent * std::exp(-static_cast<double>(t.logLength(in))) });
    }
  }
  return weights;
}

} // namespace

ConformalDiskMap meanValueDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const ProgressCallback& progress)
{
  report(progress, 0.0, "Mean value weights");
  const IntrinsicTriangulation triangulation(mesh);
  const std::vector<NeighbourWeight> weights = meanValueWeights(triangulation);
  ConformalDiskMap map;
  map.AddedLength = triangulation.addedLength();
  map.MaxCurvatureError = map.LayoutError = std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd angles = anglesInProportion(loopLengths(mesh, loop, map.AddedLength));
  const ProgressCallback combination = atFraction(progress, 0.3, "Convex combination map");
  map.Positions = pointsOf(
    convexCombinationDisk(weights, WeightSymmetry::General, loop, angles, centring, combination));
  return map;
}

} // namespace flattening
