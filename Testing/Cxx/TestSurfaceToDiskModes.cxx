// SPDX-License-Identifier: GPL-3.0-or-later
/// The choices of vtkSurfaceToDiskFilter: cuts, boundaries, regions of interest, conditioning.
#include "SurfaceToDiskChecks.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkCylinderSource.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace disk_tests;

double distanceBetween(vtkPolyData* data, const std::vector<vtkIdType>& points, vtkPolyData* output)
{
  double nearest = HUGE_VAL;
  for (const vtkIdType boundary : boundaryPoints(output))
  {
    double x[3];
    output->GetPoint(boundary, x);
    for (const vtkIdType i : points)
    {
      double y[3];
      data->GetPoint(i, y);
      nearest = std::min(nearest, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
    }
  }
  return nearest;
}

// 64 sides about the y axis, radius 1 at y = -1 and 1.5 at y = 1, open at both ends.
vtkSmartPointer<vtkPolyData> openTube()
{
  vtkNew<vtkCylinderSource> source;
  source->SetResolution(64);
  source->SetRadius(1.0);
  source->SetHeight(2.0);
  source->CappingOff();
  source->Update();
  vtkSmartPointer<vtkPolyData> tube = source->GetOutput();
  tube->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    double x[3];
    tube->GetPoint(i, x);
    if (x[1] > 0)
    {
      tube->GetPoints()->SetPoint(i, 1.5 * x[0], x[1], 1.5 * x[2]);
    }
  }
  return tube;
}

TEST(SurfaceToDiskModes, SeamRunsThroughItsPointsAndLosesNothing)
{
  const auto input = sphere(60);
  const double area = areaOf(input);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToSeam();
  filter->UseSeamPointsOn();
  filter->AddSeamPoint(0.5, 0.0, 0.0);
  filter->AddSeamPoint(0.0, 0.5, 0.0);
  filter->AddSeamPoint(0.0, 0.0, 0.5);
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_NEAR(figure(output, "SeamLength"), 0.5 * Pi, 0.003); // two quarters of a circle of radius 0.5
  EXPECT_NEAR(figure(output, "BoundaryLength"), 2.0 * figure(output, "SeamLength"), 1e-12);
  EXPECT_GE(figure(output, "BoundaryVertices"), 128);
  EXPECT_NEAR(areaOf(output), area, 1e-12 * area);
  EXPECT_EQ(figure(output, "RemovedArea"), 0.0);
  EXPECT_EQ(figure(output, "HoleRadius"), 0.0);
  EXPECT_EQ(seamPoints(output), boundaryPoints(output));
  for (const vtkIdType i : seamPoints(output))
  {
    double x[3];
    output->GetPoint(i, x);
    EXPECT_LT(std::min(std::abs(x[2]), std::abs(x[0])), 0.01); // on either of the two arcs
    EXPECT_GT(x[0] + x[1] + x[2], 0.45);
  }
}

TEST(SurfaceToDiskModes, SeamWithoutPointsRunsFromEndToEndOfAClosedSurface)
{
  const auto input = sphere(40);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToSeam();
  filter->AddSeamPoint(9.0, 9.0, 9.0); // not used, as the switch is off
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_NEAR(figure(output, "SeamLength"), 0.5 * Pi, 0.08);
  EXPECT_NEAR(areaOf(output), areaOf(input), 1e-12 * areaOf(input));

  const auto open = run(filter, square(12));
  expectDisk(open);
  EXPECT_EQ(figure(open, "SeamLength"), 0.0);
  EXPECT_EQ(open->GetNumberOfPoints(), 169);
}

