// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRegularPolygonSource.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::testing;

constexpr double Radius = 30.0;
vtkSmartPointer<vtkPolyData> conformalHemisphere(int n)
{
  TriangleMesh mesh = ringMesh(sphericalCap(0.5 * EIGEN_PI), n).Mesh;
  mesh.Vertices *= Radius;
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(polyDataOf(mesh));
  conformal->Update();
  return conformal->GetOutput();
}

using Corners = std::vector<std::array<double, 3>>;
enum class As
{
  Polygon,
  ClosedLine,
  OpenLine
};

vtkSmartPointer<vtkPolyData> domain(const Corners& corners, As kind = As::Polygon)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(corners.size()) + (kind == As::ClosedLine));
  for (const auto& corner : corners)
  {
    cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
  }
  if (kind == As::ClosedLine)
  {
    cells->InsertCellPoint(0);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  kind == As::Polygon ? data->SetPolys(cells) : data->SetLines(cells);
  return data;
}

// Area 8, centroid (5, 4), its corners counter-clockwise from the lower left one.
const Corners Rectangle = { { 3, 3, 0 }, { 7, 3, 0 }, { 7, 5, 0 }, { 3, 5, 0 } };

void expectBounds(vtkDataSet* data, std::initializer_list<double> expected, double tolerance)
{
  double bounds[6];
  data->GetBounds(bounds);
  int k = 0;
  for (const double bound : expected)
  {
    EXPECT_NEAR(bounds[k], bound, tolerance) << "bound " << k;
    ++k;
  }
}

TEST(OMTDomain, ThePolygonIsFilledWhereItLies)
{
  const auto input = conformalHemisphere(1500);
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(input);
  filter->FixCornersOn();
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(filter->GetOutputPort());
  const Corners clockwise(Rectangle.rbegin(), Rectangle.rend());
  for (const auto& polygon : { domain(Rectangle), domain(clockwise), domain(Rectangle, As::ClosedLine) })
  {
    filter->SetDomainData(polygon);
    filter->SetNormalizeToUnitDomain();
    metrics->Update();
    vtkPolyData* output = filter->GetOutput();
    ASSERT_EQ(output->GetNumberOfCells(), input->GetNumberOfCells());
    expectBounds(output, { 3, 7, 3, 5, 0, 0 }, 1e-12);
    expectBounds(filter->GetPowerDiagram(), { 3, 7, 3, 5, 0, 0 }, 1e-12);
    EXPECT_NEAR(sum(output->GetPointData()->GetArray("CellArea")), 8.0, 1e-11);
    EXPECT_NEAR(sum(output->GetPointData()->GetArray("TargetArea")), 8.0, 1e-11);
    EXPECT_LE(figure(output, "MaxCellAreaError"), 1e-6);
    EXPECT_EQ(figure(output, "Bijective"), 1.0);
    EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
    EXPECT_GT(figure(metrics->GetOutput(), "FacesWithin2Percent"), 99.0);
    EXPECT_NEAR(figure(metrics->GetOutput(), "FlatArea"), 8.0, 1e-11);
    vtkDataArray* ids = output->GetFieldData()->GetArray("CornerPointIds");
    ASSERT_TRUE(ids);
    ASSERT_EQ(ids->GetNumberOfTuples(), 4);
    double previous[3];
    output->GetPoint(static_cast<vtkIdType>(ids->GetTuple1(3)), previous);
    for (int c = 0; c < 4; ++c)
    {
      double x[3];
      output->GetPoint(static_cast<vtkIdType>(ids->GetTuple1(c)), x);
      EXPECT_NEAR(std::abs(x[0] - 5.0), 2.0, 1e-12);
      EXPECT_NEAR(std::abs(x[1] - 4.0), 1.0, 1e-12);
      EXPECT_GT((previous[0] - 5) * (x[1] - 4) - (previous[1] - 4) * (x[0] - 5), 1.0)
        << "counter-clockwise";
      std::copy(x, x + 3, previous);
    }

    filter->SetNormalizeToSurfaceArea();
    metrics->Update();
    const double area = figure(metrics->GetOutput(), "SurfaceArea");
    EXPECT_NEAR(area, 2.0 * EIGEN_PI * Radius * Radius, 0.01 * area);
    EXPECT_NEAR(figure(metrics->GetOutput(), "FlatArea") / area, 1.0, 1e-12);
    const double scale = std::sqrt(area / 8.0);
    expectBounds(output, { 5 - 2 * scale, 5 + 2 * scale, 4 - scale, 4 + scale }, 1e-12 * scale);
  }
}

