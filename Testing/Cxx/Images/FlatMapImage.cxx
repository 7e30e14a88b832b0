// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkFlatMapImage.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

Image imageOfTiles(vtkFlatMapImage* filter)
{
  filter->Update();
  return imageOf(filter->GetOutput(), "Tile", 0.0, 8.0);
}

TEST(FlatMapImage, ShowsTheFacesUnderThePixels)
{
  const SurfaceOfRevolution surface = sphericalCap(0.5 * EIGEN_PI);
  const RevolutionMesh mesh = sunflowerMesh(surface, 2000);
  const auto map = radialMap(mesh, surface.ConformalRadius);
  addTiles(map, 0.2);
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(map);
  filter->SetSize(150);
  expectBaseline(imageOfTiles(filter), "FlatMapImage");

  vtkImageData* output = filter->GetOutput();
  const double pixel = figure(output, "PixelLength");
  EXPECT_NEAR(figure(output, "PixelsInMap") * pixel * pixel, EIGEN_PI, 0.02);
  vtkDataArray* inMap = output->GetPointData()->GetArray("InMap");
  vtkDataArray* points = output->GetPointData()->GetArray("SurfacePoints");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    if (inMap->GetTuple1(i) == 1.0)
    {
      // The conformal map of the hemisphere is the stereographic projection.
      const double squared = x[0] * x[0] + x[1] * x[1];
      EXPECT_NEAR(points->GetComponent(i, 2), (1.0 - squared) / (1.0 + squared), 0.005);
    }
  }

  filter->SetMargin(20);
  expectNotBaseline(imageOfTiles(filter), "FlatMapImage", "a wider margin");
  filter->SetMargin(2);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    double x[3];
    map->GetPoint(i, x);
    map->GetPoints()->SetPoint(i, -x[1], x[0], 0.0);
  }
  map->GetPoints()->Modified();
  filter->Modified();
  expectNotBaseline(imageOfTiles(filter), "FlatMapImage", "a map rotated by a quarter");
}

} // namespace
