// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/TransportInterpolation.h"

#include "Mesh/PlaneVectors.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/LU>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace flattening
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Triangulation =
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

// Sites or vertices of one task of a thread: large enough to hide the task's overhead. Results do not
// depend on it.
constexpr int PerTask = 512;
// Neighbours whose spread has a determinant below this share of its squared trace lie nearly in a line
// (a thousand times longer than wide), and the slope across it is unknown. A guard against dividing by
// 0.
constexpr double DegenerateSpread = 1e-6;

// Takes a point near From to To + (point - From) * Slope.
struct AffineMap
{
  Eigen::RowVector2d From;
  Eigen::RowVector2d To;
  Eigen::Matrix2d Slope;

  Eigen::RowVector2d operator()(const Eigen::RowVector2d& point) const
  {
    return this->To + (point - this->From) * this->Slope;
  }
};

// The blended affine maps of all sites.
class Field
{
public:
  Field(const TransportSites& sites, const SiteImages& images)
    : Sites(sites)
    , Images(images)
    , Vertices(sites.count())
    , Maps(sites.count())
  {
    this->triangulate();
    tbb::parallel_for(tbb::blocked_range<int>(0, sites.count(), PerTask),
      [&](const tbb::blocked_range<int>& range)
      {
        for (int i = range.begin(); i < range.end(); ++i)
        {
          this->Maps[i] = this->fit(i);
        }
      });
  }

  // The image of a point near @p site.
  Eigen::RowVector2d at(const Eigen::RowVector2d& point, int site) const
  {
    const auto face =
      this->Delaunay.locate(Kernel::Point_2(point.x(), point.y()), this->Vertices[site]->face());
    int corners[3];
    double shares[3] = { 0.0, 0.0, 0.0 };
    int count = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (!this->Delaunay.is_infinite(face->vertex(k)))
      {
        corners[count++] = face->vertex(k)->info();
      }
    }
    const auto side = [&](int k)
    { return Eigen::Vector2d((this->Sites.Positions.row(corners[k % count]) - point).transpose()); };
    if (count == 3)
    {
      for (int k = 0; k < 3; ++k)
      {
        shares[k] = std::max(0.0, cross(side(k + 1), side(k + 2)));
      }
    }
    else // outside the hull: shares of the nearest point of its edge
    {
      const Eigen::Vector2d edge = side(1) - side(0);
      const double along = std::clamp(-side(0).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      shares[0] = 1.0 - along;
      shares[1] = along;
    }
    const double sum = shares[0] + shares[1] + shares[2];
    if (!(sum > 0.0))
    {
      return this->Maps[site](point);
    }
    Eigen::RowVector2d result = Eigen::RowVector2d::Zero();
    for (int k = 0; k < count; ++k)
    {
      result += (shares[k] / sum) * this->Maps[corners[k]](point);
    }
    return result;
  }

private:
  void triangulate()
  {
    std::vector<std::pair<Kernel::Point_2, int>> points;
    points.reserve(this->Sites.count());
    for (int i = 0; i < this->Sites.count(); ++i)
    {
      points.emplace_back(Kernel::Point_2(this->Sites.Positions(i, 0), this->Sites.Positions(i, 1)), i);
    }
    this->Delaunay.insert(points.begin(), points.end());
    for (const auto vertex : this->Delaunay.finite_vertex_handles())
    {
      this->Vertices[vertex->info()] = vertex;
    }
  }

  // A site and its neighbours, ascending.
  std::vector<int> star(int site) const
  {
    std::vector<int> star{ site };
    const auto first = this->Delaunay.incident_vertices(this->Vertices[site]);
    auto neighbour = first;
    do
    {
      if (!this->Delaunay.is_infinite(neighbour))
      {
        star.push_back(neighbour->info());
      }
    } while (++neighbour != first);
    std::sort(star.begin(), star.end());
    return star;
  }

  AffineMap fit(int site) const
  {
    const std::vector<int> star = this->star(site);
    double mass = 0.0;
    AffineMap map{ Eigen::RowVector2d::Zero(), Eigen::RowVector2d::Zero(), Eigen::Matrix2d::Zero() };
    for (const int u : star)
    {
      mass += this->Images.Masses[u];
      map.From += this->Images.Masses[u] * this->Sites.Positions.row(u);
      map.To += this->Images.Masses[u] * this->Images.Positions.row(u);
    }
    map.From /= mass;
    map.To /= mass;
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (const int u : star)
    {
      const Eigen::RowVector2d offset = this->Sites.Positions.row(u) - map.From;
      spread += this->Images.Masses[u] * offset.transpose() * offset;
      moments += this->Images.Masses[u] * offset.transpose() * (this->Images.Positions.row(u) - map.To);
    }
    const double trace = spread.trace();
    const bool hasSlope = spread.determinant() > DegenerateSpread * trace * trace;
    if (hasSlope)
    {
      map.Slope = spread.inverse() * moments;
    }
    if (!hasSlope || this->Images.OnBoundary[site])
    {
      map.From = this->Sites.Positions.row(site);
      map.To = this->Images.Positions.row(site);
    }
    return map;
  }

  const TransportSites& Sites;
  const SiteImages& Images;
  Triangulation Delaunay;
  std::vector<Triangulation::Vertex_handle> Vertices;
  std::vector<AffineMap> Maps;
};

} // namespace

SiteImages siteImages(const PowerDiagram& diagram,
  const Eigen::VectorXd& masses,
  const TransportSites& sites,
  const BoundaryLoop& boundary)
{
  SiteImages images{ masses,
    diagram.centroids(),
    std::vector<char>(sites.count(), 0),
    boundaryParameters(diagram, boundary, sites.SiteOfVertex) };
  for (std::size_t k = 0; k < boundary.Vertices.size(); ++k)
  {
    const int site = sites.SiteOfVertex[boundary.Vertices[k]];
    images.Positions.row(site) = diagram.domain().at(images.BoundaryParameters[k]);
    images.OnBoundary[site] = 1;
  }
  return images;
}

Points2 interpolateTransport(const TransportSites& sites,
  const SiteImages& images,
  const Points2& positions,
  const ConvexDomain& domain)
{
  const Field field(sites, images);
  Points2 result(positions.rows(), 2);
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(positions.rows()), PerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        const Eigen::Vector2d point = field.at(positions.row(v), sites.SiteOfVertex[v]).transpose();
        result.row(v) =
          (domain.contains(point) ? point : domain.at(domain.parameterOf(point))).transpose();
      }
    });
  return result;
}

} // namespace flattening
