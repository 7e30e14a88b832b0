// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Core/Support/SampleSurfaces.h"
#include "../Core/Support/SliverRefinement.h"
#include "AnalyticSurfaces.h"
#include "FilterTest.h"
#include "Mesh/FaceOrientation.h"

#include <vtkConformalDiskFilter.h>

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkStringArray.h>
#include <vtkSurfaceToDiskFilter.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::testing;
using samples::Pi;

// A hemisphere of radius 30, as large as an organ in mm.
const RevolutionMesh& hemisphere()
{
  static const RevolutionMesh mesh = []
  {
    RevolutionMesh result = ringMesh(sphericalCap(0.5 * Pi), 2000);
    result.Mesh.Vertices *= 30.0;
    return result;
  }();
  return mesh;
}

double surfaceArea(const RevolutionMesh& mesh)
{
  return faceAreas(mesh.Mesh.Vertices, mesh.Mesh.Faces).sum();
}

TEST(ConformalDiskFilter, DiskHasTheAreaOfTheSurface)
{
  const auto input = polyDataOf(hemisphere().Mesh);
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  const double radius = std::sqrt(surfaceArea(hemisphere()) / Pi);
  EXPECT_NEAR(radius, 30.0 * std::sqrt(2.0), 0.05);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const double expected = sphericalCap(0.5 * Pi).ConformalRadius(hemisphere().Parameter[i]);
    EXPECT_NEAR(std::hypot(x[0], x[1]) / radius, expected, 1e-5);
    EXPECT_EQ(x[2], 0.0);
  }
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);

  filter->SetNormalizeToUnitDomain();
  filter->Update();
  for (vtkIdType i = hemisphere().FirstBoundaryVertex; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    filter->GetOutput()->GetPoint(i, x);
    EXPECT_NEAR(std::hypot(x[0], x[1]), 1.0, 1e-15);
  }
}

// ConformalFactor is the logarithm of flat over surface length: an edge's is half the sum of its ends'.
// Edges that were flipped on the way follow to the resolution of the mesh.
TEST(ConformalDiskFilter, ConformalFactorScalesTheEdges)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(hemisphere().Mesh));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* factor = output->GetPointData()->GetArray("ConformalFactor");
  ASSERT_NE(factor, nullptr);
  int exact = 0;
  for (int f = 0; f < hemisphere().Mesh.faceCount(); ++f)
  {
    const int a = hemisphere().Mesh.Faces(f, 0);
    const int b = hemisphere().Mesh.Faces(f, 1);
    double p[3];
    double q[3];
    output->GetPoint(a, p);
    output->GetPoint(b, q);
    const double flat = std::hypot(p[0] - q[0], p[1] - q[1]);
    const double length = (hemisphere().Mesh.Vertices.row(a) - hemisphere().Mesh.Vertices.row(b)).norm();
    const double difference =
      std::log(flat / length) - 0.5 * (factor->GetTuple1(a) + factor->GetTuple1(b));
    ASSERT_LT(std::abs(difference), 1e-3);
    exact += std::abs(difference) < 1e-9;
  }
  EXPECT_GT(exact, 0.8 * hemisphere().Mesh.faceCount());
}

TEST(ConformalDiskFilter, PassesEverythingThrough)
{
  const auto input = polyDataOf(hemisphere().Mesh);
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("Thickness");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    thickness->InsertNextValue(0.5f * i);
  }
  input->GetPointData()->SetScalars(thickness);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  vtkNew<vtkStringArray> name;
  name->SetName("Name");
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    label->InsertNextValue(static_cast<int>(c % 7));
    name->InsertNextValue("cell " + std::to_string(c));
  }
  input->GetCellData()->AddArray(label);
  input->GetCellData()->AddArray(name);
  vtkNew<vtkStringArray> subject;
  subject->SetName("Subject");
  subject->InsertNextValue("phantom");
  input->GetFieldData()->AddArray(subject);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(input);
  normals->SplittingOff();
  normals->ConsistencyOff();

  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputConnection(normals->GetOutputPort());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPointData()->GetScalars(), thickness.Get());
  EXPECT_EQ(output->GetCellData()->GetArray("Label"), label.Get());
  EXPECT_EQ(output->GetCellData()->GetAbstractArray("Name"), name.Get());
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("Subject"), subject.Get());
  EXPECT_EQ(output->GetPolys(), normals->GetOutput()->GetPolys()) << "cells stay one to one";
  // The surface's normals would shade the flat picture: they stay as an array, inactive.
  ASSERT_NE(normals->GetOutput()->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr);
  EXPECT_TRUE(output->GetPointData()->HasArray("Normals"));
  // SurfacePoints restores the surface, to the bit.
  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  ASSERT_NE(surface, nullptr);
  ASSERT_EQ(surface->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(surface->GetComponent(i, k), normals->GetOutput()->GetPoint(i)[k]);
    }
  }
  EXPECT_FALSE(normals->GetOutput()->GetPointData()->HasArray("SurfacePoints"))
    << "the input was changed";
  EXPECT_FALSE(normals->GetOutput()->GetFieldData()->HasArray("NewtonIterations"))
    << "the input was changed";
}

