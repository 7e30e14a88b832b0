// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Core/Support/SampleSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkFlatMapTransfer.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkSurfaceToDiskFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;
using namespace flattening::testing;

// n x n squares of two triangles on [0, 1]^2.
TriangleMesh square(int n)
{
  TriangleMesh mesh;
  mesh.Vertices.resize((n + 1) * (n + 1), 3);
  mesh.Faces.resize(2 * n * n, 3);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const int v = i * (n + 1) + j;
      mesh.Vertices.row(v) << static_cast<double>(j) / n, static_cast<double>(i) / n, 0.0;
      if (i < n && j < n)
      {
        mesh.Faces.row(2 * (i * n + j)) << v, v + 1, v + n + 2;
        mesh.Faces.row(2 * (i * n + j) + 1) << v, v + n + 2, v + n + 1;
      }
    }
  }
  return mesh;
}

// A sheet at height 5, flattened by doubling its size.
vtkSmartPointer<vtkPolyData> doubled(const TriangleMesh& sheet)
{
  TriangleMesh flat = sheet;
  flat.Vertices.leftCols(2) *= 2.0;
  flat.Vertices.col(2).setZero();
  const auto data = polyDataOf(flat);
  vtkNew<vtkDoubleArray> surface;
  surface->SetName("SurfacePoints");
  surface->SetNumberOfComponents(3);
  for (int v = 0; v < sheet.vertexCount(); ++v)
  {
    surface->InsertNextTuple(sheet.Vertices.row(v).data());
  }
  data->GetPointData()->AddArray(surface);
  return data;
}

// The sheet in another triangulation, with a fragment far away, labels on cells and ids on points.
vtkSmartPointer<vtkPolyData> original()
{
  const auto data = polyDataOf(both(moved(tetrahedron(), 50, 0, 0), moved(square(7), 0, 0, 5)));
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    label->InsertNextValue(static_cast<int>(3 * cell));
  }
  data->GetCellData()->SetScalars(label);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    height->InsertNextValue(0.25 * static_cast<double>(point));
  }
  data->GetPointData()->AddArray(height);
  return data;
}

TEST(FlatMapTransferFilter, BringsTheOriginalPointsIntoThePlane)
{
  vtkNew<vtkFlatMapTransfer> filter;
  const auto input = original();
  filter->SetInputData(doubled(moved(square(10), 0, 0, 5)));
  filter->SetOriginalData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 64);
  ASSERT_EQ(output->GetNumberOfCells(), 98);
  EXPECT_EQ(figure(output, "TransferredPoints"), 64);
  EXPECT_EQ(figure(output, "LostPoints"), 4);
  EXPECT_EQ(figure(output, "LostCells"), 4);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0);
  EXPECT_LT(figure(output, "LargestDistance"), 1e-12);
  EXPECT_NEAR(figure(output, "Tolerance"), 0.5 * 0.1 * (2.0 + std::sqrt(2.0)) / 3.0, 1e-12);

  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  vtkDataArray* pointIds = output->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* height = output->GetPointData()->GetArray("Height");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(pointIds->GetTuple1(i));
    EXPECT_EQ(height->GetTuple1(i), 0.25 * id);
    double x[3];
    double flat[3];
    input->GetPoint(id, x);
    output->GetPoint(i, flat);
    EXPECT_NEAR(flat[0], 2.0 * x[0], 1e-12);
    EXPECT_NEAR(flat[1], 2.0 * x[1], 1e-12);
    EXPECT_EQ(flat[2], 0.0);
    EXPECT_EQ(surface->GetComponent(i, 2), x[2]);
  }
  vtkDataArray* cellIds = output->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetScalars()->GetTuple1(c), 3 * cellIds->GetTuple1(c));
  }
}

