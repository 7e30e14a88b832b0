// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/RegionExtent.h"

#include "Base/EigenVersions.h"
#include "Base/Progress.h"
#include "Geodesics/GeodesicDistance.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace flattening
{
namespace
{

// The number of boundary points from which the search for the diameter starts. With fewer, the search
// may end at a diameter that is not the greatest.
constexpr int Starts = 4;
// The greatest number of steps to the farthest point from each start. A guard: the search stops as soon
// as the distance no longer grows.
constexpr int Sweeps = 4;
// The number of boundary vertices that are compared with each other for the pair that is farthest apart
// in space. A guard on the time.
constexpr std::size_t MostCompared = 1000;
// The number of parts of the diameter between which the extent across is measured, before the best level
// is refined. With fewer, a narrow bulge may be missed.
constexpr int Levels = 15;
// The number of smoothing steps of the boundary: waves of up to four edges vanish, those of ten or more
// stay. PerimeterError measures what more steps would change.
constexpr int SmoothingSteps = 12;

constexpr const char* DiameterStage = "Greatest diameter";
constexpr const char* AcrossStage = "Greatest extent across";

SurfaceCurve curveOf(const SurfaceMesh& mesh, const GeodesicPath& path)
{
  SurfaceCurve curve;
  curve.Length = path.Length;
  for (const PathPoint& point : path.Points)
  {
    if (point.isVertex())
    {
      const int v = static_cast<int>(point.Vertex);
      curve.Points.push_back({ v, v, 0.0 });
    }
    else
    {
      curve.Points.push_back({ static_cast<int>(mesh.source(point.Edge)),
        static_cast<int>(mesh.target(point.Edge)),
        point.Fraction });
    }
  }
  return curve;
}

// The boundary without the teeth of its triangles: waves of up to four edges vanish, those of ten or
// more stay, and the curve does not shrink (Taubin 1995, "Curve and surface smoothing without
// shrinkage").
Points3 smoothed(const Points3& vertices, const std::vector<int>& loop, int steps)
{
  Points3 points = vertices(loop, flattening::all);
  const auto n = points.rows();
  for (int step = 0; step < 2 * steps; ++step)
  {
    const double factor = step % 2 == 0 ? 0.5 : -0.53;
    Points3 next(n, 3);
    for (Eigen::Index i = 0; i < n; ++i)
    {
      next.row(i) = (1.0 - factor) * points.row(i) +
                    0.5 * factor * (points.row((i + n - 1) % n) + points.row((i + 1) % n));
    }
    points = next;
  }
  return points;
}

double closedLength(const Points3& points)
{
  double length = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    length += (points.row((i + 1) % points.rows()) - points.row(i)).norm();
  }
  return length;
}

Eigen::RowVector3d positionOf(const Points3& vertices, const EdgePoint& point)
{
  return (1.0 - point.Fraction) * vertices.row(point.From) + point.Fraction * vertices.row(point.To);
}

// The length of a curve less those by which its two ends exceed the smoothed boundary; 0 if these are
// longer, as on regions of a few triangles.
// @param amid the vertices (n x 3), where those of the boundary lie on the smoothed boundary.
double withoutOverhang(double length,
  const Points3& vertices,
  const Points3& amid,
  const SurfaceCurve& curve)
{
  const std::size_t last = curve.Points.size() - 1;
  for (const auto& [end, next] :
    { std::pair(curve.Points[0], curve.Points[std::min<std::size_t>(1, last)]),
      std::pair(curve.Points[last], curve.Points[last > 0 ? last - 1 : 0]) })
  {
    const Eigen::RowVector3d outward =
      (positionOf(vertices, end) - positionOf(vertices, next)).stableNormalized();
    length -= (vertices.row(end.From) - amid.row(end.From)).dot(outward);
  }
  return std::max(length, 0.0);
}

Points3 withSmoothed(const Points3& vertices, const std::vector<int>& loop)
{
  Points3 amid = vertices;
  amid(loop, flattening::all) = smoothed(vertices, loop, SmoothingSteps);
  return amid;
}

// Measures the geodesics of a region.
class Calliper
{
public:
  Calliper(const TriangleMesh& region, std::vector<int> loop)
    : Region(region)
    , Loop(std::move(loop))
    , Mesh(toSurfaceMesh(region))
    , Amid(withSmoothed(region.Vertices, this->Loop))
  {
  }

  // The geodesic between two vertices, with its length up to the smoothed boundary.
  SurfaceCurve path(int from, int to, const ProgressCallback& progress) const
  {
    SurfaceCurve curve = curveOf(this->Mesh,
      geodesicPath(this->Mesh,
        SurfaceMesh::Vertex_index(static_cast<unsigned>(from)),
        SurfaceMesh::Vertex_index(static_cast<unsigned>(to)),
        progress));
    curve.Length = withoutOverhang(curve.Length, this->Region.Vertices, this->Amid, curve);
    return curve;
  }

  // The longest geodesic that is found; stores its ends.
  SurfaceCurve diameter(const ProgressCallback& progress)
  {
    std::set<std::pair<int, int>> pairs;
    for (int start = 0; start < Starts; ++start)
    {
      int from = this->Loop[start * this->Loop.size() / Starts];
      double before = 0.0;
      for (int sweep = 0; sweep < Sweeps; ++sweep)
      {
        const double done = 0.4 * (start + static_cast<double>(sweep) / Sweeps) / Starts;
        Eigen::Index to = 0;
        const double length =
          geodesicDistances(this->Region, from, atFraction(progress, done, DiameterStage)).maxCoeff(&to);
        if (length <= before)
        {
          break;
        }
        before = length;
        this->Ends = { std::min(from, static_cast<int>(to)), std::max(from, static_cast<int>(to)) };
        from = static_cast<int>(to);
      }
      pairs.insert(this->Ends);
    }
    pairs.insert(this->farthestApart());
    SurfaceCurve longest;
    for (const auto& [from, to] : pairs)
    {
      SurfaceCurve curve = this->path(from, to, atFraction(progress, 0.4, DiameterStage));
      if (curve.Length > longest.Length)
      {
        longest = std::move(curve);
        this->Ends = { from, to };
      }
    }
    return this->lengthened(std::move(longest), subrange(progress, 0.4, 1.0));
  }

  // The longest geodesic across the diameter, which must have been found before.
  SurfaceCurve across(const ProgressCallback& progress) const
  {
    const ProgressCallback atFirst = atFraction(progress, 0.0, AcrossStage);
    const Eigen::VectorXd fromFirst = geodesicDistances(this->Region, this->Ends.first, atFirst);
    const Eigen::VectorXd fromSecond = geodesicDistances(this->Region, this->Ends.second, atFirst);
    const Eigen::VectorXd along = fromFirst - fromSecond;
    const std::size_t first = this->nearestOnLoop(fromFirst);
    std::size_t second = this->nearestOnLoop(fromSecond);
    if (first == second) // the ends lie inside and nothing parts the boundary: take its halves
    {
      second = (first + this->Loop.size() / 2) % this->Loop.size();
    }
    const std::array<std::vector<int>, 2> sides{ this->between(first, second),
      this->between(second, first) };
    SurfaceCurve longest;
    if (sides[0].empty() || sides[1].empty())
    {
      return longest;
    }
    // @param level from -1 at one end of the diameter to 1 at the other.
    const auto tryLevel = [&](double level, double done)
    {
      const double value = level * fromFirst[this->Ends.second];
      const auto nearest = [&](const std::vector<int>& side)
      {
        return *std::min_element(side.begin(),
          side.end(),
          [&](int a, int b) { return std::abs(along[a] - value) < std::abs(along[b] - value); });
      };
      SurfaceCurve curve =
        this->path(nearest(sides[0]), nearest(sides[1]), atFraction(progress, done, AcrossStage));
      const bool isLonger = curve.Length > longest.Length;
      longest = isLonger ? std::move(curve) : longest;
      return isLonger;
    };
    double best = 0.0;
    for (int level = 1; level < Levels; ++level)
    {
      const double done = static_cast<double>(level) / Levels;
      const double place = 2.0 * done - 1.0;
      best = tryLevel(place, done) ? place : best;
    }
    for (double step = 1.0 / Levels; step > 0.25 / Levels; step *= 0.5)
    {
      const double middle = best;
      best = tryLevel(middle - step, 1.0) ? middle - step : best;
      best = tryLevel(middle + step, 1.0) ? middle + step : best;
    }
    return longest;
  }

private:
  // The two boundary vertices that are farthest apart in space, less their distances from the smoothed
  // boundary, among many spread along the boundary.
  std::pair<int, int> farthestApart() const
  {
    const std::size_t stride = 1 + this->Loop.size() / MostCompared;
    const auto moved = [this](int v)
    { return (this->Region.Vertices.row(v) - this->Amid.row(v)).norm(); };
    std::pair<int, int> farthest{ this->Loop.front(), this->Loop.back() };
    double greatest = 0.0;
    for (std::size_t i = 0; i < this->Loop.size(); i += stride)
    {
      for (std::size_t j = 0; j < i; j += stride)
      {
        const int a = this->Loop[i];
        const int b = this->Loop[j];
        const double distance =
          (this->Region.Vertices.row(a) - this->Region.Vertices.row(b)).norm() - moved(a) - moved(b);
        if (distance > greatest)
        {
          greatest = distance;
          farthest = std::minmax(a, b);
        }
      }
    }
    return farthest;
  }

  // The diameter after moving its ends along the boundary as long as it grows.
  SurfaceCurve lengthened(SurfaceCurve longest, const ProgressCallback& progress)
  {
    int tries = 0;
    const auto size = static_cast<std::ptrdiff_t>(this->Loop.size());
    // Near the maximum, a small move changes the length by its square only.
    const std::ptrdiff_t smallest = std::max<std::ptrdiff_t>(size / 100, 1);
    for (std::ptrdiff_t step = std::max<std::ptrdiff_t>(size / 16, 1); step >= smallest; step /= 2)
    {
      for (int* end : { &this->Ends.first, &this->Ends.second })
      {
        for (const std::ptrdiff_t move : { step, size - step })
        {
          const auto place = std::find(this->Loop.begin(), this->Loop.end(), *end);
          if (place == this->Loop.end())
          {
            continue; // the end is an interior vertex
          }
          const double done = 1.0 - 1.0 / (1.0 + tries++); // the number of tries is not known
          const int before = *end;
          *end = this->Loop[(place - this->Loop.begin() + move) % size];
          SurfaceCurve curve =
            this->Ends.first == this->Ends.second
              ? SurfaceCurve()
              : this->path(
                  this->Ends.first, this->Ends.second, atFraction(progress, done, DiameterStage));
          if (curve.Length > longest.Length)
          {
            longest = std::move(curve);
          }
          else
          {
            *end = before;
          }
        }
      }
    }
    return longest;
  }

  // The index of the boundary vertex of the smallest distance.
  std::size_t nearestOnLoop(const Eigen::VectorXd& distance) const
  {
    return std::min_element(this->Loop.begin(),
             this->Loop.end(),
             [&](int a, int b) { return distance[a] < distance[b]; }) -
           this->Loop.begin();
  }

  // The boundary vertices strictly between two indices.
  std::vector<int> between(std::size_t from, std::size_t to) const
  {
    std::vector<int> side;
    for (std::size_t i = (from + 1) % this->Loop.size(); i != to; i = (i + 1) % this->Loop.size())
    {
      side.push_back(this->Loop[i]);
    }
    return side;
  }

  const TriangleMesh& Region;
  std::vector<int> Loop;
  SurfaceMesh Mesh;
  Points3 Amid; // the vertices, where those of the boundary lie on the smoothed boundary
  std::pair<int, int> Ends{ 0, 0 };
};

} // namespace

