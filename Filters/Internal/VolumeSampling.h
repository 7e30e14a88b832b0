// SPDX-License-Identifier: GPL-3.0-or-later
/// The values of a volume at points in space.
#pragma once

#include "Core/Base/Progress.h"
#include "Core/Mesh/TriangleMesh.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkFloatArray;
class vtkImageData;

namespace flattening
{

/// A volume's point array with the values at given points.
struct VolumeSamples
{
  vtkSmartPointer<vtkFloatArray> Values; ///< of the array's name and components; NaN outside
  std::vector<char> Inside;              ///< per point: whether it is in the volume
};

/// Samples every numeric point array of a volume; holds a copy of them in floating point, for VTK rounds
/// what it interpolates of integers.
class VolumeSampling
{
public:
  /// @p nearest: the value of the nearest voxel, for labels; else linear between the voxels.
  /// @throws InvalidInput if the volume has no numeric point array.
  VolumeSampling(vtkImageData* volume, bool nearest, const ProgressCallback& progress = {});
  ~VolumeSampling();

  /// One per array, in the volume's order. Points that are not finite are outside.
  std::vector<VolumeSamples> at(const Points3& points, const ProgressCallback& progress = {}) const;

private:
  void sample(const Points3& points, vtkIdType first, std::vector<VolumeSamples>& samples) const;

  vtkSmartPointer<vtkImageData>
    Volume;                       ///< arrays by number: the probe's own has a name that may be theirs
  std::vector<std::string> Names; ///< of the arrays
  bool Nearest;
};

} // namespace flattening
