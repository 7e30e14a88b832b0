// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceToDiskChecks.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCylinderSource.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkReverseSense.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using namespace disk_tests;

TEST(SurfaceToDiskFilter, TriangulatesQuadsAndTracesThem)
{
  const auto input = square(5);
  addAttributes(input);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto output = run(filter, input);
  expectDisk(output);
  ASSERT_EQ(output->GetNumberOfCells(), 50);
  EXPECT_EQ(output->GetNumberOfPoints(), 36);
  auto* cells = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("vtkOriginalCellIds"));
  auto* points = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("vtkOriginalPointIds"));
  auto* numbers = vtkFloatArray::SafeDownCast(output->GetCellData()->GetArray("CellNumber"));
  ASSERT_TRUE(cells && points && numbers);
  for (vtkIdType c = 0; c < 50; ++c)
  {
    double bounds[6];
    double whole[6];
    output->GetCellBounds(c, bounds);
    input->GetCellBounds(cells->GetValue(c), whole);
    for (int k = 0; k < 6; ++k)
    {
      EXPECT_EQ(bounds[k], whole[k]); // half a square has its bounds
    }
    EXPECT_EQ(numbers->GetValue(c), cells->GetValue(c) + 1);
    EXPECT_EQ(output->GetCellData()->GetArray("Filled")->GetTuple1(c), 0);
  }
  for (vtkIdType i = 0; i < 36; ++i)
  {
    EXPECT_EQ(points->GetValue(i), i);
  }
  EXPECT_EQ(figure(output, "ReorientedFaces"), 0);
}

namespace
{

void expectThatLinesAndVerticesAreDropped(vtkPolyData* input)
{
  const vtkIdType vertex[] = { 0 };
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, vertex);
  const vtkIdType line[] = { 0, 1, 2 };
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(3, line);
  input->SetVerts(vertices);
  input->SetLines(lines);
  input->GetCellData()->Initialize();
  addAttributes(input);

  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_EQ(output->GetNumberOfCells(), 72);
  EXPECT_EQ(figure(output, "DroppedCells"), 2);
  EXPECT_NEAR(areaOf(output), 1.0, 1e-14);
  // Two cells come before the others; every triangle's corners are points of the cell that it comes
  // from.
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const auto original =
      static_cast<vtkIdType>(output->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(c));
    ASSERT_GE(original, 2);
    EXPECT_EQ(output->GetCellData()->GetArray("CellNumber")->GetTuple1(c), original + 1);
    vtkNew<vtkIdList> cell;
    input->GetCellPoints(original, cell);
    vtkNew<vtkIdList> corners;
    output->GetCellPoints(c, corners);
    for (int k = 0; k < 3; ++k)
    {
      const auto id = static_cast<vtkIdType>(
        output->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(corners->GetId(k)));
      EXPECT_GE(cell->IsId(id), 0);
    }
  }
}

} // namespace

TEST(SurfaceToDiskFilter, TakesStripsAndDropsLinesAndVertices)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(square(6));
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(triangles->GetOutputPort());
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  expectThatLinesAndVerticesAreDropped(stripper->GetOutput());
}

TEST(SurfaceToDiskFilter, DropsLinesAndVerticesBesideTriangles)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(square(6));
  triangles->Update();
  expectThatLinesAndVerticesAreDropped(triangles->GetOutput());
}

// vtkSphereSource's poles and an area that the hole shares, on a mesh too coarse for a round hole.
TEST(SurfaceToDiskFilter, OpensASphereOfAnyResolution)
{
  for (const int resolution : { 6, 30 })
  {
    const auto input = sphere(resolution);
    addAttributes(input);
    vtkNew<vtkSurfaceToDiskFilter> filter;
    filter->UseHolePointOn();
    filter->SetHolePoint(0.05, 0.1, 0.5);
    filter->SetHoleAreaFraction(0.01);
    const auto output = run(filter, input);
    expectDisk(output);
    const double total = areaOf(input);
    EXPECT_NEAR(figure(output, "RemovedArea"), 0.01 * total, 1e-10 * total);
    EXPECT_NEAR(areaOf(output), 0.99 * total, 1e-4 * total);
    EXPECT_GE(figure(output, "BoundaryVertices"), 128);
    const double flat = std::sqrt(4.0 * Pi * 0.01 * total);
    EXPECT_NEAR(figure(output, "BoundaryLength"), flat, 0.05 * flat);

    // Attributes: linear ones are exact on split edges, labels are one of the neighbours'.
    vtkIdType added = 0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double x[3];
      output->GetPoint(i, x);
      const double* position = output->GetPointData()->GetArray("Position")->GetTuple3(i);
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(x[k], position[k], 1e-14);
      }
      const double octant = output->GetPointData()->GetScalars()->GetTuple1(i);
      EXPECT_TRUE(octant >= 100 && octant < 108 && octant == std::floor(octant));
      const auto original =
        static_cast<vtkIdType>(output->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(i));
      added += original < 0;
      if (original >= 0)
      {
        double y[3];
        input->GetPoint(original, y);
        EXPECT_TRUE(x[0] == y[0] && x[1] == y[1] && x[2] == y[2]);
        EXPECT_EQ(octant, input->GetPointData()->GetScalars()->GetTuple1(original));
      }
      auto* names = vtkStringArray::SafeDownCast(output->GetPointData()->GetAbstractArray("Name"));
      ASSERT_TRUE(names);
      EXPECT_EQ(names->GetValue(i), "octant " + std::to_string(int(octant)));
    }
    EXPECT_GE(added, 128);
  }
}

