// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a surface and its distance from the origin do not change its flat map.
#include "../Core/Support/RandomNumbers.h"
#include "../Core/Support/SampleSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkSurfaceToDiskFilter.h>

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <string>

namespace
{

using namespace flattening;
using namespace flattening::testing;

// A closed surface without symmetry, with coordinates of 30 binary digits, so that it can be moved
// without rounding.
TriangleMesh closedSurface()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(30);
  source->SetPhiResolution(30);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* sphere = source->GetOutput();
  TriangleMesh mesh;
  mesh.Vertices.resize(sphere->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    sphere->GetPoint(i, mesh.Vertices.row(i).data());
  }
  samples::RandomNumbers random(1);
  for (auto vertex : mesh.Vertices.rowwise())
  {
    vertex.z() *= 1.5;
    vertex += random.point(-0.003, 0.003);
  }
  mesh.Vertices =
    mesh.Vertices.unaryExpr([](double x) { return std::ldexp(std::round(std::ldexp(x, 30)), -30); });
  mesh.Faces.resize(sphere->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < sphere->GetNumberOfCells(); ++f)
  {
    sphere->GetCellPoints(f, corners);
    mesh.Faces.row(f) << static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
      static_cast<int>(corners->GetId(2));
  }
  return mesh;
}

struct Chain
{
  vtkNew<vtkSurfaceToDiskFilter> Disk;
  vtkNew<vtkConformalDiskFilter> Conformal;
  vtkNew<vtkOMTAreaPreservingFilter> Areas;
  vtkNew<vtkDistortionMetrics> Metrics;

  explicit Chain(const TriangleMesh& mesh)
  {
    this->Disk->SetInputData(polyDataOf(mesh));
    this->Disk->SetCutModeToSeam();
    this->Conformal->SetInputConnection(this->Disk->GetOutputPort());
    this->Areas->SetInputConnection(this->Conformal->GetOutputPort());
    this->Metrics->SetInputConnection(this->Areas->GetOutputPort());
    this->Metrics->UseTargetAreaOff();
    this->Metrics->Update();
  }

  Points3 flat() { return pointsOf(this->Metrics->GetOutput()); }
  Points3 conformal() { return pointsOf(this->Conformal->GetOutput()); }

  static Points3 pointsOf(vtkPolyData* map)
  {
    Points3 points(map->GetNumberOfPoints(), 3);
    for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
    {
      map->GetPoint(i, points.row(i).data());
    }
    return points;
  }

  double figure(const char* name)
  {
    return flattening::testing::figure(this->Metrics->GetOutput(), name);
  }
};

TEST(SizeAndPlace, TheMapIsTheSameAtAnySizeBitForBit)
{
  const TriangleMesh mesh = closedSurface();
  Chain chain(mesh);
  const Points3 flat = chain.flat();
  ASSERT_GT(flat.rows(), 800);
  EXPECT_EQ(chain.figure("Bijective"), 1.0);
  EXPECT_GE(chain.figure("FacesWithin2Percent"), 95.0);
  for (int exponent = -900; exponent <= 900; exponent += 150)
  {
    SCOPED_TRACE(exponent);
    const auto times = [exponent](double x) { return std::ldexp(x, exponent); };
    TriangleMesh scaled = mesh;
    scaled.Vertices = mesh.Vertices.unaryExpr(times);
    Chain other(scaled);
    EXPECT_EQ(other.flat(), flat.unaryExpr(times).eval());
    for (const char* name :
      { "FacesWithin2Percent", "MeanAreaError", "MeanAngleError", "AreaWeightedMeanAngleError" })
    {
      EXPECT_EQ(other.figure(name), chain.figure(name)) << name;
    }
    EXPECT_EQ(other.figure("SurfaceArea"), std::ldexp(chain.figure("SurfaceArea"), 2 * exponent));
    EXPECT_EQ(figure(other.Disk->GetOutput(), "SeamLength"),
      times(figure(chain.Disk->GetOutput(), "SeamLength")));
  }
}

