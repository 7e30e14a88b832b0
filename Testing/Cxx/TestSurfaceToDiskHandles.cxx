// SPDX-License-Identifier: GPL-3.0-or-later
/// What vtkSurfaceToDiskFilter does about handles: a torus, and a slab with three holes.
#include "SurfaceToDiskChecks.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace
{

using namespace disk_tests;

class SurfaceToDiskHandles : public ::testing::TestWithParam<int>
{
protected:
  vtkSmartPointer<vtkPolyData> Surface = this->GetParam() == 1 ? torus(48, 24) : slabWithHoles(3);
  double Area = areaOf(this->Surface);
  vtkNew<vtkSurfaceToDiskFilter> Filter;
};

TEST_P(SurfaceToDiskHandles, AreRemoved)
{
  const auto output = run(this->Filter, this->Surface);
  expectDisk(output);
  EXPECT_EQ(figure(output, "Genus"), this->GetParam());
  EXPECT_EQ(figure(output, "RemovedHandles"), this->GetParam());
  vtkDataArray* loops = output->GetFieldData()->GetArray("HandleLoopLengths");
  ASSERT_EQ(loops->GetNumberOfTuples(), this->GetParam());
  // Around the tube of the torus; through a square hole and around the bar beside it.
  const double shortest = this->GetParam() == 1 ? 2.0 * Pi : 4.0;
  for (int i = 0; i < this->GetParam(); ++i)
  {
    EXPECT_NEAR(loops->GetTuple1(i), shortest, 0.02 * shortest);
  }
  EXPECT_NEAR(figure(output, "SeamLength"), figure(output, "ReliefLength"), 1e-9); // no handle is cut
  const double changed = figure(output, "HandleAreaAdded") - figure(output, "HandleAreaRemoved");
  EXPECT_GT(figure(output, "HandleAreaAdded"), 0.0);
  EXPECT_NEAR(figure(output, "SurfaceArea"),
    this->Area + changed - figure(output, "RemovedArea"),
    2e-3 * this->Area); // the angles opened
  EXPECT_NEAR(areaOf(output), figure(output, "SurfaceArea"), 1e-12 * this->Area);
}

TEST_P(SurfaceToDiskHandles, AreCutWithoutAnyLoss)
{
  this->Filter->SetHandleModeToCut();
  const auto output = run(this->Filter, this->Surface);
  expectDisk(output);
  EXPECT_EQ(figure(output, "Genus"), this->GetParam());
  EXPECT_EQ(figure(output, "RemovedHandles"), 0);
  EXPECT_EQ(output->GetFieldData()->GetArray("HandleLoopLengths")->GetNumberOfTuples(), 0);
  EXPECT_EQ(figure(output, "RemovedArea"), 0.0);
  EXPECT_NEAR(areaOf(output), this->Area, 1e-12 * this->Area);
  EXPECT_NEAR(figure(output, "SurfaceArea"), this->Area, 1e-12 * this->Area);

  EXPECT_GE(figure(output, "BoundaryVertices"), 128);
  EXPECT_EQ(seamPoints(output), boundaryPoints(output));
  EXPECT_NEAR(figure(output, "BoundaryLength"),
    2.0 * figure(output, "SeamLength"),
    1e-12 * figure(output, "BoundaryLength"));
  // Every point of the input is there, those on the seam, which has no ends, more than once.
  std::map<vtkIdType, int> uses;
  const auto idOf = [&output](vtkIdType i)
  {
    return static_cast<vtkIdType>(output->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(i));
  };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ++uses[idOf(i)];
  }
  uses.erase(-1);
  EXPECT_EQ(static_cast<vtkIdType>(uses.size()), this->Surface->GetNumberOfPoints());
  const std::set<vtkIdType> seam = seamPoints(output);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_TRUE(idOf(i) < 0 || (uses[idOf(i)] > 1) == (seam.count(i) > 0)) << i;
  }
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("Filled")->GetTuple1(c), 0);
  }
}

