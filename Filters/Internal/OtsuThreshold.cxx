// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/OtsuThreshold.h"

#include <vtkFloatArray.h>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// Bins of the histogram. A CT has some 4,000 values, so that the threshold is found to 4 of them; with
// 64 bins that of a brain MRI moves by 1 of its 133 grey values.
constexpr double Bins = 1024.0;

// Sums over the bins below a threshold.
struct Sums
{
  double Count = 0.0;
  double Value = 0.0;

  void add(const Histogram& histogram, std::size_t bin)
  {
    this->Count += histogram.Counts[bin];
    this->Value += histogram.Counts[bin] * histogram.centre(bin);
  }
};

Sums sumsOf(const Histogram& histogram)
{
  Sums sums;
  for (std::size_t bin = 0; bin < histogram.Counts.size(); ++bin)
  {
    sums.add(histogram, bin);
  }
  return sums;
}

// The variance between the classes, as a share of the number of voxels squared.
double between(const Sums& below, const Sums& all)
{
  const double above = all.Count - below.Count;
  if (below.Count <= 0.0 || above <= 0.0)
  {
    return 0.0;
  }
  const double difference = below.Value / below.Count - (all.Value - below.Value) / above;
  return below.Count * above * difference * difference;
}

} // namespace

Histogram histogramOf(vtkFloatArray* values, double low, double high, bool wholeNumbers)
{
  Histogram histogram;
  histogram.Width = wholeNumbers ? std::ceil((high - low + 1.0) / Bins) : (high - low) / Bins;
  histogram.Low = wholeNumbers ? low - 0.5 : low;
  const double count = wholeNumbers ? std::floor((high - histogram.Low) / histogram.Width) + 1.0 : Bins;
  histogram.Counts.assign(static_cast<std::size_t>(count), 0.0);
  const float* begin = values->GetPointer(0);
  const double last = count - 1.0;
  for (const float* value = begin; value != begin + values->GetNumberOfValues(); ++value)
  {
    const double bin = std::clamp((*value - histogram.Low) / histogram.Width, 0.0, last);
    histogram.Counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  return histogram;
}

OtsuThreshold classesAt(const Histogram& histogram, double threshold)
{
  const Sums all = sumsOf(histogram);
  const double mean = all.Value / all.Count;
  Sums below;
  double variance = 0.0;
  for (std::size_t bin = 0; bin < histogram.Counts.size(); ++bin)
  {
    const double deviation = histogram.centre(bin) - mean;
    variance += histogram.Counts[bin] * deviation * deviation;
    if (histogram.centre(bin) < threshold)
    {
      below.add(histogram, bin);
    }
  }
  OtsuThreshold classes;
  classes.Value = threshold;
  classes.ShareBelow = below.Count / all.Count;
  classes.MeanBelow = below.Count > 0.0 ? below.Value / below.Count : histogram.Low;
  classes.MeanAbove =
    below.Count < all.Count ? (all.Value - below.Value) / (all.Count - below.Count) : classes.MeanBelow;
  classes.Separation = variance > 0.0 ? between(below, all) / (all.Count * variance) : 0.0;
  return classes;
}

OtsuThreshold otsuThreshold(const Histogram& histogram)
{
  const Sums all = sumsOf(histogram);
  Sums below;
  double greatest = 0.0;
  std::size_t first = 0; // the last bin of the class below, and
  std::size_t last = 0;  // the last one that makes the same classes, as the bins between are empty
  for (std::size_t bin = 0; bin + 1 < histogram.Counts.size(); ++bin)
  {
    below.add(histogram, bin);
    const double variance = between(below, all);
    if (variance > greatest)
    {
      greatest = variance;
      first = last = bin;
    }
    else if (last + 1 == bin && histogram.Counts[bin] == 0.0)
    {
      last = bin;
    }
  }
  return classesAt(histogram, 0.5 * (histogram.centre(first) + histogram.centre(last + 1)));
}

} // namespace flattening
