// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "../FormulaVolumes.h"
#include "ImageTest.h"

#include <algorithm>
#include <string>

namespace
{

using namespace flattening::testing;

constexpr double Radius = 8.0;
constexpr double DentDepth = 3.0;

// Above 0 inside of a ball with a dent on the side of +x, from 100 in its middle on; below it outside.
double dentedBall(const Eigen::Vector3d& point)
{
  const double towards = point.x() / std::max(point.norm(), 1e-9);
  const double radius = Radius - (towards > 0.5 ? DentDepth * (2.0 * towards - 1.0) : 0.0);
  return 100.0 * (1.0 - point.norm() / radius);
}

Image imageOfHeights(vtkVolumeToSurface* filter)
{
  filter->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(filter->GetOutput());
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(data->GetPoint(i)[2]);
  }
  data->GetPointData()->AddArray(heights);
  colourBy(data, "Height", -Radius, Radius);
  View view;
  view.Towards = { 1.0, -1.0, 1.0 };
  view.HalfHeight = 1.1 * Radius;
  return imageOf(data, view);
}

TEST(VolumeToSurface, TakesADentedBallOutOfAVolume)
{
  const std::string name = "VolumeToSurface";
  const auto filter = filterAt(0.0, 0.0, volumeOf(Eigen::Vector3d(24, 24, 24), dentedBall));
  expectBaseline(imageOfHeights(filter), name);
  vtkPolyData* surface = filter->GetOutput();
  EXPECT_GT(surface->GetNumberOfPoints(), 500);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    // A voxel is up to 2 high, and the field is linear along rays but not across them.
    ASSERT_NEAR(dentedBall(Eigen::Vector3d(surface->GetPoint(i))), 0.0, 4.0);
  }

  filter->SetIsovalue(30.0);
  expectNotBaseline(imageOfHeights(filter), name, "another isovalue");
  filter->SetIsovalue(0.0);
  filter->SetSmoothing(3.0);
  expectNotBaseline(imageOfHeights(filter), name, "a smoothing that fills the dent");
  filter->SetSmoothing(0.0);
  filter->SetInputData(volumeOf(Eigen::Vector3d(24, 24, 24),
    [](const Eigen::Vector3d& p) { return dentedBall(Eigen::Vector3d(-p.x(), p.y(), p.z())); }));
  expectNotBaseline(imageOfHeights(filter), name, "left for right");
}

} // namespace
