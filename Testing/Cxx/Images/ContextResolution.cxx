// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkContextResolution.h>

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

// A hemisphere of 2,500 vertices with a region half-way down on the side of the x-axis.
vtkSmartPointer<vtkPolyData> hemisphere()
{
  const auto data = polyDataOf(sunflowerMesh(sphericalCap(0.5 * EIGEN_PI), 2500).Mesh);
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    region->InsertNextValue(x[0] + x[2] > 1.36 ? 1 : 0);
  }
  data->GetPointData()->AddArray(region);
  return data;
}

Image imageOfRegion(vtkPolyData* surface)
{
  colourBy(surface, "Region", 0.0, 1.0);
  return imageOf(surface, { {}, { 1.0, 0.0, 1.0 }, { -1.0, 0.0, 1.0 }, 1.05, 150, true });
}

TEST(ContextResolution, CoarsensAroundTheRegion)
{
  const auto input = hemisphere();
  vtkNew<vtkContextResolution> filter;
  filter->SetInputData(input);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Region");
  filter->SetContextFaces(300);
  filter->Update();
  expectBaseline(imageOfRegion(filter->GetOutput()), "ContextResolution");
  EXPECT_NEAR(figure(filter->GetOutput(), "ContextCells"), 300.0, 15.0);
  EXPECT_EQ(figure(filter->GetOutput(), "RegionPoints"), sum(input->GetPointData()->GetArray("Region")));

  expectNotBaseline(imageOfRegion(input), "ContextResolution", "a surface that was not coarsened");
  filter->SetContextFaces(80);
  filter->Update();
  expectNotBaseline(imageOfRegion(filter->GetOutput()), "ContextResolution", "a much coarser context");
}

} // namespace
