// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Core/Support/SampleSurfaces.h"
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::testing;
using samples::Pi;

// The conformal map of a hemisphere of radius 30 with about n points.
vtkSmartPointer<vtkPolyData> conformalHemisphere(int n)
{
  TriangleMesh mesh = ringMesh(sphericalCap(0.5 * Pi), n).Mesh;
  mesh.Vertices *= 30.0;
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(polyDataOf(mesh));
  conformal->Update();
  return conformal->GetOutput();
}

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

double surfaceArea(vtkPolyData* flattened)
{
  vtkDataArray* points = flattened->GetPointData()->GetArray("SurfacePoints");
  TriangleMesh mesh;
  mesh.Vertices.resize(points->GetNumberOfTuples(), 3);
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    points->GetTuple(i, mesh.Vertices.row(i).data());
  }
  mesh.Faces.resize(flattened->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < flattened->GetNumberOfCells(); ++c)
  {
    flattened->GetCellPoints(c, corners);
    for (int k = 0; k < 3; ++k)
    {
      mesh.Faces(c, k) = static_cast<int>(corners->GetId(k));
    }
  }
  return faceAreas(mesh.Vertices, mesh.Faces).sum();
}

vtkNew<vtkDoubleArray> addWeights(vtkPolyData* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> weights;
  weights->SetName(name);
  weights->SetNumberOfTuples(data->GetNumberOfPoints());
  weights->Fill(value);
  data->GetPointData()->AddArray(weights);
  return weights;
}

TEST(OMTAreaPreservingFilter, CellsHaveTheirTargetAreas)
{
  const auto input = conformalHemisphere(2000);
  const double area = surfaceArea(input);
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(input);
  for (const bool unit : { false, true })
  {
    filter->SetNormalizeTo(
      unit ? vtkOMTAreaPreservingFilter::UNIT_DOMAIN : vtkOMTAreaPreservingFilter::SURFACE_AREA);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    const double whole = unit ? Pi : area;
    vtkPointData* points = output->GetPointData();
    ASSERT_NE(points->GetArray("CellArea"), nullptr);
    EXPECT_NEAR(sum(points->GetArray("CellArea")) / whole, 1.0, 1e-12);
    EXPECT_NEAR(sum(points->GetArray("TargetArea")) / whole, 1.0, 1e-12);
    double largest = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double target = points->GetArray("TargetArea")->GetTuple1(i);
      largest =
        std::max(largest, std::abs(points->GetArray("CellArea")->GetTuple1(i) - target) / target);
    }
    EXPECT_LE(largest, 1e-6);
    EXPECT_NEAR(figure(output, "MaxCellAreaError"), largest, 1e-13);
    EXPECT_NEAR(output->GetBounds()[1], std::sqrt(whole / Pi), 2e-3 * std::sqrt(whole));
    EXPECT_EQ(output->GetBounds()[4], 0.0);
    EXPECT_EQ(output->GetBounds()[5], 0.0);
  }
}

// The size of the input does not count, only its shape.
TEST(OMTAreaPreservingFilter, AcceptsADiskOfAnyRadius)
{
  const auto input = conformalHemisphere(1000);
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(input);
  filter->Update();
  const auto expected = copyOf(filter->GetOutput());
  const auto scaled = copyOf(input);
  for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i)
  {
    double x[3];
    scaled->GetPoint(i, x);
    scaled->GetPoints()->SetPoint(i, 1e-3 * x[0], 1e-3 * x[1], 0.0);
  }
  filter->SetInputData(scaled);
  filter->Update();
  for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double y[3];
    expected->GetPoint(i, x);
    filter->GetOutput()->GetPoint(i, y);
    ASSERT_LT(std::hypot(x[0] - y[0], x[1] - y[1]), 1e-9);
  }
}