TEST(ConformalDiskFilter, FiguresOfTheSolver)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(hemisphere().Mesh));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_GT(figure(output, "NewtonIterations"), 0.0);
  EXPECT_LT(figure(output, "NewtonIterations"), 20.0);
  EXPECT_LE(figure(output, "MaxCurvatureError"), 1e-10);
  EXPECT_LE(figure(output, "LayoutError"), 1e-8);
  EXPECT_EQ(figure(output, "AddedLength"), 0.0);
  EXPECT_EQ(figure(output, "RepairedFaces"), 0.0);
  EXPECT_EQ(figure(output, "MovedPoints"), 0.0);
  EXPECT_EQ(figure(output, "GreatestMove"), 0.0);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
  EXPECT_GE(figure(output, "IntrinsicFlips"), 0.0);
}

bool hasFigure(vtkPolyData* output, const char* name)
{
  return output->GetFieldData()->HasArray(name);
}

TEST(ConformalDiskFilter, EveryMethodHasItsOwnFigures)
{
  vtkNew<vtkConformalDiskFilter> filter;
  EXPECT_EQ(filter->GetMethod(), vtkConformalDiskFilter::RICCI_FLOW);
  const auto input = polyDataOf(hemisphere().Mesh);
  // The filter removes values that the map of another surface left in the field data.
  vtkNew<vtkDoubleArray> stale;
  stale->SetName("MaxCurvatureError");
  stale->InsertNextValue(0.0);
  input->GetFieldData()->AddArray(stale);
  filter->SetInputData(input);
  vtkPolyData* output = filter->GetOutput();
  for (const int method : { vtkConformalDiskFilter::RICCI_FLOW,
         vtkConformalDiskFilter::BOUNDARY_FIRST,
         vtkConformalDiskFilter::MEAN_VALUE })
  {
    SCOPED_TRACE(method);
    filter->SetMethod(method);
    filter->Update();
    const bool isFlow = method == vtkConformalDiskFilter::RICCI_FLOW;
    for (const char* name : { "NewtonIterations", "MaxCurvatureError", "LayoutError" })
    {
      EXPECT_EQ(hasFigure(output, name), isFlow) << name;
    }
    EXPECT_EQ(hasFigure(output, "BoundaryIterations"), method == vtkConformalDiskFilter::BOUNDARY_FIRST);
    EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
    EXPECT_EQ(figure(output, "AddedLength"), 0.0);
    EXPECT_EQ(hasFigure(output, "SpreadPoints"), method != vtkConformalDiskFilter::MEAN_VALUE);
    EXPECT_TRUE(hasFigure(output, "IntrinsicFlips"));
    // The stereographic projection halves lengths at the pole of a unit sphere; the disk of the
    // hemisphere's area has radius sqrt(2).
    EXPECT_NEAR(output->GetPointData()->GetArray("ConformalFactor")->GetTuple1(0),
      -0.5 * std::log(2.0),
      method == vtkConformalDiskFilter::MEAN_VALUE ? 0.05 : 5e-3);
  }
  EXPECT_TRUE(input->GetFieldData()->HasArray("MaxCurvatureError")) << "the input was changed";
  filter->SetMethodToBoundaryFirst();
  EXPECT_EQ(filter->GetMethod(), vtkConformalDiskFilter::BOUNDARY_FIRST);
  filter->SetMethodToMeanValue();
  EXPECT_EQ(filter->GetMethod(), vtkConformalDiskFilter::MEAN_VALUE);
  filter->SetMethodToRicciFlow();
  EXPECT_EQ(filter->GetMethod(), vtkConformalDiskFilter::RICCI_FLOW);
  filter->SetMethod(-1);
  EXPECT_EQ(filter->GetMethod(), vtkConformalDiskFilter::RICCI_FLOW);
  filter->SetMethod(9);
  EXPECT_EQ(filter->GetMethod(), vtkConformalDiskFilter::MEAN_VALUE);
}

