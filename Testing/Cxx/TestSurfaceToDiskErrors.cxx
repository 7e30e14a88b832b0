// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceToDiskChecks.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using namespace disk_tests;

// Quads around a ring.
vtkSmartPointer<vtkPolyData> torus(int n, int m)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double u = 2 * Pi * i / n;
      const double v = 2 * Pi * j / m;
      const double r = 2 + std::cos(v);
      points->InsertNextPoint(r * std::cos(u), r * std::sin(u), std::sin(v));
      const vtkIdType next = (i + 1) % n * m;
      const vtkIdType up = (j + 1) % m;
      const vtkIdType ids[] = { i * m + j, next + j, next + up, i * m + up };
      quads->InsertNextCell(4, ids);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(quads);
  return result;
}

// Expects one error with these words and an empty output; then the filter works again.
void expectError(vtkSurfaceToDiskFilter* filter, vtkPolyData* input, const char* words)
{
  vtkNew<vtkTest::ErrorObserver> filterErrors;
  vtkNew<vtkTest::ErrorObserver> executiveErrors;
  const unsigned long filterTag = filter->AddObserver(vtkCommand::ErrorEvent, filterErrors);
  const unsigned long executiveTag =
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveErrors);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_TRUE(filterErrors->GetError()) << words;
  EXPECT_NE(filterErrors->GetErrorMessage().find(words), std::string::npos)
    << filterErrors->GetErrorMessage() << " lacks: " << words;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->RemoveObserver(filterTag);
  filter->GetExecutive()->RemoveObserver(executiveTag);

  vtkNew<vtkSurfaceToDiskFilter> fresh;
  filter->SetTargetEdgeLength(fresh->GetTargetEdgeLength());
  filter->SetMergeTolerance(fresh->GetMergeTolerance());
  expectDisk(run(filter, square(8)));
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

TEST(SurfaceToDiskErrors, NamesWhatIsWrongAndTheRemedy)
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

  filter->SetHandleModeToError();
  expectError(filter, torus(24, 10), "genus 1");
  filter->SetHandleModeToRemove();

  filter->RemeshOn();
  filter->SetTargetEdgeLength(-2);
  expectError(filter, square(8), "target edge length");
  filter->SetTargetEdgeLength(5);
  expectError(filter, square(8), "fewer than 20 faces");
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

} // namespace