TEST(OMTAreaPreservingFilter, PassesEverythingThrough)
{
  const auto input = conformalHemisphere(500);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    label->InsertNextValue(static_cast<int>(c));
  }
  input->GetCellData()->SetScalars(label);
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPolys(), input->GetPolys());
  EXPECT_EQ(output->GetCellData()->GetScalars(), label.Get());
  for (const char* name : { "SurfacePoints", "ConformalFactor" })
  {
    EXPECT_EQ(output->GetPointData()->GetArray(name), input->GetPointData()->GetArray(name)) << name;
  }
  EXPECT_TRUE(output->GetFieldData()->HasArray("MaxCurvatureError")) << "of the stage before";
  EXPECT_FALSE(input->GetPointData()->HasArray("CellArea")) << "the input was changed";
  EXPECT_NE(output->GetPoints(), input->GetPoints());
}

TEST(OMTAreaPreservingFilter, FiguresOfTheSolver)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(conformalHemisphere(2000));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_GT(figure(output, "NewtonIterations"), 0.0);
  EXPECT_LT(figure(output, "NewtonIterations"), 10.0);
  EXPECT_GT(figure(output, "PowerDiagrams"), figure(output, "NewtonIterations"));
  EXPECT_EQ(figure(output, "CoincidentPoints"), 0.0);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
  EXPECT_EQ(figure(output, "Bijective"), 1.0);
  EXPECT_GE(figure(output, "RefinementRounds"), 1.0);
  EXPECT_EQ(figure(output, "RefinementRepairs"), 0.0);
}

TEST(OMTAreaPreservingFilter, StartsFromThePowerWeightsOfAnEarlierRun)
{
  for (const bool unit : { false, true })
  {
    vtkNew<vtkOMTAreaPreservingFilter> filter;
    filter->SetNormalizeTo(
      unit ? vtkOMTAreaPreservingFilter::UNIT_DOMAIN : vtkOMTAreaPreservingFilter::SURFACE_AREA);
    const auto input = conformalHemisphere(2000);
    filter->SetInputData(input);
    filter->Update();
    EXPECT_GT(figure(filter->GetOutput(), "NewtonIterations"), 0.0);
    const auto again = copyOf(input);
    again->GetPointData()->AddArray(filter->GetOutput()->GetPointData()->GetArray("PowerWeight"));
    filter->SetInputData(again);
    filter->Update();
    EXPECT_LE(figure(filter->GetOutput(), "NewtonIterations"), 1.0);
    EXPECT_LE(figure(filter->GetOutput(), "MaxCellAreaError"), 1e-6);
  }
}

TEST(OMTAreaPreservingFilter, GoesOnFromThePointsOfAnEarlierRun)
{
  for (const bool unit : { false, true })
  {
    vtkNew<vtkOMTAreaPreservingFilter> filter;
    filter->SetNormalizeTo(
      unit ? vtkOMTAreaPreservingFilter::UNIT_DOMAIN : vtkOMTAreaPreservingFilter::SURFACE_AREA);
    const auto input = conformalHemisphere(4000);
    filter->SetInputData(input);
    filter->Update();
    EXPECT_EQ(figure(filter->GetOutput(), "WarmStart"), 0.0);
    const auto former = copyOf(filter->GetOutput());
    vtkDataArray* flatPoints = former->GetPointData()->GetArray("FlatPoints");
    ASSERT_TRUE(flatPoints);
    for (vtkIdType i = 0; i < former->GetNumberOfPoints(); ++i)
    {
      double point[3];
      former->GetPoint(i, point);
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_EQ(flatPoints->GetComponent(i, k), point[k]);
      }
    }
    const auto again = copyOf(input);
    again->GetPointData()->AddArray(former->GetPointData()->GetArray("PowerWeight"));
    again->GetPointData()->AddArray(flatPoints);
    const auto weights = addWeights(again, "AreaWeight", 1.0);
    for (vtkIdType i = 0; i < 300; ++i) // around the pole
    {
      weights->SetValue(i, 2.0);
    }
    filter->SetInputData(again);
    filter->Update();
    EXPECT_EQ(figure(filter->GetOutput(), "WarmStart"), 1.0);
    EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1.0);
    EXPECT_LE(figure(filter->GetOutput(), "MaxCellAreaError"), 1e-6);
    vtkDataArray* now = filter->GetOutput()->GetPointData()->GetArray("FlatPoints");
    EXPECT_NE(now->GetComponent(300, 0), flatPoints->GetComponent(300, 0)) << "of this run";

    // Scaled to another size, it is not a map to this domain.
    filter->SetNormalizeTo(
      unit ? vtkOMTAreaPreservingFilter::SURFACE_AREA : vtkOMTAreaPreservingFilter::UNIT_DOMAIN);
    filter->Update();
    EXPECT_EQ(figure(filter->GetOutput(), "WarmStart"), 0.0);
    EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1.0);
  }
}