TEST(ConformalDiskFilter, SaysWhatItDidAboutFlippedFaces)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(samples::withRandomSlivers(hemisphere().Mesh, 2000, 1e-3, 1)));
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
  EXPECT_GT(figure(output, "RepairedFaces"), 0.0);
  EXPECT_GT(figure(output, "MovedPoints"), 0.0);
  EXPECT_GT(figure(output, "GreatestMove"), 0.0);
  EXPECT_FALSE(observer->GetWarning());
  Points2 positions(output->GetNumberOfPoints(), 2);
  FaceMatrix faces(output->GetNumberOfCells(), 3);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    positions.row(i) << output->GetPoint(i)[0], output->GetPoint(i)[1];
  }
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    vtkIdList* corners = output->GetCell(i)->GetPointIds();
    for (int k = 0; k < 3; ++k)
    {
      faces(i, k) = static_cast<int>(corners->GetId(k));
    }
  }
  EXPECT_EQ(countFlippedFaces(positions, faces), 0) << "in the output's own size";
}

// A boundary of three vertices, two of which all but coincide: the triangle between them leaves no room.
TEST(ConformalDiskFilter, WarnsOfFlippedFaces)
{
  TriangleMesh mesh = samples::withoutFaces(samples::sphere(4), { 0 });
  const Eigen::Vector3i hole = samples::sphere(4).Faces.row(0).transpose();
  mesh.Vertices.row(hole[1]) =
    mesh.Vertices.row(hole[0]) + 1e-9 * (mesh.Vertices.row(hole[1]) - mesh.Vertices.row(hole[0]));
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(mesh));
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  EXPECT_GT(figure(filter->GetOutput(), "FlippedFaces"), 0.0);
  ASSERT_TRUE(observer->GetWarning());
  EXPECT_NE(observer->GetWarningMessage().find("are flipped"), std::string::npos);
}

// A long finger with slivers that no untangling repairs, and with a toothed boundary. A rectangle is
// proposed only if the boundary is as long as that of a strip of more than 13 to 1.
TEST(ConformalDiskFilter, ProposesARectangleForStripsOnly)
{
  const auto warnings = [](double depthOfTeeth, double lowest, double highest)
  {
    const RevolutionMesh finger = ringMesh(capsule(30.0), 1000);
    TriangleMesh mesh = samples::withRandomSlivers(finger.Mesh, 2000, 1e-6, 1);
    for (int v = finger.FirstBoundaryVertex; v < finger.Mesh.vertexCount(); v += 2)
    {
      mesh.Vertices(v, 2) += std::copysign(depthOfTeeth, mesh.Vertices(v, 2));
    }
    vtkNew<vtkConformalDiskFilter> filter;
    filter->SetInputData(polyDataOf(mesh));
    std::string all;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&all);
    command->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
    filter->AddObserver(vtkCommand::WarningEvent, command);
    filter->Update();
    EXPECT_GT(figure(filter->GetOutput(), "FlippedFaces"), 0.0);
    EXPECT_GT(figure(filter->GetOutput(), "SpreadPoints"), 1000.0);
    EXPECT_GT(figure(filter->GetOutput(), "BoundaryAnisotropy"), lowest);
    EXPECT_LT(figure(filter->GetOutput(), "BoundaryAnisotropy"), highest);
    return all;
  };
  const std::string ofFinger = warnings(4.0, 0.2, 0.9);
  EXPECT_NE(ofFinger.find("smooth the surface more, or fill its narrow parts"), std::string::npos)
    << ofFinger;
  EXPECT_EQ(ofFinger.find("Rectangle"), std::string::npos) << ofFinger;
  const std::string ofStrip = warnings(8.0, 0.05, 0.2);
  EXPECT_NE(
    ofStrip.find("set Domain to Rectangle, as the surface is long and narrow"), std::string::npos)
    << ofStrip;
}

