// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Core/Support/SampleSurfaces.h"
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkFlattenRegion.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTriangle.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::testing;
using samples::Pi;

constexpr double Radius = 10.0;
constexpr double CapAngle = 0.9; // of the labelled cap

// A hemisphere of radius 10 with the label 4 around its pole on points and, with 14, on cells.
vtkSmartPointer<vtkPolyData> hemisphere(int n = 8000)
{
  TriangleMesh mesh = sunflowerMesh(sphericalCap(0.5 * Pi), n).Mesh;
  mesh.Vertices *= Radius;
  const auto data = polyDataOf(mesh);
  const auto inCap = [](double z) { return z > Radius * std::cos(CapAngle); };
  vtkNew<vtkIntArray> ofPoints;
  ofPoints->SetName("Label");
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    ofPoints->InsertNextValue(inCap(mesh.Vertices(v, 2)) ? 4 : 1);
  }
  data->GetPointData()->AddArray(ofPoints);
  vtkNew<vtkIntArray> ofCells;
  ofCells->SetName("CellLabel");
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const double z = (mesh.Vertices(mesh.Faces(f, 0), 2) + mesh.Vertices(mesh.Faces(f, 1), 2) +
                       mesh.Vertices(mesh.Faces(f, 2), 2)) /
                     3.0;
    ofCells->InsertNextValue(inCap(z) ? 14 : 11);
  }
  data->GetCellData()->AddArray(ofCells);
  return data;
}

void useLabels(vtkFlattenRegion* filter)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Label");
  filter->SetLabel(4);
}

double entry(vtkTable* table, const char* measure, const char* column)
{
  auto* names = vtkStringArray::SafeDownCast(table->GetColumnByName("Measure"));
  const vtkIdType row = names ? names->LookupValue(measure) : -1;
  if (row < 0)
  {
    ADD_FAILURE() << measure;
    return 0.0;
  }
  return table->GetValueByName(row, column).ToDouble();
}

TEST(FlattenRegion, MeasuresACapInSpaceAndOnTheMap)
{
  const auto input = hemisphere();
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(0, input);
  for (const bool cells : { false, true })
  {
    SCOPED_TRACE(cells);
    useLabels(filter);
    if (cells)
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "CellLabel");
      filter->SetLabel(14);
    }
    filter->AutomaticMarginOff();
    filter->SetMargin(1.0);
    filter->Update();
    vtkTable* table = filter->GetMeasures();
    ASSERT_EQ(table->GetNumberOfRows(), 4);
    const double area = 2.0 * Pi * Radius * Radius * (1.0 - std::cos(CapAngle));
    const double perimeter = 2.0 * Pi * Radius * std::sin(CapAngle);
    EXPECT_NEAR(entry(table, "Area", "OnSurface") / area, 1.0, 0.01);
    EXPECT_NEAR(entry(table, "Area", "OnMap") / entry(table, "Area", "OnSurface"), 1.0, 0.005);
    EXPECT_NEAR(entry(table, "GreatestDiameter", "OnSurface") / (2 * Radius * CapAngle), 1.0, 0.02);
    EXPECT_NEAR(entry(table, "ExtentAcross", "OnSurface") / (2 * Radius * CapAngle), 1.0, 0.02);
    EXPECT_NEAR(entry(table, "Perimeter", "OnSurface") / perimeter, 1.0, 0.02);
    // A cap goes to a disk of its area, and its meridians to nearly straight lines: the boundary has
    // teeth on the surface and is a circle on the map.
    const double flatRadius = std::sqrt(area / Pi);
    EXPECT_NEAR(entry(table, "GreatestDiameter", "OnMap") / (2 * flatRadius), 1.0, 0.05);
    EXPECT_NEAR(entry(table, "Perimeter", "OnMap") / (2 * Pi * flatRadius), 1.0, 0.03);
    for (const char* measure : { "Area", "GreatestDiameter", "ExtentAcross", "Perimeter" })
    {
      EXPECT_GT(entry(table, measure, "StandardDeviation"), 0.0);
      EXPECT_LT(entry(table, measure, "StandardDeviation"), 0.03 * entry(table, measure, "OnSurface"));
      EXPECT_EQ(figure(filter->GetOutput(), measure), entry(table, measure, "OnSurface"));
    }
    EXPECT_EQ(table->GetValueByName(0, "Unit").ToString(), "");
    EXPECT_EQ(table->GetValueByName(3, "Unit").ToString(), "");
    EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1);
    EXPECT_EQ(figure(filter->GetOutput(), "RegionPieces"), 1);
  }
}