// Share of the faces whose area in the flat is within 2 % of that on the surface, percent.
double facesWithin2Percent(vtkPolyData* flattened)
{
  vtkDataArray* surface = flattened->GetPointData()->GetArray("SurfacePoints");
  vtkNew<vtkIdList> corners;
  vtkIdType within = 0;
  for (vtkIdType c = 0; c < flattened->GetNumberOfCells(); ++c)
  {
    flattened->GetCellPoints(c, corners);
    double flat[3][3];
    double curved[3][3];
    for (int k = 0; k < 3; ++k)
    {
      flattened->GetPoint(corners->GetId(k), flat[k]);
      surface->GetTuple(corners->GetId(k), curved[k]);
    }
    const double ratio = vtkTriangle::TriangleArea(flat[0], flat[1], flat[2]) /
                         vtkTriangle::TriangleArea(curved[0], curved[1], curved[2]);
    within += std::abs(ratio - 1.0) <= 0.02;
  }
  return 100.0 * static_cast<double>(within) / static_cast<double>(flattened->GetNumberOfCells());
}

TEST(OMTAreaPreservingFilter, FacesAreExactUnlessRefinementIsOff)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(conformalHemisphere(2000));
  EXPECT_TRUE(filter->GetFaceRefinement()) << "the default";
  filter->Update();
  const double refined = facesWithin2Percent(filter->GetOutput());
  EXPECT_GE(refined, 99.6);
  filter->FaceRefinementOff();
  filter->Update();
  EXPECT_LT(facesWithin2Percent(filter->GetOutput()), refined);
  EXPECT_EQ(figure(filter->GetOutput(), "RefinementRounds"), 0.0);
  filter->FaceRefinementOn();
  filter->SetAngleWeight(0.8);
  filter->Update();
  EXPECT_LT(facesWithin2Percent(filter->GetOutput()), 90.0) << "shape has its price";
  EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1.0);
}

// Not those of the filter before.
TEST(OMTAreaPreservingFilter, FiguresAreInBothOutputs)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  const auto input = conformalHemisphere(500);
  filter->SetInputData(input);
  filter->Update();
  for (const char* name : { "NewtonIterations", "FlippedFaces", "MaxCellAreaError", "Sites" })
  {
    EXPECT_EQ(figure(filter->GetPowerDiagram(), name), figure(filter->GetOutput(), name)) << name;
  }
  EXPECT_NE(figure(filter->GetPowerDiagram(), "NewtonIterations"), figure(input, "NewtonIterations"));
}

