// SPDX-License-Identifier: GPL-3.0-or-later
#include "../FilterTest.h"
#include "ImageTest.h"

#include <vtkConformalDiskFilter.h>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

Image imageOfTiles(vtkPolyData* flat)
{
  colourBy(flat, "Tile", 0.0, 8.0);
  return imageOf(flat);
}

TEST(ConformalDisk, OfABump)
{
  const SurfaceOfRevolution surface = gaussianBump(1.0, 0.3);
  const RevolutionMesh bump = sunflowerMesh(surface, 600);
  const auto data = polyDataOf(bump.Mesh);
  addTiles(data, 0.2);
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(data);
  filter->SetNormalizeToUnitDomain();
  filter->UseCenterPointOn();
  filter->SetCenterPoint(bump.Mesh.Vertices.row(0).data());
  filter->UseBoundaryPointOn();
  filter->SetBoundaryPoint(bump.Mesh.Vertices.row(bump.FirstBoundaryVertex).data());
  filter->Update();
  vtkPolyData* flat = filter->GetOutput();
  expectBaseline(imageOfTiles(flat), "ConformalDisk");
  EXPECT_LT(distanceFromRadialMap(bump, flat, surface.ConformalRadius), 0.03);
  EXPECT_EQ(figure(flat, "FlippedFaces"), 0.0);

  const auto withAreas = radialMap(bump, [&surface](double t) { return surface.brenierRadius(t); });
  withAreas->GetCellData()->ShallowCopy(data->GetCellData());
  expectNotBaseline(imageOfTiles(withAreas), "ConformalDisk", "the area-preserving map");

  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flat->GetPoint(i, x);
    flat->GetPoints()->SetPoint(i, x[0], -x[1], 0.0);
  }
  expectNotBaseline(imageOfTiles(flat), "ConformalDisk", "a mirrored map");

  filter->SetCenterPoint(bump.Mesh.Vertices.row(40).data());
  filter->Update();
  expectNotBaseline(imageOfTiles(filter->GetOutput()), "ConformalDisk", "another centre");
}

} // namespace
