// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkAreaWeights.h>
#include <vtkConformalDiskFilter.h>
#include <vtkOMTAreaPreservingFilter.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSignedCharArray.h>
#include <vtkSphere.h>
#include <vtkTriangle.h>

#include <array>
#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::testing;

constexpr const char* Labels = "Region";

// A hill of 30 mm with labels: 7 on a part of its flank, 3 on the rest.
vtkSmartPointer<vtkPolyData> labelledHill(int n)
{
  TriangleMesh mesh = sunflowerMesh(gaussianBump(1.0, 0.4), n).Mesh;
  mesh.Vertices *= 30.0;
  const auto data = polyDataOf(mesh);
  vtkNew<vtkIntArray> labels;
  labels->SetName(Labels);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double x = mesh.Vertices(v, 0) - 10.0;
    labels->InsertNextValue(x * x + mesh.Vertices(v, 1) * mesh.Vertices(v, 1) < 64.0 ? 7 : 3);
  }
  data->GetPointData()->AddArray(labels);
  return data;
}

void useLabels(vtkAreaWeights* filter, int association = vtkDataObject::FIELD_ASSOCIATION_POINTS)
{
  filter->SetInputArrayToProcess(0, 0, 0, association, Labels);
}

vtkDataArray* weightsOf(vtkAlgorithm* filter)
{
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "AreaWeight");
  return output->GetPointData()->GetArray("AreaWeight");
}

// How much more a region has grown than the rest.
struct Growth
{
  double Cells;
  double Faces; // with all corners in the region, against those with none in it
};

Growth growthOf(vtkPolyData* flat, const std::vector<char>& inside)
{
  vtkDataArray* surface = flat->GetPointData()->GetArray("SurfacePoints");
  vtkDataArray* cells = flat->GetPointData()->GetArray("CellArea");
  std::array<double, 2> cell{};
  std::array<double, 2> point{};
  std::array<double, 2> face{};
  std::array<double, 2> original{};
  for (vtkIdType v = 0; v < flat->GetNumberOfPoints(); ++v)
  {
    cell[inside[v] != 0] += cells->GetTuple1(v);
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < flat->GetNumberOfCells(); ++f)
  {
    flat->GetCellPoints(f, corners);
    double x[3][3];
    double p[3][3];
    int count = 0;
    for (int k = 0; k < 3; ++k)
    {
      surface->GetTuple(corners->GetId(k), x[k]);
      flat->GetPoint(corners->GetId(k), p[k]);
      count += inside[corners->GetId(k)] != 0;
    }
    const double area = vtkTriangle::TriangleArea(x[0], x[1], x[2]);
    for (int k = 0; k < 3; ++k)
    {
      point[inside[corners->GetId(k)] != 0] += area / 3.0;
    }
    if (count % 3 == 0)
    {
      face[count / 3] += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
      original[count / 3] += area;
    }
  }
  return { cell[1] / cell[0] / (point[1] / point[0]), face[1] / face[0] / (original[1] / original[0]) };
}

std::vector<char> pointsWithLabel(vtkPolyData* data, int label)
{
  std::vector<char> inside(data->GetNumberOfPoints());
  for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v)
  {
    inside[v] = data->GetPointData()->GetArray(Labels)->GetTuple1(v) == label;
  }
  return inside;
}

// The promise of the whole: a factor asked is a factor delivered.
TEST(AreaWeights, TheFlatMapHasTheFactorsAskedFor)
{
  const auto input = labelledHill(5000);
  vtkNew<vtkAreaWeights> weights;
  weights->SetInputData(input);
  useLabels(weights);
  weights->SetLabel(7);
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(weights->GetOutputPort());
  vtkNew<vtkOMTAreaPreservingFilter> flat;
  flat->SetInputConnection(conformal->GetOutputPort());
  const std::vector<char> inside = pointsWithLabel(input, 7);
  for (const double factor : { 0.25, 1.0, 2.0, 4.0, 8.0 })
  {
    SCOPED_TRACE(factor);
    weights->SetFactor(factor);
    flat->Update();
    const Growth growth = growthOf(flat->GetOutput(), inside);
    EXPECT_NEAR(growth.Cells / factor, 1.0, 1e-6);
    EXPECT_NEAR(growth.Faces / factor, 1.0, 0.01);
    EXPECT_EQ(figure(flat->GetOutput(), "Bijective"), 1);
    std::printf("factor %5.2f: cells %.2e, faces %.4f %%\n",
      factor,
      growth.Cells / factor - 1.0,
      100.0 * (growth.Faces / factor - 1.0));
  }
}

