// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterTest.h"
#include "SurfaceToDiskChecks.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace
{

using namespace disk_tests;
using flattening::testing::ErrorLog;

// Expects exactly one error, with these words, and an empty output.
void expectError(vtkSurfaceToDiskFilter* filter, vtkPolyData* input, const std::string& words)
{
  SCOPED_TRACE(words);
  const ErrorLog errors(filter);
  const auto output = run(filter, input);
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 0);
}

// Whatever went wrong before, the next update is as good as any.
void expectDiskWithoutError(vtkSurfaceToDiskFilter* filter, vtkPolyData* input)
{
  const ErrorLog errors(filter);
  expectDisk(run(filter, input));
  EXPECT_TRUE(errors.messages().empty()) << errors.messages().front();
}

TEST(SurfaceToDiskErrors, EmptyInputGivesEmptyOutputSilently)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkNew<vtkPolyData> empty;
  EXPECT_EQ(run(filter, empty)->GetNumberOfPoints(), 0);
  EXPECT_FALSE(errors->GetError());
}

TEST(SurfaceToDiskErrors, SurfacesThatAreNone)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  vtkNew<vtkLineSource> line;
  line->Update();
  expectError(filter, line->GetOutput(), "no triangles");

  for (const double bad : { double(NAN), double(INFINITY) })
  {
    const auto input = square(3);
    input->GetPoints()->SetPoint(7, 0.5, bad, 0.0);
    expectError(filter, input, "point 7 has a coordinate that is not finite");
  }

  const auto flat = square(3);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    flat->GetPoints()->SetPoint(i, static_cast<double>(i), 0, 0);
  }
  vtkNew<vtkTriangleFilter> collinear; // polygons without area do not survive triangulation
  collinear->SetInputData(square(3));
  collinear->Update();
  collinear->GetOutput()->SetPoints(flat->GetPoints());
  expectError(filter, collinear->GetOutput(), "zero area");

  // The band of a Moebius strip.
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  constexpr int Sections = 20;
  for (int i = 0; i < Sections; ++i)
  {
    const double u = 2.0 * Pi * i / Sections;
    for (const double w : { -0.3, 0.3 })
    {
      const double r = 1.0 + w * std::cos(0.5 * u);
      points->InsertNextPoint(r * std::cos(u), r * std::sin(u), w * std::sin(0.5 * u));
    }
    const bool last = i + 1 == Sections;
    const vtkIdType next = last ? 1 : 2 * i + 2;
    const vtkIdType opposite = last ? 0 : 2 * i + 3;
    const vtkIdType quad[] = { 2 * i, next, opposite, 2 * i + 1 };
    quads->InsertNextCell(4, quad);
  }
  vtkNew<vtkPolyData> moebius;
  moebius->SetPoints(points);
  moebius->SetPolys(quads);
  expectError(filter, moebius, "one-sided");
  expectDiskWithoutError(filter, sphere(20));
}

TEST(SurfaceToDiskErrors, Handles)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetHandleModeToError();
  expectError(
    filter, torus(24, 10), "genus 1, that is 1 handle or tunnel: set Handles to Remove or Cut");
  expectError(filter, slabWithHoles(3), "3 handles or tunnels");
  expectDiskWithoutError(filter, sphere(20));
}

TEST(SurfaceToDiskErrors, ComponentsThatDoNotExist)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetComponentModeToByIndex();
  for (const int index : { 1, 7, -1 })
  {
    filter->SetComponentIndex(index);
    expectError(filter, sphere(12), "component " + std::to_string(index));
  }
  filter->SetComponentIndex(0);
  expectDiskWithoutError(filter, sphere(12));
}

TEST(SurfaceToDiskErrors, PicksOffTheSurface)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->UseHolePointOn();
  for (const double bad : { 3.0, double(NAN) })
  {
    filter->SetHolePoint(0.0, bad, 0.0);
    expectError(filter, sphere(20), "the hole's point");
  }
  filter->SetHolePoint(0.0, 0.51, 0.0);
  expectDiskWithoutError(filter, sphere(20));
}

TEST(SurfaceToDiskErrors, Seams)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToSeam();
  filter->UseSeamPointsOn();
  expectError(filter, sphere(20), "no point of the seam is given");
  filter->AddSeamPoint(0.5, 0.0, 0.0);
  expectError(filter, sphere(20), "a seam through 1 point");
  filter->AddSeamPoint(0.5, 0.0, 0.0);
  expectError(filter, sphere(20), "points 1 and 2 of the seam coincide");
  filter->SetSeamPoint(1, 0.0, 2.0, 0.0);
  expectError(filter, sphere(20), "point 2 of the seam (0 2 0) lies");
  filter->SetSeamPoint(1, 0.0, NAN, 0.0);
  expectError(filter, sphere(20), "point 2 of the seam is not finite");
  filter->SetSeamPoint(1, 0.0, 0.5, 0.0);
  expectDiskWithoutError(filter, sphere(20));

  filter->SetSeamPoint(0, 0.3, 0.5, 0.0);
  filter->SetSeamPoint(1, 0.7, 0.5, 0.0);
  expectError(filter, square(20), "neither starts nor ends on it");
  filter->UseSeamPointsOff();
  expectDiskWithoutError(filter, square(20));
  filter->RemoveAllSeamPoints();

  const ErrorLog errors(filter);
  filter->SetSeamPoint(0, 1.0, 2.0, 3.0);
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("no seam point 0"), std::string::npos);
}