TEST(OMTDomain, CornersAreFreeUnlessTheyAreFixed)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(conformalHemisphere(1500));
  vtkNew<vtkRegularPolygonSource> triangle; // with a polygon and its outline as a line
  triangle->SetNumberOfSides(3);
  filter->SetDomainConnection(triangle->GetOutputPort());
  filter->SetNormalizeToUnitDomain();
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(filter->GetOutputPort());
  metrics->Update();
  EXPECT_FALSE(filter->GetFixCorners());
  EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1.0);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->GetArray("CornerPointIds"));
  const double whole = 0.75 * std::sqrt(3.0) * 0.25; // circumscribed radius 0.5
  EXPECT_NEAR(sum(filter->GetOutput()->GetPointData()->GetArray("CellArea")), whole, 1e-7); // floats
  const double free = figure(metrics->GetOutput(), "FlatArea");
  EXPECT_LT(free, 0.99999 * whole);
  EXPECT_GT(free, 0.99 * whole);
  filter->FixCornersOn();
  metrics->Update();
  EXPECT_NEAR(figure(metrics->GetOutput(), "FlatArea"), whole, 1e-7);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("CornerPointIds")->GetNumberOfTuples(), 3);

  // Without the polygon the disk is back.
  filter->RemoveDomain();
  filter->Update();
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->GetArray("CornerPointIds"));
  expectBounds(filter->GetOutput(), { -1, 1, -1, 1 }, 1e-2);
}

// Few points of a circle may all lie on the sides of a box. Those of a square turned by 45 degrees are
// in its corners, even.
TEST(OMTDomain, ADiskOfFewBoundaryPointsIsNoRectangle)
{
  for (const int boundary : { 3, 4 })
  {
    for (int turn = 0; turn < 8; ++turn)
    {
      TriangleMesh mesh;
      mesh.Vertices = Points3::Zero(boundary + 1, 3);
      mesh.Faces.resize(boundary, 3);
      for (int k = 0; k < boundary; ++k)
      {
        const double angle = 2.0 * EIGEN_PI * (k / static_cast<double>(boundary) + turn / 24.0);
        mesh.Vertices.row(k) << std::cos(angle), std::sin(angle), 0.0;
        mesh.Faces.row(k) << k, (k + 1) % boundary, boundary;
      }
      const auto map = polyDataOf(mesh);
      vtkNew<vtkDoubleArray> places;
      places->DeepCopy(map->GetPoints()->GetData());
      places->SetName("SurfacePoints");
      map->GetPointData()->AddArray(places);
      vtkNew<vtkOMTAreaPreservingFilter> filter;
      ErrorLog errors(filter);
      filter->SetInputData(map);
      filter->Update();
      EXPECT_TRUE(errors.messages().empty());
      ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), boundary + 1);
      double x[3];
      filter->GetOutput()->GetPoint(boundary, x);
      EXPECT_LT(std::hypot(x[0], x[1]), 1e-3) << "the centre stays around the origin";
    }
  }
}

// There is nothing to refine.
TEST(OMTDomain, EveryPointMayBeACorner)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(4, 3);
  mesh.Vertices << 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 1;
  mesh.Faces.resize(2, 3);
  mesh.Faces << 0, 1, 2, 0, 2, 3;
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(polyDataOf(mesh));
  conformal->SetDomainToRectangle();
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  ErrorLog errors(filter);
  filter->SetInputConnection(conformal->GetOutputPort());
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1);
}

TEST(OMTDomain, BadPolygons)
{
  const auto input = conformalHemisphere(300);
  const auto good = domain(Rectangle);
  const auto expect = [&](vtkPolyData* polygon, const std::string& words)
  {
    SCOPED_TRACE(words);
    vtkNew<vtkOMTAreaPreservingFilter> filter;
    filter->FixCornersOn();
    ErrorLog errors(filter);
    filter->SetInputData(input);
    filter->SetDomainData(polygon);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetPowerDiagram()->GetNumberOfPoints(), 0);
    filter->SetDomainData(good);
    filter->Update();
    EXPECT_EQ(errors.messages().size(), 1u);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), input->GetNumberOfCells());
  };
  const double nan = std::nan("");
  expect(vtkNew<vtkPolyData>(), "0 polygons, 0 lines");
  expect(input, "polygons, 0 lines");
  expect(domain(Rectangle, As::OpenLine), "does not end where it begins");
  expect(domain({ { 0, 0, 0 }, { 1, 0, 0 } }), "has 2 points");
  expect(domain({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }), "no area");
  expect(
    domain({ { 0, 0, 0 }, { 2, 0, 0 }, { 0.5, 0.5, 0 }, { 0, 2, 0 } }), "not convex, or crosses itself");
  expect(
    domain({ { 0, 0, 0 }, { 3, 0, 0 }, { 1, 2, 0 }, { 2, 2, 0 } }), "not convex, or crosses itself");
  expect(domain({ { 0, 0, 0 }, { 1, nan, 0 }, { 1, 1, 0 } }), "point 1 of the domain's outline is not");
  expect(domain({ { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 0, 0, 1 } }), "plane of constant z");
  expect(domain({ { 1e9, 0, 0 }, { 1e9 + 0.1, 0, 0 }, { 1e9, 0.1, 0 } }), "too small");
  expect(
    domain({ { 1e130, 0, 0 }, { 2e130, 0, 0 }, { 1e130, 1e130, 0 } }), "does not hold so small a map");
  auto damaged = domain(Rectangle);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 99 });
  damaged->SetPolys(cells);
  expect(damaged, "names point 99");
  Corners many;
  for (int k = 0; k < 1000; ++k)
  {
    const double angle = 2e-3 * EIGEN_PI * k;
    many.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  expect(domain(many), "turn Fix Corners off");
}

} // namespace