TEST(SurfaceToDiskModes, SeamLengthensTheBoundaryOfAnOpenSurface)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToSeam();
  filter->UseSeamPointsOn();
  filter->AddSeamPoint(0.0, 0.5, 0.0);
  filter->AddSeamPoint(0.4, 0.5, 0.0);
  const auto output = run(filter, square(40));
  expectDisk(output);
  EXPECT_NEAR(figure(output, "SeamLength"), 0.4, 1e-12);
  EXPECT_NEAR(figure(output, "BoundaryLength"), 4.8, 1e-12);
  EXPECT_GE(figure(output, "BoundaryVertices"), 160 + 2 * 16);
  EXPECT_NEAR(areaOf(output), 1.0, 1e-12);
}

// A capsule along x: its caps hold all of the curvature, and a relief joins them.
TEST(SurfaceToDiskModes, ReliefRunsWhereTheCurvatureIs)
{
  const auto input = sphere(60);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    double x[3];
    input->GetPoint(i, x);
    input->GetPoints()->SetPoint(i, x[0] + (x[0] > 0.0 ? 1.0 : -1.0) * 2.0 * std::abs(x[0]), x[1], x[2]);
  }
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToRelief();
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_GE(figure(output, "ReliefBranches"), 1);
  EXPECT_GT(figure(output, "ReliefLength"), 2.4);
  // One is a sum over branches, the other a difference of boundaries.
  EXPECT_NEAR(figure(output, "ReliefLength"), figure(output, "SeamLength"), 1e-12);
  EXPECT_NEAR(figure(output, "BoundaryLength"), 2.0 * figure(output, "SeamLength"), 1e-12);
  EXPECT_GE(figure(output, "BoundaryVertices"), 128);
  EXPECT_NEAR(areaOf(output), areaOf(input), 1e-12 * areaOf(input));
  EXPECT_EQ(figure(output, "RemovedArea"), 0.0);
  EXPECT_EQ(seamPoints(output), boundaryPoints(output));
  double strain[2];
  output->GetFieldData()->GetArray("ReliefStrain")->GetTuple(0, strain);
  EXPECT_LT(strain[1], 0.4 * strain[0]);
  double ends[2] = { 0.0, 0.0 };
  for (const vtkIdType i : seamPoints(output))
  {
    ends[0] = std::min(ends[0], output->GetPoint(i)[0]);
    ends[1] = std::max(ends[1], output->GetPoint(i)[0]);
  }
  EXPECT_LT(ends[0], -1.3); // the tips are at -1.5 and 1.5
  EXPECT_GT(ends[1], 1.3);
}

// A flat sheet needs no relief, and stays as it is.
TEST(SurfaceToDiskModes, ReliefLeavesFlatSheetsAlone)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToRelief();
  filter->SetReliefGain(1e-6);
  const auto output = run(filter, square(20));
  expectDisk(output);
  EXPECT_EQ(figure(output, "ReliefBranches"), 0);
  EXPECT_EQ(figure(output, "SeamLength"), 0.0);
  EXPECT_EQ(output->GetNumberOfPoints(), 441);
}

// After the handles were removed, or cut first.
TEST(SurfaceToDiskModes, ReliefOpensSurfacesThatHadHandles)
{
  for (const int mode : { vtkSurfaceToDiskFilter::REMOVE_HANDLES, vtkSurfaceToDiskFilter::CUT_HANDLES })
  {
    vtkNew<vtkSurfaceToDiskFilter> filter;
    filter->SetCutModeToRelief();
    filter->SetHandleMode(mode);
    const auto output = run(filter, torus(60, 30));
    expectDisk(output);
    EXPECT_GT(output->GetFieldData()->GetArray("ReliefStrain")->GetComponent(0, 0), 0.0) << mode;
    // At least as long, but for the rounding of sums in another order.
    EXPECT_GE(figure(output, "SeamLength"), (1.0 - 1e-12) * figure(output, "ReliefLength")) << mode;
  }
}

