// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "FilterTest.h"
#include "MemoryLimit.h"
#include "PassedGrid.h"

#include <vtkConformalDiskFilter.h>
#include <vtkFlatMapImage.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <cmath>
#include <set>

namespace
{

using namespace flattening;
using namespace flattening::testing;

constexpr double Pi = 3.14159265358979323846;

// A hemisphere of radius 30, flattened, with a linear function of the map, labels on points and cells,
// and two arrays of one name.
vtkSmartPointer<vtkPolyData> flatHemisphere()
{
  vtkNew<vtkConformalDiskFilter> conformal;
  TriangleMesh mesh = analytic::sunflowerMesh(analytic::sphericalCap(0.5 * Pi), 2000).Mesh;
  mesh.Vertices *= 30.0;
  conformal->SetInputData(polyDataOf(mesh));
  vtkNew<vtkOMTAreaPreservingFilter> transported;
  transported->SetInputConnection(conformal->GetOutputPort());
  transported->Update();
  auto map = vtkSmartPointer<vtkPolyData>::New();
  map->ShallowCopy(transported->GetOutput());
  vtkNew<vtkDoubleArray> linear;
  linear->SetName("Linear");
  vtkNew<vtkIntArray> side;
  side->SetName("Side");
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    double x[3];
    map->GetPoint(i, x);
    linear->InsertNextValue(3.0 * x[0] - 2.0 * x[1] + 7.0);
    side->InsertNextValue(x[0] < 0.0 ? 10 : 20);
  }
  map->GetPointData()->AddArray(linear);
  map->GetPointData()->AddArray(side);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  vtkNew<vtkIntArray> cellSide;
  cellSide->SetName("Side");
  for (int c = 0; c < map->GetNumberOfCells(); ++c)
  {
    number->InsertNextValue(5 * c);
    cellSide->InsertNextValue(c % 2);
  }
  map->GetCellData()->AddArray(number);
  map->GetCellData()->AddArray(cellSide);
  return map;
}

class FlatMapImage : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { Map = flatHemisphere(); }
  static void TearDownTestSuite() { Map = nullptr; }

  static vtkSmartPointer<vtkPolyData> Map;
};

vtkSmartPointer<vtkPolyData> FlatMapImage::Map;

TEST_F(FlatMapImage, SamplesPointsAndCellsUnderTheCentreOfEachPixel)
{
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(Map);
  filter->SetSize(200);
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  vtkPointData* pixels = image->GetPointData();
  ASSERT_EQ(image->GetNumberOfPoints(), 40000);
  const double radius = 30.0 * std::sqrt(2.0);
  EXPECT_NEAR(image->GetSpacing()[0], 2.0 * radius / 200.0, 0.01);
  EXPECT_DOUBLE_EQ(figure(image, "PixelLength"), image->GetSpacing()[0]);

  vtkDataArray* surface = pixels->GetArray("SurfacePoints");
  vtkDataArray* cells = pixels->GetArray("CellId");
  int inside = 0;
  std::set<double> labels;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const bool inMap = pixels->GetArray("InMap")->GetTuple1(i) == 1;
    inside += inMap;
    // The map's boundary is a polygon in the circle: within 0.1 of it both answers are right.
    const double distance = std::hypot(x[0], x[1]);
    ASSERT_TRUE(std::abs(distance - radius) < 0.1 || inMap == (distance < radius)) << distance;
    EXPECT_EQ(cells->GetTuple1(i) >= 0.0, inMap);
    if (inMap)
    {
      ASSERT_NEAR(pixels->GetArray("Linear")->GetTuple1(i), 3.0 * x[0] - 2.0 * x[1] + 7.0, 1e-10);
      ASSERT_EQ(pixels->GetArray("Number")->GetTuple1(i), 5.0 * cells->GetTuple1(i));
      ASSERT_EQ(pixels->GetArray("SideCell")->GetTuple1(i), std::fmod(cells->GetTuple1(i), 2.0));
      labels.insert(pixels->GetArray("Side")->GetTuple1(i));
      // The point of the hemisphere at this distance from the centre, by area.
      const double height = 30.0 * (1.0 - std::pow(distance / radius, 2));
      ASSERT_NEAR(surface->GetComponent(i, 2), height, 0.5);
    }
  }
  EXPECT_EQ(inside, figure(image, "PixelsInMap"));
  EXPECT_NEAR(inside * std::pow(image->GetSpacing()[0], 2), Pi * radius * radius, 0.002 * Pi * 1800.0);
  EXPECT_EQ(labels, (std::set<double>{ 10.0, 20.0 })) << "labels were averaged";
}

