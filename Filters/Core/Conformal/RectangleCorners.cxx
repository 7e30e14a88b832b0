// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConformalRectangle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

// Length of the boundary over that of the chords that measure a turn to either side of a vertex, at
// first. A choice: shorter chords see the noise of single edges, longer ones miss corners that are close
// to each other, as at the ends of a strip.
constexpr int FirstWindows = 40;
// Least turn of a corner (radians), half of a right angle: a choice. With less, smooth boundaries have
// corners.
constexpr double LeastTurn = 0.25 * EIGEN_PI;

// The boundary as a closed curve, parametrised by length.
class BoundaryCurve
{
public:
  BoundaryCurve(const TriangleMesh& mesh, const std::vector<int>& loop)
    : Mesh(mesh)
    , Loop(loop)
    , Along(loop.size() + 1, 0.0)
  {
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const int next = loop[(k + 1) % loop.size()];
      this->Along[k + 1] =
        this->Along[k] + (mesh.Vertices.row(next) - mesh.Vertices.row(loop[k])).norm();
    }
  }

  double length() const { return this->Along.back(); }
  double at(int k) const { return this->Along[k]; }

  Eigen::RowVector3d point(double along) const
  {
    along -= this->length() * std::floor(along / this->length());
    const auto after = std::upper_bound(this->Along.begin() + 1, this->Along.end() - 1, along);
    const auto k = static_cast<int>(after - this->Along.begin()) - 1;
    const double edge = this->Along[k + 1] - this->Along[k];
    const double t = edge > 0.0 ? (along - this->Along[k]) / edge : 0.0;
    return (1.0 - t) * this->Mesh.Vertices.row(this->Loop[k]) +
           t * this->Mesh.Vertices.row(this->Loop[(k + 1) % this->Loop.size()]);
  }

  // The angle between chords of a length before and after vertex k of the loop (radians).
  double turn(int k, double window) const
  {
    const Eigen::RowVector3d here = this->Mesh.Vertices.row(this->Loop[k]);
    const Eigen::RowVector3d before = here - this->point(this->Along[k] - window);
    const Eigen::RowVector3d after = this->point(this->Along[k] + window) - here;
    return std::atan2(before.cross(after).norm(), before.dot(after));
  }

  // The distance between two parameters along the curve, the shorter way around.
  double distance(double a, double b) const
  {
    const double d = std::abs(a - b);
    return std::min(d, this->length() - d);
  }

  // The vertex nearest to a parameter.
  int nearest(double along) const
  {
    along -= this->length() * std::floor(along / this->length());
    int best = 0;
    for (int k = 1; k < static_cast<int>(this->Loop.size()); ++k)
    {
      best = this->distance(this->Along[k], along) < this->distance(this->Along[best], along) ? k : best;
    }
    return best;
  }

private:
  const TriangleMesh& Mesh;
  const std::vector<int>& Loop;
  std::vector<double> Along;
};

// Indices into the loop of its sharp corners, the sharpest first.
// @param window length of the chords that measure a turn
std::vector<int> sharpCorners(const BoundaryCurve& curve, int count, double window)
{
  std::vector<double> turns(count);
  for (int k = 0; k < count; ++k)
  {
    turns[k] = curve.turn(k, window);
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&turns](int a, int b) { return turns[a] > turns[b]; });
  // The chords of a vertex beside a corner reach around it: only the corner turns the most within a
  // chord.
  std::vector<int> corners;
  for (auto k = order.begin(); k != order.end() && turns[*k] >= LeastTurn; ++k)
  {
    const auto isApart = [&](double distance)
    {
      return [&curve, k, distance](int other)
      { return curve.distance(curve.at(*k), curve.at(other)) > distance; };
    };
    if (std::all_of(corners.begin(), corners.end(), isApart(2.0 * window)) &&
        std::all_of(order.begin(), k, isApart(window)))
    {
      corners.push_back(*k);
    }
  }
  return corners;
}

