// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/VolumeContour.h"

#include "Core/Base/Errors.h"
#include "Core/Base/Memory.h"
#include "Internal/InnerProgress.h"
#include "Internal/MovedPolyData.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageCast.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
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
// The widest Gaussian, in lengths of the volume along its axis. A guard: the weights of one that is as
// wide are the same in single precision, and a wider one is too much for VTK's integers.
constexpr double WidestGaussian = 1e6;
// In voxels; a narrower one, whose square may be 0, leaves every voxel as it is.
constexpr double NarrowestGaussian = 1e-3;

template <typename Filter>
auto run(Filter* filter, const ProgressCallback& progress, const char* stage)
{
  const InnerProgress forwarding(filter, progress, stage);
  filter->Update();
  report(progress, 1.0, stage); // throws if an abort left the output empty
  return vtkSmartPointer(filter->GetOutput());
}

// The image that a filter makes of another one, in the same place: VTK's filters forget the directions
// of the axes.
template <typename Filter>
vtkSmartPointer<vtkImageData> filtered(Filter* filter,
  vtkImageData* image,
  const ProgressCallback& progress,
  const char* stage)
{
  filter->SetInputData(image);
  const vtkSmartPointer<vtkImageData> result = run(filter, progress, stage);
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  return result;
}

// The number of voxels along an axis. Extents may reach over all integers.
long long voxelsAlong(const int extent[6], int axis)
{
  return static_cast<long long>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
}

std::string sizeText(const int extent[6])
{
  std::string text;
  for (int k = 0; k < 3; ++k)
  {
    text += (k > 0 ? " x " : "") + std::to_string(voxelsAlong(extent, k));
  }
  return text;
}

// The same voxels in the same places, counted from 0: VTK's filters write beyond their memory where a
// margin takes an extent past the least or greatest integer.
vtkSmartPointer<vtkImageData> countedFromZero(vtkImageData* volume, vtkDataArray* values)
{
  const int* extent = volume->GetExtent();
  double first[3];
  volume->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], first);
  auto voxels = vtkSmartPointer<vtkImageData>::New();
  voxels->CopyStructure(volume);
  voxels->SetDimensions(static_cast<int>(voxelsAlong(extent, 0)),
    static_cast<int>(voxelsAlong(extent, 1)),
    static_cast<int>(voxelsAlong(extent, 2)));
  voxels->SetOrigin(first);
  voxels->GetPointData()->SetScalars(values);
  return voxels;
}

// The rotation, about the origin of the volume, that turns the axes of the coordinates to its own.
Eigen::Affine3d directionOf(vtkImageData* volume)
{
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(
    volume->GetDirectionMatrix()->GetData());
  const Eigen::Translation3d origin(Eigen::Vector3d(volume->GetOrigin()));
  return origin * Eigen::Affine3d(Eigen::Matrix3d(axes)) * origin.inverse();
}

} // namespace

void requireVolume(vtkImageData* volume, vtkDataArray* values)
{
  const int* extent = volume->GetExtent();
  for (int k = 0; k < 3; ++k)
  {
    if (voxelsAlong(extent, k) < 2)
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
    bytes *= static_cast<double>(voxelsAlong(extent, k)) + 2.0 * margin;
  }
  requireMemory("the surface of a volume of " + sizeText(extent) + " voxels",
    bytes,
    "take a part of it, or every second voxel, with Extract Subset");
}

FloatingVolume inFloatingPoint(vtkImageData* volume,
  vtkDataArray* values,
  const ProgressCallback& progress)
{
  vtkSmartPointer<vtkDataArray> numbers = values;
  if (values->GetDataType() == VTK_BIT) // which VTK's image filters do not know
  {
    numbers = vtkSmartPointer<vtkUnsignedCharArray>::New();
    numbers->DeepCopy(values);
  }
  vtkNew<vtkImageCast> cast;
  cast->SetOutputScalarTypeToFloat();
  FloatingVolume result;
  result.Image = filtered(cast.Get(), countedFromZero(volume, numbers), progress, "Reading the volume");
  result.Image->GetPointData()->GetScalars()->GetFiniteRange(result.Range.data(), 0);
  if (!(result.Range[0] <= result.Range[1]))
  {
    throw InvalidInput(
      "no voxel has a value that single precision holds: check that the file could be read");
  }
  if (result.Range[0] == result.Range[1])
  {
    throw InvalidInput("all voxels have the value " + formatted(result.Range[0]) +
                       ", so that there is no surface: check that the file could be read");
  }
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
  const int* e = volume->GetExtent();
  pad->SetOutputWholeExtent(
    e[0] - voxels, e[1] + voxels, e[2] - voxels, e[3] + voxels, e[4] - voxels, e[5] + voxels);
  pad->SetConstant(air);
  return filtered(pad.Get(), volume, progress, "Adding a margin");
}

vtkSmartPointer<vtkImageData> smoothed(vtkImageData* volume,
  double standardDeviation,
  const ProgressCallback& progress)
{
  double deviations[3]; // in voxels
  double factors[3];
  for (int k = 0; k < 3; ++k)
  {
    const auto length = static_cast<double>(voxelsAlong(volume->GetExtent(), k));
    deviations[k] = std::min(standardDeviation / volume->GetSpacing()[k], WidestGaussian * length);
    if (deviations[k] < NarrowestGaussian)
    {
      deviations[k] = 0.0;
    }
    // Beyond the length of the volume the Gaussian meets no voxel.
    factors[k] = std::min(RadiusFactor, length / deviations[k]);
  }
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetStandardDeviations(deviations[0], deviations[1], deviations[2]);
  smooth->SetRadiusFactors(factors[0], factors[1], factors[2]);
  return filtered(smooth.Get(), volume, progress, "Smoothing the volume");
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
  // VTK's filter turns the triangles of a mirrored volume inside out, so that it gets one that is not
  // turned.
  vtkNew<vtkImageData> straight;
  straight->ShallowCopy(volume);
  vtkNew<vtkMatrix3x3> identity;
  straight->SetDirectionMatrix(identity);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(straight);
  contour->SetValue(0, isovalue);
  contour->ComputeScalarsOff(); // it has one value everywhere
  const vtkSmartPointer<vtkPolyData> surface = run(contour.Get(), progress, "Contouring the volume");
  if (!volume->GetDirectionMatrix()->IsIdentity())
  {
    movePolyData(surface, directionOf(volume));
  }
  return surface;
}

double voxelSize(vtkImageData* volume)
{
  const double* size = volume->GetSpacing();
  return std::cbrt(size[0] * size[1] * size[2]);
}

} // namespace flattening
