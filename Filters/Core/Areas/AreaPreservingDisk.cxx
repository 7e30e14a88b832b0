// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/AreaPreservingDisk.h"

#include "Areas/WarmStart.h"
#include "Base/Errors.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Transport/BoundaryPlacement.h"
#include "Transport/TransportInterpolation.h"
#include "Transport/TransportSites.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// How far from the boundary a boundary vertex of the input may lie: of a length 1, the disk's radius.
constexpr double BoundaryTolerance = 1e-6;
constexpr int LeastSites = 1000;
// A former map that flips more of its faces on the way is no better a start than the transport.
constexpr double LargestFlippedShare = 0.01;

// Members of the boundary loop, in its order, that stay at places which grow over less than a turn.
struct FixedMembers
{
  std::vector<int> Members;
  std::vector<double> Places;
};

// Where the surface is mapped to.
struct Target
{
  std::shared_ptr<const ConvexDomain> Domain;
  std::string Name;
  std::string Boundary;
  FixedMembers Corners; // of which the members may be left to be found
};

void requirePositions(const Points2& positions,
  const std::vector<int>& loop,
  const ConvexDomain& domain,
  const Target& target)
{
  const std::string remedy =
    ": the input must be a map to the " + target.Name + ", run Conformal Disk first";
  for (const int v : loop)
  {
    const Eigen::Vector2d position = positions.row(v);
    if (!((domain.at(domain.placeOf(position)) - position).norm() <= BoundaryTolerance))
    {
      throw InvalidInput(
        "boundary vertex " + std::to_string(v) + " does not lie on the " + target.Boundary + remedy);
    }
  }
  const Eigen::Vector2d centroid = domain.centroid();
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    const Eigen::Vector2d position = positions.row(v);
    if (!domain.contains(centroid + (1.0 - BoundaryTolerance) * (position - centroid)))
    {
      throw InvalidInput("vertex " + std::to_string(v) + " lies outside of the " + target.Name + remedy);
    }
  }
}

// Every ray from the centroid is stretched to the length that it has in the other domain, whose centroid
// is 0 too.
Points2 carriedAlongRays(const Points2& positions, const ConvexDomain& from, const ConvexDomain& to)
{
  Points2 carried(positions.rows(), 2);
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    const Eigen::Vector2d position = positions.row(v);
    const double share = position.norm() / from.at(from.placeOf(position)).norm();
    carried.row(v) = std::min(share, 1.0) * to.at(to.placeOf(position));
  }
  return carried;
}

// Not more than leaves LeastSites.
int verticesPerSite(const AreaPreservingOptions& options, int vertexCount)
{
  return options.RefineFaces
           ? std::clamp(vertexCount / LeastSites, 1, std::max(1, options.VerticesPerSite))
           : 1;
}

void refine(AreaPreservingMap& map,
  const TriangleMesh& mesh,
  const TransportedMap& transported,
  const Eigen::VectorXd& weights,
  const FaceRefinementOptions& options,
  const ProgressCallback& progress)
{
  const Eigen::VectorXd relative =
    weights.size() > 0 ? Eigen::VectorXd(weights / weights.maxCoeff()) : weights;
  FaceRefinementResult refined =
    refineFaces(mesh, transported, faceTargets(mesh, relative), options, progress);
  map.Positions = std::move(refined.Positions);
  map.FlippedFaces = refined.FlippedFaces;
  map.Bijective = refined.Bijective;
  map.RefinementRounds = refined.Rounds;
  map.RepairedFaces = refined.RepairedFaces;
  map.StartShare = refined.StartShare;
}

// Those of the target, with the members whose cells have them where it names none.
FixedMembers cornersOf(const Target& target,
  const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex)
{
  FixedMembers corners = target.Corners;
  if (corners.Members.size() < corners.Places.size())
  {
    corners.Members = cornerMembers(diagram, loop, siteOfVertex, corners.Places);
    const auto first = std::min_element(corners.Members.begin(), corners.Members.end());
    const auto before = first - corners.Members.begin();
    const double turn = target.Domain->perimeter();
    std::transform(corners.Places.begin(),
      corners.Places.begin() + before,
      corners.Places.begin(),
      [turn](double place) { return place + turn; });
    std::rotate(corners.Places.begin(), corners.Places.begin() + before, corners.Places.end());
    std::rotate(corners.Members.begin(), first, corners.Members.end());
  }
  return corners;
}