// The relief of a closed surface is shorter than one that is made for a free outline, whatever the gain
// below 0.07, unless the outline will be free, and a flat surface keeps its boundary.
TEST(SurfaceToDiskModes, AutomaticOpensClosedSurfacesAndLeavesFlatOnes)
{
  const auto input = sphere(60);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToAutomatic();
  filter->SetReliefGain(1e-3);
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_EQ(figure(output, "ChosenCut"), vtkSurfaceToDiskFilter::RELIEF);
  EXPECT_GE(figure(output, "ReliefBranches"), 2);
  filter->SetReliefGain(0.07);
  EXPECT_EQ(figure(run(filter, input), "ReliefLength"), figure(output, "ReliefLength"));
  filter->SetReliefGain(1e-3);
  filter->SetCutModeToRelief();
  const double longer = figure(run(filter, input), "ReliefLength");
  EXPECT_GT(longer, figure(output, "ReliefLength"));
  filter->SetCutModeToAutomatic();
  filter->FreeOutlineOn();
  EXPECT_EQ(figure(run(filter, input), "ReliefLength"), longer);
  filter->FreeOutlineOff();
  EXPECT_EQ(figure(output, "RemovedArea"), 0.0);
  const auto reason = output->GetFieldData()->GetAbstractArray("ReasonOfCut");
  ASSERT_TRUE(reason);
  EXPECT_NE(reason->GetVariantValue(0).ToString().find("a relief"), std::string::npos);

  const auto open = run(filter, square(12));
  expectDisk(open);
  EXPECT_EQ(figure(open, "ChosenCut"), -1);
  EXPECT_EQ(figure(open, "SeamLength"), 0.0);
  EXPECT_EQ(open->GetNumberOfPoints(), 169);

  filter->SetHandleModeToCut();
  const auto ring = run(filter, torus(40, 20));
  expectDisk(ring);
  EXPECT_EQ(figure(ring, "ChosenCut"), -1);
  EXPECT_EQ(figure(ring, "ReliefBranches"), 0);
}

TEST(SurfaceToDiskModes, LabelIsRemovedAndItsBorderIsTheBoundary)
{
  const auto input = sphere(60);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Labels");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    labels->InsertNextValue(input->GetPoint(i)[2] > 0.3 ? 7 : 1);
  }
  input->GetPointData()->AddArray(labels);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToLabel();
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Labels");
  filter->SetCutLabel(7);
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_NEAR(figure(output, "RemovedArea"), 0.2 * areaOf(input), 0.02 * areaOf(input));
  EXPECT_NEAR(figure(output, "RemovedArea") + areaOf(output), areaOf(input), 1e-12);
  for (const vtkIdType i : boundaryPoints(output))
  {
    EXPECT_NEAR(output->GetPoint(i)[2], 0.3, 0.05);
  }
}

// A cut through the centre of a sphere and one at z = 0.3, both aslant to its edges.
TEST(SurfaceToDiskModes, PlaneKeepsTheSideThatItsNormalPointsTo)
{
  const auto input = sphere(80);
  const double area = areaOf(input);
  double normal[] = { 3.0, -1.0, 2.0 };
  const double length = std::sqrt(14.0);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToPlane();
  filter->SetPlaneNormal(normal);
  double kept = 0.0;
  for (const double offset : { 0.0, 0.3 })
  {
    filter->SetPlaneOrigin(
      offset * normal[0] / length, offset * normal[1] / length, offset * normal[2] / length);
    const auto output = run(filter, input);
    expectDisk(output);
    // Archimedes: a cap's area goes with its height.
    EXPECT_NEAR(areaOf(output) / area, 0.5 - offset, 2e-3);
    EXPECT_NEAR(areaOf(output) + figure(output, "RemovedArea"), area, 2e-3 * area);
    EXPECT_NEAR(figure(output, "BoundaryLength"), 2.0 * Pi * std::sqrt(0.25 - offset * offset), 5e-3);
    EXPECT_GE(figure(output, "BoundaryVertices"), 128);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double x[3];
      output->GetPoint(i, x);
      EXPECT_GT((x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2]) / length, offset - 1e-12);
    }
    for (const vtkIdType i : boundaryPoints(output))
    {
      double x[3];
      output->GetPoint(i, x);
      EXPECT_NEAR((x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2]) / length, offset, 1e-12);
    }
    kept = areaOf(output);
  }
  filter->SetPlaneNormal(-normal[0], -normal[1], -normal[2]);
  EXPECT_NEAR(areaOf(run(filter, input)) + kept, area, 2e-3 * area);
}

