// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterTest.h"
#include "PassedGrid.h"
#include "PlanarWarpSamples.h"

#include <vtkPlanarWarp.h>

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace
{

using namespace flattening::testing;

TEST(PlanarWarpImages, ImagesAreResampledByTheInverseMap)
{
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(deformed(plane(40), bend));
  filter->SetCarriedData(picture());
  filter->SetImageSize(200, 150);
  filter->NearestPixelOff();
  filter->Update();
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->GetDimensions()[0], 200);
  EXPECT_EQ(image->GetDimensions()[1], 150);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 0.01); // two wide, 1.25 high
  EXPECT_DOUBLE_EQ(image->GetSpacing()[1], 0.01);
  EXPECT_EQ(std::string(image->GetPointData()->GetScalars()->GetName()), "Ramp");
  vtkDataArray* ramp = image->GetPointData()->GetArray("Ramp");
  vtkDataArray* inMap = image->GetPointData()->GetArray("InMap");
  ASSERT_TRUE(image->GetPointData()->GetArray("Column"));
  int shown = 0;
  double worst = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double y = x[1] - 0.25 * x[0] * (2.0 - x[0]);
    const bool inside = y > 1e-3 && y < 1.0 - 1e-3 && x[0] > 0.0 && x[0] < 2.0;
    const bool outside = y < -1e-3 || y > 1.0 + 1e-3;
    EXPECT_FALSE(inside && inMap->GetTuple1(i) == 0) << x[0] << " " << y;
    EXPECT_FALSE(outside && inMap->GetTuple1(i) == 1) << x[0] << " " << y;
    if (inside)
    {
      ++shown;
      worst = std::max(worst, std::abs(ramp->GetTuple1(i) - (x[0] + 10.0 * y)));
    }
    else if (outside)
    {
      EXPECT_EQ(ramp->GetTuple1(i), 0.0);
    }
  }
  EXPECT_NEAR(shown, 20000, 100);                    // the area of 2 in pixels
  EXPECT_LT(worst, 10.0 * 0.5 / 40 / 40 / 8 * 1.01); // ten times what the mesh is off from the curve
  EXPECT_EQ(figure(image, "OutsidePoints"), 0);

  const auto labels = [&]
  {
    std::set<double> values;
    auto* output = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      values.insert(output->GetPointData()->GetArray("Label")->GetTuple1(i));
    }
    return values;
  };
  EXPECT_GT(labels().size(), 3u);
  filter->NearestPixelOn();
  filter->Update();
  EXPECT_EQ(labels(), (std::set<double>{ 0, 3, 900 }));

  filter->SetImageSize(0, 0);
  filter->Update();
  EXPECT_EQ(vtkImageData::SafeDownCast(filter->GetOutputDataObject(0))->GetDimensions()[0], 101);
}

TEST(PlanarWarpImages, ImageFiltersSeeThePixels)
{
  for (const bool leave : { false, true })
  {
    vtkNew<vtkPlanarWarp> filter;
    filter->SetInputData(deformed(plane(40), bend));
    filter->SetCarriedData(picture());
    filter->SetOutsidePoints(leave ? vtkPlanarWarp::LEAVE_UNMOVED : vtkPlanarWarp::REMOVE);
    filter->SetImageSize(20, 15);
    expectGridPassedOn(filter->GetOutputPort(), "InMap");
  }
}

TEST(PlanarWarpImages, ImageFiltersSeeTheValues)
{
  for (const char* scalars : { "Ramp", "Label" })
  {
    SCOPED_TRACE(scalars);
    const auto image = picture();
    image->GetPointData()->SetActiveScalars(scalars);
    vtkNew<vtkPlanarWarp> filter;
    filter->SetInputData(deformed(plane(40), bend));
    filter->SetCarriedData(image);
    filter->SetImageSize(20, 15);
    expectScalarsPassedOn(filter->GetOutputPort());
  }
}

TEST(PlanarWarpImages, ScalarsNeedNoName)
{
  const auto image = picture();
  vtkNew<vtkIntArray> label;
  label->DeepCopy(image->GetPointData()->GetArray("Label"));
  label->SetName(nullptr);
  image->GetPointData()->SetScalars(label);
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(deformed(plane(40), bend));
  filter->SetCarriedData(image);
  filter->SetImageSize(200, 150);
  filter->NearestPixelOn();
  filter->Update();
  vtkPointData* pixels = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  vtkDataArray* labels = pixels->GetScalars();
  ASSERT_NE(labels, nullptr);
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(labels->GetTuple1(i), pixels->GetArray("Label")->GetTuple1(i));
  }
}