// Of the transport that a refined map is given of; nothing if none is. What AngleWeight the map had is
// not known.
std::optional<PowerDiagram> formerDiagram(const PowerDiagram& diagram,
  const Eigen::VectorXd& weights,
  int vertexCount,
  const AreaPreservingOptions& options)
{
  if (!options.RefineFaces || options.Refinement.AngleWeight > 0.0 ||
      options.StartPositions.rows() != vertexCount || weights.size() != diagram.siteCount() ||
      !weights.allFinite())
  {
    return {};
  }
  PowerDiagram former = diagram;
  return former.update(weights.cast<DoubleDouble>()) ? std::optional(std::move(former)) : std::nullopt;
}

AreaPreservingResult areaPreservingMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const Points2& onDomain, // the same, or another map to the domain, with few faces flipped
  const Target& target,
  const std::vector<int>& loop,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  AreaPreservingMap map;
  map.TargetAreas = targetAreas(mesh, weights);

  const int n = mesh.vertexCount();
  const int perSite = verticesPerSite(options, n);
  TransportSites sites = distinctSites(conformal);
  map.CoincidentVertices = n - sites.count();
  if (perSite > 1)
  {
    // By areas without weights: the sites stay where they are when weights change.
    sites = groupedSites(conformal, targetAreas(mesh, {}), loop, perSite);
  }
  map.Sites = sites.count();
  const Eigen::VectorXd siteTargets = sites.sums(map.TargetAreas);

  PowerDiagram diagram(sites.Positions, target.Domain);
  const double transportEnd = options.RefineFaces ? 0.5 : 0.95;
  TransportOptions transportOptions = options.Transport;
  if (options.Transport.StartWeights.size() == n)
  {
    transportOptions.StartWeights.resize(sites.count());
    for (int v = 0; v < n; ++v)
    {
      transportOptions.StartWeights[sites.SiteOfVertex[v]] = options.Transport.StartWeights[v];
    }
  }
  const std::optional<PowerDiagram> former =
    formerDiagram(diagram, transportOptions.StartWeights, n, options);
  const TransportResult transport =
    transportNewton(diagram, siteTargets, transportOptions, subrange(progress, 0.0, transportEnd));
  map.NewtonIterations = transport.NewtonIterations;
  map.PowerDiagrams = diagram.updates();
  map.MaxCellError = transport.MaxCellError;

  report(progress, transportEnd + 0.01, "Flat positions");
  map.Positions.resize(n, 2);
  map.CellAreas.resize(n);
  map.PowerWeights.resize(n);
  for (int v = 0; v < n; ++v)
  {
    const int site = sites.SiteOfVertex[v];
    map.Positions.row(v) = diagram.centroids().row(site);
    map.CellAreas[v] = diagram.areas()[site] * (map.TargetAreas[v] / siteTargets[site]);
    map.PowerWeights[v] = static_cast<double>(transport.Weights[site]);
  }
  const FixedMembers corners = cornersOf(target, diagram, loop, sites.SiteOfVertex);
  const auto transported = [&](const PowerDiagram& cells) -> TransportedSites
  {
    std::vector<double> places =
      corners.Members.empty()
        ? boundaryParameters(cells, loop, sites.SiteOfVertex)
        : boundaryParameters(cells, loop, sites.SiteOfVertex, corners.Members, corners.Places);
    SiteImages images = siteImages(cells, siteTargets, sites, loop, places);
    return { std::move(images), std::move(places) };
  };
  const TransportedSites present = transported(diagram);
  if (former &&
      isRefinedMap(
        options.StartPositions, mesh.Faces, *target.Domain, loop, corners.Members, corners.Places))
  {
    map.Positions =
      carriedMap(options.StartPositions, sites, transported(*former), present, loop, *target.Domain);
    map.IsContinued =
      countFlippedFaces(map.Positions, mesh.Faces) <= LargestFlippedShare * mesh.faceCount();
  }
  if (!map.IsContinued)
  {
    if (options.RefineFaces)
    {
      map.Positions = interpolateTransport(sites, present.Images, conformal, *target.Domain);
    }
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      map.Positions.row(loop[k]) = target.Domain->at(present.Places[k]);
    }
  }
  for (const int member : corners.Members)
  {
    map.CornerVertices.push_back(loop[member]);
  }
  map.FlippedFaces = countFlippedFaces(map.Positions, mesh.Faces);
  map.Bijective = map.FlippedFaces == 0; // boundaryParameters() are in order
  if (options.RefineFaces)
  {
    refine(map,
      mesh,
      { target.Domain,
        loop,
        corners.Members,
        conformal,
        Points2(map.Positions),
        onDomain,
        map.IsContinued },
      weights,
      options.Refinement,
      subrange(progress, transportEnd + 0.02, 1.0));
  }
  report(progress, 1.0, "Area-preserving map");
  return { std::move(map), std::move(diagram), std::move(sites.SiteOfVertex) };
}

} // namespace

