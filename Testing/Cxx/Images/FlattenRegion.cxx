// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkFlattenRegion.h>

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

// A hill with the label 4 on an egg-shaped region on its flank, which the map can be in no doubt how to
// turn.
vtkSmartPointer<vtkPolyData> hill()
{
  auto data = polyDataOf(sunflowerMesh(gaussianBump(0.7, 0.35), 1500).Mesh);
  addTiles(data, 0.15);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    const double along = (x[0] - 0.25) / 0.5;
    const double across = (x[1] - 0.05) / (0.3 - 0.15 * along);
    labels->InsertNextValue(std::hypot(along, across) < 1.0 ? 4 : 1);
  }
  data->GetPointData()->AddArray(labels);
  return data;
}

Image imageOfTiles(vtkPolyData* flat, const char* array = "Tile")
{
  colourBy(flat, array, 0.0, 8.0);
  View view;
  view.HalfHeight = 0.75;
  return imageOf(flat, view);
}

TEST(FlattenRegion, CutsOutAndFlattensOneLabel)
{
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(0, hill());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Label");
  filter->SetLabel(4);
  filter->AutomaticMarginOff();
  filter->SetMargin(0.1);
  filter->Update();
  vtkPolyData* flat = filter->GetOutput();
  expectBaseline(imageOfTiles(flat), "FlattenRegion");
  EXPECT_EQ(figure(flat, "RegionPieces"), 1.0);
  EXPECT_EQ(figure(flat, "FlippedFaces"), 0.0);
  EXPECT_NEAR(figure(flat, "FlatArea") / figure(flat, "Area"), 1.0, 0.005);

  expectNotBaseline(imageOfTiles(flat, "InRegion"), "FlattenRegion", "another array");
  filter->SetMargin(0.2);
  filter->Update();
  expectNotBaseline(imageOfTiles(filter->GetOutput()), "FlattenRegion", "a wider margin");
}

} // namespace
