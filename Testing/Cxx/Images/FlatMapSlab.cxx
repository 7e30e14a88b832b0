// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkFlatMapSlab.h>

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

constexpr double Depth = 0.4;

double value(const double* x)
{
  return x[0] + 0.5 * x[1] + 0.7 * x[2];
}

vtkSmartPointer<vtkImageData> linearVolume()
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(31, 31, 31);
  volume->SetOrigin(-1.5, -1.5, -1.5);
  volume->SetSpacing(0.1, 0.1, 0.1);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Value");
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    double x[3];
    volume->GetPoint(i, x);
    values->InsertNextValue(value(x));
  }
  volume->GetPointData()->SetScalars(values);
  return volume;
}

Image imageOfSlab(vtkFlatMapSlab* filter, int layer)
{
  filter->Update();
  colourBy(filter->GetOutput(), "ValueSlab", -1.0, 1.0, layer);
  return imageOf(filter->GetOutput());
}

TEST(FlatMapSlab, SamplesAVolumeBelowTheSurface)
{
  const SurfaceOfRevolution surface = sphericalCap(0.5 * EIGEN_PI);
  const auto map = radialMap(sunflowerMesh(surface, 1500), surface.ConformalRadius);
  vtkNew<vtkFlatMapSlab> filter;
  filter->SetInputData(0, map);
  filter->SetVolumeData(linearVolume());
  filter->ClearDepths();
  filter->AddDepth(0.0);
  filter->AddDepth(Depth);
  filter->SetStackSize(0);
  expectBaseline(imageOfSlab(filter, 1), "FlatMapSlab");

  vtkDataArray* samples = filter->GetOutput()->GetPointData()->GetArray("ValueSlab");
  ASSERT_EQ(samples->GetNumberOfComponents(), 2);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    double x[3];
    map->GetPointData()->GetArray("SurfacePoints")->GetTuple(i, x);
    EXPECT_NEAR(samples->GetComponent(i, 0), value(x), 1e-6);
    EXPECT_NEAR(samples->GetComponent(i, 1), (1.0 - Depth) * value(x), 0.05);
  }
  EXPECT_EQ(figure(filter->GetOutput(), "OutsideSamples"), 0.0);

  expectNotBaseline(imageOfSlab(filter, 0), "FlatMapSlab", "another depth");
  filter->OutwardsOn();
  expectNotBaseline(imageOfSlab(filter, 1), "FlatMapSlab", "a depth outwards");
}

} // namespace
