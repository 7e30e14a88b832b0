// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/PowerDiagram.h"

#include "Mesh/Halfedges.h"
#include "Mesh/PlaneVectors.h"
#include "Transport/PowerTriangulation.h"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace flattening
{
PowerDiagram::PowerDiagram(const Points2& sites, std::shared_ptr<const ConvexDomain> domain)
  : Domain(std::move(domain))
  , Sites(sites)
  , Order(sites.rows())
{
  std::vector<SiteKernel::Point_2> points;
  points.reserve(sites.rows());
  for (Eigen::Index i = 0; i < sites.rows(); ++i)
  {
    points.emplace_back(sites(i, 0), sites(i, 1));
  }
  std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
  using Traits = CGAL::Spatial_sort_traits_adapter_2<SiteKernel,
    CGAL::Pointer_property_map<SiteKernel::Point_2>::type>;
  CGAL::spatial_sort(this->Order.begin(), this->Order.end(), Traits(CGAL::make_property_map(points)));
}

bool PowerDiagram::update(const Weights& weights, int largestHidden)
{
  ++this->Updates;
  this->SiteWeights = weights;
  if (!this->triangulate(largestHidden))
  {
    return false;
  }
  this->placeCentres();
  this->measureHidden();
  this->clipSides();
  this->measureCells();
  return true;
}

double PowerDiagram::weightDifference(int from, int to) const
{
  return static_cast<double>(this->SiteWeights[to] - this->SiteWeights[from]);
}

bool PowerDiagram::triangulate(int largestHidden)
{
  PowerTriangulation triangulation;
  PowerTriangulation::Face_handle hint;
  for (const std::size_t i : this->Order)
  {
    const auto vertex = triangulation.insert(
      WeightedSite(this->Sites(i, 0), this->Sites(i, 1), this->SiteWeights[i]), hint);
    vertex->info() = static_cast<int>(i);
    // A hidden site stays hidden: further sites only make the cells smaller.
    if (static_cast<int>(triangulation.number_of_hidden_vertices()) > largestHidden)
    {
      return false;
    }
    hint = vertex->face();
  }
  if (triangulation.dimension() < 2)
  {
    return false;
  }

  int faces = 0;
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
  {
    face->info() = triangulation.is_infinite(face) ? -1 : faces++;
  }
  this->HiddenSites.clear();
  this->HiddenIn.clear();
  for (auto vertex = triangulation.hidden_vertices_begin();
       vertex != triangulation.hidden_vertices_end();
       ++vertex)
  {
    this->HiddenSites.push_back({ vertex->info(), 0.0 });
    this->HiddenIn.push_back(vertex->face()->info());
  }
  this->Origins.resize(3 * faces);
  this->Twins.resize(3 * faces);
  this->Outgoing.assign(this->siteCount(), -1);
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face)
  {
    const int f = face->info();
    for (int k = 0; k < 3; ++k)
    {
      // Side k runs from vertex k to vertex k + 1; CGAL numbers it by the vertex opposite.
      const int opposite = (k + 2) % 3;
      const auto neighbour = face->neighbor(opposite);
      const int h = 3 * f + k;
      this->Origins[h] = face->vertex(k)->info();
      this->Twins[h] = neighbour->info() < 0
                         ? -1
                         : 3 * neighbour->info() + (triangulation.mirror_index(face, opposite) + 1) % 3;
    }
  }
  for (int h = 0; h < 3 * faces; ++h)
  {
    int& entry = this->Outgoing[this->Origins[h]];
    if (entry < 0 || this->Twins[h] < 0)
    {
      entry = h;
    }
  }
  return true;
}

double PowerDiagram::squaredLength(int halfedge) const
{
  return (
    this->Sites.row(this->Origins[halfedge]) - this->Sites.row(this->Origins[nextHalfedge(halfedge)]))
    .squaredNorm();
}