// VTK divides a polygon along its normal, whose square is far from the square of a length.
TEST(SizeAndPlace, PolygonsOfAnySizeAreDivided)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetResolution(10, 10);
  plane->Update();
  for (int exponent = -900; exponent <= 900; exponent += 300)
  {
    SCOPED_TRACE(exponent);
    vtkNew<vtkPolyData> scaled;
    scaled->DeepCopy(plane->GetOutput());
    for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i)
    {
      const double* x = scaled->GetPoint(i);
      scaled->GetPoints()->SetPoint(i, std::ldexp(x[0], exponent), std::ldexp(x[1], exponent), 0.0);
    }
    vtkNew<vtkSurfaceToDiskFilter> filter;
    filter->SetInputData(scaled);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 200);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 121);
  }
}

// The conformal map is as exact as the coordinates. The refinement of the areas is not unique: it ends
// when the areas are right, long before shapes have come to rest, and each of its hundred quasi-Newton
// steps makes differences grow. Those of 1e-13 at the start move vertices of this map, of radius 1, by
// 0.011 in the mean. Areas and angles are as good.
TEST(SizeAndPlace, TheMapIsTheSameFarFromTheOrigin)
{
  const TriangleMesh mesh = closedSurface();
  Chain chain(mesh);
  const Points3 flat = chain.flat();
  const Points3 conformal = chain.conformal();
  for (const double offset : { 1e3, 1e6 })
  {
    SCOPED_TRACE(offset);
    TriangleMesh moved = mesh;
    moved.Vertices.rowwise() += Eigen::RowVector3d(offset, -2.0 * offset, 0.5 * offset);
    Chain other(moved);
    const Points3 there = other.flat();
    ASSERT_EQ(there.rows(), flat.rows());
    EXPECT_LE((other.conformal() - conformal).cwiseAbs().maxCoeff(), 1e-13 * offset);
    EXPECT_LE((there - flat).cwiseAbs().maxCoeff(), 0.1);
    EXPECT_LE((there - flat).rowwise().norm().mean(), 0.02);
    EXPECT_EQ(other.figure("Bijective"), 1.0);
    EXPECT_NEAR(other.figure("FacesWithin2Percent"), chain.figure("FacesWithin2Percent"), 0.2);
    EXPECT_NEAR(other.figure("MeanAngleError"), chain.figure("MeanAngleError"), 0.3);
    EXPECT_NEAR(other.figure("SurfaceArea"), chain.figure("SurfaceArea"), 1e-9);
  }
}

TEST(SizeAndPlace, WhatDoublePrecisionDoesNotHoldIsAnError)
{
  const TriangleMesh mesh = closedSurface();
  vtkNew<vtkPolyData> empty;
  for (const auto& [scale, offset, words] : { std::tuple(1e-300, 0.0, "too few for double precision"),
         std::tuple(1.5e308, 0.0, "too many for double precision"),
         std::tuple(1.0, 1e13, "away from the origin") })
  {
    TriangleMesh other = mesh;
    other.Vertices = scale * mesh.Vertices.array() + offset;
    vtkNew<vtkSurfaceToDiskFilter> filter;
    ErrorLog errors(filter);
    filter->SetInputData(polyDataOf(other));
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages()[0].find(words), std::string::npos) << errors.messages()[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

// With 24 binary digits, coordinates around 1e5 have steps of 0.008, a tenth of the edges of this ball.
TEST(SizeAndPlace, CoarseCoordinatesAreAWarning)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(30);
  source->SetPhiResolution(30);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetCutModeToSeam();
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  for (const auto& [precision, x, isCoarse] : { std::tuple(vtkAlgorithm::SINGLE_PRECISION, 0.0, false),
         std::tuple(vtkAlgorithm::SINGLE_PRECISION, 100.0, false),
         std::tuple(vtkAlgorithm::SINGLE_PRECISION, 1e5, true),
         std::tuple(vtkAlgorithm::DOUBLE_PRECISION, 1e5, false) })
  {
    SCOPED_TRACE(x);
    observer->Clear();
    source->SetOutputPointsPrecision(precision);
    source->SetCenter(x, 0.0, 0.0);
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 1000);
    EXPECT_EQ(observer->GetWarning(), isCoarse);
    EXPECT_EQ(
      observer->GetWarningMessage().find("in steps of 0.0078125,") != std::string::npos, isCoarse)
      << observer->GetWarningMessage();
  }
}

