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

/// What the factor of a region compares.
enum class FactorMeaning
{
  RelativeToRest, ///< its areas against those of the rest
  Magnification   ///< its areas with the weights against those without: the rest makes room
};

struct RegionWeights
{
  Eigen::VectorXd Weights; ///< n, > 0
  double RestWeight = 1.0; ///< of the vertices far from all regions
};

/// The weights of the vertices. A vertex of a region has the region's factor (the first one's that it is
/// in), one far from all regions has RestWeight: 1 or, for a magnification, what keeps the sum of weight
/// times area. Outside a region its weight fades from the factor to the rest's over @p edgeWidth
/// (geodesic, input units), by the cubic 3 t^2 - 2 t^3; 0: a sharp edge, the weights change from one
/// vertex to the next.
/// @param areas n, what the vertices' areas are without these weights, in any unit.
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

/// The smallest and greatest magnification, over all vertices, of weights w: w_v sum(areas) / sum(w
/// areas).
struct MagnificationRange
{
  double Smallest = 1.0;
  double Greatest = 1.0;
};
MagnificationRange magnificationRange(const Eigen::VectorXd& areas, const Eigen::VectorXd& weights);

/// The label that covers most of the area around each vertex, of one label per face (m); of equal areas
/// the smallest. Vertices without faces get @p none.
std::vector<long long> vertexLabels(const TriangleMesh& mesh,
  const std::vector<long long>& faceLabels,
  long long none);

} // namespace flattening
