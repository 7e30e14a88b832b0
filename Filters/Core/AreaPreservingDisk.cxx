// SPDX-License-Identifier: GPL-3.0-or-later
#include "AreaPreservingDisk.h"

#include "BoundaryPlacement.h"
#include "Errors.h"
#include "FaceOrientation.h"
#include "MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace flattening
{
namespace
{

// How far from the circle a boundary vertex of the input may lie, relative to the radius.
constexpr double CircleTolerance = 1e-6;

void requireDiskPositions(const Points2& positions, const std::vector<int>& loop)
{
  for (const int v : loop)
  {
    if (!(std::abs(positions.row(v).norm() - 1.0) <= CircleTolerance))
    {
      throw InvalidInput("boundary vertex " + std::to_string(v) +
                         " does not lie on the circle around the origin: "
                         "the input must be a map to the disk, run Conformal Disk first");
    }
  }
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    if (!(positions.row(v).norm() <= 1.0 + CircleTolerance))
    {
      throw InvalidInput(
        "vertex " + std::to_string(v) +
        " lies outside of the disk: the input must be a map to the disk, run Conformal Disk first");
    }
  }
}

struct Sites
{
  Points2 Positions;
  std::vector<int> SiteOfVertex;
};

// Vertices at the very same place are one site.
Sites distinctSites(const Points2& positions)
{
  const int n = static_cast<int>(positions.rows());
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  const auto before = [&positions](int a, int b)
  {
    return positions(a, 0) != positions(b, 0) ? positions(a, 0) < positions(b, 0)
                                              : positions(a, 1) < positions(b, 1);
  };
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<int> representative(n);
  for (int k = 0; k < n; ++k)
  {
    const bool same = k > 0 && !before(order[k - 1], order[k]);
    representative[order[k]] = same ? representative[order[k - 1]] : order[k];
  }
  Sites sites;
  sites.SiteOfVertex.resize(n);
  sites.Positions.resize(n, 2);
  int count = 0;
  for (int v = 0; v < n; ++v) // the lowest vertex of each place comes first: the sort is stable
  {
    if (representative[v] == v)
    {
      sites.Positions.row(count) = positions.row(v);
      sites.SiteOfVertex[v] = count++;
    }
    else
    {
      sites.SiteOfVertex[v] = sites.SiteOfVertex[representative[v]];
    }
  }
  sites.Positions.conservativeResize(count, 2);
  return sites;
}

} // namespace

Eigen::VectorXd targetAreas(const TriangleMesh& mesh, const Eigen::VectorXd& weights)
{
  Eigen::VectorXd targets =
    vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!(targets[v] > 0.0))
    {
      throw InvalidInput("vertex " + std::to_string(v) +
                         " has no area, all of its triangles are degenerate: run Surface To Disk first");
    }
    if (weights.size() > 0)
    {
      if (!(weights[v] > 0.0) || !std::isfinite(weights[v]))
      {
        throw InvalidInput("the area weight of vertex " + std::to_string(v) + " is " +
                           std::to_string(weights[v]) + ": weights must be positive, finite numbers");
      }
      targets[v] *= weights[v];
    }
  }
  return targets * (EIGEN_PI / targets.sum());
}

AreaPreservingResult areaPreservingDiskMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const Eigen::VectorXd& weights,
  const TransportOptions& options,
  const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(mesh);
  requireDiskPositions(conformal, loop);
  AreaPreservingMap map;
  map.TargetAreas = targetAreas(mesh, weights);

  Sites sites = distinctSites(conformal);
  const int n = mesh.vertexCount();
  map.CoincidentVertices = n - static_cast<int>(sites.Positions.rows());
  Eigen::VectorXd siteTargets = Eigen::VectorXd::Zero(sites.Positions.rows());
  for (int v = 0; v < n; ++v)
  {
    siteTargets[sites.SiteOfVertex[v]] += map.TargetAreas[v];
  }

  PowerDiagram diagram(sites.Positions);
  const TransportResult transport =
    transportNewton(diagram, siteTargets, options, subrange(progress, 0.0, 0.95));
  map.NewtonIterations = transport.NewtonIterations;
  map.PowerDiagrams = diagram.updates();
  map.MaxCellError = transport.MaxCellError;

  report(progress, 0.97, "Flat positions");
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
  const std::vector<double> angles = boundaryAngles(diagram, loop, sites.SiteOfVertex);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    map.Positions.row(loop[k]) << std::cos(angles[k]), std::sin(angles[k]);
  }
  map.FlippedFaces = countFlippedFaces(map.Positions, mesh.Faces);
  report(progress, 1.0, "Area-preserving disk");
  return { std::move(map), std::move(diagram), std::move(sites.SiteOfVertex) };
}

} // namespace flattening
