// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilterTest.h"
#include "PlanarWarpSamples.h"

#include <vtkPlanarWarp.h>

#include <vtkAreaWeights.h>
#include <vtkBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkConformalDiskFilter.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMutableDirectedGraph.h>
#include <vtkMutableUndirectedGraph.h>
#include <vtkNew.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkReverseSense.h>
#include <vtkUndirectedGraph.h>

#include <cmath>
#include <string>

namespace
{

using namespace flattening::testing;

TEST(PlanarWarpFilter, LinesBendWithTheMesh)
{
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(deformed(plane(40, 7.0), bend));
  filter->SetCarriedData(polyline({ { 0, 0.5, 7.0 }, { 2, 0.5, 9.0 } }));
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  // Half of the mean side: sides of 1/40, 1/40 and its diagonal.
  const double longest = (2.0 + std::sqrt(2.0)) / 3.0 / 40 / 2;
  const auto parts = static_cast<vtkIdType>(std::ceil(2.0 / longest));
  ASSERT_EQ(output->GetNumberOfPoints(), parts + 1);
  EXPECT_EQ(figure(output, "InsertedPoints"), parts - 1);
  EXPECT_EQ(figure(output, "OutsidePoints"), 0);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  ASSERT_EQ(output->GetCell(0)->GetNumberOfPoints(), parts + 1);
  EXPECT_EQ(output->GetCellData()->GetArray("Street")->GetTuple1(0), 42);
  vtkDataArray* surface = output->GetPointData()->GetArray("SurfacePoints");
  for (vtkIdType k = 0; k <= parts; ++k)
  {
    const vtkIdType id = output->GetCell(0)->GetPointId(static_cast<int>(k));
    double x[3];
    output->GetPoint(id, x);
    const double share = static_cast<double>(k) / parts;
    EXPECT_NEAR(x[0], 2.0 * share, 1e-12);
    EXPECT_NEAR(x[1], 0.5 + share * (1.0 - share), 0.5 / 40 / 40 / 8 * 1.001); // f'' h^2 / 8
    EXPECT_NEAR(x[2], 2.0 * share, 1e-12); // the height above the mesh
    EXPECT_NEAR(surface->GetComponent(id, 1), 0.5, 1e-15);
    EXPECT_NEAR(output->GetPointData()->GetArray("Length")->GetTuple1(id), 10.0 * share, 1e-12);
    EXPECT_EQ(output->GetPointData()->GetArray("Label")->GetTuple1(id), share > 0.5 ? 1 : 0);
  }

  filter->SetMaximumSegmentLength(0.5);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutputDataObject(0), "InsertedPoints"), 3);
  filter->SubdivideLinesOff();
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutputDataObject(0), "InsertedPoints"), 0);
}

TEST(PlanarWarpFilter, OutsideIsRemovedOrLeft)
{
  const auto line = polyline({ { 0.5, 0.5, 0 }, { 1.5, 0.5, 0 }, { 2.5, 0.5, 0 }, { 1.5, 0.25, 0 } });
  vtkNew<vtkPlanarWarp> filter;
  filter->SubdivideLinesOff();
  filter->SetInputData(doubled());
  filter->SetCarriedData(line);
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(figure(output, "OutsidePoints"), 1);
  EXPECT_EQ(output->GetNumberOfPoints(), 3);
  ASSERT_EQ(output->GetNumberOfLines(), 1); // the last point stands alone
  EXPECT_EQ(output->GetCell(0)->GetNumberOfPoints(), 2);
  EXPECT_EQ(output->GetPoint(1)[0], 3.0);

  filter->SetOutsidePointsToLeaveUnmoved();
  filter->Update();
  output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(figure(output, "OutsidePoints"), 1);
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  EXPECT_EQ(output->GetPoint(2)[0], 2.5);
  EXPECT_EQ(output->GetPoint(3)[0], 3.0);
  vtkDataArray* inMap = output->GetPointData()->GetArray("InMap");
  EXPECT_EQ(inMap->GetTuple1(1), 1);
  EXPECT_EQ(inMap->GetTuple1(2), 0);

  // subdivided, the line is cut at the mesh's side: two runs, to within a segment
  filter->SetOutsidePointsToRemove();
  filter->SubdivideLinesOn();
  filter->SetMaximumSegmentLength(0.01);
  filter->Update();
  output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfLines(), 2);
  double bounds[6];
  output->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 4.0, 0.021);
}