TEST(SurfaceToDiskErrors, Planes)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToPlane();
  filter->SetPlaneOrigin(0.7, 0.0, 0.0);
  expectError(filter, sphere(20), "plane");
  filter->SetPlaneOrigin(0.1, 0.0, 0.0);
  filter->SetPlaneNormal(0.0, 0.0, 0.0);
  expectError(filter, sphere(20), "normal");
  filter->SetPlaneNormal(0.0, NAN, 0.0);
  expectError(filter, sphere(20), "normal");
  filter->SetPlaneNormal(0.0, 0.0, 1e-30);
  expectDiskWithoutError(filter, sphere(20));
}

TEST(SurfaceToDiskErrors, RegionsOfInterest)
{
  const auto input = sphere(20);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->UseRegionOfInterestOn();
  expectError(filter, input, "no array is chosen for the region of interest");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Region");
  expectError(filter, input, "the region of interest Region is not a point or cell array");

  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  region->SetNumberOfTuples(input->GetNumberOfPoints() + 1);
  region->Fill(0);
  input->GetPointData()->AddArray(region);
  expectError(filter,
    input,
    "has " + std::to_string(region->GetNumberOfTuples()) + " tuples for " +
      std::to_string(input->GetNumberOfPoints()) + " points");
  region->SetNumberOfTuples(input->GetNumberOfPoints());

  vtkNew<vtkIntArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(input->GetNumberOfPoints());
  input->GetPointData()->AddArray(vectors);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Vectors");
  expectError(filter, input, "Vectors is not a point or cell array of one component");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Region");

  region->SetNumberOfTuples(input->GetNumberOfPoints());
  region->Fill(1);
  region->Modified();
  expectError(filter, input, "covers all of the surface");
  filter->SetCutModeToSeam();
  expectError(filter, input, "leaves no room for a seam");
  filter->SetCutModeToHole();
  region->SetValue(7, 0); // no room for a hole but around one point
  region->Modified();
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetHoleAreaFraction(0.1);
  expectDisk(run(filter, input));
  ASSERT_TRUE(observer->GetWarning());
  EXPECT_NE(observer->GetWarningMessage().find("points of the region of interest"), std::string::npos);
  observer->Clear();
  region->Fill(0);
  region->Modified();
  expectDiskWithoutError(filter, input);
  EXPECT_FALSE(observer->GetWarning());
  expectDiskWithoutError(filter, input);
}

TEST(SurfaceToDiskErrors, LengthsOutOfRange)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetMergeTolerance(-1.0);
  expectError(filter, square(8), "merge tolerance");
  filter->SetMergeTolerance(0.0);

  for (const double bad : { -1.0, double(NAN), double(INFINITY) })
  {
    filter->SetFillLengthLimit(bad);
    expectError(filter, square(8), "longest boundary to be filled");
  }
  filter->SetFillLengthLimit(3.9);
  filter->SetBoundaryModeToFillAll();
  expectError(filter, square(8), "4"); // its circumference
  filter->SetFillLengthLimit(0.0);
  filter->SetBoundaryModeToLongest();

  filter->RemeshOn();
  filter->SetTargetEdgeLength(-2);
  expectError(filter, square(8), "target edge length");
  filter->SetTargetEdgeLength(5);
  expectError(filter, square(8), "fewer than 20 faces");
  filter->SetTargetEdgeLength(0);
  for (const double bad : { 0.0, -1.0, double(NAN) })
  {
    filter->SetRelativeEdgeLength(bad);
    expectError(filter, square(8), "relative edge length");
  }
  filter->SetRelativeEdgeLength(1.0);
  expectDiskWithoutError(filter, square(8));
}

// A view would show the result from before otherwise.
TEST(SurfaceToDiskErrors, EmptyWhatIsDownstream)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  vtkNew<vtkTriangleFilter> downstream;
  downstream->SetInputConnection(filter->GetOutputPort());
  filter->SetInputData(sphere(20));
  downstream->Update();
  EXPECT_GT(downstream->GetOutput()->GetNumberOfPoints(), 100);
  vtkNew<vtkTest::ErrorObserver> errors;
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  const ErrorLog log(filter);
  filter->UseHolePointOn();
  for (int update = 0; update < 2; ++update)
  {
    downstream->Update();
    EXPECT_EQ(log.messages().size(), 1u); // and is not said again
    EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 0);
  }
  EXPECT_FALSE(errors->GetError()); // nor in the pipeline's words
  filter->UseHolePointOff();
  downstream->Update();
  EXPECT_GT(downstream->GetOutput()->GetNumberOfPoints(), 100);
}

