// SPDX-License-Identifier: GPL-3.0-or-later
/// A volume's values in layers at several depths, as arrays of points and as a stack of images.
#pragma once

#include "Core/Base/Progress.h"
#include "Internal/VolumeSampling.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace flattening
{

/// One entry per depth, each with one per array of the volume.
using Layers = std::vector<std::vector<VolumeSamples>>;

/// The volume at @p points + depth @p inward (n x 3, unit vectors) for each depth (input units).
Layers sampleLayers(const VolumeSampling& volume,
  const Points3& points,
  const Points3& inward,
  const std::vector<double>& depths,
  const ProgressCallback& progress);

/// A depth in a message and as the name of a component.
std::string depthText(double depth);

/// Adds a point array `<array>Slab` per array of the volume, with the layers side by side.
void addSlabArrays(vtkPolyData* output, const Layers& layers, const std::vector<double>& depths);

/// Adds the point array `InVolume`, a component per layer. Returns how many samples are outside.
long long addMask(vtkPolyData* output, const Layers& layers);

/// Fills @p stack with the layers over the image @p pixels; z is depth if the depths are at equal steps.
void fillStack(vtkImageData* stack,
  vtkImageData* pixels,
  const Layers& layers,
  const std::vector<double>& depths);

/// Sets the field array `Depths`.
void setDepths(vtkDataObject* output, const std::vector<double>& depths);

} // namespace flattening
