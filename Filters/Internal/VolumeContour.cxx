// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/VolumeContour.h"

#include "Core/Base/Errors.h"
#include "Internal/ImageMemory.h"
#include "Internal/InnerProgress.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageCast.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <string>

namespace flattening
{
namespace
{

// Single-precision numbers for each voxel that exist at one time: the volume with its margin, its
// smoothed copy, and the two between the axes in vtkImageGaussianSmooth.
constexpr double CopiesAtOnce = 4.0;

// The Gaussian ends at three standard deviations, beyond which 0.3 % of its weight lie.
constexpr double RadiusFactor = 3.0;

template <typename Filter>
auto run(Filter* filter, const ProgressCallback& progress, const char* stage)
{
  const InnerProgress forwarding(filter, progress, stage);
  filter->Update();
  report(progress, 1.0, stage); // throws if an abort left the output empty
  return vtkSmartPointer(filter->GetOutput());
}

std::string sizeText(const int extent[6])
{
  std::string text;
  for (int k = 0; k < 3; ++k)
  {
    text += (k > 0 ? " x " : "") + std::to_string(extent[2 * k + 1] - extent[2 * k] + 1);
  }
  return text;
}

} // namespace

void requireVolume(vtkImageData* volume, vtkDataArray* values)
{
  const int* extent = volume->GetExtent();
  for (int k = 0; k < 3; ++k)
  {
    if (extent[2 * k + 1] - extent[2 * k] < 1)
    {
      throw InvalidInput("this is a single slice, of " + sizeText(extent) +
                         " voxels, and a surface needs a volume: open the whole series");
    }
    const double size = volume->GetSpacing()[k];
    if (!(size > 0.0 && std::isfinite(size)))
    {
      throw InvalidInput("a voxel has the size " + formatted(size) + " along axis " +
                         std::to_string(k + 1) +
                         ": set the Spacing of the volume to what it was scanned with");
    }
  }
  if (!values)
  {
    throw InvalidInput(
      "the volume has no numbers at its voxels: choose an array of points, or turn cell "
      "arrays into such (Cell Data To Point Data)");
  }
  if (values->GetNumberOfComponents() != 1)
  {
    throw InvalidInput("a voxel of \"" + std::string(values->GetName() ? values->GetName() : "") +
                       "\" has " + std::to_string(values->GetNumberOfComponents()) +
                       " values: take one of them, or their magnitude, with Calculator");
  }
}

void requireVolumeMemory(const int extent[6], int margin)
{
  double bytes = CopiesAtOnce * sizeof(float);
  for (int k = 0; k < 3; ++k)
  {
    bytes *= extent[2 * k + 1] - extent[2 * k] + 1.0 + 2.0 * margin;
  }
  requireMemory("the surface of a volume of " + sizeText(extent) + " voxels",
    bytes,
    "take a part of it, or every second voxel, with Extract Subset");
}

FloatingVolume inFloatingPoint(vtkImageData* volume,
  vtkDataArray* values,
  const ProgressCallback& progress)
{
  FloatingVolume result;
  values->GetFiniteRange(result.Range.data(), 0);
  if (!(result.Range[0] <= result.Range[1]))
  {
    throw InvalidInput("no voxel has a finite value: check that the file could be read");
  }
  if (result.Range[0] == result.Range[1])
  {
    throw InvalidInput("all voxels have the value " + formatted(result.Range[0]) +
                       ", so that there is no surface: check that the file could be read");
  }
  vtkNew<vtkImageData> voxels;
  voxels->CopyStructure(volume);
  voxels->GetPointData()->SetScalars(values);
  vtkNew<vtkImageCast> cast;
  cast->SetInputData(voxels);
  cast->SetOutputScalarTypeToFloat();
  result.Image = run(cast.Get(), progress, "Reading the volume");
  return result;
}

void fillNotFinite(FloatingVolume& volume, double air)
{
  auto* values = vtkFloatArray::SafeDownCast(volume.Image->GetPointData()->GetScalars());
  float* begin = values->GetPointer(0);
  for (float* value = begin; value != begin + values->GetNumberOfValues(); ++value)
  {
    if (!std::isfinite(*value))
    {
      *value = static_cast<float>(air);
      ++volume.NotFinite;
    }
  }
}

vtkSmartPointer<vtkImageData> padded(vtkImageData* volume,
  int voxels,
  double air,
  const ProgressCallback& progress)
{
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputData(volume);
  const int* e = volume->GetExtent();
  pad->SetOutputWholeExtent(
    e[0] - voxels, e[1] + voxels, e[2] - voxels, e[3] + voxels, e[4] - voxels, e[5] + voxels);
  pad->SetConstant(air);
  return run(pad.Get(), progress, "Adding a margin");
}

vtkSmartPointer<vtkImageData> smoothed(vtkImageData* volume,
  double standardDeviation,
  const ProgressCallback& progress)
{
  const double* size = volume->GetSpacing();
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(volume);
  smooth->SetStandardDeviations(
    standardDeviation / size[0], standardDeviation / size[1], standardDeviation / size[2]);
  smooth->SetRadiusFactors(RadiusFactor, RadiusFactor, RadiusFactor);
  return run(smooth.Get(), progress, "Smoothing the volume");
}

vtkSmartPointer<vtkPolyData> isosurface(vtkImageData* volume,
  double isovalue,
  const ProgressCallback& progress)
{
  double range[2];
  volume->GetScalarRange(range);
  if (!(range[0] < isovalue && isovalue < range[1]))
  {
    throw InvalidInput("the isovalue " + formatted(isovalue) +
                       " is not between the least and greatest value of the smoothed volume, " +
                       formatted(range[0]) + " and " + formatted(range[1]) +
                       ": choose one between them, tick Automatic Isovalue, or smooth less");
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(volume);
  contour->SetValue(0, isovalue);
  contour->ComputeScalarsOff(); // it has one value everywhere
  return run(contour.Get(), progress, "Contouring the volume");
}

double voxelSize(vtkImageData* volume)
{
  const double* size = volume->GetSpacing();
  return std::cbrt(size[0] * size[1] * size[2]);
}

} // namespace flattening
