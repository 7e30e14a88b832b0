// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkFlatMapTransfer.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

Image imageOfTiles(vtkFlatMapTransfer* filter)
{
  filter->Update();
  colourBy(filter->GetOutput(), "Tile", 0.0, 8.0);
  return imageOf(filter->GetOutput());
}

// The same hill in two triangulations. The map of the one is known in closed form, and so is where the
// vertices of the other belong on it.
TEST(FlatMapTransfer, BringsAnotherTriangulationToTheMap)
{
  const SurfaceOfRevolution surface = gaussianBump(1.0, 0.3);
  const RevolutionMesh rings = ringMesh(surface, 300);
  const auto original = polyDataOf(rings.Mesh);
  addTiles(original, 0.25);
  vtkNew<vtkFlatMapTransfer> filter;
  filter->SetInputData(0, radialMap(sunflowerMesh(surface, 3000), surface.ConformalRadius));
  filter->SetOriginalData(original);
  expectBaseline(imageOfTiles(filter), "FlatMapTransfer");

  vtkPolyData* output = filter->GetOutput();
  // Only boundary points are lost, those that lie beyond the chords of the other boundary.
  EXPECT_GE(output->GetNumberOfPoints(), rings.FirstBoundaryVertex);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
  vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const auto id = static_cast<Eigen::Index>(ids->GetTuple1(i));
    const double radius = surface.ConformalRadius(rings.Parameter[id]);
    EXPECT_NEAR(x[0], radius * std::cos(rings.Angle[id]), 0.01);
    EXPECT_NEAR(x[1], radius * std::sin(rings.Angle[id]), 0.01);
  }

  for (vtkIdType i = 0; i < original->GetNumberOfPoints(); ++i)
  {
    double x[3];
    original->GetPoint(i, x);
    const double angle = 0.2;
    original->GetPoints()->SetPoint(i,
      std::cos(angle) * x[0] - std::sin(angle) * x[1],
      std::sin(angle) * x[0] + std::cos(angle) * x[1],
      x[2]);
  }
  original->GetPoints()->Modified();
  filter->Modified();
  expectNotBaseline(imageOfTiles(filter), "FlatMapTransfer", "an original surface turned by 0.2");
}

} // namespace