// A tube with a wide end at the top, with one at the bottom: both can be the boundary.
TEST(SurfaceToDiskModes, BoundaryIsTheChosenOne)
{
  const auto input = openTube();
  const double wide = 64 * 2.0 * 1.5 * std::sin(Pi / 64);
  const double narrow = 64 * 2.0 * std::sin(Pi / 64);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetFillLengthLimit(9.5);
  filter->SetSmallestAngle(0.0);
  const auto longest = run(filter, input);
  expectDisk(longest);
  EXPECT_NEAR(figure(longest, "BoundaryLength"), wide, 1e-6);
  EXPECT_EQ(figure(longest, "FilledHoles"), 1);

  filter->SetBoundaryModeToClosestToPoint();
  filter->SetBoundaryPoint(0.0, -5.0, 0.0);
  const auto closest = run(filter, input);
  expectDisk(closest);
  EXPECT_NEAR(figure(closest, "BoundaryLength"), narrow, 1e-6);
  // The flat patch: a polygon of 64 sides.
  EXPECT_NEAR(figure(closest, "FilledArea"), 32.0 * 2.25 * std::sin(2.0 * Pi / 64), 1e-6);

  filter->SetBoundaryPoint(0.0, -1e200, 0.0);
  EXPECT_EQ(figure(run(filter, input), "FilledHoles"), 1);

  filter->SetBoundaryModeToFillAll();
  const auto closed = run(filter, input);
  expectDisk(closed);
  EXPECT_EQ(figure(closed, "FilledHoles"), 2);
  EXPECT_EQ(figure(closed, "ChosenCut"), vtkSurfaceToDiskFilter::RELIEF);
  EXPECT_GE(figure(closed, "BoundaryVertices"), 128);
}

TEST(SurfaceToDiskModes, ComponentsAreNumberedByArea)
{
  vtkNew<vtkAppendPolyData> append;
  for (const double radius : { 1.0, 3.0, 2.0 })
  {
    const auto ball = sphere(16);
    for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
    {
      double x[3];
      ball->GetPoint(i, x);
      ball->GetPoints()->SetPoint(i, radius * x[0] + 10.0 * radius, radius * x[1], radius * x[2]);
    }
    append->AddInputData(ball);
  }
  append->Update();
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetComponentModeToByIndex();
  for (int index = 0; index < 3; ++index)
  {
    filter->SetComponentIndex(index);
    const auto output = run(filter, append->GetOutput());
    expectDisk(output);
    EXPECT_NEAR(output->GetCenter()[0], 10.0 * (3 - index), 0.5);
    EXPECT_EQ(figure(output, "Components"), 3);
    const double whole = areaOf(sphere(16));
    const double dropped = (14.0 - (3 - index) * (3 - index)) * whole;
    EXPECT_NEAR(figure(output, "DroppedComponentArea"), dropped, 1e-6 * dropped);
  }
}

