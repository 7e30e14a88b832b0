// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthErrors.h"

#include <tbb/parallel_sort.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

// A value and its weight.
using Weighted = std::pair<double, double>;

// The smallest value at which the weights of the values up to it reach @p share of all; 0 if there is
// none.
double quantile(std::vector<Weighted>& values, double share)
{
  tbb::parallel_sort(values.begin(), values.end());
  const double all = std::accumulate(values.begin(),
    values.end(),
    0.0,
    [](double sum, const Weighted& value) { return sum + value.second; });
  double sum = 0.0;
  for (const auto& [value, weight] : values)
  {
    sum += weight;
    if (sum >= share * all)
    {
      return value;
    }
  }
  return values.empty() ? 0.0 : values.back().first;
}

double sumOf(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Calls @p visit(ratio, weight) for all pairs; the weights of each source sum to 1.
template <typename Visit>
void forEachPair(const std::vector<SourceLengths>& sources, const Visit& visit)
{
  for (const SourceLengths& source : sources)
  {
    const double all = sumOf(source.Weights);
    for (std::size_t i = 0; i < source.Ratios.size(); ++i)
    {
      visit(source.Ratios[i], source.Weights[i] / all);
    }
  }
}

// The scale s for which the sum of weight |s ratio - 1| is least: the median of 1 / ratio, weighted by
// weight times ratio.
double bestScale(const std::vector<SourceLengths>& sources)
{
  std::vector<Weighted> inverses;
  forEachPair(sources,
    [&inverses](double ratio, double weight)
    {
      if (ratio > 0.0)
      {
        inverses.emplace_back(1.0 / ratio, weight * ratio);
      }
    });
  return quantile(inverses, 0.5);
}

double meanError(const SourceLengths& source, double scale)
{
  double error = 0.0;
  for (std::size_t i = 0; i < source.Ratios.size(); ++i)
  {
    error += source.Weights[i] * std::abs(scale * source.Ratios[i] - 1.0);
  }
  return 100.0 * error / sumOf(source.Weights);
}

} // namespace

LengthErrors lengthErrors(const std::vector<SourceLengths>& sources)
{
  LengthErrors errors;
  errors.Scale = bestScale(sources);
  std::vector<double> means;
  for (const SourceLengths& source : sources)
  {
    if (!source.Ratios.empty())
    {
      means.push_back(meanError(source, errors.Scale));
    }
  }
  if (means.empty())
  {
    return errors;
  }
  const auto count = static_cast<double>(means.size());
  errors.Mean = sumOf(means) / count;
  double squares = 0.0;
  for (const double mean : means)
  {
    squares += (mean - errors.Mean) * (mean - errors.Mean);
  }
  errors.StandardError = count > 1.0 ? std::sqrt(squares / (count * (count - 1.0))) : 0.0;

  std::vector<Weighted> ofPairs;
  forEachPair(sources,
    [&](double ratio, double weight)
    { ofPairs.emplace_back(100.0 * std::abs(errors.Scale * ratio - 1.0), weight); });
  errors.P95 = quantile(ofPairs, 0.95);
  return errors;
}

} // namespace flattening