TEST(PlanarWarpFilter, PolygonsVerticesAndStripsKeepTheirCellData)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (const double x : { 0.0, 0.5, 1.0, 3.0 })
  {
    points->InsertNextPoint(x, 0.0, 0.0);
    points->InsertNextPoint(x, 0.5, 0.0);
  }
  data->SetPoints(points);
  data->AllocateEstimate(4, 4);
  vtkNew<vtkCellArray> vertices;
  const vtkIdType far = 6;
  const vtkIdType near = 3;
  vertices->InsertNextCell(1, &far);
  vertices->InsertNextCell(1, &near);
  vtkNew<vtkCellArray> quads;
  const vtkIdType within[] = { 0, 2, 3, 1 };
  const vtkIdType across[] = { 4, 6, 7, 5 };
  quads->InsertNextCell(4, across);
  quads->InsertNextCell(4, within);
  vtkNew<vtkCellArray> strips;
  const vtkIdType strip[] = { 0, 1, 2, 3, 4, 5 };
  strips->InsertNextCell(6, strip);
  data->SetVerts(vertices);
  data->SetPolys(quads);
  data->SetStrips(strips);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  for (int cell = 0; cell < 5; ++cell)
  {
    number->InsertNextValue(cell);
  }
  data->GetCellData()->AddArray(number);

  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(doubled());
  filter->SetCarriedData(data);
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(figure(output, "OutsidePoints"), 2);
  EXPECT_EQ(output->GetNumberOfVerts(), 1);
  EXPECT_EQ(output->GetNumberOfPolys(), 1);
  EXPECT_EQ(output->GetNumberOfStrips(), 1);
  ASSERT_EQ(output->GetCellData()->GetArray("Number")->GetNumberOfTuples(), 3);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(0), 1);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(1), 3);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(2), 4);
  EXPECT_EQ(output->GetPoint(5)[0], 2.0);
}

template <typename Graph>
vtkSmartPointer<Graph> network(double lastX)
{
  auto graph = vtkSmartPointer<Graph>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> station;
  station->SetName("Station");
  for (const double x : { 0.1, 1.1, lastX })
  {
    graph->AddVertex();
    points->InsertNextPoint(x, 0.5, 0.0);
    station->InsertNextValue(static_cast<int>(std::lround(10 * x)));
  }
  graph->SetPoints(points);
  graph->GetVertexData()->AddArray(station);
  graph->AddEdge(0, 2);
  graph->AddEdge(1, 0);
  vtkNew<vtkDoubleArray> load;
  load->SetName("Load");
  load->InsertNextValue(5.0);
  load->InsertNextValue(6.0);
  graph->GetEdgeData()->AddArray(load);
  const double between[] = { 0.6, 0.9, 0.0 };
  graph->SetEdgePoints(1, 1, between);
  return graph;
}

TEST(PlanarWarpFilter, GraphsKeepIdsAndData)
{
  const auto map = doubled();
  vtkNew<vtkDoubleArray> patient;
  patient->SetName("Patient");
  patient->InsertNextValue(17.0);
  map->GetFieldData()->AddArray(patient);
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(map);
  filter->SetCarriedData(network<vtkMutableDirectedGraph>(1.9));
  filter->SetMaximumSegmentLength(0.3);
  filter->Update();
  auto* graph = vtkDirectedGraph::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(graph);
  ASSERT_EQ(graph->GetNumberOfVertices(), 3);
  ASSERT_EQ(graph->GetNumberOfEdges(), 2);
  EXPECT_DOUBLE_EQ(graph->GetPoint(2)[0], 2 * static_cast<double>(1.9f));
  EXPECT_EQ(graph->GetVertexData()->GetArray("Station")->GetTuple1(1), 11);
  EXPECT_EQ(graph->GetEdgeData()->GetArray("Load")->GetTuple1(1), 6.0);
  EXPECT_EQ(graph->GetSourceVertex(1), 1);
  EXPECT_EQ(graph->GetTargetVertex(1), 0);
  EXPECT_NEAR(graph->GetVertexData()->GetArray("SurfacePoints")->GetComponent(1, 0), 1.1, 1e-6);
  ASSERT_EQ(graph->GetNumberOfEdgePoints(0), 5); // 1.8 in six parts
  EXPECT_NEAR(graph->GetEdgePoint(0, 1)[0], 2 * (0.1 + 0.6), 1e-6);
  ASSERT_EQ(graph->GetNumberOfEdgePoints(1), 5); // 0.64 in three parts, the point, 0.64 in three
  EXPECT_NEAR(graph->GetEdgePoint(1, 2)[1], 1.8, 1e-12);
  EXPECT_EQ(figure(graph, "InsertedPoints"), 9);
  EXPECT_EQ(figure(graph, "Patient"), 17.0); // the field data of the map, as with other data

  filter->SetCarriedData(network<vtkMutableUndirectedGraph>(2.9));
  filter->Update();
  auto* undirected = vtkUndirectedGraph::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(undirected);
  EXPECT_EQ(figure(undirected, "OutsidePoints"), 1);
  EXPECT_EQ(undirected->GetNumberOfVertices(), 2);
  ASSERT_EQ(undirected->GetNumberOfEdges(), 1);
  EXPECT_EQ(undirected->GetEdgeData()->GetArray("Load")->GetTuple1(0), 6.0);
}

