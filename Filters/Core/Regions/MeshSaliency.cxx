// SPDX-License-Identifier: GPL-3.0-or-later
#include "Regions/MeshSaliency.h"

#include "Base/Errors.h"
#include "Mesh/DisjointSets.h"
#include "Regions/GaussianMeans.h"
#include "Regions/MeanCurvature.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// The default unit of the scales as a share of the diagonal of the bounding box, from the paper.
constexpr double DefaultUnit = 0.003;
// The greatest number of scales: a guard against a mistyped number, as each scale takes time and memory.
constexpr int MaxScales = 20;
// The standard deviation of the first scale in units, from the paper.
constexpr int FirstScale = 2;

double diagonalOf(const TriangleMesh& mesh)
{
  return (mesh.Vertices.colwise().maxCoeff() - mesh.Vertices.colwise().minCoeff()).norm();
}

double requireUnit(const TriangleMesh& mesh, const MeshSaliencyOptions& options)
{
  if (options.Scales < 1 || options.Scales > MaxScales)
  {
    throw InvalidInput("saliency has " + std::to_string(options.Scales) + " scales: choose 1 to " +
                       std::to_string(MaxScales));
  }
  if (!(options.SampleSpacing >= 0.0 && options.SampleSpacing <= 1.0))
  {
    throw InvalidInput("the sample spacing of saliency must be from 0 to 1 standard deviations");
  }
  const double diagonal = diagonalOf(mesh);
  const double unit = options.Unit == 0.0 ? DefaultUnit * diagonal : options.Unit;
  if (!(unit > 0.0) || !std::isfinite(unit))
  {
    throw InvalidInput("the unit of the saliency scales must be a positive length");
  }
  const double reach = 4.0 * (options.Scales + 1) * unit; // radius of the largest ball
  if (reach > diagonal)
  {
    throw InvalidInput("the largest scale of saliency reaches " + formatted(reach) +
                       " far, more than the surface's diagonal of " + formatted(diagonal) +
                       ": choose a smaller unit or fewer scales");
  }
  return unit;
}

WeightedPoints samplesOf(const TriangleMesh& mesh, const Eigen::VectorXd& areas, bool areaWeighted)
{
  WeightedPoints points;
  points.Positions = mesh.Vertices;
  points.Integral = integratedMeanCurvature(mesh);
  points.Mass = areas;
  if (!areaWeighted)
  {
    points.Integral = (areas.array() > 0.0).select(points.Integral.array() / areas.array(), 0.0);
    points.Mass = (areas.array() > 0.0).cast<double>();
  }
  return points;
}

