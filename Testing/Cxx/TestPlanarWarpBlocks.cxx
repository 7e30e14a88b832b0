// SPDX-License-Identifier: GPL-3.0-or-later
/// Planar Warp with composite data sets on either port.
#include "FilterTest.h"
#include "PlanarWarpSamples.h"

#include <vtkPlanarWarp.h>

#include <vtkDirectedGraph.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMutableDirectedGraph.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <string>

namespace
{

using namespace flattening::testing;

vtkSmartPointer<vtkDataObject> alone(vtkPolyData* mesh, vtkDataObject* data)
{
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(mesh);
  filter->SetCarriedData(data);
  filter->Update();
  return filter->GetOutput();
}

void expectSamePoints(vtkPoints* found, vtkPoints* expected)
{
  ASSERT_EQ(found->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(found->GetPoint(i)[k], expected->GetPoint(i)[k]);
    }
  }
}

void expectSameFigures(vtkDataObject* found, vtkDataObject* expected)
{
  EXPECT_EQ(found->GetFieldData()->GetNumberOfArrays(), expected->GetFieldData()->GetNumberOfArrays());
  for (int i = 0; i < expected->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    const char* name = expected->GetFieldData()->GetArrayName(i);
    EXPECT_EQ(figure(found, name), figure(expected, name)) << name;
  }
}

vtkSmartPointer<vtkMutableDirectedGraph> connection()
{
  auto graph = vtkSmartPointer<vtkMutableDirectedGraph>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.25, 0.5, 0.0);
  points->InsertNextPoint(1.75, 0.5, 0.0);
  graph->AddVertex();
  graph->AddVertex();
  graph->SetPoints(points);
  graph->AddEdge(0, 1);
  return graph;
}

vtkSmartPointer<vtkPolyData> meshWithFigure(double percent)
{
  auto mesh = deformed(plane(20), bend);
  vtkNew<vtkDoubleArray> array;
  array->SetName("FacesWithin2Percent");
  array->InsertNextValue(percent);
  mesh->GetFieldData()->AddArray(array);
  return mesh;
}

// Lines, a graph and an image on one mesh, each to what it becomes alone; what cannot be carried is
// named.
TEST(PlanarWarpBlocks, OneMeshCarriesEveryBlock)
{
  const auto mesh = meshWithFigure(98.0);
  const auto line = polyline({ { 0, 0.5, 0 }, { 2, 0.5, 0 } });
  const auto graph = connection();
  const auto image = picture();
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 0.5, 0.0);
  grid->SetPoints(points);
  vtkNew<vtkMultiBlockDataSet> data;
  data->SetBlock(0, line);
  data->SetBlock(1, graph);
  data->SetBlock(2, image);
  data->SetBlock(3, grid);
  data->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "stops");

  vtkNew<vtkPlanarWarp> filter;
  ErrorLog errors(filter);
  filter->SetInputData(mesh);
  filter->SetCarriedData(data);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 4u);

  auto* lines = vtkPolyData::SafeDownCast(output->GetBlock(0));
  ASSERT_NE(lines, nullptr);
  const auto expectedLines = alone(mesh, line);
  ASSERT_GT(lines->GetNumberOfPoints(), 50);
  EXPECT_EQ(
    figure(lines, "FacesWithin2Percent"), 98.0); // the map's figures come along, as they do alone
  expectSamePoints(lines->GetPoints(), vtkPolyData::SafeDownCast(expectedLines)->GetPoints());
  expectSameFigures(lines, expectedLines);

  auto* edges = vtkDirectedGraph::SafeDownCast(output->GetBlock(1));
  ASSERT_NE(edges, nullptr);
  const auto expectedEdges = alone(mesh, graph);
  expectSamePoints(edges->GetPoints(), vtkGraph::SafeDownCast(expectedEdges)->GetPoints());
  EXPECT_GT(edges->GetNumberOfEdgePoints(0), 50);
  expectSameFigures(edges, expectedEdges);

  auto* pixels = vtkImageData::SafeDownCast(output->GetBlock(2));
  ASSERT_NE(pixels, nullptr);
  const auto expectedPixels = alone(mesh, image);
  auto* expectedImage = vtkImageData::SafeDownCast(expectedPixels);
  ASSERT_EQ(pixels->GetNumberOfPoints(), expectedImage->GetNumberOfPoints());
  for (const char* name : { "Ramp", "InMap" })
  {
    for (vtkIdType i = 0; i < pixels->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(pixels->GetPointData()->GetArray(name)->GetTuple1(i),
        expectedImage->GetPointData()->GetArray(name)->GetTuple1(i));
    }
  }
  expectSameFigures(pixels, expectedPixels);

  EXPECT_EQ(output->GetBlock(3), nullptr);
  EXPECT_EQ(figure(output, "FailedBlocks"), 1.0);
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find(
              "block \"stops\": it is a vtkUnstructuredGrid, not a surface or a graph or an image: run"),
    std::string::npos)
    << errors.messages().front();

  filter->SetImageOutputToTexturedMesh(); // another class in the same place
  filter->Update();
  output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  auto* textured = vtkPolyData::SafeDownCast(output->GetBlock(2));
  ASSERT_NE(textured, nullptr);
  EXPECT_EQ(textured->GetNumberOfPoints(), mesh->GetNumberOfPoints());
}

// The same network on two magnifiers.
TEST(PlanarWarpBlocks, OneDataSetIsCarriedByEveryMesh)
{
  const auto line = polyline({ { 0.25, 0.5, 0 }, { 1.75, 0.5, 0 } });
  const auto bent = meshWithFigure(98.0);
  const auto large = doubled();
  vtkNew<vtkPartitionedDataSet> meshes;
  meshes->SetPartition(0, bent);
  meshes->SetPartition(1, large);
  vtkNew<vtkPlanarWarp> filter;
  ErrorLog errors(filter);
  filter->SetInputDataObject(0, meshes);
  filter->SetCarriedData(line);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  auto* output = vtkPartitionedDataSet::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfPartitions(), 2u);
  auto* first = vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(0));
  auto* second = vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(1));
  ASSERT_NE(first, nullptr);
  ASSERT_NE(second, nullptr);
  const auto expected = alone(bent, line);
  expectSamePoints(first->GetPoints(), vtkPolyData::SafeDownCast(expected)->GetPoints());
  expectSameFigures(first, expected);
  EXPECT_NEAR(second->GetBounds()[0], 0.5, 1e-12);
  EXPECT_NEAR(second->GetBounds()[1], 3.5, 1e-12);
  EXPECT_NEAR(second->GetBounds()[2], 1.0, 1e-12);
}

} // namespace