TEST(AreaWeights, AMagnifiedRegionHasItsAreaOnTheMap)
{
  vtkNew<vtkAreaWeights> weights;
  weights->SetInputData(labelledHill(3000));
  useLabels(weights);
  weights->SetLabel(7);
  weights->SetFactor(4.0);
  weights->SetEdgeWidth(3.0);
  weights->SetFactorMeaningToMagnification();
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputConnection(weights->GetOutputPort());
  vtkNew<vtkOMTAreaPreservingFilter> flat;
  flat->SetInputConnection(conformal->GetOutputPort());
  flat->FaceRefinementOff();
  flat->Update();
  double area = 0.0;
  const std::vector<char> inside = pointsWithLabel(flat->GetOutput(), 7);
  for (vtkIdType v = 0; v < flat->GetOutput()->GetNumberOfPoints(); ++v)
  {
    area += inside[v] ? flat->GetOutput()->GetPointData()->GetArray("CellArea")->GetTuple1(v) : 0.0;
  }
  EXPECT_NEAR(area / figure(weights->GetOutput(), "RegionArea"), 4.0, 1e-6);
  EXPECT_NEAR(figure(weights->GetOutput(), "RegionFlatArea") / area, 1.0, 1e-6);
  EXPECT_NEAR(figure(weights->GetOutput(), "GreatestMagnification"), 4.0, 1e-9);
  EXPECT_LT(figure(weights->GetOutput(), "SmallestMagnification"), 0.9);
}

TEST(AreaWeights, ATableGivesEveryLabelItsFactor)
{
  const auto input = labelledHill(2000);
  input->GetPointData()->GetArray(Labels)->SetTuple1(0, 5);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputData(input);
  filter->SetWeightsFromLabelTable();
  useLabels(filter);
  filter->AddLabelFactor(7, 3.0);
  filter->AddLabelFactor(5, 0.5);
  filter->Update();
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    const double label = input->GetPointData()->GetArray(Labels)->GetTuple1(v);
    EXPECT_EQ(weightsOf(filter)->GetTuple1(v), label == 7 ? 3.0 : label == 5 ? 0.5 : 1.0);
  }
}

TEST(AreaWeights, AChainMultiplies)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(0.0, 0.0, 30.0);
  sphere->SetRadius(20.0);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  vtkNew<vtkAreaWeights> first;
  first->SetInputData(labelledHill(2000));
  first->SetWeightsFromImplicitFunction();
  first->SetImplicitFunction(sphere);
  first->SetFactor(3.0);
  vtkNew<vtkAreaWeights> second;
  second->SetInputConnection(first->GetOutputPort());
  second->SetWeightsFromImplicitFunction();
  second->SetImplicitFunction(plane);
  second->InsideOutOn();
  second->SetFactor(0.5);
  second->Update();
  int seen = 0;
  for (vtkIdType v = 0; v < second->GetOutput()->GetNumberOfPoints(); ++v)
  {
    double x[3];
    second->GetOutput()->GetPoint(v, x);
    const bool near = std::hypot(x[0], x[1], x[2] - 30.0) <= 20.0;
    EXPECT_EQ(weightsOf(second)->GetTuple1(v), (near ? 3.0 : 1.0) * (x[0] >= 0.0 ? 0.5 : 1.0));
    seen |= 1 << (2 * near + (x[0] >= 0.0));
  }
  EXPECT_EQ(seen, 15);
  sphere->SetRadius(1.0); // a moved widget is noticed
  second->Update();
  EXPECT_LT(figure(first->GetOutput(), "RegionPoints"), 20);
  second->SetWeightsFromScalars(); // without a region, that of the filter before is not reported
  second->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "AreaWeight");
  second->Update();
  EXPECT_GT(second->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(second->GetOutput()->GetFieldData()->GetArray("RegionPoints"), nullptr);
}

// On a flat map a function is placed on the map, or by SurfacePoints in space.
TEST(AreaWeights, AFunctionIsPlacedOnTheMapOrInSpace)
{
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(labelledHill(2000));
  vtkNew<vtkPlane> plane; // all of the map is on it; the hill is above
  plane->SetOrigin(0.0, 0.0, 10.0);
  plane->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputConnection(conformal->GetOutputPort());
  filter->SetWeightsFromImplicitFunction();
  filter->SetImplicitFunction(plane);
  filter->InsideOutOn();
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "SurfacePoints");
  filter->Update();
  vtkDataArray* surface = filter->GetOutput()->GetPointData()->GetArray("SurfacePoints");
  for (vtkIdType v = 0; v < surface->GetNumberOfTuples(); ++v)
  {
    EXPECT_EQ(weightsOf(filter)->GetTuple1(v), surface->GetComponent(v, 2) >= 10.0 ? 2.0 : 1.0);
  }
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages()[0].find("has no point of the surface"), std::string::npos);
}

TEST(AreaWeights, ScalarsGoThroughTheCurve)
{
  const auto input = labelledHill(2000);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    height->InsertNextValue(input->GetPoint(v)[2]);
  }
  input->GetPointData()->AddArray(height);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputData(input);
  filter->SetWeightsFromScalars();
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Height");
  filter->AddCurvePoint(5.0, 1.0);
  filter->AddCurvePoint(25.0, 3.0);
  filter->Update();
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    const double z = height->GetValue(v);
    EXPECT_NEAR(weightsOf(filter)->GetTuple1(v),
      z < 5.0    ? 1.0
      : z > 25.0 ? 3.0
                 : 1.0 + 0.1 * (z - 5.0),
      1e-12);
  }
  height->FillComponent(0, 2.5);
  height->Modified();
  input->Modified();
  filter->ClearCurve();
  filter->Update();
  EXPECT_EQ(weightsOf(filter)->GetTuple1(11), 2.5);
}

