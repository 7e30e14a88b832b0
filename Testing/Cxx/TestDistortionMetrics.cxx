// SPDX-License-Identifier: GPL-3.0-or-later
#include "MemoryLimit.h"

#include <vtkDistortionMetrics.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

// A flat rectangle [0,2] x [0,1] of 2 n^2 triangles. The surface is the same rectangle, upright in
// space, but its half x < 1 is stretched by 3 along x.
vtkSmartPointer<vtkPolyData> flattenedRectangle(int n)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0, 0, 0);
  plane->SetPoint1(2, 0, 0);
  plane->SetPoint2(0, 1, 0);
  plane->SetResolution(n, n);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> flattened = triangles->GetOutput();

  vtkNew<vtkDoubleArray> surface;
  surface->SetName("SurfacePoints");
  surface->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < flattened->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flattened->GetPoint(i, x);
    surface->InsertNextTuple3(x[0] < 1 ? 3 * x[0] : x[0] + 2, 5, x[1]);
  }
  flattened->GetPointData()->AddArray(surface);
  return flattened;
}

// 1 for the cells in the stretched half, 4 for the others.
void addCellLabels(vtkPolyData* flattened, const char* name)
{
  vtkNew<vtkIntArray> labels;
  labels->SetName(name);
  for (vtkIdType c = 0; c < flattened->GetNumberOfCells(); ++c)
  {
    double bounds[6];
    flattened->GetCellBounds(c, bounds);
    labels->InsertNextValue(bounds[1] <= 1 + 1e-12 ? 1 : 4);
  }
  flattened->GetCellData()->AddArray(labels);
}

double figure(vtkPolyData* output, const char* name)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1)
  {
    ADD_FAILURE() << "no one-tuple field array " << name;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return array->GetTuple1(0);
}

double entry(vtkTable* table, int row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

// Runs the filter, expects one error with these words and empty outputs; then expects it to work again.
void expectError(vtkDistortionMetrics* metrics, vtkPolyData* input, const char* words)
{
  vtkNew<vtkTest::ErrorObserver> filterErrors;
  vtkNew<vtkTest::ErrorObserver> executiveErrors;
  const unsigned long filterTag = metrics->AddObserver(vtkCommand::ErrorEvent, filterErrors);
  const unsigned long executiveTag =
    metrics->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveErrors);
  metrics->SetInputData(input);
  metrics->Update();
  EXPECT_TRUE(filterErrors->GetError()) << words;
  EXPECT_NE(filterErrors->GetErrorMessage().find(words), std::string::npos)
    << filterErrors->GetErrorMessage() << "lacks: " << words;
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(metrics->GetSummary()->GetNumberOfRows(), 0);
  metrics->RemoveObserver(filterTag);
  metrics->GetExecutive()->RemoveObserver(executiveTag);

  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "");
  metrics->SetInputData(flattenedRectangle(2));
  metrics->Update();
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfCells(), 8);
}

TEST(DistortionMetrics, CellArraysOfAKnownStretch)
{
  const auto flattened = flattenedRectangle(4);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattened);
  metrics->Update();
  vtkPolyData* output = metrics->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), 32);
  ASSERT_EQ(output->GetNumberOfPoints(), 25);
  vtkCellData* cells = output->GetCellData();
  // The surface has area 4, the flat rectangle 2; each half of the latter has area 1.
  for (vtkIdType c = 0; c < 32; ++c)
  {
    double bounds[6];
    output->GetCellBounds(c, bounds);
    const bool stretched = bounds[1] <= 1 + 1e-12;
    const double larger = std::sqrt(0.5) * (stretched ? 3 : 1);
    const double smaller = std::sqrt(0.5);
    const double squares = larger * larger + smaller * smaller;
    EXPECT_NEAR(cells->GetArray("AreaDistortion")->GetTuple1(c), std::log(larger * smaller), 1e-14);
    EXPECT_NEAR(cells->GetArray("AngleDistortion")->GetTuple1(c), std::log(larger / smaller), 1e-14);
    EXPECT_NEAR(cells->GetArray("AreaRatio")->GetTuple1(c), 1 / (larger * smaller), 1e-14);
    EXPECT_NEAR(cells->GetArray("BeltramiMagnitude")->GetTuple1(c), stretched ? 0.5 : 0, 1e-14);
    EXPECT_NEAR(cells->GetArray("StretchL2")->GetTuple1(c), std::sqrt(squares / 2), 1e-14);
    EXPECT_NEAR(cells->GetArray("SymmetricDirichlet")->GetTuple1(c),
      squares + 1 / (larger * larger) + 1 / (smaller * smaller),
      1e-13);
    // Legs 1/2 and 1/4 become 3/2 and 1/4; the right angle stays.
    const double angle =
      stretched ? 2.0 / 3.0 * (std::atan(0.5) - std::atan(0.5 / 3)) * 180 / std::acos(-1.0) : 0;
    EXPECT_NEAR(cells->GetArray("AngleError")->GetTuple1(c), angle, 1e-11);
    EXPECT_EQ(cells->GetArray("Flipped")->GetTuple1(c), 0);
    EXPECT_EQ(cells->GetArray("Degenerate")->GetTuple1(c), 0);
  }
  EXPECT_NEAR(figure(output, "SurfaceArea"), 4, 1e-13);
  EXPECT_NEAR(figure(output, "FlatArea"), 2, 1e-14);
  EXPECT_EQ(figure(output, "FlippedFaces"), 0);
  EXPECT_EQ(figure(output, "DegenerateFaces"), 0);
  EXPECT_EQ(figure(output, "FacesWithin2Percent"), 0);
  EXPECT_NEAR(figure(output, "MeanAreaError"), 0.5 * (100.0 / 3 + 100), 1e-11);
  EXPECT_NEAR(figure(output, "MaxAreaError"), 100, 1e-11);
  EXPECT_NEAR(figure(output, "AreaWeightedMeanBeltramiMagnitude"), 0.75 * 0.5, 1e-14);
}

