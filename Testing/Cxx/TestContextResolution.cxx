// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Core/Support/SampleSurfaces.h"
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkContextResolution.h>
#include <vtkDistortionMetrics.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::testing;

// A hemisphere with the region 1 around a point half way down, 2 % of its points.
vtkSmartPointer<vtkPolyData> hemisphere()
{
  const auto data =
    polyDataOf(analytic::sunflowerMesh(analytic::sphericalCap(0.5 * samples::Pi), 12000).Mesh);
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    region->InsertNextValue(x[0] + x[2] > 1.4 ? 1 : 0);
    height->InsertNextValue(x[2]);
  }
  data->GetPointData()->AddArray(region);
  data->GetPointData()->AddArray(height);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  for (int c = 0; c < data->GetNumberOfCells(); ++c)
  {
    number->InsertNextValue(3 * c);
  }
  data->GetCellData()->AddArray(number);
  return data;
}

void choose(vtkAlgorithm* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

TEST(ContextResolution, RegionsAreAsTheyWereAndArraysComeAlong)
{
  const auto input = hemisphere();
  vtkNew<vtkContextResolution> filter;
  filter->SetInputData(input);
  choose(filter, "Region");
  filter->SetContextFaces(1500);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_NEAR(figure(output, "ContextCells"), 1500, 60);
  EXPECT_EQ(figure(output, "ContextCells") + figure(output, "KeptCells"), output->GetNumberOfCells());
  vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
  int inRegion = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    // Between the points the hemisphere is a little lower than their mean.
    EXPECT_NEAR(output->GetPointData()->GetArray("Height")->GetTuple1(i), x[2], 0.01);
    if (id >= 0 && input->GetPointData()->GetArray("Region")->GetTuple1(id) == 1)
    {
      double before[3];
      input->GetPoint(id, before);
      EXPECT_EQ(std::hypot(x[0] - before[0], x[1] - before[1], x[2] - before[2]), 0.0);
      ++inRegion;
    }
  }
  EXPECT_EQ(inRegion, figure(output, "RegionPoints"));
  EXPECT_EQ(inRegion, sum(input->GetPointData()->GetArray("Region")));
  vtkDataArray* cells = output->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(c), 3.0 * cells->GetTuple1(c));
  }
}

// The area of the region on the flat map of the coarse surface, and of the whole one.
TEST(ContextResolution, TheRegionHasTheSameAreaOnTheMap)
{
  vtkNew<vtkContextResolution> filter;
  filter->SetInputData(hemisphere());
  choose(filter, "Region");
  filter->SetContextFaces(1500);
  double areas[2];
  for (const int coarse : { 0, 1 })
  {
    vtkNew<vtkConformalDiskFilter> conformal;
    coarse ? conformal->SetInputConnection(filter->GetOutputPort())
           : conformal->SetInputData(hemisphere());
    vtkNew<vtkOMTAreaPreservingFilter> transported;
    transported->SetInputConnection(conformal->GetOutputPort());
    vtkNew<vtkDistortionMetrics> metrics;
    metrics->SetInputConnection(transported->GetOutputPort());
    choose(metrics, "Region");
    metrics->Update();
    EXPECT_EQ(figure(transported->GetOutput(), "Bijective"), 1);
    areas[coarse] = metrics->GetSummary()->GetValueByName(1, "FlatArea").ToDouble();
  }
  std::cout << "area of the region: " << areas[0] << ", with a coarse context " << areas[1] << "\n";
  EXPECT_NEAR(areas[1], areas[0], 0.002 * areas[0]);
}

TEST(ContextResolution, CellsMakeARegionToo)
{
  const auto input = hemisphere();
  vtkNew<vtkIntArray> one;
  one->SetName("One");
  one->SetNumberOfTuples(input->GetNumberOfCells());
  one->Fill(0);
  one->SetValue(500, 7);
  input->GetCellData()->AddArray(one);
  vtkNew<vtkContextResolution> filter;
  filter->SetInputData(input);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "One");
  filter->SetContextFaces(2000);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "RegionPoints"), 3);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("One")->GetRange()[1], 7);
}

TEST(ContextResolution, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkContextResolution> filter;
  ErrorLog errors(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

TEST(ContextResolution, ReportsWhatIsWrong)
{
  vtkNew<vtkContextResolution> filter;
  const auto input = hemisphere();
  const auto expectMessage = [&filter](const std::string& words)
  {
    ErrorLog errors(filter);
    filter->Modified();
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u) << words;
    EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  };
  filter->SetInputData(input);
  expectMessage("no array of regions is chosen");
  choose(filter, "None");
  expectMessage("no array of regions is chosen");
  choose(filter, "Missing");
  expectMessage("Missing is not a point or cell array of one component");
  choose(filter, "Region");
  filter->SetContextFaces(0);
  expectMessage("positive number");
  filter->SetContextFaces(1000);
  vtkNew<vtkDoubleArray> nowhere;
  nowhere->SetName("Nowhere");
  nowhere->SetNumberOfTuples(input->GetNumberOfPoints());
  nowhere->Fill(0.0);
  input->GetPointData()->AddArray(nowhere);
  choose(filter, "Nowhere");
  expectMessage("no point is in a region");
  nowhere->SetValue(5, std::numeric_limits<double>::quiet_NaN());
  expectMessage("Nowhere has no number at 5");
  choose(filter, "Region");
  ErrorLog errors(filter);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 500);
}

} // namespace