TEST(SurfaceToDiskErrors, StopsWhenAborted)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      if (algorithm->GetProgress() > 0.5)
      {
        algorithm->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(run(filter, sphere(20))->GetNumberOfPoints(), 0);
  EXPECT_FALSE(errors->GetError());
}

TEST(SurfaceToDiskErrors, ArraysWithTooFewOrManyTuplesAreNamed)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  for (const bool onCells : { false, true })
  {
    const auto input = square(5);
    vtkNew<vtkDoubleArray> array;
    array->SetName("Thickness");
    if (onCells)
    {
      input->GetCellData()->AddArray(array);
    }
    else
    {
      input->GetPointData()->AddArray(array);
    }
    for (const int tuples : { 7, 700 })
    {
      array->SetNumberOfTuples(tuples);
      array->Fill(1.0);
      array->Modified();
      expectError(filter, input, "the array Thickness has " + std::to_string(tuples) + " tuples for ");
    }
  }
  expectDiskWithoutError(filter, square(5));
}

// Readers pass on offsets and point ids of damaged files.
TEST(SurfaceToDiskErrors, CellsWithPointsThatDoNotExistAreNamed)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto jump = square(5);
  jump->GetPolys()->GetOffsetsArray()->SetComponent(3, 0, 1e12);
  expectError(filter, jump, "the list of cells names places that it does not have");
  for (const bool isLine : { false, true })
  {
    const auto input = square(5);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    input->SetLines(lines);
    vtkCellArray* cells = isLine ? input->GetLines() : input->GetPolys();
    cells->GetConnectivityArray()->SetComponent(1, 0, 1e6);
    expectError(filter, input, "a cell names point 1000000, which does not exist");
  }
  expectDiskWithoutError(filter, square(5));
}

TEST(SurfaceToDiskErrors, LinesLabelsAndReliefsThatMakeNoCut)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetCutModeToSeam();
  vtkNew<vtkPolyData> lines;
  filter->SetSeamLinesData(lines);
  expectError(filter, sphere(20), "no line to cut along");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const std::array<double, 3>& x :
    { std::array<double, 3>{ 0.5, 0, 0 }, { 0, 0.5, 0 }, { 0.35, 0.35, 0.1 }, { 0.35, 0.35, -0.1 } })
  {
    points->InsertNextPoint(x.data());
  }
  for (const vtkIdType start : { 0, 2 })
  {
    const vtkIdType ids[2] = { start, start + 1 };
    cells->InsertNextCell(2, ids);
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  expectError(filter, sphere(20), "crosses or touches itself");
  points->SetPoint(1, 0, 2, 0);
  points->Modified();
  lines->Modified();
  expectError(filter, sphere(20), "of the seam (0 2 0) lies 1.50");
  filter->SetSeamLinesData(nullptr);

  filter->SetCutModeToLabel();
  expectError(filter, sphere(20), "no array of labels is chosen");
  const auto input = sphere(20);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Labels");
  labels->SetNumberOfValues(input->GetNumberOfPoints());
  labels->Fill(3);
  input->GetPointData()->AddArray(labels);
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Labels");
  expectError(filter, input, "no face has the label");
  filter->SetCutLabel(3);
  expectError(filter, input, "the label covers the whole surface");

  filter->SetCutModeToRelief();
  filter->SetReliefGain(-1.0);
  expectError(filter, input, "the gain of a relief's branch is -1");
  filter->SetReliefGain(0.05);
  filter->SetLongestRelief(0.0);
  expectError(filter, input, "the longest relief is 0");
  filter->SetLongestRelief(20.0);
  filter->UseRegionOfInterestOn();
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Labels");
  expectError(filter, input, "covers all of the surface");
  filter->UseRegionOfInterestOff();
  expectDiskWithoutError(filter, input);
}

TEST(SurfaceToDiskErrors, HolesOfAFewTrianglesAreWarnedOf)
{
  const auto warningsOf = [](int mode)
  {
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkSurfaceToDiskFilter> filter;
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetCutMode(mode);
    expectDisk(run(filter, sphere(20)));
    return observer->GetWarning() ? observer->GetWarningMessage() : std::string();
  };
  EXPECT_NE(warningsOf(vtkSurfaceToDiskFilter::HOLE).find("set Cut to Seam"), std::string::npos);
  EXPECT_EQ(warningsOf(vtkSurfaceToDiskFilter::SEAM), "");
}

} // namespace