// The longest side of the triangles.
double longestSide(vtkPolyData* data)
{
  double longest = 0.0;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(c, ids);
    for (int k = 0; k < 3; ++k)
    {
      double a[3];
      double b[3];
      data->GetPoint(ids->GetId(k), a);
      data->GetPoint(ids->GetId((k + 1) % 3), b);
      longest = std::max(longest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return longest;
}

// A surface that is opened and flattened, and the map brought back to it.
struct FlattenedAndBack
{
  explicit FlattenedAndBack(vtkPolyData* input)
  {
    this->Disk->SetInputData(input);
    this->Conformal->SetInputConnection(this->Disk->GetOutputPort());
    this->Flat->SetInputConnection(this->Conformal->GetOutputPort());
    this->Transfer->SetInputConnection(this->Flat->GetOutputPort());
    this->Transfer->SetOriginalData(input);
  }

  vtkNew<vtkSurfaceToDiskFilter> Disk;
  vtkNew<vtkConformalDiskFilter> Conformal;
  vtkNew<vtkOMTAreaPreservingFilter> Flat;
  vtkNew<vtkFlatMapTransfer> Transfer;
};

// The default disk of a closed surface has a seam. The triangles that the seam does not cut lie beside
// it, and none reaches from one bank to the other.
TEST(FlatMapTransferFilter, ClosedSurfaceThatWasOpenedAlongASeam)
{
  TriangleMesh ellipsoid = sphere(4);
  ellipsoid.Vertices.col(0) *= 2.0;
  ellipsoid.Vertices.col(1) *= 1.3;
  const auto input = polyDataOf(ellipsoid);
  const FlattenedAndBack pipeline(input);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(pipeline.Transfer->GetOutputPort());
  metrics->Update();
  vtkPolyData* output = pipeline.Transfer->GetOutput();
  const double cells = ellipsoid.faceCount();
  ASSERT_GT(figure(output, "SeamLength"), 1.0);
  EXPECT_EQ(figure(output, "LostPoints"), 0);
  EXPECT_EQ(figure(output, "LostCells"), figure(output, "CellsAcrossSeams"));
  EXPECT_LT(figure(output, "LostCells"), 0.1 * cells);
  EXPECT_EQ(output->GetNumberOfCells(), cells - figure(output, "LostCells"));
  EXPECT_GT(figure(output, "RepeatedPoints"), 0);
  EXPECT_GE(output->GetNumberOfPoints(), ellipsoid.vertexCount() + figure(output, "RepeatedPoints"));
  EXPECT_EQ(figure(output, "FlippedFaces"), 0);
  EXPECT_LE(
    longestSide(output), 1.1 * longestSide(vtkPolyData::SafeDownCast(pipeline.Flat->GetOutput())));
  const double area = figure(output, "SurfaceArea");
  EXPECT_GT(area, 0.9 * totalArea(ellipsoid));
  vtkDataObject* measured = metrics->GetOutputDataObject(0);
  EXPECT_NEAR(figure(measured, "SurfaceArea"), area, 1e-9 * area);
  EXPECT_NEAR(figure(measured, "FlatArea"), area, 0.005 * area);
  EXPECT_GT(figure(measured, "FacesWithin2Percent"), 95.0);
}

TEST(FlatMapTransferFilter, RemeshedSurfaceThatWasOpenedAlongASeam)
{
  TriangleMesh ellipsoid = sphere(3);
  ellipsoid.Vertices.col(0) *= 2.0;
  const auto input = polyDataOf(ellipsoid);
  const FlattenedAndBack pipeline(input);
  pipeline.Disk->RemeshOn();
  pipeline.Disk->SetCutModeToSeam();
  pipeline.Transfer->Update();
  vtkPolyData* output = pipeline.Transfer->GetOutput();
  const double edges = figure(output, "SeamLength") / longestSide(input);
  EXPECT_GT(figure(output, "CellsAcrossSeams"), edges);
  EXPECT_LT(figure(output, "CellsAcrossSeams"), 6.0 * edges);
  EXPECT_LT(figure(output, "LostCells"), figure(output, "CellsAcrossSeams") + 10);
  EXPECT_LT(figure(output, "FlippedFaces"), 0.01 * ellipsoid.faceCount());
  EXPECT_LT(
    longestSide(output), 1.5 * longestSide(vtkPolyData::SafeDownCast(pipeline.Flat->GetOutput())));
}

TEST(FlatMapTransferFilter, HasNoMeasuresOfTheFlattenedSurface)
{
  const TriangleMesh sheet = moved(square(10), 0, 0, 5);
  const auto flat = doubled(sheet);
  for (const char* name : { "CornerPointIds", "Bijective", "MaxCellAreaError", "FreeOutline" })
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    array->InsertNextValue(1);
    flat->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flat);
  metrics->MeasureLengthsOn();
  metrics->Update();
  vtkDataObject* measured = metrics->GetOutputDataObject(0);
  ASSERT_NEAR(figure(measured, "FlatArea"), 4.0, 1e-12);
  vtkNew<vtkFlatMapTransfer> filter;
  filter->SetInputDataObject(0, measured);
  filter->SetOriginalData(original());
  filter->Update();
  const std::vector<std::string> expected = { "CellsAcrossSeams",
    "FlippedFaces",
    "LargestDistance",
    "LostCells",
    "LostPoints",
    "RepeatedPoints",
    "SurfaceArea",
    "Tolerance",
    "TransferredPoints" };
  std::vector<std::string> names;
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names.emplace_back(data->GetArrayName(i));
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, expected);
  EXPECT_NEAR(figure(filter->GetOutput(), "SurfaceArea"), 1.0, 1e-12);
}