TEST(ConformalDiskFilter, NearestPointsGoToTheCentreAndToAngleZero)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(hemisphere().Mesh));
  const int centre = 500;
  const int right = hemisphere().FirstBoundaryVertex + 31;
  const Eigen::RowVector3d c = hemisphere().Mesh.Vertices.row(centre) * 1.02;
  const Eigen::RowVector3d r = hemisphere().Mesh.Vertices.row(right) * 1.02;
  filter->SetUseCenterPoint(true);
  filter->SetCenterPoint(c.x(), c.y(), c.z());
  filter->SetUseBoundaryPoint(true);
  filter->SetBoundaryPoint(r.x(), r.y(), r.z());
  filter->Update();
  double x[3];
  filter->GetOutput()->GetPoint(centre, x);
  EXPECT_EQ(std::hypot(x[0], x[1]), 0.0);
  filter->GetOutput()->GetPoint(right, x);
  EXPECT_NEAR(x[1], 0.0, 1e-13);
  EXPECT_NEAR(x[0], std::sqrt(surfaceArea(hemisphere()) / Pi), 1e-12);
}

// Half of a cylinder of radius 10 and length 45, as a grid.
vtkSmartPointer<vtkPolyData> halfCylinder()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(45.0, 0.0, 0.0);
  plane->SetPoint2(0.0, Pi, 0.0);
  plane->SetResolution(40, 60);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  const vtkSmartPointer<vtkPolyData> data = triangles->GetOutput();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    data->GetPoints()->SetPoint(i, x[0], 10.0 * std::cos(x[1]), 10.0 * std::sin(x[1]));
  }
  return data;
}

TEST(ConformalDiskFilter, AHalfCylinderUnrollsToARectangle)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(halfCylinder());
  filter->SetDomainToRectangle();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_NEAR(figure(output, "Modulus"), 45.0 / (10.0 * Pi), 2e-4) << "the mesh is a prism";
  double bounds[6];
  output->GetBounds(bounds);
  const double height = 60 * 2.0 * 10.0 * std::sin(Pi / 120.0);
  EXPECT_NEAR(bounds[0], 0.0, 1e-12);
  EXPECT_NEAR(bounds[1], 45.0, 1e-4);
  EXPECT_NEAR(bounds[2], 0.0, 1e-12);
  EXPECT_NEAR(bounds[3], height, 1e-4) << "the area is that of the surface";
  EXPECT_EQ(figure(output, "FlippedFaces"), 0.0);
  EXPECT_NEAR(figure(output, "BoundaryAnisotropy"),
    4.0 * Pi * 45.0 * height / std::pow(90.0 + 2.0 * height, 2.0),
    1e-4);

  // Turned by a quarter: the first corner is one of the far end.
  filter->UseCornersOn();
  filter->SetLowerLeftCorner(50.0, 10.0, 0.0);
  filter->SetLowerRightCorner(50.0, -10.0, 0.0);
  filter->SetUpperRightCorner(-5.0, -10.0, 0.0);
  filter->SetUpperLeftCorner(-5.0, 10.0, 0.0);
  filter->SetNormalizeToUnitDomain();
  filter->Update();
  ASSERT_EQ(output->GetNumberOfPoints(), 41 * 61);
  EXPECT_NEAR(figure(output, "Modulus"), height / 45.0, 1e-6);
  output->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], height / 45.0, 1e-6);
  EXPECT_NEAR(bounds[3], 1.0, 1e-12);
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetFieldData()->GetArray("CornerPointIds"));
  ASSERT_TRUE(ids);
  ASSERT_EQ(ids->GetNumberOfTuples(), 4);
  double x[3];
  output->GetPoint(ids->GetValue(2), x);
  EXPECT_NEAR(x[0], figure(output, "Modulus"), 1e-12);
  EXPECT_NEAR(x[1], 1.0, 1e-12);

  filter->SetLowerLeftCorner(50.0, -10.0, 0.0);
  filter->SetLowerRightCorner(50.0, 10.0, 0.0);
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("not in the order"), std::string::npos);
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
}