TEST_F(FlatMapImage, APixelIsWhereTextureCoordinatesLookForIt)
{
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(Map);
  filter->SetSize(100);
  filter->Update();
  vtkDataArray* coordinates = filter->GetOutput()->GetPointData()->GetArray("TCoords");
  for (const int column : { 20, 50, 81 })
  {
    const vtkIdType id = 33 * 100 + column;
    ASSERT_EQ(filter->GetOutput()->GetPointData()->GetArray("InMap")->GetTuple1(id), 1);
    EXPECT_NEAR(coordinates->GetComponent(id, 0), (column + 0.5) / 100.0, 1e-7);
    EXPECT_NEAR(coordinates->GetComponent(id, 1), 33.5 / 100.0, 1e-7);
  }
}

TEST_F(FlatMapImage, BeyondTheMapOnlyTheMarginHasValues)
{
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(Map);
  filter->SetSize(100);
  for (const int margin : { 0, 3 })
  {
    filter->SetMargin(margin);
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    vtkPointData* pixels = image->GetPointData();
    const double radius = 30.0 * std::sqrt(2.0);
    int filled = 0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double x[3];
      image->GetPoint(i, x);
      const double beyond = (std::hypot(x[0], x[1]) - radius) / image->GetSpacing()[0];
      const bool isNumber = !std::isnan(pixels->GetArray("Linear")->GetTuple1(i));
      if (pixels->GetArray("InMap")->GetTuple1(i) == 0)
      {
        EXPECT_EQ(pixels->GetArray("CellId")->GetTuple1(i), -1);
        EXPECT_TRUE(std::abs(beyond - margin) < 0.1 || isNumber == (beyond < margin)) << beyond;
        EXPECT_EQ(pixels->GetArray("Side")->GetTuple1(i) != 0.0, isNumber);
        EXPECT_EQ(std::isnan(pixels->GetArray("SurfacePoints")->GetComponent(i, 1)), !isNumber);
        filled += isNumber;
      }
    }
    // A ring as wide as the margin, but for the four parts of it beyond the image.
    const double outer = 50.0 + margin;
    const double cut =
      outer * outer * std::acos(50.0 / outer) - 50.0 * std::sqrt(outer * outer - 2500.0);
    EXPECT_NEAR(filled, Pi * (outer * outer - 2500.0) - 4.0 * cut, 40.0);
  }
}

TEST_F(FlatMapImage, ImageFiltersSeeThePixels)
{
  vtkNew<vtkPolyData> map;
  map->ShallowCopy(Map);
  map->GetPointData()->SetActiveScalars("Linear");
  for (const double length : { 0.0, 0.7 })
  {
    vtkNew<vtkFlatMapImage> filter;
    filter->SetInputData(map);
    filter->SetSize(100);
    filter->SetPixelLength(length);
    expectGridPassedOn(filter->GetOutputPort(), "InMap");
  }
}

TEST_F(FlatMapImage, ImageFiltersSeeTheValues)
{
  vtkNew<vtkFloatArray> single;
  single->DeepCopy(Map->GetPointData()->GetArray("Linear"));
  single->SetName("Single");
  vtkNew<vtkPolyData> map;
  map->ShallowCopy(Map);
  map->GetPointData()->AddArray(single);
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(map);
  filter->SetSize(50);
  for (const char* scalars : { "Linear", "Single", "Side", "SurfacePoints" })
  {
    SCOPED_TRACE(scalars);
    map->GetPointData()->SetActiveScalars(scalars);
    map->Modified();
    expectScalarsPassedOn(filter->GetOutputPort());
  }
}

// A cell array of the name of a point array has the name with "Cell" as often as it takes.
TEST_F(FlatMapImage, NoArrayReplacesAnother)
{
  vtkNew<vtkPolyData> map;
  map->ShallowCopy(Map);
  vtkNew<vtkIntArray> taken;
  taken->SetName("SideCell");
  taken->SetNumberOfTuples(map->GetNumberOfPoints());
  taken->Fill(7);
  map->GetPointData()->AddArray(taken);
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(map);
  filter->SetSize(50);
  filter->Update();
  vtkPointData* pixels = filter->GetOutput()->GetPointData();
  ASSERT_TRUE(pixels->HasArray("SideCellCell"));
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    if (pixels->GetArray("InMap")->GetTuple1(i) == 1)
    {
      ASSERT_EQ(pixels->GetArray("SideCell")->GetTuple1(i), 7.0);
      ASSERT_EQ(pixels->GetArray("SideCellCell")->GetTuple1(i),
        std::fmod(pixels->GetArray("CellId")->GetTuple1(i), 2.0));
    }
  }
}