// An edge that leaves the mesh at both ends: the points inserted outside are not in the output.
TEST(PlanarWarpFilter, GraphsCountTheInsertedPointsThatAreKept)
{
  const auto graph = network<vtkMutableUndirectedGraph>(1.9);
  const double beyond[] = { 0.1, 3.0, 0.0, 1.9, 3.0, 0.0 };
  graph->SetEdgePoints(0, 2, beyond); // 2.5 in nine parts, 1.8 in six, 2.5 in nine
  const double within[] = { 0.6, 0.5, 0.0 };
  graph->SetEdgePoints(1, 1, within); // 0.5 in two parts, twice
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(doubled());
  filter->SetCarriedData(graph);
  filter->SetMaximumSegmentLength(0.3);
  filter->Update();
  auto* inMesh = vtkGraph::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(inMesh->GetNumberOfEdgePoints(0), 2); // at y = 0.5 + 2.5 / 9
  EXPECT_EQ(inMesh->GetNumberOfEdgePoints(1), 3);
  EXPECT_EQ(figure(inMesh, "InsertedPoints"), 2 + 2);

  filter->SetOutsidePointsToLeaveUnmoved();
  filter->Update();
  auto* all = vtkGraph::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(all->GetNumberOfEdgePoints(0), 8 + 1 + 5 + 1 + 8);
  EXPECT_EQ(figure(all, "InsertedPoints"), 8 + 5 + 8 + 2);
}

TEST(PlanarWarpFilter, APointOfAnyFiniteDistanceIsOutside)
{
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputData(doubled());
  filter->SetCarriedData(polyline({ { 0.5, 0.5, 0 }, { 1.5, 0.5, 0 }, { 1e300, 0.5, 0 } }));
  ErrorLog errors(filter);
  filter->Update();
  EXPECT_TRUE(errors.messages().empty());
  EXPECT_EQ(figure(filter->GetOutputDataObject(0), "OutsidePoints"), 1);
}

TEST(PlanarWarpFilter, AMagnifierHasTheFactorsAskedFor)
{
  // The box in the middle of a planar rectangle, four times as large on the map; a fine grid of squares
  // of known area is carried.
  const auto mesh = plane(40);
  vtkNew<vtkConformalDiskFilter> conformal;
  conformal->SetInputData(mesh);
  conformal->SetDomainToRectangle();
  vtkNew<vtkBox> box;
  box->SetBounds(0.7, 1.3, 0.3, 0.7, -1, 1);
  vtkNew<vtkAreaWeights> weights;
  weights->SetInputConnection(conformal->GetOutputPort());
  weights->SetWeightsFromImplicitFunction();
  weights->SetImplicitFunction(box);
  weights->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "SurfacePoints");
  weights->SetFactorMeaning(vtkAreaWeights::MAGNIFICATION);
  weights->SetFactor(4.0);
  vtkNew<vtkOMTAreaPreservingFilter> transport;
  transport->SetInputConnection(weights->GetOutputPort());
  vtkNew<vtkPlaneSource> grid;
  grid->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  grid->SetOrigin(0.75, 0.35, 0); // within the triangles all of whose corners are in the box
  grid->SetPoint1(1.25, 0.35, 0);
  grid->SetPoint2(0.75, 0.65, 0);
  grid->SetResolution(500, 300);
  vtkNew<vtkPlanarWarp> filter;
  filter->SetInputConnection(transport->GetOutputPort());
  filter->SetCarriedConnection(grid->GetOutputPort());
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfCells(), 150000);
  double area = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    output->GetCellPoints(cell, count, ids);
    for (vtkIdType k = 0; k < count; ++k)
    {
      double a[3];
      double b[3];
      output->GetPoint(ids[k], a);
      output->GetPoint(ids[(k + 1) % count], b);
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  }
  EXPECT_NEAR(area, 4.0 * 0.5 * 0.3, 0.01 * 4.0 * 0.5 * 0.3);
}