// Port 1: one polygon per site, with the site's id and area. Arcs are polylines of steps of a degree at
// most, which cuts a little from the cells on the circle.
TEST(OMTAreaPreservingFilter, PowerDiagramIsTheCells)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  const auto input = conformalHemisphere(1000);
  const double radius = std::sqrt(surfaceArea(input) / Pi);
  filter->SetInputData(input);
  filter->FaceRefinementOff();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkPolyData* cells = filter->GetPowerDiagram();
  ASSERT_EQ(cells->GetNumberOfCells(), output->GetNumberOfPoints());
  vtkDataArray* siteId = cells->GetCellData()->GetArray("SiteId");
  vtkDataArray* cellArea = cells->GetCellData()->GetArray("CellArea");
  vtkDataArray* targetArea = cells->GetCellData()->GetArray("TargetArea");
  ASSERT_TRUE(siteId && cellArea && targetArea);
  vtkNew<vtkIdList> corners;
  int onCircle = 0;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellPoints(c, corners);
    double area = 0.0;
    double center[2] = { 0.0, 0.0 };
    const vtkIdType count = corners->GetNumberOfIds();
    bool inside = true;
    for (vtkIdType k = 0; k < count; ++k)
    {
      double p[3];
      double q[3];
      cells->GetPoint(corners->GetId(k), p);
      cells->GetPoint(corners->GetId((k + 1) % count), q);
      const double twice = p[0] * q[1] - p[1] * q[0];
      area += 0.5 * twice;
      center[0] += twice / 6.0 * (p[0] + q[0]);
      center[1] += twice / 6.0 * (p[1] + q[1]);
      inside = inside && std::hypot(p[0], p[1]) < (1.0 - 1e-9) * radius;
    }
    const auto site = static_cast<vtkIdType>(siteId->GetTuple1(c));
    ASSERT_EQ(cellArea->GetTuple1(c), output->GetPointData()->GetArray("CellArea")->GetTuple1(site));
    ASSERT_EQ(targetArea->GetTuple1(c), output->GetPointData()->GetArray("TargetArea")->GetTuple1(site));
    ASSERT_NEAR(area / cellArea->GetTuple1(c), 1.0, inside ? 1e-10 : 3e-3) << c;
    if (inside)
    {
      // Interior points are at the centroids of their cells.
      double x[3];
      output->GetPoint(site, x);
      ASSERT_LT(std::hypot(x[0] - center[0] / area, x[1] - center[1] / area), 1e-9);
    }
    onCircle += !inside;
  }
  EXPECT_GT(onCircle, 50);
  EXPECT_LT(onCircle, 300);
}

TEST(OMTAreaPreservingFilter, AreaWeights)
{
  const auto input = conformalHemisphere(2000);
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetTolerance(1e-10);
  const auto shareOfRegion = [&]
  {
    filter->SetInputData(copyOf(input)); // new data every time
    filter->Update();
    vtkDataArray* area = filter->GetOutput()->GetPointData()->GetArray("CellArea");
    vtkDataArray* surface = filter->GetOutput()->GetPointData()->GetArray("SurfacePoints");
    double inside = 0.0;
    for (vtkIdType i = 0; i < area->GetNumberOfTuples(); ++i)
    {
      inside += surface->GetComponent(i, 0) > 10.0 ? area->GetTuple1(i) : 0.0;
    }
    return inside / (sum(area) - inside);
  };
  const double before = shareOfRegion();
  vtkDataArray* surface = input->GetPointData()->GetArray("SurfacePoints");
  for (const char* name : { "AreaWeight", "Importance" })
  {
    const auto weights = addWeights(input, name, 1.0);
    for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
    {
      weights->SetValue(i,
        surface->GetComponent(i, 0) <= 10.0 ? 1.0
        : std::string(name) == "AreaWeight" ? 2.0
                                            : 3.0);
    }
  }
  EXPECT_NEAR(shareOfRegion() / before, 2.0, 1e-9) << "AreaWeight by default";
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  EXPECT_NEAR(shareOfRegion() / before, 2.0, 1e-9) << "AreaWeight where none is chosen";
  EXPECT_STREQ(filter->GetWeightsInUse(), "AreaWeight, 1 to 2");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Importance");
  EXPECT_NEAR(shareOfRegion() / before, 3.0, 1e-9);
  input->GetPointData()->SetActiveScalars("Importance");
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  EXPECT_NEAR(shareOfRegion() / before, 3.0, 1e-9) << "the active scalars";
  filter->UseAreaWeightOff();
  EXPECT_NEAR(shareOfRegion() / before, 1.0, 1e-9);
}