// A hole at a corner of either surface, a seam in a straight line; both besides the cut of the handles.
TEST_P(SurfaceToDiskHandles, AreCutBesidesTheHoleOrSeamAskedFor)
{
  this->Filter->SetHandleModeToCut();
  const double cutAlone = figure(run(this->Filter, this->Surface), "SeamLength");
  double corner[3];
  this->Surface->GetPoint(0, corner); // of the torus: (3 0 0)
  this->Filter->SetHolePoint(corner);
  EXPECT_EQ(figure(run(this->Filter, this->Surface), "HoleRadius"), 0.0); // the switch is off
  this->Filter->UseHolePointOn();
  const auto holed = run(this->Filter, this->Surface);
  expectDisk(holed);
  EXPECT_EQ(figure(holed, "Genus"), this->GetParam());
  EXPECT_NEAR(figure(holed, "RemovedArea"), 1e-3 * this->Area, 1e-6 * this->Area);
  const double* centre = holed->GetFieldData()->GetArray("HoleCentre")->GetTuple3(0);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(centre[k], corner[k], 1e-9);
  }

  this->Filter->SetCutModeToSeam();
  EXPECT_EQ(figure(run(this->Filter, this->Surface), "SeamLength"), cutAlone); // the switch is off
  this->Filter->UseSeamPointsOn();
  this->Filter->AddSeamPoint(corner[0], corner[1], corner[2]);
  // A quarter of the way around the tube; along an edge of the slab.
  if (this->GetParam() == 1)
  {
    this->Filter->AddSeamPoint(2.0, 0.0, 1.0);
  }
  else
  {
    this->Filter->AddSeamPoint(corner[0] + 1.5, corner[1], corner[2]);
  }
  const auto seamed = run(this->Filter, this->Surface);
  expectDisk(seamed);
  EXPECT_EQ(figure(seamed, "RemovedArea"), 0.0);
  EXPECT_NEAR(areaOf(seamed), this->Area, 1e-12 * this->Area);
  EXPECT_EQ(seamPoints(seamed), boundaryPoints(seamed));
  double nearest = HUGE_VAL; // the seam's first point is on it
  for (const vtkIdType i : seamPoints(seamed))
  {
    double x[3];
    seamed->GetPoint(i, x);
    nearest = std::min(nearest, std::hypot(x[0] - corner[0], x[1] - corner[1], x[2] - corner[2]));
  }
  EXPECT_LT(nearest, 1e-9);
}

// The whole surface is of interest, so that there is no way around.
TEST_P(SurfaceToDiskHandles, CutThroughARegionOfInterestIsSaid)
{
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  region->SetNumberOfTuples(this->Surface->GetNumberOfPoints());
  region->Fill(1);
  this->Surface->GetPointData()->AddArray(region);
  this->Filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, region->GetName());
  this->Filter->SetHandleModeToCut();
  vtkNew<vtkTest::ErrorObserver> observer;
  this->Filter->AddObserver(vtkCommand::WarningEvent, observer);
  EXPECT_EQ(figure(run(this->Filter, this->Surface), "SeamRegionPoints"), 0);
  EXPECT_FALSE(observer->GetWarning());
  this->Filter->UseRegionOfInterestOn();
  const auto output = run(this->Filter, this->Surface);
  expectDisk(output);
  const double crossed = figure(output, "SeamRegionPoints");
  EXPECT_GT(crossed, 10.0);
  ASSERT_TRUE(observer->GetWarning());
  const std::string text = observer->GetWarningMessage();
  EXPECT_NE(text.find("runs through " + std::to_string(static_cast<int>(crossed)) + " points"),
    std::string::npos)
    << text;
  EXPECT_NE(text.find("set Handles to Remove"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Genus, SurfaceToDiskHandles, ::testing::Values(1, 3));

} // namespace