TEST(SurfaceToDiskFilter, FillsHolesAndMarksThem)
{
  // A tube of 32 sides, made of separate quads, with normals that would keep the caps apart.
  vtkNew<vtkCylinderSource> source;
  source->SetResolution(32);
  source->SetRadius(1.0);
  source->SetHeight(2.0);
  source->CappingOff();
  source->Update();
  vtkPolyData* tube = source->GetOutput();
  tube->GetPointData()->Initialize();
  addAttributes(tube);
  // One end is pulled wider.
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    double x[3];
    tube->GetPoint(i, x);
    if (x[1] > 0)
    {
      tube->GetPoints()->SetPoint(i, 1.5 * x[0], x[1], 1.5 * x[2]);
    }
  }
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetFillLengthLimit(10.0); // the ends are 6.3 and 9.4 long
  const auto output = run(filter, tube);
  expectDisk(output);
  EXPECT_EQ(figure(output, "FilledHoles"), 1);
  EXPECT_NEAR(figure(output, "FilledArea"), 16.0 * std::sin(2.0 * Pi / 32), 1e-6);
  double marked = 0.0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    double p[3][3];
    vtkNew<vtkIdList> corners;
    output->GetCellPoints(c, corners);
    bool onCap = true;
    for (int k = 0; k < 3; ++k)
    {
      output->GetPoint(corners->GetId(k), p[k]);
      onCap &= std::abs(p[k][1] + 1.0) < 1e-6;
    }
    EXPECT_EQ(output->GetCellData()->GetArray("Filled")->GetTuple1(c), onCap ? 1 : 0);
    EXPECT_EQ(output->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(c) < 0, onCap);
    EXPECT_EQ(output->GetCellData()->GetArray("CellNumber")->GetTuple1(c) == 0.0, onCap);
    marked += onCap;
  }
  EXPECT_GT(marked, 30);
}

TEST(SurfaceToDiskFilter, KeepsTheChosenComponent)
{
  const auto small = sphere(12);
  for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
  {
    double x[3];
    small->GetPoint(i, x);
    small->GetPoints()->SetPoint(i, 0.3 * x[0] + 5, 0.3 * x[1], 0.3 * x[2]);
  }
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(small);
  append->AddInputData(sphere(16));
  append->Update();
  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto largest = run(filter, append->GetOutput());
  expectDisk(largest);
  EXPECT_EQ(figure(largest, "Components"), 2);
  EXPECT_EQ(figure(largest, "DroppedComponents"), 1);
  EXPECT_LT(largest->GetBounds()[1], 1.0);

  filter->SetComponentModeToClosestToPoint();
  filter->SetComponentPoint(4, 0, 0);
  const auto closest = run(filter, append->GetOutput());
  expectDisk(closest);
  EXPECT_GT(closest->GetBounds()[0], 4.0);
}

TEST(SurfaceToDiskFilter, CleansATriangleSoupWithFlippedAndDuplicateFaces)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(sphere(20));
  triangles->Update();
  vtkPolyData* whole = triangles->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const vtkIdType faces = whole->GetNumberOfCells();
  for (vtkIdType c = 0; c < faces + 3; ++c) // three of them twice
  {
    vtkNew<vtkIdList> corners;
    whole->GetCellPoints(c % faces, corners);
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k)
    {
      ids[k] = points->InsertNextPoint(whole->GetPoint(corners->GetId(c % 4 == 1 ? 2 - k : k)));
    }
    cells->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(points);
  soup->SetPolys(cells);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  const auto output = run(filter, soup);
  expectDisk(output);
  EXPECT_EQ(figure(output, "DroppedDuplicateFaces"), 3);
  EXPECT_EQ(figure(output, "DroppedFaces"), 3);
  EXPECT_EQ(figure(output, "DroppedDegenerateFaces"), 0);
  EXPECT_EQ(figure(output, "MergedPoints"), 3 * (faces + 3) - whole->GetNumberOfPoints());
  EXPECT_EQ(figure(output, "ReorientedFaces"), (faces + 2) / 4);
  EXPECT_EQ(figure(output, "Components"), 1);
}

