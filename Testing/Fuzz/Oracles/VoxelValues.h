// SPDX-License-Identifier: GPL-3.0-or-later
/// Values of a volume at a place that is known up to rounding.
#pragma once

#include "FlatPlaces.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace fuzz
{

/// A box in space, in which a place lies.
using Box3 = std::array<Interval, 3>;

/// The values that a filter gives a place: one tuple for each array of the volume.
struct Sample
{
  bool IsInside;
  std::vector<std::vector<double>> Values;
};

/// The arrays of a volume that are sampled: those with numbers and a name.
std::vector<vtkDataArray*> numbersOf(vtkImageData* volume);

/// The fault, in words, of the sample at a place of the box; empty if it may be right.
std::string faultOf(const Sample& sample, vtkImageData* volume, const Box3& box, bool nearestVoxel);

} // namespace fuzz
