// SPDX-License-Identifier: GPL-3.0-or-later
/// The values of a volume in layers at several depths, as point arrays and as a stack of images.
#pragma once

#include "Core/Base/Progress.h"
#include "Internal/ImageGrid.h"
#include "Internal/VolumeSampling.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace flattening
{

/// One entry per depth, each with one entry per array of the volume.
using Layers = std::vector<std::vector<VolumeSamples>>;

/// Samples the volume at points + depth * inward for each depth (input units).
/// @param inward unit vectors (n x 3).
Layers sampleLayers(const VolumeSampling& volume,
  const Points3& points,
  const Points3& inward,
  const std::vector<double>& depths,
  const ProgressCallback& progress);

/// The text of a depth for messages and component names.
std::string depthText(double depth);

/// Adds a point array `<array>Slab` for each array of the volume, with the layers as components.
void addSlabArrays(vtkPolyData* output, const Layers& layers, const std::vector<double>& depths);

/// Adds the point array `InVolume` with a component per layer. Returns the number of samples outside.
long long addMask(vtkPolyData* output, const Layers& layers);

/// The grid of the stack over an image with one layer; z is the depth if depths are equally spaced.
ImageGrid stackGrid(const ImageGrid& pixels, const std::vector<double>& depths);

/// Fills @p stack with the layers over the image @p pixels.
void fillStack(vtkImageData* stack,
  vtkImageData* pixels,
  const Layers& layers,
  const std::vector<double>& depths);

/// Sets the field array `Depths`.
void setDepths(vtkDataObject* output, const std::vector<double>& depths);

} // namespace flattening