TEST(FlattenRegion, TheMapAndItsCurvesKnowWhereTheyAreInSpace)
{
  const auto input = hemisphere();
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(0, input);
  useLabels(filter);
  filter->AutomaticMarginOff();
  filter->SetMargin(2.0);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* labels = output->GetPointData()->GetArray("Label");
  double lowest = Radius;
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    double x[3];
    input->GetPoint(static_cast<vtkIdType>(ids->GetTuple1(v)), x);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(surface->GetComponent(v, k), x[k]);
    }
    EXPECT_EQ(labels->GetTuple1(v), x[2] > Radius * std::cos(CapAngle) ? 4 : 1);
    lowest = std::min(lowest, x[2]);
  }
  // The margin is 2 wide along edges, that is 1.4 to 2 in space.
  EXPECT_LT(lowest, Radius * std::cos(CapAngle + 0.13));
  EXPECT_GT(lowest, Radius * std::cos(CapAngle + 0.21));

  double areas[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } }; // in the margin and region, flat and in space
  vtkDataArray* inRegion = output->GetCellData()->GetArray("InRegion");
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    output->GetCellPoints(c, corners);
    double p[3][3];
    double x[3][3];
    for (int k = 0; k < 3; ++k)
    {
      output->GetPoint(corners->GetId(k), p[k]);
      surface->GetTuple(corners->GetId(k), x[k]);
    }
    const int region = inRegion->GetTuple1(c) > 0.0;
    areas[region][0] += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    areas[region][1] += vtkTriangle::TriangleArea(x[0], x[1], x[2]);
  }
  EXPECT_NEAR(areas[1][1], entry(filter->GetMeasures(), "Area", "OnSurface"), 1e-9 * areas[1][1]);
  EXPECT_NEAR(areas[1][0], entry(filter->GetMeasures(), "Area", "OnMap"), 1e-9 * areas[1][1]);
  EXPECT_NEAR(areas[0][0] / areas[0][1], 1.0, 0.02);

  // The curves in space are those that were measured; those on the map are on it.
  vtkPolyData* curves = filter->GetCurves();
  ASSERT_EQ(curves->GetNumberOfLines(), 3);
  vtkDataArray* places = curves->GetPointData()->GetArray("SurfacePoints");
  for (vtkIdType line = 0; line < 2; ++line)
  {
    vtkNew<vtkIdList> points;
    curves->GetCellPoints(line, points);
    double length = 0.0;
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      double x[3];
      places->GetTuple(points->GetId(i), x);
      EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), Radius, 0.02 * Radius);
      if (i > 0)
      {
        double before[3];
        places->GetTuple(points->GetId(i - 1), before);
        length += std::hypot(x[0] - before[0], x[1] - before[1], x[2] - before[2]);
      }
    }
    const double measured = curves->GetCellData()->GetArray("Length")->GetTuple1(line);
    EXPECT_NEAR(
      length, measured, 0.5); // which ends amid the teeth of the boundary, the curve at their tips
  }
  auto* names = vtkStringArray::SafeDownCast(curves->GetCellData()->GetAbstractArray("Measure"));
  EXPECT_EQ(names->GetValue(0), "GreatestDiameter");
  EXPECT_EQ(names->GetValue(2), "Perimeter");
}

TEST(FlattenRegion, OfAFlatMapMeansTheSurfaceInSpace)
{
  const auto input = hemisphere(3000);
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(input);
  vtkNew<vtkFlattenRegion> ofMap;
  ofMap->SetInputConnection(conformal->GetOutputPort());
  useLabels(ofMap);
  ofMap->Update();
  vtkNew<vtkFlattenRegion> ofSurface;
  ofSurface->SetInputData(0, input);
  useLabels(ofSurface);
  ofSurface->Update();
  EXPECT_EQ(figure(ofMap->GetOutput(), "Area"), figure(ofSurface->GetOutput(), "Area"));
  EXPECT_EQ(
    figure(ofMap->GetOutput(), "GreatestDiameter"), figure(ofSurface->GetOutput(), "GreatestDiameter"));
}

std::set<std::string> fieldArrays(vtkDataObject* data)
{
  std::set<std::string> names;
  for (int a = 0; a < data->GetFieldData()->GetNumberOfArrays(); ++a)
  {
    names.insert(data->GetFieldData()->GetArrayName(a));
  }
  return names;
}

