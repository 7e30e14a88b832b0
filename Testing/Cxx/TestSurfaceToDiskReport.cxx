// SPDX-License-Identifier: GPL-3.0-or-later
/// What vtkSurfaceToDiskFilter tells and shows of its changes: the third output, warnings,
/// ScaledCurvature.
#include "SurfaceToDiskChecks.h"

#include <vtkAppendPolyData.h>
#include <vtkCommand.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace disk_tests;

// The amount in the row of the table that begins with @p change; -1 if there is none.
double amount(vtkTable* table, const std::string& change)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, "Change").ToString().rfind(change, 0) == 0)
    {
      return table->GetValueByName(row, "Amount").ToDouble();
    }
  }
  return -1.0;
}

// The warnings of a filter, as long as it lives.
struct WarningLog
{
  explicit WarningLog(vtkSurfaceToDiskFilter* filter)
  {
    filter->AddObserver(vtkCommand::WarningEvent, this, &WarningLog::record);
  }
  void record(vtkObject*, unsigned long, void* text)
  {
    this->Messages.emplace_back(static_cast<const char*>(text));
  }
  const std::vector<std::string>& messages() const { return this->Messages; }

  std::vector<std::string> Messages;
};

TEST(SurfaceToDiskReport, AHandleThatIsNoNoiseIsWarnedOf)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  WarningLog warnings(filter);
  run(filter, torus(80, 40));
  ASSERT_EQ(warnings.messages().size(), 1u);
  const std::string& warning = warnings.messages().front();
  EXPECT_NE(
    warning.find("a handle or tunnel was cut through and capped; the loop is "), std::string::npos)
    << warning;
  EXPECT_NE(warning.find("set Handles to Cut"), std::string::npos) << warning;
  vtkTable* table = filter->GetReport();
  EXPECT_EQ(amount(table, "handles removed"), 1.0);
  const double loop = amount(table, "length of the longest loop");
  EXPECT_NEAR(loop, 2.0 * Pi, 0.05) << "around the tube of radius 1";
  EXPECT_NEAR(amount(table, "area of the caps"), 2.0 * Pi, 0.1);
  EXPECT_EQ(amount(table, "area of the disk"), figure(filter->GetOutput(), "SurfaceArea"));

  vtkNew<vtkSurfaceToDiskFilter> cut;
  WarningLog none(cut);
  cut->SetHandleModeToCut();
  run(cut, torus(80, 40));
  EXPECT_TRUE(none.messages().empty());
  EXPECT_EQ(amount(cut->GetReport(), "handles removed"), -1.0) << "a row of nothing is left out";
}

TEST(SurfaceToDiskReport, RemeshingTellsTheAreaThatItCosts)
{
  vtkNew<vtkSurfaceToDiskFilter> plain;
  run(plain, sphere(60));
  const double before = figure(plain->GetOutput(), "SurfaceArea");
  EXPECT_EQ(figure(plain->GetOutput(), "RemeshAreaChange"), 0.0);
  for (const double share : { 0.2, 1.0 }) // of the radius
  {
    vtkNew<vtkSurfaceToDiskFilter> filter;
    WarningLog warnings(filter);
    filter->RemeshOn();
    filter->SetTargetEdgeLength(share * std::sqrt(before / (4.0 * Pi)));
    run(filter, sphere(60));
    const double change = figure(filter->GetOutput(), "SurfaceArea") - before;
    EXPECT_NEAR(figure(filter->GetOutput(), "RemeshAreaChange"), change, 0.003 * before);
    // Equilateral triangles with corners on a sphere have less area than it, by 5/24 of the square of
    // their side over its radius.
    const double less = 5.0 / 24.0 * share * share;
    EXPECT_NEAR(change / before, -less, 0.3 * less);
    std::size_t told = 0;
    for (const std::string& warning : warnings.messages())
    {
      told += warning.find("remeshing changed the area from ") != std::string::npos;
    }
    EXPECT_EQ(told, share == 1.0 ? 1u : 0u);
  }
}