void PowerDiagram::placeCentres()
{
  const int faces = static_cast<int>(this->Origins.size() / 3);
  this->Centres.resize(faces);
  tbb::parallel_for(0,
    faces,
    [this](int f)
    {
      // Relative to an end of the shortest side, whose vector then has no rounding error.
      int shortest = 3 * f;
      for (const int h : { 3 * f + 1, 3 * f + 2 })
      {
        shortest = this->squaredLength(h) < this->squaredLength(shortest) ? h : shortest;
      }
      const int i = this->Origins[shortest];
      const int j = this->Origins[nextHalfedge(shortest)];
      const int k = this->Origins[previousHalfedge(shortest)];
      const Eigen::Vector2d origin = this->Sites.row(i);
      const Eigen::Vector2d a = this->Sites.row(j).transpose() - origin;
      const Eigen::Vector2d b = this->Sites.row(k).transpose() - origin;
      const double p = 0.5 * (a.squaredNorm() - this->weightDifference(i, j));
      const double q = 0.5 * (b.squaredNorm() - this->weightDifference(i, k));
      const double determinant = cross(a, b);
      this->Centres[f] =
        origin + Eigen::Vector2d(p * b.y() - q * a.y(), q * a.x() - p * b.x()) / determinant;
    });
}

// A hidden site is nearest to having a cell at the point of equal power of the face that covers it.
void PowerDiagram::measureHidden()
{
  for (std::size_t k = 0; k < this->HiddenSites.size(); ++k)
  {
    HiddenSite& hidden = this->HiddenSites[k];
    const int corner = this->Origins[3 * this->HiddenIn[k]];
    const Eigen::Vector2d origin = this->Sites.row(corner);
    const Eigen::Vector2d away = this->Sites.row(hidden.Site).transpose() - origin;
    const double lacking = away.squaredNorm() -
                           2.0 * away.dot(this->Centres[this->HiddenIn[k]] - origin) -
                           this->weightDifference(corner, hidden.Site);
    hidden.Lacking = std::max(0.0, lacking);
  }
}

void PowerDiagram::clipSides()
{
  const int halfedges = static_cast<int>(this->Origins.size());
  this->Segments.resize(halfedges);
  tbb::parallel_for(0,
    halfedges,
    [this](int h)
    {
      const int t = this->Twins[h];
      if (t >= 0 && t < h)
      {
        return;
      }
      // The side of the cell of h's origin runs from the centre of the face on the right of h to the one
      // of the face on the left.
      Segment& side = this->Segments[h];
      constexpr double far = std::numeric_limits<double>::infinity();
      const Eigen::Vector2d& left = this->Centres[h / 3];
      const Eigen::Vector2d& right = t < 0 ? left : this->Centres[t / 3];
      side = { right, left, false, false, true };
      if (t >= 0 && this->Domain->contains(left) && this->Domain->contains(right))
      {
        return;
      }
      const int i = this->Origins[h];
      const int j = this->Origins[nextHalfedge(h)];
      const Eigen::Vector2d origin = this->Sites.row(i);
      Eigen::Vector2d along = this->Sites.row(j).transpose() - origin;
      const double distance = along.norm();
      along /= distance;
      const double offset = 0.5 * (distance - this->weightDifference(i, j) / distance);
      const Eigen::Vector2d middle = origin + offset * along;
      const Eigen::Vector2d normal(-along.y(), along.x());
      ConvexDomain::Chord chord;
      if (!this->Domain->cross(middle, normal, chord))
      {
        side.Inside = false;
        return;
      }
      const double first = t < 0 ? -far : (right - middle).dot(normal);
      const double last = (left - middle).dot(normal);
      if (first < chord.EnterAt)
      {
        side.From = chord.Enter;
        side.FromOnBoundary = true;
      }
      if (last > chord.LeaveAt)
      {
        side.To = chord.Leave;
        side.ToOnBoundary = true;
      }
      side.Inside = std::max(first, chord.EnterAt) < std::min(last, chord.LeaveAt);
    });

  this->Sides.clear();
  for (int h = 0; h < halfedges; ++h)
  {
    if ((this->Twins[h] < 0 || h < this->Twins[h]) && this->Segments[h].Inside)
    {
      const int i = this->Origins[h];
      const int j = this->Origins[nextHalfedge(h)];
      this->Sides.push_back({ i,
        j,
        (this->Segments[h].To - this->Segments[h].From).norm(),
        (this->Sites.row(i) - this->Sites.row(j)).norm() });
    }
  }
}