// The mean of the local maxima other than the greatest; 0 if there is no other.
double meanOfOtherMaxima(const FaceMatrix& faces, const Eigen::VectorXd& values)
{
  std::vector<char> isMaximum(values.size(), 0);
  for (const int v : faces.reshaped())
  {
    isMaximum[v] = 1;
  }
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = faces(f, k);
      const int b = faces(f, (k + 1) % 3);
      // Of equal values the smallest index is the maximum.
      isMaximum[std::pair(values[a], b) < std::pair(values[b], a) ? a : b] = 0;
    }
  }
  Eigen::Index greatest = 0;
  values.maxCoeff(&greatest);
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index v = 0; v < values.size(); ++v)
  {
    if (isMaximum[v] && v != greatest)
    {
      sum += values[v];
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

// Scales the saliency down the more the scale has peaks of similar height (Itti, Koch, Niebur 1998).
Eigen::VectorXd suppressed(const FaceMatrix& faces, const Eigen::VectorXd& saliency, double curvature)
{
  constexpr double rounding = 1e-5; // relative error of gaussianMeans
  const double greatest = saliency.maxCoeff();
  if (greatest <= rounding * curvature)
  {
    return Eigen::VectorXd::Zero(saliency.size());
  }
  const Eigen::VectorXd normalised = saliency / greatest;
  const double gap = 1.0 - meanOfOtherMaxima(faces, normalised);
  return gap * gap * normalised;
}

} // namespace

MeshSaliency meshSaliency(const TriangleMesh& mesh,
  const MeshSaliencyOptions& options,
  const ProgressCallback& progress)
{
  MeshSaliency result;
  result.Unit = requireUnit(mesh, options);
  report(progress, 0.0, "Curvature");
  const Eigen::VectorXd areas = vertexAreas(mesh);
  const WeightedPoints points = samplesOf(mesh, areas, options.AreaWeighted);
  if (!(points.Mass.sum() > 0.0))
  {
    throw InvalidInput("the surface has no area: pass a surface with triangles that are not degenerate");
  }
  result.MeanCurvature =
    (points.Mass.array() > 0.0).select(points.Integral.array() / points.Mass.array(), 0.0);

  std::map<int, Eigen::VectorXd> means; // by standard deviation in units; 4 and 6 serve twice
  for (int scale = FirstScale; scale < FirstScale + options.Scales; ++scale)
  {
    means[scale];
    means[2 * scale];
  }
  double curvature = 0.0;
  int done = 0;
  for (auto& [deviation, mean] : means)
  {
    const double begin = 0.05 + 0.9 * done / means.size();
    const double end = 0.05 + 0.9 * ++done / means.size();
    mean = gaussianMeans(
      points, deviation * result.Unit, options.SampleSpacing, subrange(progress, begin, end));
    curvature = std::max(curvature, mean.cwiseAbs().maxCoeff());
  }
  report(progress, 0.95, "Suppression");
  result.Saliency = Eigen::VectorXd::Zero(mesh.vertexCount());
  for (int scale = FirstScale; scale < FirstScale + options.Scales; ++scale)
  {
    result.PerScale.emplace_back((means[scale] - means[2 * scale]).cwiseAbs());
    result.Saliency += suppressed(mesh.Faces, result.PerScale.back(), curvature);
  }
  return result;
}

double areaPercentile(const TriangleMesh& mesh, const Eigen::VectorXd& values, double fraction)
{
  if (!(fraction >= 0.0 && fraction <= 1.0))
  {
    throw InvalidInput("a percentile must be from 0 to 100");
  }
  const Eigen::VectorXd areas = vertexAreas(mesh);
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(),
    order.end(),
    [&values](int a, int b) { return std::pair(values[a], a) < std::pair(values[b], b); });
  const double wanted = fraction * areas.sum();
  double area = 0.0;
  for (const int v : order)
  {
    area += areas[v];
    if (area >= wanted)
    {
      return values[v];
    }
  }
  return values.maxCoeff();
}

std::vector<int> salientRegions(const TriangleMesh& mesh,
  const Eigen::VectorXd& values,
  double threshold,
  double smallest,
  double largest)
{
  const int n = mesh.vertexCount();
  DisjointSets sets(n);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = mesh.Faces(f, k);
      const int b = mesh.Faces(f, (k + 1) % 3);
      if (values[a] >= threshold && values[b] >= threshold)
      {
        sets.join(a, b);
      }
    }
  }
  const Eigen::VectorXd areas = vertexAreas(mesh);
  std::vector<double> areaOf(n, 0.0); // by representative
  std::vector<int> firstOf(n, -1);
  std::vector<int> representatives;
  for (int v = 0; v < n; ++v)
  {
    if (values[v] >= threshold && areas[v] > 0.0)
    {
      const int set = sets.find(v);
      areaOf[set] += areas[v];
      if (firstOf[set] < 0)
      {
        firstOf[set] = v;
        representatives.push_back(set);
      }
    }
  }
  representatives.erase(std::remove_if(representatives.begin(),
                          representatives.end(),
                          [&](int set) { return areaOf[set] < smallest || areaOf[set] > largest; }),
    representatives.end());
  std::sort(representatives.begin(),
    representatives.end(),
    [&](int a, int b) { return std::pair(-areaOf[a], firstOf[a]) < std::pair(-areaOf[b], firstOf[b]); });
  std::vector<int> number(n, 0);
  for (std::size_t i = 0; i < representatives.size(); ++i)
  {
    number[representatives[i]] = static_cast<int>(i) + 1;
  }
  std::vector<int> regions(n, 0);
  for (int v = 0; v < n; ++v)
  {
    regions[v] = values[v] >= threshold && areas[v] > 0.0 ? number[sets.find(v)] : 0;
  }
  return regions;
}

} // namespace flattening