TEST(OMTAreaPreservingFilter, ParametersAreClampedAndPrinted)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 2);
  EXPECT_EQ(filter->GetTolerance(), 1e-6);
  filter->SetTolerance(1.0);
  EXPECT_EQ(filter->GetTolerance(), 0.1);
  filter->SetTolerance(0.0);
  EXPECT_EQ(filter->GetTolerance(), 1e-12);
  std::ostringstream printed;
  filter->Print(printed);
  for (const char* part : { "NormalizeTo: SurfaceArea", "Tolerance: 1e-12", "UseAreaWeight: 1" })
  {
    EXPECT_NE(printed.str().find(part), std::string::npos) << part;
  }
}

TEST(OMTAreaPreservingFilter, EmptyInputGivesEmptyOutputSilently)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  ErrorLog errors(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetPowerDiagram()->GetNumberOfPoints(), 0);
}

TEST(OMTAreaPreservingFilter, BadInput)
{
  const auto good = conformalHemisphere(300);
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  const auto expect = [&](vtkPolyData* input, const std::string& words)
  { expectError(filter.Get(), input, words, good); };

  auto data = copyOf(good);
  data->GetPointData()->RemoveArray("SurfacePoints");
  expect(data, "run Conformal Disk first");
  addWeights(data, "SurfacePoints", 1.0);
  expect(data, "SurfacePoints has 1 components, not 3");

  data = copyOf(good);
  data->GetPointData()->GetArray("SurfacePoints")->SetComponent(7, 0, std::nan(""));
  expect(data, "vertex 7 has a coordinate that is not finite");
  data->GetPointData()->GetArray("SurfacePoints")->Fill(1.0);
  expect(data, "zero area");

  data = copyOf(good);
  data->GetPoints()->SetPoint(7, std::nan(""), 0, 0);
  expect(data, "point 7 of the flat surface is not finite");
  data = copyOf(good);
  data->GetPoints()->SetPoint(7, 0, 0, 1);
  expect(data, "not flat");
  data = copyOf(good);
  data->GetPoints()->SetPoint(7, 99, 0, 0);
  expect(data, "vertex 7 lies outside of the disk");
  data = copyOf(good);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    data->GetPoints()->SetPoint(i, x[0] + 1.0, x[1], 0.0);
  }
  expect(data, "does not lie on the circle around the origin");
  data = copyOf(good);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoints()->SetPoint(i, 0, 0, 0);
  }
  expect(data, "single point: run Conformal Disk first");

  data = copyOf(good);
  data->SetPolys(vtkNew<vtkCellArray>());
  expect(data, "no triangles");

  for (const double bad : { 0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    data = copyOf(good);
    addWeights(data, "AreaWeight", 1.0)->SetValue(11, bad);
    expect(data, "the area weight of vertex 11 is");
  }
  data = copyOf(good);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("AreaWeight");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(data->GetNumberOfPoints());
  vectors->Fill(1.0);
  data->GetPointData()->AddArray(vectors);
  expect(data, "the area weights AreaWeight have 3 components, not 1");

  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  filter->SetInputData(copyOf(good));
  ErrorLog errors(filter);
  filter->Update();
  EXPECT_EQ(errors.messages().size(), 0u) << "none was asked for by name";
  EXPECT_STREQ(filter->GetWeightsInUse(), "none");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Missing");
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("no point array Missing"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetPowerDiagram()->GetNumberOfCells(), 0);
  filter->UseAreaWeightOff();
  filter->Update();
  EXPECT_EQ(errors.messages().size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), good->GetNumberOfCells());
}