// The hole that is placed without a region, and the seam, are forbidden; so they move.
TEST(SurfaceToDiskModes, RegionOfInterestIsLeftAlone)
{
  for (const bool perPoint : { true, false })
  {
    for (const int cut : { vtkSurfaceToDiskFilter::HOLE, vtkSurfaceToDiskFilter::SEAM })
    {
      SCOPED_TRACE(std::to_string(perPoint) + " " + std::to_string(cut));
      const auto input = sphere(40);
      vtkNew<vtkSurfaceToDiskFilter> filter;
      filter->SetCutMode(cut);
      const auto anywhere = run(filter, input);
      double centre[3] = { 0, 0, 0 };
      anywhere->GetPoint(*boundaryPoints(anywhere).begin(), centre);

      // All within 0.3 of a point of that boundary.
      std::vector<vtkIdType> region;
      vtkNew<vtkIntArray> mark;
      mark->SetName("Region");
      mark->SetNumberOfTuples(perPoint ? input->GetNumberOfPoints() : input->GetNumberOfCells());
      mark->Fill(0);
      vtkNew<vtkIdList> corners;
      for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
      {
        input->GetCellPoints(c, corners);
        bool inside = true;
        for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
        {
          double x[3];
          input->GetPoint(corners->GetId(k), x);
          inside &= std::hypot(x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]) < 0.3;
        }
        for (vtkIdType k = 0; inside && k < corners->GetNumberOfIds(); ++k)
        {
          region.push_back(corners->GetId(k));
          mark->SetValue(perPoint ? corners->GetId(k) : c, 7);
        }
      }
      ASSERT_GT(region.size(), 30u);
      input->GetPointData()->Initialize();
      static_cast<vtkFieldData*>(
        perPoint ? static_cast<vtkDataSetAttributes*>(input->GetPointData()) : input->GetCellData())
        ->AddArray(mark);
      filter->SetInputArrayToProcess(0,
        0,
        0,
        perPoint ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS,
        "Region");
      EXPECT_LT(distanceBetween(input, region, run(filter, input)), 0.05); // the switch is off
      filter->UseRegionOfInterestOn();
      const auto output = run(filter, input);
      expectDisk(output);
      EXPECT_GT(distanceBetween(input, region, output), 0.02);
      EXPECT_EQ(figure(output, "RemovedRegionPoints"), 0);
    }
  }
}

TEST(SurfaceToDiskModes, RelativeEdgeLengthIsInMeanEdgesOfTheSurface)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->RemeshOn();
  for (const double relative : { 0.5, 1.0, 2.0 })
  {
    filter->SetRelativeEdgeLength(relative);
    const auto output = run(filter, square(40));
    expectDisk(output);
    // Every quad has an edge of each direction and a diagonal.
    const double length = relative * (2.0 + std::sqrt(2.0)) / 3.0 / 40.0;
    EXPECT_NEAR(figure(output, "RemeshEdgeLength"), length, 0.01 * length);
    const double equilateral = 1.0 / (0.25 * std::sqrt(3.0) * length * length);
    EXPECT_NEAR(output->GetNumberOfCells(), equilateral, 0.2 * equilateral);
    EXPECT_GE(figure(output, "SmallestAngle"), 1.0);
    EXPECT_NEAR(areaOf(output), 1.0, 1e-12);
  }
}

// A sphere whose parallels lie close together: needles of 0.2 degrees.
TEST(SurfaceToDiskModes, SmallAnglesAreOpened)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(600);
  source->SetPhiResolution(12);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* input = source->GetOutput();
  input->GetPointData()->Initialize();
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToHole(); // far from the needles
  filter->SetSmallestAngle(0.0);
  const auto needles = run(filter, input);
  EXPECT_LT(figure(needles, "SmallestAngle"), 0.7);
  filter->SetSmallestAngle(1.0);
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_GE(figure(output, "SmallestAngle"), 1.0);
  EXPECT_NEAR(areaOf(output), areaOf(needles), 0.01 * areaOf(needles));
}