TEST(PlanarWarpImages, AnImageAroundTheMeshIsLeftUnmoved)
{
  // The mesh covers the left half of the picture and is deformed within it.
  const auto half = plane(20);
  for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i)
  {
    const double* x = half->GetPoint(i);
    half->GetPoints()->SetPoint(i, 0.5 * x[0], x[1], 0.0);
  }
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(deformed(half, [](double* x) { x[0] = 0.5 * (x[0] + x[0] * x[0]); }));
  filter->SetCarriedData(picture());
  filter->SetOutsidePointsToLeaveUnmoved();
  filter->SetImageSize(400, 200);
  filter->Update();
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(sum(image->GetPointData()->GetArray("InMap")), 400 * 200);
  double unmoved = 0.0;
  double moved = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double value = image->GetPointData()->GetArray("Ramp")->GetTuple1(i) - 10.0 * x[1];
    if (x[0] > 1.0)
    {
      unmoved = std::max(unmoved, std::abs(value - x[0]));
    }
    else
    {
      moved = std::max(moved, std::abs(0.5 * (value + value * value) - x[0]));
    }
  }
  EXPECT_LT(unmoved, 1e-12);
  EXPECT_LT(moved, 1.0 / 40 / 40 / 8 * 1.01); // f'' h^2 / 8
}

// Resampling of a plane gives pixels without thickness.
TEST(PlanarWarpImages, ThePixelsNeedNoThickness)
{
  for (const bool isTexture : { false, true })
  {
    vtkNew<vtkPlanarWarp> filter;
    filter->SetInputData(doubled());
    const auto image = picture();
    filter->SetCarriedData(image);
    filter->SetImageOutput(isTexture ? vtkPlanarWarp::TEXTURED_MESH : vtkPlanarWarp::RESAMPLED_IMAGE);
    filter->Update();
    const auto expected = vtk::TakeSmartPointer(filter->GetOutputDataObject(0)->NewInstance());
    expected->DeepCopy(filter->GetOutputDataObject(0));
    image->SetSpacing(image->GetSpacing()[0], image->GetSpacing()[1], 0.0);
    filter->Update();
    const auto values = [isTexture](vtkDataObject* data)
    {
      vtkFieldData* points = data->GetAttributes(vtkDataObject::POINT);
      return points->GetArray(isTexture ? "TCoords" : "Ramp");
    };
    vtkDataArray* found = values(filter->GetOutputDataObject(0));
    ASSERT_EQ(found->GetNumberOfTuples(), values(expected)->GetNumberOfTuples());
    for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(found->GetComponent(i, 0), values(expected)->GetComponent(i, 0)) << i;
    }
  }
}

TEST(PlanarWarpImages, TheMeshCanCarryTheImageAsATexture)
{
  vtkNew<vtkPlanarWarp> filter;
  const auto mesh = doubled();
  filter->SetInputData(mesh);
  filter->SetCarriedData(picture());
  filter->SetImageOutputToTexturedMesh();
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_EQ(output->GetNumberOfCells(), mesh->GetNumberOfCells());
  vtkDataArray* coordinates = output->GetPointData()->GetTCoords();
  ASSERT_TRUE(coordinates);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* x = output->GetPoint(i); // twice what it was; pixel 0's centre is half a pixel inside
    EXPECT_NEAR(coordinates->GetComponent(i, 0), (x[0] / 2.0 / 0.02 + 0.5) / 101, 1e-6);
    EXPECT_NEAR(coordinates->GetComponent(i, 1), (x[1] / 2.0 / 0.02 + 0.5) / 51, 1e-6);
  }
  EXPECT_EQ(figure(output, "OutsidePoints"), 0);
  EXPECT_FALSE(mesh->GetPointData()->GetTCoords());
}

TEST(PlanarWarpImages, CanBeStopped)
{
  struct Stop
  {
    vtkAlgorithm* Filter;
    int Reports = 0;
    void now()
    {
      ++this->Reports;
      this->Filter->SetAbortExecute(1);
    }
  };
  vtkNew<vtkPlanarWarp> filter;
  ErrorLog errors(filter);
  Stop stop{ filter };
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, &stop, &Stop::now);
  filter->SetInputData(doubled());
  filter->SetCarriedData(picture());
  filter->Update();
  EXPECT_GE(stop.Reports, 1);
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  EXPECT_TRUE(errors.messages().empty());

  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 101 * 51);
  EXPECT_TRUE(errors.messages().empty());
}

} // namespace
