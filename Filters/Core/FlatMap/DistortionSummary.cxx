// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/DistortionSummary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{

double measureOf(const FaceDistortion& distortion, Measure measure, int f)
{
  switch (measure)
  {
    case Measure::AreaError:
      return 100.0 * std::abs(distortion.AreaRatio[f] - 1.0);
    case Measure::AreaDistortion:
      return std::abs(distortion.AreaDistortion[f]);
    case Measure::AngleDistortion:
      return distortion.AngleDistortion[f];
    case Measure::BeltramiMagnitude:
      return distortion.BeltramiMagnitude[f];
    case Measure::StretchL2:
      return distortion.StretchL2[f];
    case Measure::SymmetricDirichlet:
      return distortion.SymmetricDirichlet[f];
    case Measure::AngleError:
      return distortion.AngleError[f];
  }
  return 0.0;
}

MeasureStatistics statisticsOf(const FaceDistortion& distortion,
  Measure measure,
  const std::vector<int>& faces)
{
  MeasureStatistics statistics;
  std::vector<double> values;
  values.reserve(faces.size());
  double area = 0.0;
  for (const int f : faces)
  {
    if (distortion.SurfaceDegenerate[f] ||
        (distortion.FlatDegenerate[f] && measure != Measure::AreaError))
    {
      continue;
    }
    const double value = measureOf(distortion, measure, f);
    values.push_back(value);
    statistics.Mean += value;
    statistics.AreaWeightedMean += value * distortion.SurfaceArea[f];
    area += distortion.SurfaceArea[f];
  }
  if (values.empty())
  {
    return statistics;
  }
  statistics.Mean /= static_cast<double>(values.size());
  statistics.AreaWeightedMean /= area;
  std::sort(values.begin(), values.end());
  const auto percentile = [&values](double fraction)
  {
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(rank, 1) - 1];
  };
  statistics.P95 = percentile(0.95);
  statistics.P99 = percentile(0.99);
  statistics.Max = values.back();
  return statistics;
}

double standardDeviation(const std::vector<double>& values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
  return std::sqrt((all - all.mean()).square().mean());
}

// Sets the standard deviations of the area ratio and of its logarithm.
void addDeviations(const FaceDistortion& distortion,
  const std::vector<int>& faces,
  DistortionSummary& summary)
{
  std::vector<double> ratios;
  std::vector<double> logarithms;
  for (const int f : faces)
  {
    if (!distortion.SurfaceDegenerate[f])
    {
      ratios.push_back(distortion.AreaRatio[f]);
    }
    if (!distortion.degenerate(f))
    {
      logarithms.push_back(distortion.AreaDistortion[f]);
    }
  }
  summary.SDAreaRatio = standardDeviation(ratios);
  summary.SDLogAreaRatio = standardDeviation(logarithms);
}

} // namespace

DistortionSummary summariseDistortion(const FaceDistortion& distortion, const std::vector<int>& faces)
{
  DistortionSummary summary;
  summary.Faces = static_cast<int>(faces.size());
  double targetArea = 0.0;
  double squaredStretch = 0.0;
  double stretchedArea = 0.0;
  int measurable = 0;
  int within = 0;
  for (const int f : faces)
  {
    summary.SurfaceArea += distortion.SurfaceArea[f];
    summary.FlatArea += distortion.FlatArea[f];
    targetArea += distortion.TargetArea[f];
    summary.FlippedFaces += distortion.Flipped[f];
    summary.DegenerateFaces += distortion.degenerate(f);
    measurable += !distortion.SurfaceDegenerate[f];
    within += !distortion.SurfaceDegenerate[f] && !distortion.Flipped[f] &&
              std::abs(distortion.AreaRatio[f] - 1.0) <= 0.02;
    if (!distortion.degenerate(f))
    {
      squaredStretch += distortion.SurfaceArea[f] * distortion.StretchL2[f] * distortion.StretchL2[f];
      stretchedArea += distortion.SurfaceArea[f];
    }
  }
  if (targetArea > 0.0)
  {
    const double flatShare = summary.FlatArea / distortion.TotalFlatArea;
    summary.AreaErrorPercent = 100.0 * (flatShare / (targetArea / distortion.TotalTargetArea) - 1.0);
  }
  if (measurable > 0)
  {
    summary.FacesWithin2Percent = 100.0 * within / measurable;
  }
  if (stretchedArea > 0.0)
  {
    summary.RootMeanSquareStretch = std::sqrt(squaredStretch / stretchedArea);
  }
  addDeviations(distortion, faces, summary);
  for (int m = 0; m < MeasureCount; ++m)
  {
    summary.Measures[m] = statisticsOf(distortion, static_cast<Measure>(m), faces);
  }
  summary.SurfaceArea *= distortion.SurfaceAreaUnit;
  summary.FlatArea *= distortion.FlatAreaUnit;
  return summary;
}

DistortionSummary summariseDistortion(const FaceDistortion& distortion)
{
  std::vector<int> faces(distortion.faceCount());
  std::iota(faces.begin(), faces.end(), 0);
  return summariseDistortion(distortion, faces);
}

} // namespace flattening