TEST(DistortionMetrics, DeviationsOfTheAreaRatio)
{
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattenedRectangle(4));
  metrics->Update();
  // Half of the faces have the ratio 2/3, the other half 2.
  EXPECT_NEAR(figure(metrics->GetOutput(), "SDAreaRatio"), 2.0 / 3.0, 1e-13);
  EXPECT_NEAR(figure(metrics->GetOutput(), "SDLogAreaRatio"), 0.5 * std::log(3.0), 1e-13);
  EXPECT_NEAR(entry(metrics->GetSummary(), 0, "SDAreaRatio"), 2.0 / 3.0, 1e-13);
}

const char* const LengthFigures[] = { "MeanLocalLengthError",
  "StandardErrorLocalLengthError",
  "P95LocalLengthError",
  "MeanWithinMapLengthError",
  "StandardErrorWithinMapLengthError",
  "P95WithinMapLengthError",
  "MeanGlobalLengthError",
  "StandardErrorGlobalLengthError",
  "P95GlobalLengthError",
  "RingDistanceError",
  "LengthScale" };

TEST(DistortionMetrics, LengthsAreMeasuredOnRequestOnly)
{
  vtkNew<vtkDistortionMetrics> metrics;
  EXPECT_FALSE(metrics->GetMeasureLengths());
  EXPECT_EQ(metrics->GetLengthRadius(), 30.0);
  EXPECT_EQ(metrics->GetLengthSamples(), 300);
  metrics->SetInputData(flattenedRectangle(10));
  metrics->Update();
  EXPECT_FALSE(metrics->GetOutput()->GetPointData()->HasArray("LengthError"));
  for (const char* name : LengthFigures)
  {
    EXPECT_FALSE(metrics->GetOutput()->GetFieldData()->HasArray(name)) << name;
  }

  metrics->MeasureLengthsOn();
  metrics->Update();
  for (const char* name : LengthFigures)
  {
    EXPECT_GT(figure(metrics->GetOutput(), name), 0.0) << name;
  }
  vtkDataArray* errors = metrics->GetOutput()->GetPointData()->GetArray("LengthError");
  ASSERT_NE(errors, nullptr);
  EXPECT_EQ(errors->GetNumberOfTuples(), 121);
  EXPECT_GT(errors->GetRange()[0], 0.0);
  // With a radius beyond the surface's size all lengths are local.
  EXPECT_NEAR(figure(metrics->GetOutput(), "MeanLocalLengthError"),
    figure(metrics->GetOutput(), "MeanGlobalLengthError"),
    5.0 * figure(metrics->GetOutput(), "StandardErrorGlobalLengthError"));
  EXPECT_EQ(metrics->GetSummary()->GetColumnByName("MeanLocalLengthError"), nullptr);
}