vtkSmartPointer<vtkSelection> selectionOf(int field, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetFieldType(field);
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetSelectionList(list);
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

TEST(AreaWeights, ASelectionOfPointsOrCells)
{
  const auto input = labelledHill(2000);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputData(0, input);
  filter->SetWeightsFromSelection();
  filter->SetInputData(1, selectionOf(vtkSelectionNode::POINT, { 5, 17, 1000 }));
  filter->Update();
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    EXPECT_EQ(weightsOf(filter)->GetTuple1(v), v == 5 || v == 17 || v == 1000 ? 2.0 : 1.0);
  }
  EXPECT_EQ(figure(filter->GetOutput(), "RegionPoints"), 3);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("vtkInsidedness"), nullptr);

  filter->SetInputData(1, selectionOf(vtkSelectionNode::CELL, { 77 }));
  filter->Update();
  vtkNew<vtkIdList> corners;
  input->GetCellPoints(77, corners);
  EXPECT_EQ(figure(filter->GetOutput(), "RegionPoints"), 3);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(weightsOf(filter)->GetTuple1(corners->GetId(k)), 2.0);
  }
}

// ParaView's Extract Selection leaves such an array with Preserve Topology.
TEST(AreaWeights, ASelectionIsNotThatOfAnArrayOfTheInput)
{
  const auto input = labelledHill(2000);
  vtkNew<vtkSignedCharArray> earlier;
  earlier->SetName("vtkInsidedness");
  earlier->SetNumberOfTuples(input->GetNumberOfCells());
  earlier->Fill(1);
  input->GetCellData()->AddArray(earlier);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputData(0, input);
  filter->SetWeightsFromSelection();
  filter->SetInputData(1, selectionOf(vtkSelectionNode::POINT, { 5, 17, 1000 }));
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "RegionPoints"), 3);
}

TEST(AreaWeights, LabelsOfCellsGoToThePoints)
{
  const auto input = labelledHill(2000);
  vtkNew<vtkIntArray> labels;
  labels->SetName(Labels);
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    labels->InsertNextValue(input->GetCell(c)->GetBounds()[0] >= 0.0 ? 7 : 3);
  }
  input->GetCellData()->AddArray(labels);
  vtkNew<vtkAreaWeights> filter;
  filter->SetInputData(input);
  useLabels(filter, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  filter->SetLabel(7);
  filter->Update();
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    const double x = input->GetPoint(v)[0];
    if (std::abs(x) > 3.0)
    {
      EXPECT_EQ(weightsOf(filter)->GetTuple1(v), x > 0.0 ? 2.0 : 1.0);
    }
  }
}

TEST(AreaWeights, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkAreaWeights> filter;
  ErrorLog errors(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(errors.messages().empty());
}

TEST(AreaWeights, ReportsWhatIsWrong)
{
  const auto input = labelledHill(500);
  vtkNew<vtkAreaWeights> filter;
  const auto expectWords = [&](const std::string& words)
  {
    SCOPED_TRACE(words);
    ErrorLog errors(filter);
    filter->SetInputData(input);
    filter->Modified();
    filter->Update();
    ASSERT_EQ(errors.messages().size(), 1u);
    EXPECT_NE(errors.messages()[0].find(words), std::string::npos) << errors.messages()[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  expectWords("no array is chosen");
  useLabels(filter);
  expectWords("no point has the label 1; there are 3, 7");
  filter->SetLabel(7);
  filter->SetFactor(0.0);
  expectWords("must be positive numbers");
  filter->SetFactor(std::numeric_limits<double>::max());
  expectWords("too large or too small");
  filter->SetFactor(1000.0);
  filter->SetFactorMeaningToMagnification();
  expectWords("more than there is");
  filter->SetWeightsFromLabelTable();
  expectWords("the table of labels is empty");
  filter->AddLabelFactor(3, 2.0);
  filter->AddLabelFactor(3, 1.0);
  expectWords("in the table twice");
  filter->ClearLabelFactors();
  filter->AddLabelFactor(3.5, 2.0);
  expectWords("no point has the label 3.5");
  filter->SetWeightsFromScalars();
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nothing");
  expectWords("Nothing is not a point or cell array of one component");
  filter->SetWeightsFromSelection();
  expectWords("there is no selection");
  filter->SetInputData(1, selectionOf(vtkSelectionNode::POINT, { 100000 }));
  expectWords("the selection has no point");
  filter->SetWeightsFromImplicitFunction();
  expectWords("no implicit function is set");
  input->GetPointData()->GetArray(Labels)->SetName("AreaWeight");
  input->GetPointData()->GetArray("AreaWeight")->SetTuple1(3, 0.0);
  filter->SetImplicitFunction(vtkNew<vtkSphere>());
  expectWords("AreaWeight is not a positive number at point 3");
}

} // namespace
