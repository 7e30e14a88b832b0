// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/WarmStart.h"

#include "Mesh/FaceOrientation.h"

#include <algorithm>

namespace flattening
{
namespace
{

// How far a boundary vertex may lie from the boundary of a domain of area pi. A guard: scaling to the
// units of the output and back costs rounding only, and edges of the boundary are longer.
constexpr double OnBoundaryTolerance = 1e-6;
// A guard: a carried map that flips a greater share of its faces is no better a start than the
// transport.
constexpr double LargestFlippedShare = 0.01;

bool isAt(const Points2& positions, int v, const ConvexDomain& domain, double parameter)
{
  return (domain.at(parameter).transpose() - positions.row(v)).norm() <= OnBoundaryTolerance;
}

bool isMapToDomain(const Points2& positions,
  const FaceMatrix& faces,
  const ConvexDomain& domain,
  const BoundaryLoop& boundary)
{
  const std::vector<int>& loop = boundary.Vertices;
  if (!positions.allFinite() || !areOnBoundary(positions, loop, domain))
  {
    return false;
  }
  for (std::size_t c = 0; c < boundary.Corners.size(); ++c)
  {
    if (!isAt(positions, loop[boundary.Corners[c]], domain, boundary.CornerParameters[c]))
    {
      return false;
    }
  }
  return domain.areInOrder(domain.parametersOf(positions, loop)) &&
         countFlippedFaces(positions, faces) == 0;
}

// The same parameters from the first on around the whole boundary.
std::vector<double> turnOf(const std::vector<double>& parameters, const ConvexDomain& domain)
{
  std::vector<double> turn;
  for (const double parameter : parameters)
  {
    turn.push_back(domain.parameterAfter(parameters.front(), parameter));
  }
  turn.push_back(parameters.front() + domain.perimeter());
  return turn;
}

} // namespace

bool areOnBoundary(const Points2& positions, const std::vector<int>& loop, const ConvexDomain& domain)
{
  const Eigen::VectorXd parameters = domain.parametersOf(positions, loop);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    if (!isAt(positions, loop[k], domain, parameters[k]))
    {
      return false;
    }
  }
  return true;
}

Eigen::VectorXd WarmStart::weightsOf(const TransportSites& sites) const
{
  if (this->PowerWeights.size() != static_cast<Eigen::Index>(sites.SiteOfVertex.size()))
  {
    return {};
  }
  Eigen::VectorXd weights(sites.count());
  for (Eigen::Index v = 0; v < this->PowerWeights.size(); ++v)
  {
    weights[sites.SiteOfVertex[v]] = this->PowerWeights[v];
  }
  return weights;
}

std::optional<Points2> warmPositions(const WarmStart& start,
  const FaceMatrix& faces,
  const TransportSites& sites,
  const PowerDiagram& diagram,
  const SiteImages& images,
  const BoundaryLoop& boundary)
{
  const Eigen::VectorXd weights = start.weightsOf(sites);
  if (start.Positions.rows() != start.PowerWeights.size() || weights.size() == 0 ||
      !weights.allFinite() || !isMapToDomain(start.Positions, faces, diagram.domain(), boundary))
  {
    return {};
  }
  PowerDiagram before = diagram;
  if (!before.update(weights.cast<DoubleDouble>()))
  {
    return {};
  }
  Points2 carried = carriedMap(start.Positions,
    sites,
    siteImages(before, images.Masses, sites, boundary),
    images,
    boundary.Vertices,
    diagram.domain());
  return countFlippedFaces(carried, faces) <= LargestFlippedShare * static_cast<double>(faces.rows())
           ? std::optional(std::move(carried))
           : std::nullopt;
}

Points2 carriedMap(const Points2& positions,
  const TransportSites& sites,
  const SiteImages& before,
  const SiteImages& after,
  const std::vector<int>& loop,
  const ConvexDomain& domain)
{
  const TransportSites moved{ before.Positions, sites.SiteOfVertex };
  Points2 result = interpolateTransport(moved, after, positions, domain);

  const std::vector<double> from = turnOf(before.BoundaryParameters, domain);
  const std::vector<double> to = turnOf(after.BoundaryParameters, domain);
  for (const int v : loop)
  {
    const double parameter =
      domain.parameterAfter(from.front(), domain.parameterOf(positions.row(v).transpose()));
    const auto above = std::upper_bound(from.begin(), from.end() - 1, parameter);
    const std::size_t k = above - from.begin();
    const double share = std::clamp((parameter - from[k - 1]) / (from[k] - from[k - 1]), 0.0, 1.0);
    result.row(v) = domain.at((1.0 - share) * to[k - 1] + share * to[k]).transpose();
  }
  return result;
}

} // namespace flattening