TEST_F(FlatMapImage, PixelsOfAGivenLength)
{
  vtkNew<vtkTransform> twice;
  twice->Scale(2.0, 2.0, 1.0);
  vtkNew<vtkTransformPolyDataFilter> larger;
  larger->SetTransform(twice);
  larger->SetInputData(Map);
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputConnection(larger->GetOutputPort());
  filter->SetPixelLength(1.0);
  filter->Update();
  const int before = filter->GetOutput()->GetDimensions()[0];
  EXPECT_EQ(before, static_cast<int>(std::ceil(120.0 * std::sqrt(2.0))));
  EXPECT_LE(figure(filter->GetOutput(), "PixelLength"), 1.0);
  EXPECT_GT(figure(filter->GetOutput(), "PixelLength"), 1.0 - 1.0 / before);

  twice->Scale(0.5, 0.5, 1.0); // the map changes: what is downstream must know the extent at once
  filter->UpdateInformation();
  int extent[6];
  filter->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  EXPECT_EQ(extent[1] + 1, static_cast<int>(std::ceil(60.0 * std::sqrt(2.0))));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetDimensions()[0], extent[1] + 1);
}

// Each of several blocks of different sizes has its own image.
TEST_F(FlatMapImage, EveryBlockHasItsImage)
{
  vtkNew<vtkTransform> twice;
  twice->Scale(2.0, 2.0, 1.0);
  vtkNew<vtkTransformPolyDataFilter> larger;
  larger->SetTransform(twice);
  larger->SetInputData(Map);
  larger->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Map);
  blocks->SetBlock(1, larger->GetOutput());
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputDataObject(blocks);
  filter->SetPixelLength(1.0);
  filter->Update();
  auto* images = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(images, nullptr);
  ASSERT_EQ(images->GetNumberOfBlocks(), 2u);
  for (const unsigned int block : { 0u, 1u })
  {
    auto* image = vtkImageData::SafeDownCast(images->GetBlock(block));
    ASSERT_NE(image, nullptr);
    EXPECT_EQ(
      image->GetDimensions()[0], static_cast<int>(std::ceil((1 + block) * 60.0 * std::sqrt(2.0))));
    EXPECT_GT(figure(image, "PixelsInMap"), 0.7 * image->GetNumberOfPoints());
  }
}

TEST_F(FlatMapImage, EmptyInputGivesAnEmptyImage)
{
  vtkNew<vtkFlatMapImage> filter;
  ErrorLog errors(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(Map);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(vtkNew<vtkPolyData>()); // the extent of the map before is no longer announced
  filter->UpdateInformation();
  int extent[6];
  filter->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  EXPECT_LT(extent[1], extent[0]);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

TEST_F(FlatMapImage, ReportsWhatIsWrong)
{
  vtkNew<vtkFlatMapImage> filter;
  const auto expectMessage = [&filter](const std::string& words)
  {
    ErrorLog errors(filter);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  filter->SetInputData(polyDataOf(analytic::ringMesh(analytic::flatDisk(), 100).Mesh));
  expectMessage("no point array SurfacePoints");
  filter->SetInputData(Map);
  filter->SetPixelLength(1e-3);
  expectMessage("raise PixelLength");
  ErrorLog errors(filter);
  filter->Update(); // as the views of ParaView do
  filter->Update();
  EXPECT_TRUE(errors.messages().empty()) << "reported once";
  filter->SetPixelLength(0.0);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 512 * 512);
}

#ifdef FLATTENING_CAN_LIMIT_MEMORY
// 16384 x 16384 pixels take tens of gigabytes; VTK would end the program.
TEST_F(FlatMapImage, AnImageThatDoesNotFitInMemoryIsAnError)
{
  vtkNew<vtkFlatMapImage> filter;
  filter->SetInputData(Map);
  filter->SetSize(VTK_INT_MAX);
  ASSERT_EQ(filter->GetSize(), 16384);
  {
    const MemoryLimit limit(500000000);
    ErrorLog errors(filter);
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(
      errors.messages().front().find("an image of 16384 x 16384 pixels takes "), std::string::npos);
    EXPECT_NE(errors.messages().front().find("set a smaller Size"), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  filter->SetSize(64);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 64 * 64);
}
#endif

} // namespace
