// SPDX-License-Identifier: GPL-3.0-or-later
#include "VoxelValues.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

// How far outside of the volume a place may lie, in voxels along each axis.
constexpr long double OutsideTolerance = 1.001e-6L;
// The rounding of values in single precision.
constexpr long double ValueRounding = 4e-7L;

using Index = std::array<int, 3>;

double voxel(vtkImageData* volume, vtkDataArray* array, const Index& at, int component)
{
  const int* size = volume->GetDimensions();
  const vtkIdType id =
    at[0] + size[0] * (at[1] + static_cast<vtkIdType>(size[1]) * static_cast<vtkIdType>(at[2]));
  return array->GetComponent(id, component);
}

// Whether a function holds for a voxel from @p low to @p high.
template <typename Function>
bool anyVoxel(const Index& low, const Index& high, const Function& holds)
{
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        if (holds(Index{ x, y, z }))
        {
          return true;
        }
      }
    }
  }
  return false;
}

int clampedIndex(long double index, int size)
{
  return static_cast<int>(std::clamp(index, 0.0L, static_cast<long double>(size - 1)));
}

// The value between the eight voxels around a place.
long double trilinear(vtkImageData* volume,
  vtkDataArray* array,
  int component,
  const std::array<long double, 3>& place)
{
  const int* size = volume->GetDimensions();
  Index low;
  Index high;
  std::array<long double, 3> share;
  for (int k = 0; k < 3; ++k)
  {
    low[k] = clampedIndex(std::floor(place[k]), size[k]);
    high[k] = std::min(low[k] + 1, size[k] - 1);
    share[k] = std::clamp(place[k] - low[k], 0.0L, 1.0L);
  }
  long double value = 0.0L;
  for (int corner = 0; corner < 8; ++corner)
  {
    Index at;
    long double weight = 1.0L;
    for (int k = 0; k < 3; ++k)
    {
      const bool isHigh = ((corner >> k) & 1) != 0;
      at[k] = isHigh ? high[k] : low[k];
      weight *= isHigh ? share[k] : 1.0L - share[k];
    }
    value += weight * voxel(volume, array, at, component);
  }
  return value;
}

// Whether a value is interpolated at a place of the box, in voxels.
bool isTrilinear(double value, vtkImageData* volume, vtkDataArray* array, int component, const Box3& box)
{
  const int* size = volume->GetDimensions();
  Index low;
  Index high;
  std::array<long double, 3> middle;
  long double halves = 0.0L;
  for (int k = 0; k < 3; ++k)
  {
    low[k] = clampedIndex(std::floor(box[k].Low), size[k]);
    high[k] = clampedIndex(std::ceil(box[k].High), size[k]);
    middle[k] = 0.5L * (box[k].Low + box[k].High);
    halves += 0.5L * (box[k].High - box[k].Low);
  }
  long double least = HUGE_VALL;
  long double greatest = -HUGE_VALL;
  anyVoxel(low,
    high,
    [&](const Index& at)
    {
      const long double x = voxel(volume, array, at, component);
      least = std::min(least, x);
      greatest = std::max(greatest, x);
      return false;
    });
  const long double rounding = ValueRounding * std::max(std::abs(least), std::abs(greatest));
  // From one voxel to the next the value changes by at most the difference of the extremes.
  return value >= least - rounding && value <= greatest + rounding &&
         std::abs(value - trilinear(volume, array, component, middle)) <=
           halves * (greatest - least) + rounding;
}

bool isOfVoxel(const std::vector<double>& values,
  vtkImageData* volume,
  vtkDataArray* array,
  const Box3& box)
{
  const int* size = volume->GetDimensions();
  const bool isSingle = array->GetDataType() == VTK_FLOAT || array->GetDataTypeSize() <= 2;
  Index low;
  Index high;
  for (int k = 0; k < 3; ++k)
  {
    low[k] = clampedIndex(std::ceil(box[k].Low - 0.5L), size[k]);
    high[k] = clampedIndex(std::floor(box[k].High + 0.5L), size[k]);
  }
  return anyVoxel(low,
    high,
    [&](const Index& at)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double x = voxel(volume, array, at, c);
        if (values[c] != (isSingle ? static_cast<double>(static_cast<float>(x)) : x))
        {
          return false;
        }
      }
      return true;
    });
}

// The distance between voxels along an axis. A single slice may have no thickness.
long double lengthOf(vtkImageData* volume, int axis)
{
  const double length = volume->GetSpacing()[axis];
  const bool isSingle = volume->GetDimensions()[axis] == 1;
  return isSingle && !(length != 0.0 && std::isfinite(length)) ? 1.0L : std::abs(length);
}

// The box in voxels, with the rounding of the coordinates.
Box3 inVoxels(vtkImageData* volume, const Box3& box)
{
  Box3 index;
  for (int k = 0; k < 3; ++k)
  {
    const long double origin = volume->GetOrigin()[k];
    const long double length = lengthOf(volume, k);
    const long double rounding = 1e-15L * (std::max(std::abs(box[k].Low), std::abs(box[k].High)) +
                                            std::abs(origin) + std::abs(length));
    index[k] = { (box[k].Low - rounding - origin) / length, (box[k].High + rounding - origin) / length };
  }
  return index;
}

} // namespace

std::vector<vtkDataArray*> numbersOf(vtkImageData* volume)
{
  std::vector<vtkDataArray*> arrays;
  for (int a = 0; a < volume->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = volume->GetPointData()->GetArray(a);
    if (array && array->GetName())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

std::string faultOf(const Sample& sample, vtkImageData* volume, const Box3& box, bool nearestVoxel)
{
  const Box3 index = inVoxels(volume, box);
  bool mayBeInside = true;
  bool mayBeOutside = false;
  for (int k = 0; k < 3; ++k)
  {
    const long double last = volume->GetDimensions()[k] - 1;
    // Written so that a place that is not a number is outside.
    mayBeInside =
      mayBeInside && index[k].High >= -OutsideTolerance && index[k].Low <= last + OutsideTolerance;
    mayBeOutside = mayBeOutside || !(index[k].Low >= 0.0L && index[k].High <= last);
  }
  if (sample.IsInside ? !mayBeInside : !mayBeOutside)
  {
    return sample.IsInside ? "lies outside of the volume" : "lies in the volume";
  }
  const std::vector<vtkDataArray*> arrays = numbersOf(volume);
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const std::vector<double>& values = sample.Values[a];
    bool holds = !sample.IsInside || !nearestVoxel || isOfVoxel(values, volume, arrays[a], index);
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      holds = holds && (!sample.IsInside
                           ? std::isnan(values[c])
                           : nearestVoxel ||
                               isTrilinear(values[c], volume, arrays[a], static_cast<int>(c), index));
    }
    if (!holds)
    {
      return std::string("has the wrong value of ") + arrays[a]->GetName();
    }
  }
  return {};
}

} // namespace fuzz