// A rectangle in which a triangle has no area: a point lies on the middle of the opposite side.
TriangleMesh rectangleWithANeedle()
{
  TriangleMesh mesh = samples::rectangleGrid(11, 11, 2.0);
  const auto needle = mesh.Faces.row(110);
  mesh.Vertices.row(needle[0]) = 0.5 * (mesh.Vertices.row(needle[1]) + mesh.Vertices.row(needle[2]));
  return mesh;
}

// At the scale s of the surface, the factors stay as they are for a map with the area of the surface,
// and have the summand -log s for a map to the unit disk. Powers of two make the maps equal bit for bit.
TEST(SizeAndPlace, ConformalFactorAndAddedLengthHaveTheUnitsOfTheInput)
{
  const TriangleMesh mesh = rectangleWithANeedle();
  for (int method = 0; method < 3; ++method)
  {
    for (const int normalization :
      { vtkConformalDiskFilter::SURFACE_AREA, vtkConformalDiskFilter::UNIT_DOMAIN })
    {
      vtkNew<vtkConformalDiskFilter> filter;
      filter->SetMethod(method);
      filter->SetNormalizeTo(normalization);
      filter->SetInputData(polyDataOf(mesh));
      filter->Update();
      vtkNew<vtkDoubleArray> expected;
      expected->DeepCopy(filter->GetOutput()->GetPointData()->GetArray("ConformalFactor"));
      const double added = figure(filter->GetOutput(), "AddedLength");
      EXPECT_GT(added, 0.0);
      for (const int exponent : { -40, -33, -31, 31, 33, 40 })
      {
        SCOPED_TRACE(exponent);
        const double scale = std::ldexp(1.0, exponent);
        const double summand =
          normalization == vtkConformalDiskFilter::UNIT_DOMAIN ? -std::log(scale) : 0.0;
        TriangleMesh other = mesh;
        other.Vertices *= scale;
        filter->SetInputData(polyDataOf(other));
        filter->Update();
        vtkDataArray* found = filter->GetOutput()->GetPointData()->GetArray("ConformalFactor");
        for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
        {
          ASSERT_NEAR(found->GetTuple1(i), expected->GetTuple1(i) + summand, 1e-9);
        }
        EXPECT_NEAR(figure(filter->GetOutput(), "AddedLength") / scale, added, 1e-9 * added);
      }
    }
  }
}

// The warning about coarse steps of the coordinates looks at the points of the disk alone: a vertex that
// the filter drops may lie anywhere.
TEST(SizeAndPlace, CoordinatesOfDroppedCellsAreNoWarning)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(30);
  source->SetPhiResolution(30);
  source->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  source->Update();
  vtkPolyData* ball = source->GetOutput();
  const vtkIdType far = ball->GetPoints()->InsertNextPoint(3e6, 0.0, 0.0);
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell(1, &far);
  vtkNew<vtkPolyData> input;
  input->SetPoints(ball->GetPoints());
  input->SetPolys(ball->GetPolys());
  input->SetVerts(vertex);
  vtkNew<vtkSurfaceToDiskFilter> filter;
  filter->SetInputData(input);
  filter->SetCutModeToSeam();
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 1000);
  EXPECT_EQ(figure(filter->GetOutput(), "DroppedCells"), 1);
  EXPECT_FALSE(observer->GetWarning()) << observer->GetWarningMessage();
}

} // namespace
