// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/RegionWeights.h"

#include "Base/Errors.h"
#include "Geodesics/GeodesicDistance.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

namespace flattening
{
namespace
{

void requireRegions(const std::vector<WeightedRegion>& regions)
{
  for (const WeightedRegion& region : regions)
  {
    if (!(region.Factor > 0.0) || !std::isfinite(region.Factor))
    {
      throw InvalidInput("the factor of " + region.Name + " is " + formatted(region.Factor) +
                         ": factors must be positive numbers; to leave a region out of the map, cut it "
                         "off before flattening");
    }
    if (std::none_of(region.Inside.begin(), region.Inside.end(), [](char inside) { return inside; }))
    {
      throw InvalidInput(region.Name + " has no point of the surface: choose another region");
    }
  }
}

void requireSmoothable(const TriangleMesh& mesh)
{
  if (analyseTopology(mesh.Faces, mesh.vertexCount()).Components != 1)
  {
    throw InvalidInput("the edge of a region cannot be soft on a surface in several pieces: run Surface "
                       "To Disk first, or set the edge width to 0");
  }
}

// The vertices of the region that have a neighbour outside it.
std::vector<int> borderOf(const TriangleMesh& mesh, const std::vector<char>& inside)
{
  std::set<int> border;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto face = mesh.Faces.row(f);
    if (!inside[face[0]] || !inside[face[1]] || !inside[face[2]])
    {
      std::copy_if(face.begin(),
        face.end(),
        std::inserter(border, border.end()),
        [&inside](int v) { return inside[v] != 0; });
    }
  }
  return { border.begin(), border.end() };
}

// The share of the region in the weight of each vertex (n): 1 in the region, falling to 0 over the
// width.
Eigen::VectorXd softShare(const TriangleMesh& mesh,
  const std::vector<char>& inside,
  double width,
  const ProgressCallback& progress)
{
  Eigen::VectorXd share = Eigen::VectorXd::Zero(mesh.vertexCount());
  const std::vector<int> border = width > 0.0 ? borderOf(mesh, inside) : std::vector<int>{};
  if (!border.empty())
  {
    // Points that no face has are left out, as they have no distance.
    std::vector<int> faces(mesh.faceCount());
    std::iota(faces.begin(), faces.end(), 0);
    const DerivedMesh part = extractFaces(mesh, faces);
    std::vector<int> original;
    std::vector<int> sources;
    for (int v = 0; v < part.Mesh.vertexCount(); ++v)
    {
      original.push_back(VertexOrigins::InnerIterator(part.Vertices, v).col());
      if (std::binary_search(border.begin(), border.end(), original.back()))
      {
        sources.push_back(v);
      }
    }
    const Eigen::ArrayXd t =
      (1.0 - geodesicDistances(part.Mesh, sources, progress).array() / width).cwiseMax(0.0);
    share(original) = t * t * (3.0 - 2.0 * t);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    share[v] = inside[v] ? 1.0 : share[v];
  }
  return share;
}

// The weights as w = Fixed + Rest r, where r is the weight far from all regions.
struct AffineWeights
{
  Eigen::VectorXd Fixed;
  Eigen::VectorXd Rest;
};

AffineWeights blend(const TriangleMesh& mesh,
  const std::vector<WeightedRegion>& regions,
  double width,
  const ProgressCallback& progress)
{
  const int n = mesh.vertexCount();
  Eigen::VectorXd fixed = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(n);
  std::vector<char> taken(n, 0);
  const auto count = static_cast<double>(regions.size());
  double done = 0.0;
  for (const WeightedRegion& region : regions)
  {
    report(progress, done / count, "Weighting the regions");
    const Eigen::VectorXd share =
      softShare(mesh, region.Inside, width, subrange(progress, done / count, (done + 1.0) / count));
    done += 1.0;
    for (int v = 0; v < n; ++v)
    {
      if (taken[v])
      {
        continue; // inside a region only its own factor counts, not the soft edges of its neighbours
      }
      taken[v] = region.Inside[v];
      fixed[v] = taken[v] ? region.Factor : fixed[v] + share[v] * region.Factor;
      shares[v] = taken[v] ? 1.0 : shares[v] + share[v];
    }
  }
  // Where the soft edges of several regions overlap, their shares are scaled to the sum 1.
  const Eigen::ArrayXd whole = shares.array().max(1.0);
  return { fixed.array() / whole, 1.0 - shares.array() / whole };
}

// The weight of the rest that keeps the sum of weight times area.
double restMakingRoom(const Eigen::VectorXd& areas, const AffineWeights& weights)
{
  const double room = areas.sum();
  const double asked = areas.dot(weights.Fixed);
  if (!(asked < room))
  {
    throw InvalidInput("the magnified regions would take " + formatted(100.0 * asked / room) +
                       " % of the map, more than there is: divide the factors by more than " +
                       formatted(asked / room) +
                       ", or choose factors relative to the rest, which always fit");
  }
  return (room - asked) / areas.dot(weights.Rest);
}

} // namespace

RegionWeights regionWeights(const TriangleMesh& mesh,
  const Eigen::VectorXd& areas,
  const std::vector<WeightedRegion>& regions,
  FactorMeaning meaning,
  double edgeWidth,
  const ProgressCallback& progress)
{
  requireRegions(regions);
  if (!(edgeWidth >= 0.0) || !std::isfinite(edgeWidth))
  {
    throw InvalidInput("the width of the regions' edges is " + formatted(edgeWidth) +
                       ": it must be a length, 0 for sharp edges");
  }
  if (edgeWidth > 0.0)
  {
    requireSmoothable(mesh);
  }
  const AffineWeights affine = blend(mesh, regions, edgeWidth, progress);
  const bool hasRest = areas.dot(affine.Rest) > 0.0;
  if (!hasRest && (regions.size() == 1 || meaning == FactorMeaning::Magnification))
  {
    throw InvalidInput("the regions cover the whole surface, so that nothing is left to shrink or grow "
                       "for them: leave a part of the surface out of them");
  }
  RegionWeights result;
  result.RestWeight = meaning == FactorMeaning::RelativeToRest ? 1.0 : restMakingRoom(areas, affine);
  result.Weights = affine.Fixed + result.RestWeight * affine.Rest;
  return result;
}

MagnificationRange magnificationRange(const Eigen::VectorXd& areas, const Eigen::VectorXd& weights)
{
  const double scale = areas.sum() / areas.dot(weights);
  return { scale * weights.minCoeff(), scale * weights.maxCoeff() };
}

std::vector<long long> vertexLabels(const TriangleMesh& mesh,
  const std::vector<long long>& faceLabels,
  long long none)
{
  const Eigen::VectorXd areas = faceAreas(mesh.Vertices, mesh.Faces);
  std::vector<std::map<long long, double>> areaOfLabel(mesh.vertexCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      areaOfLabel[mesh.Faces(f, k)][faceLabels[f]] += areas[f];
    }
  }
  std::vector<long long> labels(mesh.vertexCount(), none);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    double largest = -1.0;
    for (const auto& [label, area] : areaOfLabel[v])
    {
      labels[v] = area > largest ? label : labels[v];
      largest = std::max(largest, area);
    }
  }
  return labels;
}

} // namespace flattening