// A cap on a tube of 30 radii: a disk shrinks it by e^-30.
// Surface To Disk cuts an open cylinder from end to end; the rectangle's corners are where the seam
// meets the ends, also if that makes it higher than wide.
TEST(ConformalDiskFilter, AnOpenTubeUnrollsToARectangle)
{
  constexpr int around = 60;
  constexpr double length = 6.0;
  vtkNew<vtkSurfaceToDiskFilter> disk;
  disk->SetInputData(polyDataOf(flattening::samples::cylinder(around, 50, length)));
  disk->SetCutModeToSeam();
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputConnection(disk->GetOutputPort());
  filter->SetDomainToRectangle();
  filter->Update();
  EXPECT_EQ(figure(disk->GetOutput(), "FilledHoles"), 0.0);
  EXPECT_EQ(figure(disk->GetOutput(), "RemovedArea"), 0.0);
  const double circumference = around * 2.0 * std::sin(Pi / around);
  EXPECT_NEAR(figure(filter->GetOutput(), "Modulus"), length / circumference, 1e-9) << "of the prism";
  EXPECT_NEAR(figure(filter->GetOutput(), "Modulus"), length / (2.0 * Pi), 5e-4);
  EXPECT_EQ(figure(filter->GetOutput(), "FlippedFaces"), 0.0);
}

TEST(ConformalDiskFilter, ARectangleNeedsRicciFlow)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(hemisphere().Mesh));
  filter->SetDomainToRectangle();
  for (const int method : { vtkConformalDiskFilter::BOUNDARY_FIRST, vtkConformalDiskFilter::MEAN_VALUE })
  {
    filter->SetMethod(method);
    ErrorLog errors(filter);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages().front().find("set Method to Ricci Flow"), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  filter->SetMethodToRicciFlow();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), hemisphere().Mesh.faceCount());
}

TEST(ConformalDiskFilter, WarnsOfLongTubes)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputData(polyDataOf(ringMesh(capsule(30.0), 3000).Mesh));
  std::string warning;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&warning);
  command->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) = static_cast<const char*>(message); });
  filter->AddObserver(vtkCommand::WarningEvent, command);
  filter->Update();
  EXPECT_NE(warning.find("set Domain to Rectangle"), std::string::npos) << warning;
  warning.clear();
  filter->SetInputData(polyDataOf(samples::rectangleGrid(100, 4, 7.0))); // a strip is no tube
  filter->Update();
  EXPECT_NE(warning.find("long narrow parts"), std::string::npos) << warning;
  EXPECT_EQ(warning.find("stretched"), std::string::npos) << warning;
  filter->SetInputData(polyDataOf(ringMesh(capsule(3.0), 3000).Mesh));
  warning.clear();
  filter->Update();
  EXPECT_EQ(warning, "");
  filter->SetInputData(polyDataOf(ringMesh(capsule(30.0), 3000).Mesh));
  filter->Update();
  EXPECT_GT(figure(filter->GetOutput(), "SpreadPoints"), 300.0);
  EXPECT_NEAR(figure(filter->GetOutput(), "BoundaryAnisotropy"), 62.0, 1.0);
  EXPECT_EQ(figure(filter->GetOutput(), "FlippedFaces"), 0.0);
}

TEST(ConformalDiskFilter, ParametersAreClampedAndPrinted)
{
  vtkNew<vtkConformalDiskFilter> filter;
  EXPECT_EQ(filter->GetNormalizeTo(), vtkConformalDiskFilter::SURFACE_AREA);
  EXPECT_EQ(filter->GetTolerance(), 1e-11);
  filter->SetTolerance(1.0);
  EXPECT_EQ(filter->GetTolerance(), 1e-10);
  filter->SetTolerance(0.0);
  EXPECT_EQ(filter->GetTolerance(), 1e-14);
  filter->SetNormalizeTo(7);
  EXPECT_EQ(filter->GetNormalizeTo(), vtkConformalDiskFilter::UNIT_DOMAIN);
  filter->SetCenterPoint(1.0, 2.0, 3.5);
  filter->SetMethodToBoundaryFirst();
  std::ostringstream printed;
  filter->Print(printed);
  for (const char* part : { "Method: BoundaryFirst",
         "NormalizeTo: UnitDomain",
         "Domain: Disk",
         "UseCorners: 0",
         "UpperLeftCorner: (0, 0, 0)",
         "UseCenterPoint: 0",
         "CenterPoint: (1, 2, 3.5)",
         "UseBoundaryPoint: 0",
         "BoundaryPoint: (0, 0, 0)",
         "Tolerance: 1e-14" })
  {
    EXPECT_NE(printed.str().find(part), std::string::npos) << part;
  }
}

