// SPDX-License-Identifier: GPL-3.0-or-later
/// Area weights that enlarge or shrink regions of a surface by given factors, with sharp or soft edges.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace flattening
{

/// A set of vertices that is to be enlarged or shrunk.
struct WeightedRegion
{
  std::string Name;         ///< as error messages call it, e.g. "label 23"
  std::vector<char> Inside; ///< n, not 0 for the vertices of the region
  double Factor = 1.0;      ///< > 0
};

/// The meaning of the factor of a region.
enum class FactorMeaning
{
  RelativeToRest, ///< the region grows by the factor relative to the rest of the surface
  Magnification   ///< the region grows by the factor on the map; the rest shrinks to make room
};

struct RegionWeights
{
  Eigen::VectorXd Weights; ///< n, > 0
  double RestWeight = 1.0; ///< weight of the vertices far from all regions
};

/// Computes the weights of the vertices. A vertex of a region has the factor of the region (of the first
/// one, if it is in several). A vertex far from all regions has RestWeight: 1 or, for a magnification,
/// the weight that keeps the sum of weight times area. Between these the weight fades by the cubic 3 t^2
/// - 2 t^3 of the distance to the region.
/// @param areas the areas of the vertices without these weights (n, any unit).
/// @param edgeWidth geodesic width over which the weight fades, input units, >= 0; 0: a sharp edge,
/// where the weights change from one vertex to the next.
/// @throws InvalidInput if a region is empty or a factor not a positive number; if one region, or
/// several magnified ones, cover the whole surface, or there is no room for the magnified ones; if the
/// width is not finite and >= 0, or is not 0 and the surface not connected; TopologyError if it is not 0
/// and the surface is not manifold.
RegionWeights regionWeights(const TriangleMesh& mesh,
  const Eigen::VectorXd& areas,
  const std::vector<WeightedRegion>& regions,
  FactorMeaning meaning,
  double edgeWidth,
  const ProgressCallback& progress = {});

/// The smallest and greatest magnification of a vertex by weights w: w_v sum(areas) / sum(w areas).
struct MagnificationRange
{
  double Smallest = 1.0;
  double Greatest = 1.0;
};
MagnificationRange magnificationRange(const Eigen::VectorXd& areas, const Eigen::VectorXd& weights);

/// The label that covers most of the area around each vertex (n); the smallest of several with the same
/// area. Vertices without faces get @p none.
/// @param faceLabels one label per face (m).
std::vector<long long> vertexLabels(const TriangleMesh& mesh,
  const std::vector<long long>& faceLabels,
  long long none);

} // namespace flattening