PowerDiagram::Segment PowerDiagram::sideOf(int site, int halfedge) const
{
  const int t = this->Twins[halfedge];
  Segment side = this->Segments[t >= 0 ? std::min(halfedge, t) : halfedge];
  if (t >= 0 && t < halfedge ? this->Origins[t] != site : this->Origins[halfedge] != site)
  {
    std::swap(side.From, side.To);
    std::swap(side.FromOnBoundary, side.ToOnBoundary);
  }
  return side;
}

// The straight sides of a cell inside the domain, counter-clockwise.
void PowerDiagram::sidesOf(int site, std::vector<Segment>& sides) const
{
  sides.clear();
  const auto add = [&](int halfedge)
  {
    const Segment side = this->sideOf(site, halfedge);
    if (side.Inside)
    {
      sides.push_back(side);
    }
  };
  const int start = this->Outgoing[site];
  for (int h = start; h >= 0;)
  {
    add(h);
    const int arriving = previousHalfedge(h);
    h = this->Twins[arriving];
    if (h < 0)
    {
      add(arriving);
    }
    if (h == start)
    {
      break;
    }
  }
}

bool PowerDiagram::coversDomain(int site) const
{
  // No side crosses the domain, so that any of its points decides.
  const Eigen::RowVector2d point = this->Domain->centroid();
  const auto power = [this, &point](int i)
  { return DoubleDouble((this->Sites.row(i) - point).squaredNorm()) - this->SiteWeights[i]; };
  for (int i = 0; i < this->siteCount(); ++i)
  {
    if (power(i) < power(site))
    {
      return false;
    }
  }
  return true;
}

void PowerDiagram::measureCells()
{
  this->Areas.setZero(this->siteCount());
  this->Centroids = this->Sites;
  tbb::parallel_for(tbb::blocked_range<int>(0, this->siteCount(), 512),
    [this](const tbb::blocked_range<int>& range)
    {
      std::vector<Segment> sides;
      for (int i = range.begin(); i < range.end(); ++i)
      {
        this->sidesOf(i, sides);
        if (sides.empty())
        {
          if (this->Outgoing[i] >= 0 && this->coversDomain(i))
          {
            this->Areas[i] = this->Domain->area();
            this->Centroids.row(i) = this->Domain->centroid();
          }
          continue;
        }
        ArcPolygonMoments region(sides.front().From);
        for (std::size_t s = 0; s < sides.size(); ++s)
        {
          const Segment& side = sides[s];
          const Segment& following = sides[(s + 1) % sides.size()];
          region.addSide(side.From, side.To);
          if (side.ToOnBoundary && following.FromOnBoundary)
          {
            this->Domain->addBoundary(side.To, following.From, region);
          }
          else if (side.To != following.From)
          {
            region.addSide(side.To, following.From);
          }
        }
        this->Areas[i] = region.area();
        if (region.area() > 0.0)
        {
          this->Centroids.row(i) = region.centroid();
        }
      }
    });
}

PowerDiagram::BoundaryPart PowerDiagram::boundaryPart(int site) const
{
  std::vector<Segment> sides;
  this->sidesOf(site, sides);
  BoundaryPart longest;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const Segment& following = sides[(s + 1) % sides.size()];
    if (sides[s].ToOnBoundary && following.FromOnBoundary)
    {
      const double length = this->Domain->distanceAlong(sides[s].To, following.From);
      if (length > longest.Length)
      {
        longest = { this->Domain->parameterOf(sides[s].To) + 0.5 * length, length };
      }
    }
  }
  return longest;
}

std::vector<Eigen::Vector2d> PowerDiagram::outline(int site, double maximumStep) const
{
  std::vector<Segment> sides;
  this->sidesOf(site, sides);
  if (sides.empty() && this->Areas[site] > 0.0)
  {
    return this->Domain->outline(maximumStep);
  }
  std::vector<Eigen::Vector2d> outline;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const Segment& following = sides[(s + 1) % sides.size()];
    outline.push_back(sides[s].From);
    if (sides[s].To != following.From)
    {
      outline.push_back(sides[s].To);
    }
    if (sides[s].ToOnBoundary && following.FromOnBoundary)
    {
      const auto between = this->Domain->pointsBetween(sides[s].To, following.From, maximumStep);
      outline.insert(outline.end(), between.begin(), between.end());
    }
  }
  return outline;
}

} // namespace flattening