TEST(ConformalDiskFilter, EmptyInputGivesEmptyOutputSilently)
{
  vtkNew<vtkConformalDiskFilter> filter;
  ErrorLog errors(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

class BadInput : public ::testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(ConformalDiskFilter,
  BadInput,
  ::testing::Values(vtkConformalDiskFilter::RICCI_FLOW,
    vtkConformalDiskFilter::BOUNDARY_FIRST,
    vtkConformalDiskFilter::MEAN_VALUE));

TEST_P(BadInput, IsOneError)
{
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetMethod(GetParam());
  const RevolutionMesh disk = ringMesh(sphericalCap(1.0), 100);
  const auto good = polyDataOf(disk.Mesh);
  const auto expect = [&](vtkPolyData* input, const char* words)
  { expectError(filter.Get(), input, words, good); };

  vtkNew<vtkPolyData> pointsAlone;
  pointsAlone->SetPoints(good->GetPoints());
  expect(pointsAlone, "no triangles");

  vtkNew<vtkPolyData> lines;
  lines->SetPoints(good->GetPoints());
  vtkNew<vtkCellArray> segments;
  segments->InsertNextCell({ 0, 1 });
  lines->SetLines(segments);
  expect(lines, "lines or strips");

  vtkNew<vtkPlaneSource> quads;
  quads->SetResolution(3, 3);
  quads->Update();
  expect(quads->GetOutput(), "cell 0 has 4 points, not 3");

  TriangleMesh mesh = disk.Mesh;
  mesh.Vertices(9, 2) = std::nan("");
  expect(polyDataOf(mesh), "vertex 9 has a coordinate that is not finite");
  mesh.Vertices(9, 2) = -std::numeric_limits<double>::infinity();
  expect(polyDataOf(mesh), "vertex 9 has a coordinate that is not finite");
  mesh.Vertices.setConstant(2.0);
  expect(polyDataOf(mesh), "zero area");

  mesh = disk.Mesh;
  mesh.Vertices.conservativeResize(mesh.vertexCount() + 1, 3);
  mesh.Vertices.bottomRows<1>() << 0, 0, 5;
  expect(polyDataOf(mesh), "1 points belong to no triangle");
  mesh.Faces.conservativeResize(mesh.faceCount() + 1, 3);
  mesh.Faces.bottomRows<1>() << 0, 1, mesh.vertexCount() - 1;
  expect(polyDataOf(mesh), "edge (0, 1) is non-manifold: 3 faces share it");

  mesh = disk.Mesh;
  std::swap(mesh.Faces(4, 0), mesh.Faces(4, 1));
  expect(polyDataOf(mesh), "oriented against each other");

  expect(polyDataOf(samples::both(disk.Mesh, samples::moved(disk.Mesh, 9, 0, 0))), "2 components");
  expect(polyDataOf(samples::withoutFaces(samples::torus(12, 8), { 0 })), "genus 1");
  expect(polyDataOf(samples::torus(12, 8)), "genus 1");
  expect(polyDataOf(samples::sphere(2)), "closed");
  expect(polyDataOf(samples::cylinder(12, 4, 1.0)), "2 boundary loops");

  filter->SetUseCenterPoint(true);
  const auto boundary = disk.Mesh.Vertices.row(disk.FirstBoundaryVertex);
  filter->SetCenterPoint(boundary.x(), boundary.y(), boundary.z());
  filter->SetInputData(good);
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("is not an interior vertex"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->UseCenterPointOff();
  filter->Update();
  EXPECT_EQ(errors.messages().size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), good->GetNumberOfCells());
}

TEST(ConformalDiskFilter, Abort)
{
  vtkNew<vtkConformalDiskFilter> filter;
  const auto input = polyDataOf(hemisphere().Mesh);
  for (const double fraction : { 0.05, 0.3, 0.9 })
  {
    expectAbort(filter.Get(), input, fraction);
  }
  filter->SetMethodToBoundaryFirst();
  expectAbort(filter.Get(), input, 0.3);
  filter->SetMethodToMeanValue();
  expectAbort(filter.Get(), input, 0.3);
}

} // namespace