AreaPreservingResult areaPreservingDiskMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  const Target target{ std::make_shared<UnitDisk>(), "disk", "circle around the origin", {} };
  requirePositions(conformal, loop, *target.Domain, target);
  return areaPreservingMap(mesh, conformal, conformal, target, loop, weights, options, progress);
}

AreaPreservingResult areaPreservingRectangleMap(const TriangleMesh& mesh,
  const Points2& conformal,
  double width,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  if (!(width > 0.0) || !std::isfinite(width))
  {
    throw InvalidInput("a rectangle of width " + std::to_string(width) + ": it must be positive");
  }
  const double x = 0.5 * width;
  const double y = 0.5 * EIGEN_PI / width;
  Points2 corners(4, 2);
  corners << -x, -y, x, -y, x, y, -x, y;
  Target target{ std::make_shared<ConvexPolygon>(corners), "rectangle", "sides of the rectangle", {} };
  std::vector<std::pair<int, double>> fixed;
  for (int c = 0; c < 4; ++c)
  {
    const auto nearest = std::min_element(loop.begin(),
      loop.end(),
      [&](int a, int b) {
        return (conformal.row(a) - corners.row(c)).norm() < (conformal.row(b) - corners.row(c)).norm();
      });
    if (!((conformal.row(*nearest) - corners.row(c)).norm() <= BoundaryTolerance))
    {
      throw InvalidInput("no boundary vertex lies in corner " + std::to_string(c) +
                         " of the rectangle: run Conformal Disk with Domain set to Rectangle first");
    }
    fixed.emplace_back(
      static_cast<int>(nearest - loop.begin()), target.Domain->placeOf(corners.row(c).transpose()));
  }
  // In the order of the loop, the places growing over less than a turn.
  std::sort(fixed.begin(), fixed.end());
  for (const auto& [member, place] : fixed)
  {
    const double turn = target.Domain->perimeter();
    target.Corners.Members.push_back(member);
    target.Corners.Places.push_back(place < fixed.front().second ? place + turn : place);
  }
  if (!std::is_sorted(target.Corners.Places.begin(), target.Corners.Places.end()))
  {
    throw InvalidInput("the corners of the rectangle are not in the order of the boundary: the map is "
                       "turned over, run Conformal Disk first");
  }
  requirePositions(conformal, loop, *target.Domain, target);
  return areaPreservingMap(mesh, conformal, conformal, target, loop, weights, options, progress);
}

AreaPreservingResult areaPreservingPolygonMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const ConvexDomain& source,
  const PolygonTarget& polygon,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  const auto domain = std::make_shared<ConvexPolygon>(polygon.Corners);
  Target target{ domain, "disk or rectangle", "boundary of the domain", {} };
  requirePositions(conformal, loop, source, target);
  if (polygon.FixCorners)
  {
    target.Corners.Places = domain->cornerPlaces();
  }
  const double scale = domain->innerRadius() / conformal.rowwise().norm().maxCoeff();
  return areaPreservingMap(mesh,
    scale * conformal,
    carriedAlongRays(conformal, source, *domain),
    target,
    loop,
    weights,
    options,
    progress);
}

} // namespace flattening