// Indices into the loop of its four sharpest corners, ascending; fewer if it does not turn so often.
// Where two corners are closer than the first chords, shorter ones part them, and count if they see four
// corners and no more: of noise there would be many. The shortest are a quarter of an edge long, so that
// they part the ends of a single edge.
std::vector<int> sharpestCorners(const BoundaryCurve& curve, int count)
{
  std::vector<int> corners = sharpCorners(curve, count, curve.length() / FirstWindows);
  for (int windows = 2 * FirstWindows; corners.size() < 4 && windows <= 4 * count; windows *= 2)
  {
    const std::vector<int> close = sharpCorners(curve, count, curve.length() / windows);
    corners = close.size() == 4 ? close : corners;
  }
  corners.resize(std::min<std::size_t>(corners.size(), 4));
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Indices into the loop of four vertices a quarter of its length apart, ascending; fewer if some
// coincide.
std::vector<int> evenCorners(const BoundaryCurve& curve, int first)
{
  std::vector<int> corners;
  for (int side = 0; side < 4; ++side)
  {
    corners.push_back(curve.nearest(curve.at(first) + 0.25 * side * curve.length()));
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

} // namespace

std::vector<int> seamCorners(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const std::vector<char>& onSeam)
{
  const int count = static_cast<int>(loop.size());
  const auto marked = [&](int k) { return onSeam[loop[k % count]] != 0; };
  // First and last index into the loop of each marked stretch; the last may lie beyond the loop's end.
  std::vector<std::pair<int, int>> stretches;
  for (int k = 0; k < count; ++k)
  {
    if (marked(k + 1) && !marked(k))
    {
      int last = k + 1;
      while (marked(last + 1))
      {
        ++last;
      }
      stretches.emplace_back(k + 1, last);
    }
  }
  if (stretches.size() != 2 || stretches[0].first == stretches[0].second ||
      stretches[1].first == stretches[1].second)
  {
    return {};
  }
  const BoundaryCurve curve(mesh, loop);
  const auto lengthBefore = [&](int stretch)
  {
    const double length =
      curve.at(stretches[stretch].first % count) - curve.at(stretches[1 - stretch].second % count);
    return length < 0.0 ? length + curve.length() : length;
  };
  const int lower = lengthBefore(0) >= lengthBefore(1) ? 0 : 1;
  std::vector<int> corners;
  for (const int stretch : { lower, 1 - lower })
  {
    corners.push_back(loop[stretches[stretch].first % count]);
    corners.push_back(loop[stretches[stretch].second % count]);
  }
  return corners;
}

std::vector<int> rectangleCorners(const TriangleMesh& mesh, const std::vector<int>& loop)
{
  const int count = static_cast<int>(loop.size());
  const Eigen::VectorXd areas = vertexAreas(mesh);
  const Eigen::RowVector3d centroid = areas.transpose() * mesh.Vertices / areas.sum();
  const auto distance = [&](int k) { return (mesh.Vertices.row(loop[k]) - centroid).norm(); };

  const BoundaryCurve curve(mesh, loop);
  std::vector<int> indices = sharpestCorners(curve, count);
  if (indices.size() < 4)
  {
    int farthest = 0;
    for (int k = 1; k < count; ++k)
    {
      farthest = distance(k) > distance(farthest) ? k : farthest;
    }
    indices = evenCorners(curve, farthest);
  }
  if (indices.size() < 4)
  {
    indices.resize(4);
    for (int k = 0; k < 4; ++k)
    {
      indices[k] = k * count / 4;
    }
  }
  const auto side = [&](int k)
  {
    const double length = curve.at(indices[(k + 1) % 4]) - curve.at(indices[k % 4]);
    return length < 0.0 ? length + curve.length() : length;
  };
  int first = side(0) + side(2) >= side(1) + side(3) ? 0 : 1;
  first += distance(indices[(first + 2) % 4]) > distance(indices[first]) ? 2 : 0;
  std::vector<int> corners;
  for (int k = 0; k < 4; ++k)
  {
    corners.push_back(loop[indices[(first + k) % 4]]);
  }
  return corners;
}

} // namespace flattening