#ifdef FLATTENING_CAN_LIMIT_MEMORY
// The lengths between 10,201 points and those within 6 percent of the surface around them, on the map and
// within it, take more than 600 MB.
TEST(DistortionMetrics, LengthsThatDoNotFitInMemoryAreAnError)
{
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattenedRectangle(100));
  metrics->MeasureLengthsOn();
  metrics->SetLengthRadius(0.27);
  metrics->SetLengthSamples(VTK_INT_MAX);
  vtkNew<vtkTest::ErrorObserver> errors;
  metrics->AddObserver(vtkCommand::ErrorEvent, errors);
  {
    const flattening::testing::MemoryLimit limit(400000000);
    metrics->Update();
  }
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_NE(
    errors->GetErrorMessage().find("measuring lengths from 10201 points takes "), std::string::npos)
    << errors->GetErrorMessage();
  EXPECT_NE(errors->GetErrorMessage().find("lower LengthSamples or LengthRadius"), std::string::npos);
  metrics->SetLengthSamples(20);
  metrics->Update();
  EXPECT_GT(figure(metrics->GetOutput(), "MeanLocalLengthError"), 0.0);
}
#endif

// Near the stretched end all lengths along x are three times too short, on the other end all are right.
TEST(DistortionMetrics, LengthErrorsLieWhereTheMapIsStretched)
{
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattenedRectangle(20));
  metrics->MeasureLengthsOn();
  metrics->SetLengthRadius(0.3);
  metrics->Update();
  vtkPolyData* output = metrics->GetOutput();
  vtkDataArray* errors = output->GetPointData()->GetArray("LengthError");
  const double scale = figure(output, "LengthScale");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (output->GetPoint(i)[0] > 1.31)
    {
      EXPECT_NEAR(errors->GetTuple1(i), 100 * std::abs(scale - 1), 1e-9);
    }
  }
}

TEST(DistortionMetrics, PassesEverythingThrough)
{
  const auto flattened = flattenedRectangle(3);
  addCellLabels(flattened, "Labels");
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("Thickness");
  for (vtkIdType i = 0; i < flattened->GetNumberOfPoints(); ++i)
  {
    thickness->InsertNextValue(0.5f * i);
  }
  flattened->GetPointData()->SetScalars(thickness);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattened);
  metrics->Update();
  vtkPolyData* output = metrics->GetOutput();
  EXPECT_EQ(output->GetPoints(), flattened->GetPoints());
  EXPECT_EQ(output->GetPointData()->GetScalars(), thickness.Get());
  EXPECT_TRUE(output->GetCellData()->HasArray("Labels"));
  EXPECT_TRUE(output->GetPointData()->HasArray("SurfacePoints"));
  EXPECT_FALSE(flattened->GetCellData()->HasArray("AreaRatio")) << "the input was changed";
  EXPECT_FALSE(flattened->GetFieldData()->HasArray("FlatArea")) << "the input was changed";
}

TEST(DistortionMetrics, TextureCoordinatesKeepTheAspect)
{
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattenedRectangle(2));
  metrics->Update();
  vtkDataArray* coordinates = metrics->GetOutput()->GetPointData()->GetTCoords();
  ASSERT_NE(coordinates, nullptr);
  ASSERT_EQ(coordinates->GetNumberOfComponents(), 2);
  for (vtkIdType i = 0; i < metrics->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double x[3];
    metrics->GetOutput()->GetPoint(i, x);
    EXPECT_NEAR(coordinates->GetComponent(i, 0), x[0] / 2, 1e-7);
    EXPECT_NEAR(coordinates->GetComponent(i, 1), 0.25 + x[1] / 2, 1e-7);
  }
}

TEST(DistortionMetrics, OneRowPerRegionAndATotal)
{
  const auto flattened = flattenedRectangle(4);
  addCellLabels(flattened, "Labels");
  vtkNew<vtkStringArray> names;
  names->SetName("RegionNames");
  names->InsertNextValue("background");
  names->InsertNextValue("stretched half");
  flattened->GetFieldData()->AddArray(names);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattened);
  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Labels");
  metrics->Update();
  vtkTable* table = metrics->GetSummary();
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  EXPECT_EQ(table->GetValueByName(0, "Region").ToString(), "stretched half");
  EXPECT_EQ(table->GetValueByName(1, "Region").ToString(), "4") << "has no name";
  EXPECT_EQ(table->GetValueByName(2, "Region").ToString(), "Total");
  const double ids[] = { 1, 4, -1 };
  const double faces[] = { 16, 16, 32 };
  const double surfaceAreas[] = { 3, 1, 4 };
  const double flatAreas[] = { 1, 1, 2 };
  const double errors[] = { -100.0 / 3, 100, 0 };
  for (int row = 0; row < 3; ++row)
  {
    EXPECT_EQ(entry(table, row, "RegionId"), ids[row]);
    EXPECT_EQ(entry(table, row, "Faces"), faces[row]);
    EXPECT_NEAR(entry(table, row, "SurfaceArea"), surfaceAreas[row], 1e-13);
    EXPECT_NEAR(entry(table, row, "FlatArea"), flatAreas[row], 1e-13);
    EXPECT_NEAR(entry(table, row, "AreaErrorPercent"), errors[row], 1e-11);
    EXPECT_EQ(entry(table, row, "FlippedFaces"), 0);
  }
  EXPECT_NEAR(entry(table, 0, "MeanAreaError"), 100.0 / 3, 1e-11);
  EXPECT_NEAR(entry(table, 1, "P99AngleError"), 0, 1e-11);
}

