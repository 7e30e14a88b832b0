// SPDX-License-Identifier: GPL-3.0-or-later
/// The histogram of a volume, and the value that divides it best into two classes. VTK has no such
/// search.
#pragma once

#include <cstddef>
#include <vector>

class vtkFloatArray;

namespace flattening
{

/// Numbers of voxels in bins of equal width.
struct Histogram
{
  double Low = 0.0;   ///< where the first bin begins
  double Width = 1.0; ///< of a bin
  std::vector<double> Counts;

  double centre(std::size_t bin) const
  {
    return this->Low + (static_cast<double>(bin) + 0.5) * this->Width;
  }
};

/// A threshold between two classes of voxels, and measures of the two classes.
struct OtsuThreshold
{
  double Value = 0.0;
  double ShareBelow = 0.0; ///< of all voxels, from 0 to 1
  double MeanBelow = 0.0;
  double MeanAbove = 0.0;
  /// The share of the variance that lies between the classes, from 0 to 1 (Otsu's eta): 1 if each class
  /// has one value.
  double Separation = 0.0;
};

/// The histogram of values that are all finite. The bins of whole numbers are around whole numbers.
/// @param low, high the least and the greatest value
Histogram histogramOf(vtkFloatArray* values, double low, double high, bool wholeNumbers);

/// The two classes into which @p threshold divides the voxels. A bin belongs to the class below as a
/// whole if its centre is below the threshold.
OtsuThreshold classesAt(const Histogram& histogram, double threshold);

/// The threshold for which the variance between the two classes is greatest: N. Otsu, "A Threshold
/// Selection Method from Gray-Level Histograms", IEEE Transactions on Systems, Man and Cybernetics 9
/// (1979). Between two values with none in between it is halfway.
OtsuThreshold otsuThreshold(const Histogram& histogram);

} // namespace flattening
