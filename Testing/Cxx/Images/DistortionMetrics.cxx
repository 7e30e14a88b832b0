// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkDistortionMetrics.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>

#include <cmath>

namespace
{

using namespace flattening::testing;

// The square [-1, 1]^2 as the map of a trapezoid, whose height grows linearly from 1 on the left to 3 on
// the right.
vtkSmartPointer<vtkPolyData> flattenedTrapezoid()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, -1.0, 0.0);
  plane->SetPoint1(1.0, -1.0, 0.0);
  plane->SetPoint2(-1.0, 1.0, 0.0);
  plane->SetResolution(16, 12);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> flat = triangles->GetOutput();
  vtkNew<vtkDoubleArray> surface;
  surface->SetName("SurfacePoints");
  surface->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flat->GetPoint(i, x);
    surface->InsertNextTuple3(x[0], (1.0 + 0.5 * x[0]) * x[1], 4.0);
  }
  flat->GetPointData()->AddArray(surface);
  return flat;
}

Image imageOfMeasure(vtkPolyData* measured, const char* array)
{
  colourBy(measured, array, -0.8, 0.8);
  return imageOf(measured);
}

TEST(DistortionMetrics, ColourTheFaces)
{
  const auto input = flattenedTrapezoid();
  vtkNew<vtkDistortionMetrics> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  expectBaseline(imageOfMeasure(output, "AreaDistortion"), "DistortionMetrics");

  EXPECT_NEAR(figure(output, "SurfaceArea"), 4.0, 1e-12);
  vtkDataArray* surface = input->GetPointData()->GetArray("SurfacePoints");
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, corners);
    double x[3][3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetTuple(corners->GetId(k), x[k]);
    }
    const double ratio = vtkTriangle::TriangleArea(x[0], x[1], x[2]) / (4.0 / (16 * 12 * 2));
    EXPECT_NEAR(
      output->GetCellData()->GetArray("AreaDistortion")->GetTuple1(cell), std::log(ratio), 1e-12);
  }

  expectNotBaseline(imageOfMeasure(output, "AngleDistortion"), "DistortionMetrics", "another measure");
  vtkDataArray* areas = output->GetCellData()->GetArray("AreaDistortion");
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    areas->SetTuple1(cell, -areas->GetTuple1(cell));
  }
  expectNotBaseline(imageOfMeasure(output, "AreaDistortion"), "DistortionMetrics", "a wrong sign");
}

} // namespace
