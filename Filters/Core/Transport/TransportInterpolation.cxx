// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/TransportInterpolation.h"

#include "Mesh/VertexFaces.h"

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

constexpr int PerTask = 512;
// Of the squared trace of the neighbours' spread: its determinant, where they lie in a line.
constexpr double DegenerateSpread = 1e-6;

double crossProduct(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// Takes a place near From to To + (place - From) * Slope.
struct AffineMap
{
  Eigen::RowVector2d From;
  Eigen::RowVector2d To;
  Eigen::Matrix2d Slope;

  Eigen::RowVector2d operator()(const Eigen::RowVector2d& place) const
  {
    return this->To + (place - this->From) * this->Slope;
  }
};

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
    FaceMatrix faces(static_cast<Eigen::Index>(this->Sheet.number_of_faces()), 3);
    Eigen::Index row = 0;
    for (const auto face : this->Sheet.finite_face_handles())
    {
      for (int k = 0; k < 3; ++k)
      {
        faces(row, k) = face->vertex(k)->info();
      }
      ++row;
    }
    const VertexFaces facesOf(faces, sites.count());
    tbb::parallel_for(tbb::blocked_range<int>(0, sites.count(), PerTask),
      [&](const tbb::blocked_range<int>& range)
      {
        for (int i = range.begin(); i < range.end(); ++i)
        {
          this->Maps[i] = this->fit(i, faces, facesOf);
        }
      });
  }

  // Of a vertex that belongs to a site.
  Eigen::RowVector2d at(const Eigen::RowVector2d& place, int site) const
  {
    const auto face =
      this->Sheet.locate(Kernel::Point_2(place.x(), place.y()), this->Vertices[site]->face());
    int corners[3];
    double shares[3] = { 0.0, 0.0, 0.0 };
    int count = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (!this->Sheet.is_infinite(face->vertex(k)))
      {
        corners[count++] = face->vertex(k)->info();
      }
    }
    const auto side = [&](int k)
    { return Eigen::RowVector2d(this->Sites.Positions.row(corners[k % count]) - place); };
    if (count == 3)
    {
      for (int k = 0; k < 3; ++k)
      {
        shares[k] = std::max(0.0, crossProduct(side(k + 1), side(k + 2)));
      }
    }
    else // beyond the hull: as the nearest point of its edge
    {
      const Eigen::RowVector2d edge = side(1) - side(0);
      const double along = std::clamp(-side(0).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      shares[0] = 1.0 - along;
      shares[1] = along;
    }
    const double sum = shares[0] + shares[1] + shares[2];
    if (!(sum > 0.0))
    {
      return this->Maps[site](place);
    }
    Eigen::RowVector2d result = Eigen::RowVector2d::Zero();
    for (int k = 0; k < count; ++k)
    {
      result += (shares[k] / sum) * this->Maps[corners[k]](place);
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
    this->Sheet.insert(points.begin(), points.end());
    for (const auto vertex : this->Sheet.finite_vertex_handles())
    {
      this->Vertices[vertex->info()] = vertex;
    }
  }

  AffineMap fit(int site, const FaceMatrix& faces, const VertexFaces& facesOf) const
  {
    std::vector<int> star{ site };
    for (const int f : facesOf[site])
    {
      star.insert(star.end(), { faces(f, 0), faces(f, 1), faces(f, 2) });
    }
    std::sort(star.begin(), star.end());
    star.erase(std::unique(star.begin(), star.end()), star.end());
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
    if (spread.determinant() > DegenerateSpread * trace * trace)
    {
      map.Slope = spread.inverse() * moments;
    }
    else
    {
      map.From = this->Sites.Positions.row(site);
      map.To = this->Images.Positions.row(site);
    }
    if (this->Images.OnBoundary[site])
    {
      map.From = this->Sites.Positions.row(site);
      map.To = this->Images.Positions.row(site);
    }
    return map;
  }

  const TransportSites& Sites;
  const SiteImages& Images;
  Triangulation Sheet;
  std::vector<Triangulation::Vertex_handle> Vertices;
  std::vector<AffineMap> Maps;
};

} // namespace

SiteImages siteImages(const PowerDiagram& diagram,
  const Eigen::VectorXd& masses,
  const TransportSites& sites,
  const std::vector<int>& loop,
  const std::vector<double>& places)
{
  SiteImages images{ masses, diagram.centroids(), std::vector<char>(sites.count(), 0) };
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const int site = sites.SiteOfVertex[loop[k]];
    images.Positions.row(site) = diagram.domain().at(places[k]);
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
        const Eigen::Vector2d place = field.at(positions.row(v), sites.SiteOfVertex[v]).transpose();
        result.row(v) = (domain.contains(place) ? place : domain.at(domain.placeOf(place))).transpose();
      }
    });
  return result;
}

} // namespace flattening
