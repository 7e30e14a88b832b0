// SPDX-License-Identifier: GPL-3.0-or-later
/// What vtkSurfaceToDiskFilter does about handles: a torus, and a slab with three holes.
#include "SurfaceToDiskChecks.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

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
  EXPECT_EQ(figure(output, "SeamLength"), 0.0);
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

INSTANTIATE_TEST_SUITE_P(Genus, SurfaceToDiskHandles, ::testing::Values(1, 3));

} // namespace
