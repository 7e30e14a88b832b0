// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterTest.h"

#include <vtkSeamPreview.h>
#include <vtkSurfaceToDiskFilter.h>

#include <vtkAppendPolyData.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <array>
#include <cmath>
#include <vector>

namespace
{

using flattening::testing::ErrorLog;

constexpr double Pi = 3.14159265358979323846;
constexpr double Radius = 20.0;

vtkSmartPointer<vtkPolyData> sphere(double x)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(Radius);
  source->SetCenter(x, 0.0, 0.0);
  source->SetThetaResolution(64);
  source->SetPhiResolution(65); // with an equator
  source->Update();
  return source->GetOutput();
}

std::vector<double> lengths(vtkPolyData* lines)
{
  std::vector<double> found;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkPoints* points = lines->GetCell(cell)->GetPoints();
    double length = 0.0;
    for (vtkIdType i = 1; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i - 1, p);
      const double* q = points->GetPoint(i);
      length += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    }
    found.push_back(length);
  }
  return found;
}

vtkSmartPointer<vtkSeamPreview> previewOn(vtkPolyData* surface,
  const std::vector<std::array<double, 3>>& points)
{
  auto preview = vtkSmartPointer<vtkSeamPreview>::New();
  preview->SetInputData(surface);
  preview->SetNumberOfSeamPoints(static_cast<int>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    preview->SetSeamPoint(static_cast<int>(k), points[k][0], points[k][1], points[k][2]);
  }
  preview->Update();
  return preview;
}

TEST(SeamPreview, LegsAreGeodesics)
{
  // Along the equator: a quarter of a great circle, then an eighth; points a little off the surface.
  const double r = 1.02 * Radius;
  const auto preview =
    previewOn(sphere(0.0), { { r, 0, 0 }, { 0, r, 0 }, { -r * std::sqrt(0.5), r * std::sqrt(0.5), 0 } });
  const std::vector<double> found = lengths(preview->GetOutput());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0] / (0.5 * Pi * Radius), 1.0, 0.002); // chords of 64 parts are 0.04 % shorter
  EXPECT_NEAR(found[1] / (0.25 * Pi * Radius), 1.0, 0.002);
  // A second path begins with the third point, and has no leg.
  preview->SetNumberOfSeamPathStarts(1);
  preview->SetSeamPathStart(0, 2);
  preview->Update();
  EXPECT_EQ(preview->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(preview->GetOutput()->GetCellData()->GetArray("Leg")->GetTuple1(0), 0.0);
}

TEST(SeamPreview, OnlyPointsOfTrianglesArePassed)
{
  const auto surface = sphere(0.0);
  const std::vector<std::array<double, 3>> picked{ { Radius, 0, 0 }, { 0, Radius, 0 } };
  const std::vector<double> expected = lengths(previewOn(surface, picked)->GetOutput());
  vtkNew<vtkPoints> points;
  points->DeepCopy(surface->GetPoints());
  for (const std::array<double, 3>& x : picked)
  {
    points->InsertNextPoint(1.001 * x[0], 1.001 * x[1], 1.001 * x[2]);
  }
  vtkNew<vtkPolyData> withMore;
  withMore->SetPoints(points);
  withMore->SetPolys(surface->GetPolys());
  const auto preview = previewOn(withMore, { { 1.001 * Radius, 0, 0 }, { 0, 1.001 * Radius, 0 } });
  const std::vector<double> found = lengths(preview->GetOutput());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], expected[0]);
}

TEST(SeamPreview, BetweenComponentsItIsAStraightLineWithoutAnError)
{
  vtkNew<vtkAppendPolyData> two;
  two->AddInputData(sphere(0.0));
  two->AddInputData(sphere(100.0));
  two->Update();
  const auto preview = previewOn(two->GetOutput(), { { Radius, 0, 0 }, { 100.0 - Radius, 0, 0 } });
  const std::vector<double> found = lengths(preview->GetOutput());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0], 100.0 - 2.0 * Radius, 1e-3);
}

TEST(SeamPreview, ASeamOfAFewEdgesIsAnErrorOfTheCutThatSaysSo)
{
  const auto surface = sphere(0.0);
  vtkNew<vtkSurfaceToDiskFilter> disk;
  disk->SetInputData(surface);
  disk->SetCutModeToSeam();
  disk->UseSeamPointsOn();
  disk->AddSeamPoint(Radius, 0, 0);
  disk->AddSeamPoint(std::sqrt(Radius * Radius - 1.0), 1.0, 0); // half an edge away
  const ErrorLog errors(disk);
  disk->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages()[0].find("the seam is "), std::string::npos) << errors.messages()[0];
  EXPECT_NE(
    errors.messages()[0].find("edges of the surface, and a map cannot spread"), std::string::npos);
  EXPECT_EQ(disk->GetOutput()->GetNumberOfCells(), 0);
}

// A geodesic on coordinates whose squares overflow would need all memory.
TEST(SeamPreview, TheSizeOfTheSurfaceDoesNotMatter)
{
  const auto surface = sphere(0.0);
  const double r = Radius;
  const std::vector<double> expected =
    lengths(previewOn(surface, { { r, 0, 0 }, { 0, r, 0 } })->GetOutput());
  for (const int exponent : { -600, 600 })
  {
    const double scale = std::ldexp(1.0, exponent);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    {
      const double* x = surface->GetPoint(p);
      points->InsertNextPoint(scale * x[0], scale * x[1], scale * x[2]);
    }
    vtkNew<vtkPolyData> scaled;
    scaled->SetPoints(points);
    scaled->SetPolys(surface->GetPolys());
    const auto preview = previewOn(scaled, { { scale * r, 0, 0 }, { 0, scale * r, 0 } });
    const std::vector<double> found = lengths(preview->GetOutput());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0] / scale, expected[0], 1e-9 * expected[0]);
  }
}

TEST(SeamPreview, AnEmptySurfaceHasNone)
{
  vtkNew<vtkPolyData> empty;
  const auto preview = previewOn(empty, { { 0, 0, 0 }, { 1, 0, 0 } });
  EXPECT_EQ(preview->GetOutput()->GetNumberOfCells(), 0);
}

} // namespace
