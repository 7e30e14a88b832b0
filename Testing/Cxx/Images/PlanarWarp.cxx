// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "../PlanarWarpSamples.h"
#include "ImageTest.h"

#include <vtkPlanarWarp.h>

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

using namespace flattening::testing;

// 201 x 101 pixels on [0, 2] x [0, 1]: tiles of 1 and 2, of 3 and 4 in the lower left quarter.
vtkSmartPointer<vtkImageData> chequeredImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(201, 101, 1);
  image->SetSpacing(0.01, 0.01, 1.0);
  vtkNew<vtkIntArray> tiles;
  tiles->SetName("Tile");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const int column = static_cast<int>(std::floor(8.0 * x[0]));
    const int row = static_cast<int>(std::floor(8.0 * x[1]));
    tiles->InsertNextValue((column + row) % 2 + (x[0] < 1.0 && x[1] < 0.5 ? 3 : 1));
  }
  image->GetPointData()->SetScalars(tiles);
  return image;
}

Image imageOfTiles(vtkPlanarWarp* filter)
{
  filter->Update();
  auto* output = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  return imageOf(output, "Tile", 0.0, 4.0);
}

TEST(PlanarWarp, BendsAnImage)
{
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(deformed(plane(40), bend));
  filter->SetCarriedData(chequeredImage());
  filter->SetImageSize(200, 125);
  filter->NearestPixelOn();
  expectBaseline(imageOfTiles(filter), "PlanarWarp");

  auto* output = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_NEAR(sum(output->GetPointData()->GetArray("InMap")),
    20000.0,
    100.0); // the area of the mesh, 2, in pixels
  EXPECT_EQ(figure(output, "OutsidePoints"), 0.0);

  filter->SetInputData(deformed(plane(40), [](double* x) { x[1] += 0.25 * x[0]; }));
  filter->SetImageSize(200, 125);
  expectNotBaseline(imageOfTiles(filter), "PlanarWarp", "a sheared mesh");
  filter->SetInputData(deformed(plane(40),
    [](double* x)
    {
      bend(x);
      x[0] = 2.0 - x[0];
    }));
  expectNotBaseline(imageOfTiles(filter), "PlanarWarp", "a mirrored mesh");
}

} // namespace
