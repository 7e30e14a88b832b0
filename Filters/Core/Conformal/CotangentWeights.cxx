// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/CotangentWeights.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

namespace flattening
{
namespace
{

// Faces per task of a parallel loop: enough to outweigh the cost of a task.
constexpr int FacesPerTask = 1024;

} // namespace

std::vector<NeighbourWeight> cotangentWeights(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& u)
{
  std::vector<double> cotangents(t.halfedgeCount());
  tbb::parallel_for(tbb::blocked_range<int>(0, t.faceCount(), FacesPerTask),
    [&](const tbb::blocked_range<int>& faces)
    {
      for (int f = faces.begin(); f < faces.end(); ++f)
      {
        const TriangleAngles angles = t.scaledAngles(f, u);
        std::copy(std::begin(angles.Cotangent), std::end(angles.Cotangent), &cotangents[3 * f]);
      }
    });
  std::vector<NeighbourWeight> weights;
  weights.reserve(t.halfedgeCount());
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const int twin = t.twin(h);
    const double weight = twin < 0 ? 0.0 : cotangents[h] + cotangents[twin];
    if (weight > 0.0 && t.origin(h) != t.tip(h))
    {
      weights.push_back({ t.origin(h), t.tip(h), weight });
    }
  }
  return weights;
}

} // namespace flattening
