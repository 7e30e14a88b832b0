// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkAreaWeights.h>

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

constexpr double EdgeWidth = 0.25;

double distanceFromRegion(const double* x)
{
  return std::hypot(x[0] - 0.3, x[1] - 0.1) - 0.3;
}

Image imageOfWeights(vtkAreaWeights* filter)
{
  filter->Update();
  colourBy(filter->GetOutput(), "AreaWeight", 1.0, 4.0);
  return imageOf(filter->GetOutput());
}

TEST(AreaWeights, FadeOutsideTheRegion)
{
  const auto disk = polyDataOf(sunflowerMesh(flatDisk(), 1500).Mesh);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Region");
  for (vtkIdType i = 0; i < disk->GetNumberOfPoints(); ++i)
  {
    double x[3];
    disk->GetPoint(i, x);
    labels->InsertNextValue(distanceFromRegion(x) < 0.0 ? 7 : 3);
  }
  disk->GetPointData()->AddArray(labels);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputData(disk);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Region");
  filter->SetLabel(7);
  filter->SetFactor(4.0);
  filter->SetEdgeWidth(EdgeWidth);
  expectBaseline(imageOfWeights(filter), "AreaWeights");

  vtkDataArray* weights = filter->GetOutput()->GetPointData()->GetArray("AreaWeight");
  for (vtkIdType i = 0; i < disk->GetNumberOfPoints(); ++i)
  {
    double x[3];
    disk->GetPoint(i, x);
    const double distance = distanceFromRegion(x);
    if (distance < 0.0)
    {
      EXPECT_EQ(weights->GetTuple1(i), 4.0);
    }
    else if (distance > 1.2 * EdgeWidth)
    {
      EXPECT_EQ(weights->GetTuple1(i), 1.0);
    }
    else
    {
      EXPECT_GE(weights->GetTuple1(i), 1.0);
      EXPECT_LE(weights->GetTuple1(i), 4.0);
    }
  }
  EXPECT_NEAR(figure(filter->GetOutput(), "RegionArea"), EIGEN_PI * 0.09, 0.01);

  filter->SetEdgeWidth(0.0);
  expectNotBaseline(imageOfWeights(filter), "AreaWeights", "a sharp edge");
  filter->SetEdgeWidth(EdgeWidth);
  filter->SetFactor(2.0);
  expectNotBaseline(imageOfWeights(filter), "AreaWeights", "half the factor");
}

} // namespace
