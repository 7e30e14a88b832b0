// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkFlatMapTransfer.h>
#include <vtkFlattenRegion.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::testing;

// A bump, with an array TCoords of its own: the number of the point.
vtkSmartPointer<vtkPolyData> photographedBump()
{
  const auto data = polyDataOf(analytic::sunflowerMesh(analytic::gaussianBump(1.0, 0.3), 600).Mesh);
  vtkNew<vtkFloatArray> own;
  own->SetName("TCoords");
  own->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    own->InsertNextTuple2(static_cast<double>(i), 0.5);
  }
  data->GetPointData()->SetTCoords(own);
  return data;
}

// The greatest difference between the active texture coordinates and the position in the disk.
double textureError(vtkPolyData* disk)
{
  vtkDataArray* coordinates = disk->GetPointData()->GetTCoords();
  if (!coordinates || std::string(coordinates->GetName()) != "TCoords")
  {
    return 1.0;
  }
  double bounds[6];
  disk->GetBounds(bounds);
  const double side = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  double greatest = 0.0;
  for (vtkIdType i = 0; i < disk->GetNumberOfPoints(); ++i)
  {
    double x[3];
    disk->GetPoint(i, x);
    for (int k = 0; k < 2; ++k)
    {
      const double centre = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
      greatest =
        std::max(greatest, std::abs(coordinates->GetComponent(i, k) - 0.5 - (x[k] - centre) / side));
    }
  }
  return greatest;
}

TEST(TextureCoordinates, EveryMapHasItsOwn)
{
  const auto bump = photographedBump();
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(bump);
  vtkNew<vtkOMTAreaPreservingFilter> transported;
  transported->SetInputConnection(conformal->GetOutputPort());
  vtkNew<vtkFlatMapTransfer> carried;
  carried->SetInputConnection(transported->GetOutputPort());
  carried->SetOriginalData(bump);
  carried->Update();
  EXPECT_LT(textureError(conformal->GetOutput()), 1e-7);
  EXPECT_LT(textureError(transported->GetOutput()), 1e-7);
  EXPECT_LT(textureError(carried->GetOutput()), 1e-7);

  // The two maps are different, and so are their textures.
  double difference = 0.0;
  for (vtkIdType i = 0; i < bump->GetNumberOfPoints(); ++i)
  {
    difference = std::max(difference,
      std::abs(conformal->GetOutput()->GetPointData()->GetTCoords()->GetComponent(i, 0) -
               transported->GetOutput()->GetPointData()->GetTCoords()->GetComponent(i, 0)));
  }
  EXPECT_GT(difference, 0.01);
}

TEST(TextureCoordinates, ThoseOfTheSurfaceAreKeptUnderAnotherName)
{
  const auto bump = photographedBump();
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(bump);
  vtkNew<vtkOMTAreaPreservingFilter> transported;
  transported->SetInputConnection(conformal->GetOutputPort());
  transported->Update();
  vtkDataArray* own = transported->GetOutput()->GetPointData()->GetArray("SurfaceTCoords");
  ASSERT_NE(own, nullptr);
  for (vtkIdType i = 0; i < bump->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(own->GetComponent(i, 0), static_cast<double>(i));
  }
  EXPECT_EQ(std::string(bump->GetPointData()->GetTCoords()->GetName()), "TCoords")
    << "the input was changed";
}

// The map of a map has two arrays TCoords before it: that of the map is not the surface's.
TEST(TextureCoordinates, ThoseOfTheSurfaceOutliveASecondMap)
{
  const auto bump = photographedBump();
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType i = 0; i < bump->GetNumberOfPoints(); ++i)
  {
    label->InsertNextValue(std::hypot(bump->GetPoint(i)[0], bump->GetPoint(i)[1]) < 0.5 ? 1 : 0);
  }
  bump->GetPointData()->AddArray(label);
  vtkNew<vtkConformalDiskFilter> conformal;
  vtkNew<vtkFlattenRegion> region;
  region->SetInputConnection(conformal->GetOutputPort());
  region->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Label");
  region->SetLabel(1);
  vtkNew<vtkConformalDiskFilter> again;
  again->SetInputConnection(conformal->GetOutputPort());
  conformal->SetInputData(bump);
  region->Update();
  again->Update();
  EXPECT_LT(textureError(region->GetOutput()), 1e-7);
  EXPECT_LT(textureError(again->GetOutput()), 1e-7);
  vtkDataArray* ids = region->GetOutput()->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* own = region->GetOutput()->GetPointData()->GetArray("SurfaceTCoords");
  ASSERT_NE(own, nullptr);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ASSERT_TRUE(ids->GetTuple1(i) < 0 || own->GetComponent(i, 0) == ids->GetTuple1(i));
  }
  own = again->GetOutput()->GetPointData()->GetArray("SurfaceTCoords");
  ASSERT_NE(own, nullptr);
  for (vtkIdType i = 0; i < bump->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(own->GetComponent(i, 0), static_cast<double>(i));
  }

  vtkNew<vtkPolyData> plain; // a surface without texture coordinates has none on the second map
  plain->ShallowCopy(bump);
  plain->GetPointData()->RemoveArray("TCoords");
  conformal->SetInputData(plain);
  region->Update();
  EXPECT_FALSE(region->GetOutput()->GetPointData()->HasArray("SurfaceTCoords"));
}

// Active texture coordinates of another name, as of ParaView's Texture Map to Sphere, stay an array.
TEST(TextureCoordinates, ThoseOfAnotherNameStay)
{
  const auto bump = photographedBump();
  bump->GetPointData()->GetTCoords()->SetName("Texture Coordinates");
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(bump);
  conformal->Update();
  EXPECT_LT(textureError(conformal->GetOutput()), 1e-7);
  vtkDataArray* own = conformal->GetOutput()->GetPointData()->GetArray("Texture Coordinates");
  ASSERT_NE(own, nullptr);
  EXPECT_EQ(own->GetComponent(7, 0), 7.0);
}

} // namespace