// A sphere's normals are its points' directions; those of a surface that faces inwards, such as the wall
// of a cavity, are turned over with its triangles.
TEST(SurfaceToDiskFilter, NormalsAreTurnedOverWithTheFaces)
{
  vtkNew<vtkPolyDataNormals> outward;
  outward->SetInputData(sphere(20));
  outward->ComputeCellNormalsOn();
  outward->SplittingOff();
  vtkNew<vtkReverseSense> inward;
  inward->SetInputConnection(outward->GetOutputPort());
  inward->ReverseCellsOn();
  inward->ReverseNormalsOn();
  inward->Update();
  vtkNew<vtkSurfaceToDiskFilter> filter;
  for (vtkPolyData* input : { outward->GetOutput(0), inward->GetOutput(0) })
  {
    const bool turned = input == inward->GetOutput();
    for (const bool remesh : { false, true })
    {
      filter->SetRemesh(remesh);
      const auto output = run(filter, input);
      EXPECT_EQ(figure(output, "ReorientedFaces"), turned ? input->GetNumberOfCells() : 0);
      vtkDataArray* normals = output->GetPointData()->GetNormals();
      vtkDataArray* origins = output->GetPointData()->GetArray("vtkOriginalPointIds");
      vtkDataArray* cellNormals = output->GetCellData()->GetNormals();
      ASSERT_TRUE(normals && cellNormals);
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        double x[3];
        output->GetPoint(i, x);
        const double* normal = normals->GetTuple3(i);
        EXPECT_GT(x[0] * normal[0] + x[1] * normal[1] + x[2] * normal[2], 0.45) << "of radius 0.5";
        const auto origin = static_cast<vtkIdType>(origins->GetTuple1(i));
        for (int k = 0; k < 3 && origin >= 0; ++k)
        {
          const double before = input->GetPointData()->GetNormals()->GetComponent(origin, k);
          EXPECT_EQ(normals->GetComponent(i, k), turned ? -before : before);
        }
      }
      for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
      {
        double bounds[6];
        output->GetCellBounds(c, bounds);
        const double* normal = cellNormals->GetTuple3(c);
        double along = 0;
        for (int k = 0; k < 3; ++k)
        {
          along += 0.5 * (bounds[2 * k] + bounds[2 * k + 1]) * normal[k];
        }
        EXPECT_GT(along, 0.4);
      }
    }
  }
}

TEST(SurfaceToDiskFilter, RemeshesAndCarriesAttributesOver)
{
  const auto input = sphere(40);
  addAttributes(input);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->RemeshOn();
  filter->SetTargetEdgeLength(0.05);
  const auto output = run(filter, input);
  expectDisk(output);
  EXPECT_EQ(figure(output, "RemeshEdgeLength"), 0.05);
  EXPECT_NEAR(areaOf(output), 0.999 * areaOf(input), 0.005 * areaOf(input));
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const double* position = output->GetPointData()->GetArray("Position")->GetTuple3(i);
    const double octant = output->GetPointData()->GetArray("Octant")->GetTuple1(i);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(x[k], position[k], 1e-12);
      if (std::abs(x[k]) > 0.08) // an edge of the input away from where labels change
      {
        EXPECT_EQ((int(octant) - 100) >> k & 1, x[k] > 0);
      }
    }
  }
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("CellNumber")->GetTuple1(c),
      output->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(c) + 1);
  }
}

TEST(SurfaceToDiskFilter, WorksAtAnyScale)
{
  for (const double scale : { 1e-9, 1e9 })
  {
    const auto input = sphere(24);
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      double x[3];
      input->GetPoint(i, x);
      input->GetPoints()->SetPoint(i, scale * x[0], scale * x[1], scale * x[2]);
    }
    vtkNew<vtkSurfaceToDiskFilter> filter;
    for (const bool remesh : { false, true })
    {
      filter->SetRemesh(remesh);
      const auto output = run(filter, input);
      expectDisk(output);
      EXPECT_NEAR(areaOf(output) / areaOf(input), 0.999, 0.01);
      EXPECT_EQ(figure(output, "MergedPoints"), 0);
    }
  }
}

} // namespace