TEST(DistortionMetrics, PointLabelsGoToTheMajorityOfCorners)
{
  const auto flattened = flattenedRectangle(1); // two triangles, four points
  vtkNew<vtkFloatArray> labels;
  labels->SetName("PointLabels");
  for (const float label : { 7.f, 7.f, 7.f, 9.f })
  {
    labels->InsertNextValue(label);
  }
  flattened->GetPointData()->AddArray(labels);
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattened);
  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "PointLabels");
  metrics->Update();
  vtkTable* table = metrics->GetSummary();
  ASSERT_EQ(table->GetNumberOfRows(), 2) << "no face has two corners with label 9";
  EXPECT_EQ(entry(table, 0, "RegionId"), 7);
  EXPECT_EQ(entry(table, 0, "Faces"), 2);
}

// Two triangles that do not touch, of the same surface area, of the flat areas 1/2 and 3/2.
vtkSmartPointer<vtkPolyData> twoTriangles(double firstTarget, double secondTarget)
{
  auto flattened = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkDoubleArray> surface;
  surface->SetName("SurfacePoints");
  surface->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> targets;
  targets->SetName("TargetArea");
  for (int t = 0; t < 2; ++t)
  {
    const vtkIdType ids[] = { 3 * t, 3 * t + 1, 3 * t + 2 };
    triangles->InsertNextCell(3, ids);
    const double size = t == 0 ? 1.0 : 3.0;
    for (int k = 0; k < 3; ++k)
    {
      points->InsertNextPoint(5 * t + (k == 1), k == 2 ? size : 0, 0);
      surface->InsertNextTuple3(0, 5 * t + 2 * (k == 1), 2 * (k == 2));
      targets->InsertNextValue(t == 0 ? firstTarget : secondTarget);
    }
  }
  flattened->SetPoints(points);
  flattened->SetPolys(triangles);
  flattened->GetPointData()->AddArray(surface);
  flattened->GetPointData()->AddArray(targets);
  return flattened;
}

TEST(DistortionMetrics, TargetAreaIsWhatWasAskedFor)
{
  vtkNew<vtkDistortionMetrics> metrics;
  EXPECT_TRUE(metrics->GetUseTargetArea());
  metrics->SetInputData(twoTriangles(0.2, 0.6));
  metrics->Update();
  vtkDataArray* ratio = metrics->GetOutput()->GetCellData()->GetArray("AreaRatio");
  EXPECT_NEAR(ratio->GetTuple1(0), 1, 1e-15);
  EXPECT_NEAR(ratio->GetTuple1(1), 1, 1e-15);
  EXPECT_NEAR(figure(metrics->GetOutput(), "MaxAreaError"), 0, 1e-12);
  EXPECT_EQ(figure(metrics->GetOutput(), "FacesWithin2Percent"), 100);

  metrics->UseTargetAreaOff();
  metrics->Update();
  ratio = metrics->GetOutput()->GetCellData()->GetArray("AreaRatio");
  EXPECT_NEAR(ratio->GetTuple1(0), 0.5, 1e-15);
  EXPECT_NEAR(ratio->GetTuple1(1), 1.5, 1e-15);
}

TEST(DistortionMetrics, TargetAreaWithoutWeightsIsTheSurfaceArea)
{
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(twoTriangles(7, 7));
  metrics->Update();
  vtkDataArray* ratio = metrics->GetOutput()->GetCellData()->GetArray("AreaRatio");
  EXPECT_NEAR(ratio->GetTuple1(0), 0.5, 1e-15);
  EXPECT_NEAR(ratio->GetTuple1(1), 1.5, 1e-15);
}

TEST(DistortionMetrics, MirroredIsAllFlipped)
{
  const auto flattened = flattenedRectangle(3);
  for (vtkIdType i = 0; i < flattened->GetNumberOfPoints(); ++i)
  {
    double x[3];
    flattened->GetPoint(i, x);
    flattened->GetPoints()->SetPoint(i, -x[0], x[1], x[2]);
  }
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputData(flattened);
  metrics->Update();
  EXPECT_EQ(figure(metrics->GetOutput(), "FlippedFaces"), 18);
  EXPECT_EQ(metrics->GetOutput()->GetCellData()->GetArray("Flipped")->GetRange()[0], 1);
}