TEST(SurfaceToDiskReport, DroppedComponentsAreWarnedOfUnlessTheyAreNoise)
{
  const auto large = sphere(60);
  for (const double radius : { 0.3, 0.01 })
  {
    const auto small = sphere(20);
    for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
    {
      double x[3];
      small->GetPoint(i, x);
      small->GetPoints()->SetPoint(i, radius * x[0] + 3.0, radius * x[1], radius * x[2]);
    }
    vtkNew<vtkAppendPolyData> both;
    both->AddInputData(large);
    both->AddInputData(small);
    both->Update();
    vtkNew<vtkSurfaceToDiskFilter> filter;
    WarningLog warnings(filter);
    run(filter, both->GetOutput());
    EXPECT_EQ(amount(filter->GetReport(), "other components dropped"), 1.0);
    EXPECT_EQ(
      amount(filter->GetReport(), "area of these"), figure(filter->GetOutput(), "DroppedComponentArea"));
    EXPECT_EQ(warnings.messages().size(), radius > 0.1 ? 1u : 0u);
    if (!warnings.messages().empty())
    {
      EXPECT_NE(warnings.messages().front().find("1 other component with an area of"), std::string::npos)
        << warnings.messages().front();
    }
  }
}

TEST(SurfaceToDiskReport, OutlinesOfCapsAreInTheCutsAndAreNoSeams)
{
  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto output = run(filter, torus(80, 40));
  vtkDataArray* filled = output->GetCellData()->GetArray("Filled");
  ASSERT_EQ(filled->GetRange()[1], 1.0);
  vtkDataArray* ids = filter->GetCuts()->GetCellData()->GetArray("SeamId");
  double outlines = 0.0;
  double seams = 0.0;
  for (vtkIdType c = 0; c < ids->GetNumberOfTuples(); ++c)
  {
    const double length = filter->GetCuts()->GetCellData()->GetArray("Length")->GetTuple1(c);
    outlines += ids->GetTuple1(c) < 0.0 ? length : 0.0;
    seams += ids->GetTuple1(c) > 0.0 ? length : 0.0;
  }
  EXPECT_NEAR(outlines, 2.0 * 2.0 * Pi, 0.2) << "around both caps";
  EXPECT_NEAR(seams, figure(output, "SeamLength"), 1e-9);
  EXPECT_GT(seams, 1.0);
}

TEST(SurfaceToDiskReport, ADiskOfTheFilterPassesUnchanged)
{
  vtkNew<vtkSurfaceToDiskFilter> first;
  first->SetCutModeToSeam();
  const auto disk = run(first, sphere(40));
  vtkNew<vtkSurfaceToDiskFilter> second;
  const auto again = run(second, disk);
  ASSERT_EQ(again->GetNumberOfPoints(), disk->GetNumberOfPoints());
  ASSERT_EQ(again->GetNumberOfCells(), disk->GetNumberOfCells());
  for (vtkIdType i = 0; i < disk->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double y[3];
    disk->GetPoint(i, x);
    again->GetPoint(i, y);
    ASSERT_TRUE(std::equal(x, x + 3, y)) << i;
  }
  for (const char* name : { "Seam", "SeamId", "SeamDistance" })
  {
    for (vtkIdType i = 0; i < disk->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(again->GetPointData()->GetArray(name)->GetTuple1(i),
        disk->GetPointData()->GetArray(name)->GetTuple1(i))
        << name << i;
    }
  }
  EXPECT_EQ(figure(again, "MergedPoints"), 0.0);
}

TEST(SurfaceToDiskReport, TheCurvatureIsShownUnlessOtherScalarsVary)
{
  const auto active = [](vtkPolyData* data)
  {
    vtkDataArray* scalars = data->GetPointData()->GetScalars();
    return std::string(scalars ? scalars->GetName() : "");
  };
  const auto surface = sphere(30);
  surface->GetPointData()->SetScalars(nullptr);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  EXPECT_EQ(active(run(filter, surface)), "ScaledCurvature");
  vtkDataArray* curvature = filter->GetOutput()->GetPointData()->GetArray("ScaledCurvature");
  EXPECT_NEAR(curvature->GetRange()[0], 0.8, 0.2) << "of a sphere, but for its poles";
  EXPECT_NEAR(curvature->GetRange()[1], 1.2, 0.2);

  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  values->SetNumberOfTuples(surface->GetNumberOfPoints());
  values->Fill(40.0);
  surface->GetPointData()->SetScalars(values);
  surface->Modified();
  EXPECT_EQ(active(run(filter, surface)), "ScaledCurvature") << "an isovalue";
  values->SetValue(0, 41.0);
  values->Modified();
  surface->Modified();
  EXPECT_EQ(active(run(filter, surface)), "Values");
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("ScaledCurvature"));
  filter->ScaledCurvatureOff();
  EXPECT_FALSE(run(filter, surface)->GetPointData()->HasArray("ScaledCurvature"));
}

} // namespace