TEST(OMTAreaPreservingFilter, Abort)
{
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  const auto input = conformalHemisphere(1000);
  for (const double fraction : { 0.0, 0.3, 0.9 })
  {
    expectAbort(filter.Get(), input, fraction);
  }
}

// The map of a bent sheet, three times as long as wide, with a free outline.
TEST(OMTAreaPreservingFilter, FreeOutline)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(60, 20);
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(90.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 30.0, 0.0);
  vtkNew<vtkTriangleFilter> sheet;
  sheet->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(sheet->GetOutputPort());
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputConnection(conformal->GetOutputPort());
  filter->Update();
  const vtkSmartPointer<vtkPolyData> inDisk = copyOf(filter->GetOutput());
  EXPECT_EQ(figure(inDisk, "FreeOutline"), 0.0);
  filter->FreeOutlineOn();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(figure(output, "FreeOutline"), 1.0);
  EXPECT_EQ(figure(output, "Bijective"), 1.0);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);

  // The sheet comes out as it was, around the origin.
  double bounds[6];
  output->GetBounds(bounds);
  const double diagonal = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  EXPECT_LE(diagonal, 1.5 * std::hypot(90.0, 30.0));
  double corners[4][3];
  const vtkIdType ids[4] = { 0, 60, 20 * 61, 20 * 61 + 60 };
  for (int k = 0; k < 4; ++k)
  {
    output->GetPoint(ids[k], corners[k]);
  }
  const auto apart = [&](int a, int b)
  { return std::sqrt(vtkMath::Distance2BetweenPoints(corners[a], corners[b])); };
  EXPECT_NEAR(apart(0, 1), 90.0, 1e-3);
  EXPECT_NEAR(apart(0, 2), 30.0, 1e-3);
  EXPECT_NEAR(apart(0, 3), std::hypot(90.0, 30.0), 1e-3);
  EXPECT_NEAR(apart(1, 2), std::hypot(90.0, 30.0), 1e-3);

  // FlatPoints are its points. It lies as the map without a free outline does, up to a turn by a
  // twentieth that the refinement in the disk adds; the cells of the power diagram fill the map.
  vtkDataArray* flatPoints = output->GetPointData()->GetArray("FlatPoints");
  double along = 0.0;
  double across = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double place[3];
    output->GetPoint(i, place);
    double disk[3];
    inDisk->GetPoint(i, disk);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(flatPoints->GetComponent(i, k), place[k]);
    }
    along += place[0] * disk[0] + place[1] * disk[1];
    across += place[0] * disk[1] - place[1] * disk[0];
  }
  EXPECT_GT(along, 0.0);
  EXPECT_LT(std::abs(across), 0.1 * along);
  vtkPolyData* diagram = filter->GetPowerDiagram();
  double drawn = 0.0;
  for (vtkIdType c = 0; c < diagram->GetNumberOfCells(); ++c)
  {
    vtkPoints* outline = diagram->GetCell(c)->GetPoints();
    for (vtkIdType i = 0; i < outline->GetNumberOfPoints(); ++i)
    {
      double a[3];
      double b[3];
      outline->GetPoint(i, a);
      outline->GetPoint((i + 1) % outline->GetNumberOfPoints(), b);
      drawn += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  }
  EXPECT_NEAR(drawn, 2700.0, 0.01 * 2700.0);

  // A later run starts from the map.
  vtkNew<vtkPolyData> again;
  again->ShallowCopy(conformal->GetOutput());
  again->GetPointData()->AddArray(output->GetPointData()->GetArray("PowerWeight"));
  again->GetPointData()->AddArray(flatPoints);
  filter->SetInputData(again);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "WarmStart"), 1.0);
  EXPECT_EQ(figure(filter->GetOutput(), "FreeOutline"), 1.0);

  filter->FaceRefinementOff();
  const ErrorLog errors(filter.Get());
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("turn FaceRefinement on"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(OMTAreaPreservingFilter, AFreeOutlineNeedsNoConformalMap)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(30, 10);
  plane->SetOrigin(0.0, 0.0, 5.0);
  plane->SetPoint1(90.0, 20.0, 5.0);
  plane->SetPoint2(0.0, 0.0, 35.0);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  const vtkSmartPointer<vtkPolyData> surface = copyOf(triangles->GetOutput());
  surface->GetPointData()->GetTCoords()->SetName("TCoords");
  vtkNew<vtkOMTAreaPreservingFilter> filter;
  filter->SetInputData(surface);
  filter->FreeOutlineOn();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(figure(output, "FreeOutline"), 1.0);
  EXPECT_EQ(figure(output, "Bijective"), 1.0);
  vtkDataArray* surfacePoints = output->GetPointData()->GetArray("SurfacePoints");
  ASSERT_EQ(output->GetNumberOfPoints(), surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(vtkMath::Distance2BetweenPoints(surfacePoints->GetTuple3(i), surface->GetPoint(i)), 0.0);
  }
  const auto apart = [output](vtkIdType a, vtkIdType b)
  {
    double place[3];
    output->GetPoint(a, place);
    return std::sqrt(vtkMath::Distance2BetweenPoints(place, output->GetPoint(b)));
  };
  EXPECT_NEAR(apart(0, 30), std::hypot(90.0, 20.0), 1e-3);
  EXPECT_NEAR(apart(0, 10 * 31), 30.0, 1e-3);
  EXPECT_TRUE(output->GetPointData()->HasArray("SurfaceTCoords")) << "those of the surface itself";

  filter->FreeOutlineOff();
  const ErrorLog errors(filter.Get());
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("run Conformal Disk first, or turn FreeOutline on"),
    std::string::npos);
}

