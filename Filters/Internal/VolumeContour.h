// SPDX-License-Identifier: GPL-3.0-or-later
/// The steps from a volume to its isosurface, each by a filter of VTK.
#pragma once

#include "Core/Base/Progress.h"

#include <vtkSmartPointer.h>

#include <array>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace flattening
{

/// Checks that a volume has a surface: several slices, one number at each voxel, and memory for it.
/// @param values the array of the voxels; may be null
/// @throws InvalidInput that says what is wrong
void requireVolume(vtkImageData* volume, vtkDataArray* values);

/// Asks for the memory that the steps take for a volume of this extent, beside the volume itself.
/// @throws InvalidInput if there is not as much
void requireVolumeMemory(const int extent[6], int margin);

/// The voxels in single precision, as the only array. Voxels that are not finite get the value of air.
struct FloatingVolume
{
  vtkSmartPointer<vtkImageData> Image;
  std::array<double, 2> Range; ///< of the finite voxels
  long long NotFinite = 0;     ///< voxels
};

/// @throws InvalidInput if no voxel is finite, or all have the same value
FloatingVolume inFloatingPoint(vtkImageData* volume,
  vtkDataArray* values,
  const ProgressCallback& progress);

/// Replaces the voxels that are not finite.
void fillNotFinite(FloatingVolume& volume, double air);

/// The volume with a margin of @p voxels on every side.
vtkSmartPointer<vtkImageData> padded(vtkImageData* volume,
  int voxels,
  double air,
  const ProgressCallback& progress);

/// The volume convolved with a Gaussian of a standard deviation in units of the volume, whatever the
/// shape of its voxels.
vtkSmartPointer<vtkImageData> smoothed(vtkImageData* volume,
  double standardDeviation,
  const ProgressCallback& progress);

/// The surface at an isovalue, with normals.
/// @throws InvalidInput if all voxels are on one side of it
vtkSmartPointer<vtkPolyData> isosurface(vtkImageData* volume,
  double isovalue,
  const ProgressCallback& progress);

/// The size of a voxel: the cube root of its volume.
double voxelSize(vtkImageData* volume);

} // namespace flattening
