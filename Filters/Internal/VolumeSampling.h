// SPDX-License-Identifier: GPL-3.0-or-later
/// Sampling of a volume at points in space.
#pragma once

#include "Core/Base/Progress.h"
#include "Core/Mesh/TriangleMesh.h"

#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace flattening
{

/// The values of one array of a volume at given points.
struct VolumeSamples
{
  vtkSmartPointer<vtkDataArray> Values; ///< with the name and components of the array; NaN outside
  std::vector<char> Inside;             ///< one flag per point: 1 in the volume
};

/// The arrays of a volume that are sampled, in order: its numeric point arrays that have a name.
std::vector<vtkDataArray*> sampledArrays(vtkImageData* volume);

/// The type of the samples of an array, VTK_FLOAT or VTK_DOUBLE.
int sampledType(vtkDataArray* array, bool nearest);

/// Samples every numeric point array of a volume. It holds copies of the arrays in floating point, as
/// VTK rounds interpolated integers: in single precision, or in double precision where the values of
/// voxels may need it, such as labels above 2^24.
class VolumeSampling
{
public:
  /// @param nearest whether to take the value of the nearest voxel, as labels need it, instead of
  /// interpolating linearly.
  /// @param toVolume takes the points that are sampled to the coordinates of the volume.
  /// @throws InvalidInput if the volume has no numeric point array, or voxels without size.
  VolumeSampling(vtkImageData* volume,
    bool nearest,
    const Eigen::Affine3d& toVolume,
    const ProgressCallback& progress = {});
  ~VolumeSampling();

  /// The samples at the points (n x 3), one entry per array in the order of the volume. Points that are
  /// not finite are outside.
  std::vector<VolumeSamples> at(const Points3& points, const ProgressCallback& progress = {}) const;

private:
  void sample(const Points3& points, vtkIdType first, std::vector<VolumeSamples>& samples) const;
  vtkSmartPointer<vtkImageData> probed() const;

  vtkSmartPointer<vtkImageData> Volume; ///< its arrays are named by number, as the probe adds an array
                                        ///< whose name may be one of theirs
  std::vector<std::string> Names;       ///< names of the arrays in the volume
  bool Nearest;
  Eigen::Affine3d ToVolume;
};

} // namespace flattening