// A point of a sphere drawn out to four times its radius.
TEST(SurfaceToDiskModes, SpikesAreFlattened)
{
  const auto input = sphere(40);
  const double area = areaOf(input);
  double x[3];
  input->GetPoint(500, x);
  input->GetPoints()->SetPoint(500, 4.0 * x[0], 4.0 * x[1], 4.0 * x[2]);
  const double spike = areaOf(input) - area;
  ASSERT_GT(spike, 0.05 * area);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  EXPECT_TRUE(filter->GetFlattenFolds());
  const auto flattened = run(filter, input);
  expectDisk(flattened);
  EXPECT_EQ(figure(flattened, "RemovedSpikes"), 1);
  EXPECT_EQ(figure(flattened, "RemovedFins"), 0);
  EXPECT_NEAR(figure(flattened, "FoldAreaChange"), -spike, 2e-3 * area);
  EXPECT_NEAR(areaOf(flattened) + figure(flattened, "RemovedArea"), area, 2e-3 * area);

  for (const bool cutHandles : { false, true })
  {
    filter->SetFlattenFolds(cutHandles);
    filter->SetHandleMode(
      cutHandles ? vtkSurfaceToDiskFilter::CUT_HANDLES : vtkSurfaceToDiskFilter::REMOVE_HANDLES);
    filter->SetSmallestAngle(0.0); // the spike has needles
    const auto output = run(filter, input);
    expectDisk(output);
    EXPECT_EQ(figure(output, "RemovedSpikes"), 0);
    EXPECT_EQ(figure(output, "FoldAreaChange"), 0.0);
    EXPECT_NEAR(areaOf(output) + figure(output, "RemovedArea"), area + spike, 2e-3 * area);
  }
}

TEST(SurfaceToDiskModes, ReportsEveryFigure)
{
  const auto input = slabWithHoles(3);
  vtkNew<vtkIntArray> own;
  own->SetName("Patient");
  own->InsertNextValue(42);
  input->GetFieldData()->AddArray(own);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto output = run(filter, input);
  const std::map<std::string, int> tuples{ { "HandleLoopLengths", 3 } };
  const std::map<std::string, int> components{ { "HoleCentre", 3 }, { "ReliefStrain", 2 } };
  const auto at = [](const std::map<std::string, int>& map, const std::string& name)
  { return map.count(name) ? map.at(name) : 1; };
  const std::vector<std::string> names{
    "DroppedCells",
    "MergedPoints",
    "UnusedPoints",
    "DroppedFaces",
    "DroppedDegenerateFaces",
    "DroppedDuplicateFaces",
    "ClosedCracks",
    "SplitPoints",
    "Components",
    "DroppedComponents",
    "DroppedComponentArea",
    "ReorientedFaces",
    "RemovedSpikes",
    "RemovedFins",
    "FoldAreaChange",
    "LeftFolded",
    "FilledHoles",
    "FilledArea",
    "Genus",
    "RemovedHandles",
    "HandleLoopLengths",
    "HandleAreaRemoved",
    "HandleAreaAdded",
    "HandleDisplacement",
    "RemeshEdgeLength",
    "RemeshAreaChange",
    "HoleCentre",
    "HoleRadius",
    "SeamLength",
    "ChosenCut",
    "ReliefBranches",
    "ReliefLength",
    "ReliefStrain",
    "RemovedArea",
    "RemovedRegionPoints",
    "SeamRegionPoints",
    "BoundaryVertices",
    "BoundaryLength",
    "SurfaceArea",
    "SmallestAngle",
    "SelfIntersectionsBefore",
    "SelfIntersections",
  };
  for (const std::string& name : names)
  {
    vtkDataArray* array = output->GetFieldData()->GetArray(name.c_str());
    ASSERT_TRUE(array) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), at(tuples, name)) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), at(components, name)) << name;
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      EXPECT_TRUE(std::isfinite(array->GetVariantValue(i).ToDouble())) << name;
    }
  }
  EXPECT_EQ(figure(output, "Patient"), 42); // field data of the input are kept
  EXPECT_TRUE(output->GetFieldData()->GetAbstractArray("ReasonOfCut")); // a string
  EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), static_cast<int>(names.size()) + 2);

  for (const char* file : { "Filters/vtkSurfaceToDiskFilter.h", "docs/reference.md" })
  {
    std::ifstream stream(std::string(DATA_DIRECTORY "/../") + file);
    const std::string text{ std::istreambuf_iterator<char>(stream), {} };
    for (const std::string& name : names)
    {
      EXPECT_NE(text.find('`' + name + '`'), std::string::npos) << name << " is not in " << file;
    }
  }
}

} // namespace