TEST(OMTAreaPreservingFilter, ARectangleStaysARectangle)
{
  constexpr int columns = 41;
  constexpr int rows = 61;
  TriangleMesh mesh;
  mesh.Vertices.resize(columns * rows, 3);
  mesh.Faces.resize(2 * (columns - 1) * (rows - 1), 3);
  int face = 0;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int v = j * columns + i;
      const double angle = Pi * j / (rows - 1);
      const double dent = std::exp(-0.02 * std::pow(i - 15.0, 2.0) - 0.01 * std::pow(j - 25.0, 2.0));
      const double radius = 10.0 - 6.0 * dent;
      mesh.Vertices.row(v) << i, radius * std::cos(angle), radius * std::sin(angle);
      if (i + 1 < columns && j + 1 < rows)
      {
        mesh.Faces.row(face++) << v, v + 1, v + columns + 1;
        mesh.Faces.row(face++) << v, v + columns + 1, v + columns;
      }
    }
  }
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(polyDataOf(mesh));
  conformal->SetDomainToRectangle();
  vtkNew<vtkOMTAreaPreservingFilter> transport;
  transport->SetInputConnection(conformal->GetOutputPort());
  transport->Update();
  vtkPolyData* output = transport->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), columns * rows);
  const double surfaceArea = faceAreas(mesh.Vertices, mesh.Faces).sum();
  EXPECT_NEAR(sum(output->GetPointData()->GetArray("CellArea")) / surfaceArea, 1.0, 1e-11);
  EXPECT_LE(figure(output, "MaxCellAreaError"), 1e-6);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
  double bounds[6];
  output->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 0.0, 1e-12);
  EXPECT_NEAR(bounds[2], 0.0, 1e-12);
  EXPECT_NEAR(bounds[1] * bounds[3] / surfaceArea, 1.0, 1e-12);
  EXPECT_NEAR(bounds[1] / bounds[3], figure(output, "Modulus"), 1e-12);
  vtkDataArray* corners = output->GetFieldData()->GetArray("CornerPointIds");
  ASSERT_TRUE(corners);
  for (int c = 0; c < 4; ++c)
  {
    double x[3];
    output->GetPoint(static_cast<vtkIdType>(corners->GetTuple1(c)), x);
    EXPECT_NEAR(x[0], c == 1 || c == 2 ? bounds[1] : 0.0, 1e-12);
    EXPECT_NEAR(x[1], c >= 2 ? bounds[3] : 0.0, 1e-12);
  }
  double cellBounds[6];
  transport->GetPowerDiagram()->GetBounds(cellBounds);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(cellBounds[k], bounds[k], 1e-9) << "the power cells fill the rectangle";
  }

  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(transport->GetOutputPort());
  metrics->Update();
  EXPECT_NEAR(figure(metrics->GetOutput(), "FlatArea") / surfaceArea, 1.0, 1e-12);
  EXPECT_EQ(figure(metrics->GetOutput(), "FlippedFaces"), 0.0);

  transport->SetNormalizeToUnitDomain();
  transport->Update();
  output->GetBounds(bounds);
  EXPECT_NEAR(bounds[3], 1.0, 1e-12);
}