TEST(PlanarWarpFilter, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkPlanarWarp> filter;
  ErrorLog errors(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->SetCarriedData(picture());
  filter->Update();
  filter->SetInputData(doubled());
  filter->SetCarriedData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  vtkNew<vtkPolyData> pointless; // a cell without points
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(0);
  pointless->SetPolys(cells);
  filter->SetCarriedData(pointless);
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  filter->SetCarriedData(vtkNew<vtkMutableUndirectedGraph>());
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::VERTEX), 0);
  EXPECT_TRUE(errors.messages().empty());
}

// One error with these words, and nothing comes out.
void expectFailure(vtkPlanarWarp* filter,
  vtkPolyData* mesh,
  vtkDataObject* data,
  const std::string& words)
{
  SCOPED_TRACE(words);
  ErrorLog errors(filter);
  filter->SetInputData(mesh);
  filter->SetCarriedData(data);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find(words), std::string::npos) << errors.messages().front();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::POINT), 0);
  EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::VERTEX), 0);
  EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(PlanarWarpFilter, ReportsWhatIsWrong)
{
  vtkNew<vtkPlanarWarp> filter;
  const auto line = polyline({ { 0.5, 0.5, 0 }, { 1.5, 0.5, 0 } });
  expectFailure(filter, plane(5), line, "no point array SurfacePoints");
  const auto curved = deformed(plane(5), bend);
  curved->GetPointData()->GetArray("SurfacePoints")->SetComponent(3, 2, 0.1);
  expectFailure(filter, curved, line, "not planar");
  const auto folded = deformed(plane(5), bend);
  folded->GetPointData()->GetArray("SurfacePoints")->SetComponent(14, 0, 1.9);
  expectFailure(filter, folded, line, "folds over itself");
  expectFailure(filter, doubled(), polyline({ { 5, 5, 0 }, { 6, 5, 0 } }), "no point of the data lies");
  vtkNew<vtkMutableUndirectedGraph> bare;
  bare->AddVertex();
  bare->AddVertex();
  expectFailure(filter, doubled(), bare, "lay the graph out");
  vtkNew<vtkMutableUndirectedGraph> damaged;
  vtkNew<vtkPoints> tooFew;
  tooFew->InsertNextPoint(0.5, 0.5, 0.0);
  damaged->SetPoints(tooFew);
  damaged->AddVertex();
  damaged->AddVertex();
  expectFailure(filter, doubled(), damaged, "lay the graph out");

  filter->SetMaximumSegmentLength(-1.0);
  expectFailure(filter, doubled(), line, "maximal segment length");
  filter->SetMaximumSegmentLength(1e-9);
  expectFailure(filter, doubled(), line, "same units");
  filter->SetMaximumSegmentLength(0.0);

  vtkNew<vtkImageData> stack;
  stack->SetDimensions(4, 4, 3);
  expectFailure(filter, doubled(), stack, "one slice");
  vtkNew<vtkImageData> blank;
  blank->SetDimensions(4, 4, 1);
  expectFailure(filter, doubled(), blank, "has no array");
  const auto away = picture();
  away->SetOrigin(50, 0, 0);
  expectFailure(filter, doubled(), away, "no pixel of the flat map");
  filter->SetImageSize(1, 7);
  expectFailure(filter, doubled(), picture(), "2 to 65535");
  filter->SetImageSize(0, 0);
  filter->SetImageOutputToTexturedMesh();
  expectFailure(filter, doubled(), away, "no point of the mesh");
}

TEST(PlanarWarpFilter, AMeshThatFacesDownGivesAWarning)
{
  vtkNew<vtkReverseSense> down;
  down->SetInputData(doubled());
  vtkNew<vtkPlanarWarp> filter;
  struct Counter
  {
    int Warnings = 0;
    void count() { ++this->Warnings; }
  } counter;
  filter->AddObserver(vtkCommand::WarningEvent, &counter, &Counter::count);
  filter->SetInputConnection(down->GetOutputPort());
  filter->SetCarriedData(polyline({ { 0.5, 0.5, 0 }, { 1.5, 0.5, 0 } }));
  filter->Update();
  EXPECT_EQ(counter.Warnings, 1);
}

} // namespace