TEST(DistortionMetrics, EmptyInputGivesEmptyOutputSilently)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->AddObserver(vtkCommand::ErrorEvent, errors);
  metrics->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  vtkNew<vtkPolyData> empty;
  metrics->SetInputData(empty);
  metrics->Update();
  EXPECT_FALSE(errors->GetError());
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(metrics->GetSummary()->GetNumberOfRows(), 0);
}

TEST(DistortionMetrics, BadLengths)
{
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->MeasureLengthsOn();
  const auto expectLengthError = [&metrics](double radius, int samples, const char* words)
  {
    vtkNew<vtkTest::ErrorObserver> errors;
    const unsigned long tag = metrics->AddObserver(vtkCommand::ErrorEvent, errors);
    metrics->SetInputData(flattenedRectangle(4));
    metrics->SetLengthRadius(radius);
    metrics->SetLengthSamples(samples);
    metrics->Update();
    EXPECT_NE(errors->GetErrorMessage().find(words), std::string::npos) << errors->GetErrorMessage();
    EXPECT_EQ(metrics->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(metrics->GetSummary()->GetNumberOfRows(), 0);
    metrics->RemoveObserver(tag);
  };
  expectLengthError(0, 300, "the LengthRadius is 0: set it to a positive length");
  expectLengthError(std::nan(""), 300, "the LengthRadius is nan");
  expectLengthError(-3, 300, "the LengthRadius is -3");
  expectLengthError(1e-5, 300, "as near to each other as the LengthRadius of 1e-05");
  expectLengthError(1, 0, "LengthSamples is 0");
  expectLengthError(1, -5, "LengthSamples is -5");

  metrics->SetLengthSamples(2);
  metrics->Update();
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfPoints(), 25);
  metrics->SetInputData(twoTriangles(1, 1));
  metrics->SetLengthRadius(1e9);
  metrics->Update();
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfPoints(), 6) << "two parts that no path joins";
}

TEST(DistortionMetrics, BadInput)
{
  vtkNew<vtkDistortionMetrics> metrics;

  auto data = flattenedRectangle(2);
  data->GetPointData()->RemoveArray("SurfacePoints");
  expectError(metrics, data, "run Conformal Disk first");

  data = flattenedRectangle(2);
  data->GetPointData()->GetArray("SurfacePoints")->SetComponent(3, 1, std::nan(""));
  expectError(metrics, data, "vertex 3 has a surface coordinate that is not finite");

  data = flattenedRectangle(2);
  data->GetPoints()->SetPoint(4, std::numeric_limits<double>::infinity(), 0, 0);
  expectError(metrics, data, "point 4 of the flat surface is not finite");

  data = flattenedRectangle(2);
  data->GetPoints()->SetPoint(4, 0.5, 0.5, 0.25);
  expectError(metrics, data, "not flat");

  data = flattenedRectangle(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoints()->SetPoint(i, i, 0, 0);
  }
  expectError(metrics, data, "the flat surface has zero area");

  data = flattenedRectangle(2);
  data->GetPointData()->GetArray("SurfacePoints")->Fill(1);
  expectError(metrics, data, "the surface has zero area");

  data = flattenedRectangle(2);
  data->SetPolys(vtkNew<vtkCellArray>());
  expectError(metrics, data, "no triangles");

  expectError(metrics, twoTriangles(1, -1), "point 3 has the TargetArea -1");

  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Missing");
  expectError(metrics, flattenedRectangle(2), "region array Missing");

  data = flattenedRectangle(2);
  vtkNew<vtkDoubleArray> labels;
  labels->SetName("Labels");
  labels->SetNumberOfTuples(8);
  labels->Fill(std::nan(""));
  data->GetCellData()->AddArray(labels);
  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Labels");
  expectError(metrics, data, "region array Labels has no number at cell 0");

  for (const double wrong : { 2.5, 1e300, std::numeric_limits<double>::infinity() })
  {
    data = flattenedRectangle(2);
    labels->Fill(-3);
    labels->SetValue(5, wrong);
    data->GetCellData()->AddArray(labels);
    metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Labels");
    expectError(metrics, data, " at cell 5, but labels are whole numbers");
  }
  data = flattenedRectangle(2);
  labels->SetNumberOfTuples(9);
  labels->Fill(0);
  labels->SetValue(4, 1e-9);
  data->GetPointData()->AddArray(labels);
  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Labels");
  expectError(metrics, data, "the region array Labels has the value 1e-09 at point 4");
}

} // namespace