// A hexagon in a circle of its area: the map is 1 - 3 sqrt(3) / (2 pi) = 17.3 percent too small.
TEST(OMTAreaPreservingFilter, WarnsOfWhatACoarseOutlineCutsOff)
{
  TriangleMesh hexagon;
  hexagon.Vertices = Points3::Zero(7, 3);
  hexagon.Faces.resize(6, 3);
  for (int k = 0; k < 6; ++k)
  {
    hexagon.Vertices.row(k + 1) << 5.0 * std::cos(k * Pi / 3.0), 5.0 * std::sin(k * Pi / 3.0), 0.0;
    hexagon.Faces.row(k) << 0, k + 1, (k + 1) % 6 + 1;
  }
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(polyDataOf(hexagon));
  vtkNew<vtkOMTAreaPreservingFilter> omt;
  omt->SetInputConnection(conformal->GetOutputPort());
  vtkNew<vtkTest::ErrorObserver> warnings;
  omt->AddObserver(vtkCommand::WarningEvent, warnings);
  omt->Update();
  const std::string warning = warnings->GetWarningMessage();
  const std::size_t place = warning.find("multiply them by ");
  EXPECT_NE(warning.find("encloses 17.3"), std::string::npos) << warning;
  ASSERT_NE(place, std::string::npos) << warning;
  EXPECT_NEAR(std::stod(warning.substr(place + 17)), 2.0 * Pi / (3.0 * std::sqrt(3.0)), 1e-4);

  omt->SetInputData(conformalHemisphere(2000));
  warnings->Clear();
  omt->Update();
  EXPECT_FALSE(warnings->GetWarning()) << warnings->GetWarningMessage();
}

// All squares of the grid have the same diagonal. Then no map keeps all areas that is smooth: moving an
// inner vertex hardly changes the difference between the areas of the upper and the lower triangles.
TEST(OMTAreaPreservingFilter, WarnsIfManyAreasAreOff)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 20);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkOMTAreaPreservingFilter> omt;
  omt->SetInputConnection(conformal->GetOutputPort());
  vtkNew<vtkTest::ErrorObserver> warnings;
  omt->AddObserver(vtkCommand::WarningEvent, warnings);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(omt->GetOutputPort());
  metrics->Update();
  const double within =
    metrics->GetOutput()->GetFieldData()->GetArray("FacesWithin2Percent")->GetComponent(0, 0);
  ASSERT_LT(within, 50.0);
  const std::string warning = warnings->GetWarningMessage();
  const std::size_t place = warning.find("the areas of ");
  ASSERT_NE(place, std::string::npos) << warning;
  EXPECT_NEAR(std::stod(warning.substr(place + 13)), 100.0 - within, 1e-3);

  warnings->Clear();
  omt->SetAngleWeight(0.5);
  omt->Update();
  EXPECT_FALSE(warnings->GetWarning()) << warnings->GetWarningMessage();
}

} // namespace