// The map of the region keeps the areas of the surface, whatever those of the map before were to be, and
// has none of its measures.
TEST(FlattenRegion, ForgetsTheMapBefore)
{
  const auto input = hemisphere(3000);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("AreaWeight");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    weights->InsertNextValue(input->GetPoint(i)[0] > 0.0 ? 4.0 : 1.0);
  }
  input->GetPointData()->AddArray(weights);
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(input);
  vtkNew<vtkOMTAreaPreservingFilter> omt;
  omt->SetInputConnection(conformal->GetOutputPort());
  vtkNew<vtkDistortionMetrics> ofMap;
  ofMap->SetInputConnection(omt->GetOutputPort());
  ofMap->MeasureLengthsOn();
  ofMap->SetLengthSamples(20);
  vtkNew<vtkFlattenRegion> region;
  region->SetInputConnection(ofMap->GetOutputPort());
  useLabels(region);
  vtkNew<vtkDistortionMetrics> ofRegion;
  ofRegion->SetInputConnection(region->GetOutputPort());
  ofRegion->Update();
  EXPECT_GT(figure(ofRegion->GetOutput(), "FacesWithin2Percent"), 90.0);
  EXPECT_FALSE(region->GetOutput()->GetPointData()->HasArray("TargetArea"));
  EXPECT_FALSE(region->GetOutput()->GetPointData()->HasArray("LengthError"));
  EXPECT_FALSE(region->GetOutput()->GetCellData()->HasArray("AngleDistortion"));
  EXPECT_FALSE(region->GetOutput()->GetFieldData()->HasArray("MeanLocalLengthError"));
  EXPECT_FALSE(region->GetOutput()->GetFieldData()->HasArray("FacesWithin2Percent"));
  EXPECT_TRUE(fieldArrays(ofMap->GetOutput()).count("WarmStart"));
  vtkNew<vtkFlattenRegion> ofSurface;
  ofSurface->SetInputData(0, input);
  useLabels(ofSurface);
  ofSurface->Update();
  for (int port = 0; port < 3; ++port)
  {
    EXPECT_EQ(
      fieldArrays(region->GetOutputDataObject(port)), fieldArrays(ofSurface->GetOutputDataObject(port)));
  }
  // Nor has another map of the same surface.
  omt->SetInputConnection(ofMap->GetOutputPort());
  ofMap->SetInputConnection(conformal->GetOutputPort());
  omt->Update();
  EXPECT_FALSE(omt->GetOutput()->GetPointData()->HasArray("LengthError"));
  EXPECT_FALSE(omt->GetOutput()->GetCellData()->HasArray("AngleDistortion"));
}

TEST(FlattenRegion, ASelectionIsARegion)
{
  const auto input = hemisphere(3000);
  for (const bool cells : { false, true })
  {
    vtkNew<vtkIdTypeArray> ids;
    vtkDataArray* labels =
      cells ? input->GetCellData()->GetArray("CellLabel") : input->GetPointData()->GetArray("Label");
    for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
    {
      if (labels->GetTuple1(i) == (cells ? 14 : 4))
      {
        ids->InsertNextValue(i);
      }
    }
    vtkNew<vtkSelectionNode> node;
    node->SetFieldType(cells ? vtkSelectionNode::CELL : vtkSelectionNode::POINT);
    node->SetContentType(vtkSelectionNode::INDICES);
    node->SetSelectionList(ids);
    vtkNew<vtkSelection> selection;
    selection->AddNode(node);
    vtkNew<vtkFlattenRegion> filter;
    filter->SetInputData(0, input);
    filter->SetRegionFromSelection();
    filter->SetInputData(1, selection);
    filter->Update();
    vtkNew<vtkFlattenRegion> byLabel;
    byLabel->SetInputData(0, input);
    byLabel->SetInputArrayToProcess(0,
      0,
      0,
      cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS,
      labels->GetName());
    byLabel->SetLabel(cells ? 14 : 4);
    byLabel->Update();
    EXPECT_EQ(figure(filter->GetOutput(), "Area"), figure(byLabel->GetOutput(), "Area"));
  }
}

// The teeth of the boundary are in the margin, so that the triangles of the region keep their areas.
TEST(FlattenRegion, ASelectionOfBlocksIsRefused)
{
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(0, hemisphere(300));
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::BLOCKS);
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);
  filter->SetInputData(1, selection);
  filter->SetRegionFrom(vtkFlattenRegion::SELECTION);
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages()[0].find("one of blocks"), std::string::npos) << errors.messages()[0];
}