TEST(FlatMapTransferFilter, WarnsOfFlippedTriangles)
{
  const TriangleMesh sheet = square(7);
  const auto flat = doubled(sheet);
  vtkNew<vtkFlatMapTransfer> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(flat);
  filter->SetOriginalData(polyDataOf(sheet));
  filter->Update();
  EXPECT_FALSE(observer->GetWarning());
  flat->GetPoints()->SetPoint(9, 1.0, 1.0, 0.0); // one point far over its neighbours
  flat->GetPoints()->Modified();
  flat->Modified();
  filter->Update();
  EXPECT_GT(figure(filter->GetOutput(), "FlippedFaces"), 0);
  ASSERT_TRUE(observer->GetWarning());
  EXPECT_NE(observer->GetWarningMessage().find("flipped on the map"), std::string::npos);
}

TEST(FlatMapTransferFilter, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkFlatMapTransfer> filter;
  ErrorLog errors(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->SetOriginalData(original());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

TEST(FlatMapTransferFilter, ReportsWhatIsWrong)
{
  const TriangleMesh sheet = square(7);
  vtkNew<vtkFlatMapTransfer> filter;
  filter->SetOriginalData(polyDataOf(sheet));
  expectError(filter.Get(), polyDataOf(sheet), "no point array SurfacePoints", doubled(sheet));
  expectError(filter.Get(), doubled(moved(sheet, 9, 9, 9)), "raise the tolerance", doubled(sheet));
}

TEST(FlatMapTransferFilter, RefusesATolerance)
{
  const TriangleMesh sheet = square(7);
  vtkNew<vtkFlatMapTransfer> filter;
  filter->SetInputData(doubled(sheet));
  const auto expectMessage = [&filter](double tolerance, const std::string& words)
  {
    ErrorLog errors(filter);
    filter->SetTolerance(tolerance);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  filter->SetOriginalData(polyDataOf(sheet));
  expectMessage(-0.5, "the tolerance is -0.5");
  expectMessage(std::nan(""), "set it to 0, for half of the mean edge length, or to a length");

  TriangleMesh tilted = sheet; // one corner point of it alone is near
  tilted.Vertices.col(2) += tilted.Vertices.col(0) + tilted.Vertices.col(1);
  filter->SetOriginalData(polyDataOf(tilted));
  expectMessage(1e-6, "no triangle of the original surface has all of its points within 1e-06");
  filter->SetTolerance(0.0);
  filter->SetOriginalData(polyDataOf(sheet));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), sheet.vertexCount());
}

TEST(FlatMapTransferFilter, CanBeStopped)
{
  const TriangleMesh sheet = square(7);
  vtkNew<vtkFlatMapTransfer> filter;
  filter->SetOriginalData(polyDataOf(sheet));
  expectAbort(filter.Get(), doubled(sheet), 0.5);
}

} // namespace