RegionExtent regionExtent(const TriangleMesh& region, const ProgressCallback& progress)
{
  const std::vector<int> loop = requireDisk(region);
  RegionExtent extent;
  Calliper calliper(region, loop);
  extent.Diameter = calliper.diameter(subrange(progress, 0.0, 0.6));
  extent.Across = calliper.across(subrange(progress, 0.6, 1.0));
  for (const int v : loop)
  {
    extent.Outline.Points.push_back({ v, v, 0.0 });
  }
  extent.Outline.Points.push_back(extent.Outline.Points.front());
  const auto perimeter = [&](int steps) { return closedLength(smoothed(region.Vertices, loop, steps)); };
  extent.Outline.Length = perimeter(0);
  extent.EdgeLength = extent.Outline.Length / static_cast<double>(loop.size());
  extent.Perimeter = perimeter(SmoothingSteps);
  extent.PerimeterError = std::abs(extent.Perimeter - perimeter(4 * SmoothingSteps));
  return extent;
}

double smoothedPerimeter(const Points3& vertices, const std::vector<int>& loop)
{
  return closedLength(smoothed(vertices, loop, SmoothingSteps));
}

double trimmedLength(const Points3& vertices, const SurfaceCurve& curve, const std::vector<int>& loop)
{
  if (curve.Points.empty())
  {
    return 0.0;
  }
  double length = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    length += (positionOf(vertices, curve.Points[i]) - positionOf(vertices, curve.Points[i - 1])).norm();
  }
  return withoutOverhang(length, vertices, withSmoothed(vertices, loop), curve);
}

} // namespace flattening
