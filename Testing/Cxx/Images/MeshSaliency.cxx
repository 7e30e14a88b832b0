// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../Core/Support/SampleSurfaces.h"
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkMeshSaliency.h>

#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::testing;

// A ball of radius 1 with a bump at the top and a lower and narrower one on the side of the x-axis.
vtkSmartPointer<vtkPolyData> ballWithBumps()
{
  TriangleMesh mesh = samples::sphere(4);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double top = mesh.Vertices(v, 2) - 1.0;
    const double side = mesh.Vertices(v, 0) - 1.0;
    mesh.Vertices.row(v) *= 1.0 + 0.1 * std::exp(40.0 * top) + 0.06 * std::exp(80.0 * side);
  }
  return polyDataOf(mesh);
}

Image imageOfArray(vtkPolyData* surface, const char* array, double high)
{
  colourBy(surface, array, 0.0, high);
  return imageOf(surface, { {}, { 1.0, -0.4, 1.0 }, { 0.0, 0.0, 1.0 }, 1.15 });
}

TEST(MeshSaliency, ColoursTheBumps)
{
  vtkNew<vtkMeshSaliency> filter;
  filter->SetInputData(ballWithBumps());
  filter->SetUnit(0.05);
  filter->SetThresholdTypeToValue();
  filter->SetMinimumRegionArea(0.01);
  filter->PerScaleArraysOn();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const double greatest = output->GetPointData()->GetArray("Saliency")->GetRange()[1];
  expectBaseline(imageOfArray(output, "Saliency", greatest), "MeshSaliency");

  ASSERT_EQ(figure(output, "SaliencyRegions"), 2.0);
  vtkDataArray* regions = output->GetPointData()->GetArray("SaliencyRegion");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const double region = regions->GetTuple1(i);
    EXPECT_TRUE(region == 0.0 || x[region == 1.0 ? 2 : 0] > 0.8);
  }

  expectNotBaseline(imageOfArray(output, "MeanCurvature", 2.0), "MeshSaliency", "another array");
  filter->SetNumberOfScales(1);
  filter->Update();
  expectNotBaseline(
    imageOfArray(filter->GetOutput(), "Saliency", greatest), "MeshSaliency", "one scale of five");
}

} // namespace
