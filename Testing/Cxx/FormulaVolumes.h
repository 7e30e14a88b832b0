// SPDX-License-Identifier: GPL-3.0-or-later
/// Volumes of a formula, and Volume To Surface on them.
#pragma once

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeToSurface.h>

#include <Eigen/Core>

#include <functional>

namespace flattening::testing
{

inline constexpr double VoxelSizes[3] = { 1.0, 1.25, 2.0 };

using Field = std::function<double(const Eigen::Vector3d&)>;

template <typename Array = vtkDoubleArray>
vtkSmartPointer<vtkImageData> volumeOf(const Eigen::Vector3d& size, const Field& field)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  int dimensions[3];
  for (int k = 0; k < 3; ++k)
  {
    dimensions[k] = static_cast<int>(size[k] / VoxelSizes[k]) + 1;
  }
  volume->SetDimensions(dimensions);
  volume->SetSpacing(VoxelSizes);
  volume->SetOrigin(-0.5 * size[0], -0.5 * size[1], -0.5 * size[2]);
  vtkNew<Array> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    values->InsertNextTuple1(field(Eigen::Vector3d(volume->GetPoint(i))));
  }
  volume->GetPointData()->SetScalars(values);
  return volume;
}

// 100 on the sphere around the centre, and 5 less for each unit further out.
inline double ball(const Eigen::Vector3d& point, double radius)
{
  return 100.0 - 5.0 * (point.norm() - radius);
}

inline vtkSmartPointer<vtkVolumeToSurface> filterAt(double isovalue,
  double smoothing,
  vtkImageData* volume)
{
  auto filter = vtkSmartPointer<vtkVolumeToSurface>::New();
  filter->AutomaticIsovalueOff();
  filter->SetIsovalue(isovalue);
  filter->AutomaticSmoothingOff();
  filter->SetSmoothing(smoothing);
  filter->SetInputData(volume);
  return filter;
}

} // namespace flattening::testing