TEST(FlattenRegion, TheAutomaticMarginIsFourEdgesOrWhatLeavesADisk)
{
  const auto input = hemisphere(3000);
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(0, input);
  useLabels(filter);
  filter->Update();
  const double edge = std::sqrt(2.0 * Pi * Radius * Radius / 3000 * 2.0 / std::sqrt(3.0));
  EXPECT_NEAR(figure(filter->GetOutput(), "Margin") / edge, 4.0, 0.4);
  EXPECT_NEAR(figure(filter->GetOutput(), "FlatArea") / figure(filter->GetOutput(), "Area"), 1.0, 0.003);

  // Most of the way around an open tube: four edges would close the ring.
  const TriangleMesh tube = samples::cylinder(40, 20, 3.0);
  const auto pipe = polyDataOf(tube);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (int v = 0; v < tube.vertexCount(); ++v)
  {
    labels->InsertNextValue(v % 40 < 34 && v / 40 >= 8 && v / 40 <= 12 ? 4 : 1);
  }
  pipe->GetPointData()->AddArray(labels);
  filter->SetInputData(0, pipe);
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_GT(figure(filter->GetOutput(), "Margin"), 0.15);
  EXPECT_LT(figure(filter->GetOutput(), "Margin"), 4.0 * 0.15);
}

// A region of a few triangles gets a boundary that can be a circle.
TEST(FlattenRegion, OfAFewTriangles)
{
  const auto input = hemisphere(2000);
  auto* labels = vtkIntArray::SafeDownCast(input->GetPointData()->GetArray("Label"));
  labels->FillComponent(0, 1);
  vtkNew<vtkIdList> corners;
  input->GetCellPoints(0, corners);
  for (vtkIdType k = 0; k < 3; ++k)
  {
    labels->SetValue(corners->GetId(k), 4);
  }
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(0, input);
  useLabels(filter);
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "FlatArea") / figure(filter->GetOutput(), "Area"), 1.0, 0.02);
  EXPECT_EQ(figure(filter->GetOutput(), "Bijective"), 1);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("vtkOriginalPointIds")->GetRange()[0], -1);
}

TEST(FlattenRegion, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkFlattenRegion> filter;
  ErrorLog errors(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

TEST(FlattenRegion, ReportsWhatIsWrong)
{
  const auto input = hemisphere(1000);
  vtkNew<vtkFlattenRegion> filter;
  const auto expectWords = [&](const std::string& words)
  {
    SCOPED_TRACE(words);
    ErrorLog errors(filter);
    filter->SetInputData(0, input);
    filter->Modified();
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages()[0].find(words), std::string::npos) << errors.messages()[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetMeasures()->GetNumberOfRows(), 0);
    EXPECT_EQ(filter->GetCurves()->GetNumberOfPoints(), 0);
  };
  expectWords("no array of labels is chosen");
  useLabels(filter);
  filter->SetLabel(5);
  expectWords("no triangle has the label 5; there are 1, 4");
  filter->SetLabel(1); // the rim
  expectWords("not a disk");
  filter->SetLabel(4);
  filter->AutomaticMarginOff();
  filter->SetMargin(-1.0);
  expectWords("must not be negative");
  filter->SetMargin(0.0);
  filter->SetRegionFromSelection();
  expectWords("there is no selection");
}

// Its remedies are those of this filter, not those of the stage that failed, and it is short enough to
// be read.
TEST(FlattenRegion, SaysInOneSentenceThatNoMapWasFound)
{
  const vtkSmartPointer<vtkPolyData> input = hemisphere(60);
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p) // needles
  {
    double x[3];
    input->GetPoint(p, x);
    input->GetPoints()->SetPoint(p, 1e7 * x[0], x[1], x[2]);
  }
  vtkNew<vtkFlattenRegion> filter;
  filter->SetInputData(input);
  useLabels(filter);
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  const std::string& message = errors.messages()[0];
  EXPECT_NE(message.find("no flat map of the region was found"), std::string::npos) << message;
  EXPECT_NE(message.find("Margin"), std::string::npos) << message;
  EXPECT_EQ(message.find("Tolerance"), std::string::npos) << message;
}

TEST(FlattenRegion, CanBeStopped)
{
  const auto input = hemisphere(1000);
  vtkNew<vtkFlattenRegion> filter;
  useLabels(filter);
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    input->GetPointData()->GetArray("Label")->SetTuple1(
      v, 4); // the whole surface: as many cells come out
  }
  for (const double fraction : { 0.0, 0.5, 0.8 })
  {
    expectAbort(filter.Get(), input, fraction);
  }
}

} // namespace
