// SPDX-License-Identifier: GPL-3.0-or-later
/// Composite data sets: each block as on its own, a bad one named and left out.
#include "AnalyticSurfaces.h"
#include "FilterTest.h"

#include <vtkAreaWeights.h>
#include <vtkConformalDiskFilter.h>
#include <vtkDistortionMetrics.h>
#include <vtkFlatMapTransfer.h>
#include <vtkFlattenRegion.h>
#include <vtkMeshSaliency.h>
#include <vtkOMTAreaPreservingFilter.h>
#include <vtkSurfaceToDiskFilter.h>

#include <vtkCompositeDataIterator.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace flattening::analytic;
using namespace flattening::testing;

// A cap of a sphere, with the label 4 on its upper part.
vtkSmartPointer<vtkPolyData> cap(double angle, int vertices)
{
  const auto data = polyDataOf(sunflowerMesh(sphericalCap(angle), vertices).Mesh);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    labels->InsertNextValue(data->GetPoint(i)[2] > 0.8 ? 4 : 1);
  }
  data->GetPointData()->AddArray(labels);
  return data;
}

// Two of its points are gone from the data set: no filter takes it.
vtkSmartPointer<vtkPolyData> damaged()
{
  const auto data = cap(1.0, 300);
  data->GetPoints()->SetNumberOfPoints(data->GetNumberOfPoints() - 2);
  data->GetPointData()->Initialize();
  return data;
}

template <typename Composite>
void name(Composite* parent, unsigned int child, const char* text)
{
  parent->GetMetaData(child)->Set(vtkCompositeDataSet::NAME(), text);
}

// left | damaged | (an empty block) | group: right
vtkSmartPointer<vtkMultiBlockDataSet> blocks(vtkDataObject* left,
  vtkDataObject* bad,
  vtkDataObject* right)
{
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, right);
  name(group.Get(), 0, "right");
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  all->SetBlock(0, left);
  name(all.Get(), 0, "left");
  all->SetBlock(1, bad);
  name(all.Get(), 1, "crushed");
  all->SetBlock(2, nullptr);
  all->SetBlock(3, group);
  name(all.Get(), 3, "group");
  return all;
}

std::vector<vtkDataObject*> leaves(vtkDataObject* composite)
{
  std::vector<vtkDataObject*> result;
  auto leaf = vtk::TakeSmartPointer(vtkCompositeDataSet::SafeDownCast(composite)->NewIterator());
  leaf->SkipEmptyNodesOff();
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    result.push_back(leaf->GetCurrentDataObject());
  }
  return result;
}

// The same points to the last bit, the same arrays, the same figures.
void expectSame(vtkDataObject* found, vtkDataObject* expected)
{
  ASSERT_NE(found, nullptr);
  ASSERT_STREQ(found->GetClassName(), expected->GetClassName());
  EXPECT_EQ(found->GetFieldData()->GetNumberOfArrays(), expected->GetFieldData()->GetNumberOfArrays());
  for (int i = 0; i < expected->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* figures = expected->GetFieldData()->GetArray(i);
    vtkDataArray* others = figures ? found->GetFieldData()->GetArray(figures->GetName()) : nullptr;
    for (vtkIdType k = 0; others && k < figures->GetNumberOfTuples(); ++k)
    {
      EXPECT_EQ(others->GetComponent(k, 0), figures->GetComponent(k, 0)) << figures->GetName();
    }
  }
  if (auto* table = vtkTable::SafeDownCast(expected))
  {
    ASSERT_EQ(vtkTable::SafeDownCast(found)->GetNumberOfRows(), table->GetNumberOfRows());
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    {
      EXPECT_EQ(vtkTable::SafeDownCast(found)->GetValue(0, column).ToString(),
        table->GetValue(0, column).ToString());
    }
    return;
  }
  auto* surface = vtkPolyData::SafeDownCast(expected);
  auto* other = vtkPolyData::SafeDownCast(found);
  ASSERT_GT(surface->GetNumberOfCells(), 0);
  ASSERT_EQ(other->GetNumberOfCells(), surface->GetNumberOfCells());
  ASSERT_EQ(other->GetNumberOfPoints(), surface->GetNumberOfPoints());
  EXPECT_EQ(other->GetPointData()->GetNumberOfArrays(), surface->GetPointData()->GetNumberOfArrays());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double y[3];
    surface->GetPoint(i, x);
    other->GetPoint(i, y);
    ASSERT_TRUE(x[0] == y[0] && x[1] == y[1] && x[2] == y[2]) << i;
  }
}

// Runs a filter on the blocks, and on their surfaces one by one: @p makeInput prepares what the filter
// takes.
template <typename Filter>
void expectBlockwise(const std::function<void(Filter*)>& set,
  const std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData*)>& makeInput)
{
  const auto left = makeInput(cap(1.2, 400));
  const auto right = makeInput(cap(2.0, 600));
  const auto input = blocks(left, damaged(), right);
  vtkNew<Filter> filter;
  set(filter);
  ErrorLog errors(filter);
  filter->SetInputDataObject(0, input);
  filter->Update();

  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("block \"crushed\": "), std::string::npos)
    << errors.messages().front();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    ASSERT_STREQ(output->GetClassName(), "vtkMultiBlockDataSet");
    EXPECT_EQ(figure(output, "FailedBlocks"), 1.0);
    auto* texts = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("BlockErrors"));
    ASSERT_NE(texts, nullptr);
    ASSERT_EQ(texts->GetNumberOfValues(), 1);
    EXPECT_EQ(texts->GetValue(0).find("block \"crushed\": "), 0u) << texts->GetValue(0);
    const std::vector<vtkDataObject*> found = leaves(output);
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[1], nullptr);
    EXPECT_EQ(found[2], nullptr);
    EXPECT_STREQ(
      vtkMultiBlockDataSet::SafeDownCast(output)->GetMetaData(3u)->Get(vtkCompositeDataSet::NAME()),
      "group");
    for (const auto& [block, surface] : { std::pair(0, left), std::pair(3, right) })
    {
      SCOPED_TRACE(block);
      vtkNew<Filter> alone;
      set(alone);
      alone->SetInputData(surface);
      alone->Update();
      expectSame(found[block], alone->GetOutputDataObject(port));
    }
  }

  // A single surface again, then blocks again: no trace of what was before.
  filter->SetInputDataObject(0, right);
  filter->Update();
  ASSERT_NE(filter->GetOutput(), nullptr);
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("FailedBlocks"));
  EXPECT_EQ(errors.messages().size(), 1u);
}

vtkSmartPointer<vtkPolyData> itself(vtkPolyData* surface)
{
  return surface;
}

template <typename Filter>
vtkSmartPointer<vtkPolyData> applied(vtkPolyData* surface)
{
  vtkNew<Filter> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> conformal(vtkPolyData* surface)
{
  return applied<vtkConformalDiskFilter>(surface);
}

TEST(CompositeData, SurfaceToDisk)
{
  expectBlockwise<vtkSurfaceToDiskFilter>([](vtkSurfaceToDiskFilter*) {}, itself);
}

TEST(CompositeData, ConformalDisk)
{
  expectBlockwise<vtkConformalDiskFilter>([](vtkConformalDiskFilter*) {}, itself);
}

TEST(CompositeData, OMTAreaPreserving)
{
  expectBlockwise<vtkOMTAreaPreservingFilter>([](vtkOMTAreaPreservingFilter*) {}, conformal);
}

TEST(CompositeData, DistortionMetrics)
{
  expectBlockwise<vtkDistortionMetrics>([](vtkDistortionMetrics*) {}, conformal);
}

TEST(CompositeData, MeshSaliency)
{
  expectBlockwise<vtkMeshSaliency>([](vtkMeshSaliency*) {}, itself);
}

TEST(CompositeData, AreaWeights)
{
  expectBlockwise<vtkAreaWeights>(
    [](vtkAreaWeights* filter)
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Label");
      filter->SetLabel(4);
    },
    itself);
}

TEST(CompositeData, FlattenRegion)
{
  expectBlockwise<vtkFlattenRegion>(
    [](vtkFlattenRegion* filter)
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Label");
      filter->SetLabel(4);
    },
    itself);
}

// A chain of filters: a block that failed in the first is not tried again, and its error comes along.
TEST(CompositeData, ErrorsComeAlong)
{
  const auto input = blocks(cap(1.2, 400), damaged(), cap(2.0, 600));
  vtkNew<vtkConformalDiskFilter> flatten;
  flatten->SetInputDataObject(0, input);
  vtkNew<vtkOMTAreaPreservingFilter> areaPreserving;
  areaPreserving->SetInputConnection(flatten->GetOutputPort());
  vtkNew<vtkDistortionMetrics> metrics;
  metrics->SetInputConnection(areaPreserving->GetOutputPort());
  ErrorLog first(flatten);
  ErrorLog second(areaPreserving);
  ErrorLog third(metrics);
  metrics->Update();
  EXPECT_EQ(first.messages().size(), 1u);
  EXPECT_TRUE(second.messages().empty());
  EXPECT_TRUE(third.messages().empty());
  vtkDataObject* output = metrics->GetOutputDataObject(0);
  EXPECT_EQ(figure(output, "FailedBlocks"), 1.0);
  for (const int block : { 0, 3 })
  {
    EXPECT_GT(figure(leaves(output)[block], "FacesWithin2Percent"), 95.0);
    EXPECT_FALSE(leaves(output)[block]->GetFieldData()->HasArray("FailedBlocks"));
  }
}

TEST(CompositeData, PartitionedCollection)
{
  const auto first = cap(1.2, 400);
  const auto second = cap(2.0, 600);
  vtkNew<vtkPartitionedDataSetCollection> input;
  input->SetNumberOfPartitionedDataSets(2);
  input->SetPartition(0, 0, first);
  input->SetPartition(1, 0, second);
  input->SetPartition(1, 1, damaged());
  name(input.Get(), 1, "brains");
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputDataObject(0, input);
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find("block \"brains\", piece 2: "), std::string::npos)
    << errors.messages().front();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  expectSame(output->GetPartition(0, 0), conformal(first));
  expectSame(output->GetPartition(1, 0), conformal(second));
  EXPECT_EQ(output->GetPartitionAsDataObject(1, 1), nullptr);
}

TEST(CompositeData, BlockWithoutName)
{
  vtkNew<vtkPartitionedDataSet> input;
  input->SetPartition(0, cap(1.2, 400));
  input->SetPartition(1, vtkNew<vtkUnstructuredGrid>().Get());
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputDataObject(0, input);
  ErrorLog errors(filter);
  filter->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(
    errors.messages().front().find("block 2: it is a vtkUnstructuredGrid, not a surface: run Extract"),
    std::string::npos)
    << errors.messages().front();
  EXPECT_NE(leaves(filter->GetOutputDataObject(0))[0], nullptr);
}

// Two composite inputs go together block by block; a single surface serves all blocks.
TEST(CompositeData, TwoInputs)
{
  const auto left = cap(1.2, 400);
  const auto right = cap(2.0, 600);
  const auto flat = blocks(conformal(left), nullptr, conformal(right));
  vtkNew<vtkFlatMapTransfer> transfer;
  transfer->SetInputDataObject(0, flat);
  transfer->SetInputDataObject(1, blocks(left, nullptr, right));
  ErrorLog errors(transfer);
  transfer->Update();
  EXPECT_TRUE(errors.messages().empty());
  const std::vector<vtkDataObject*> found = leaves(transfer->GetOutputDataObject(0));
  EXPECT_EQ(figure(found[0], "TransferredPoints"), left->GetNumberOfPoints());
  EXPECT_EQ(figure(found[3], "TransferredPoints"), right->GetNumberOfPoints());
  EXPECT_EQ(figure(found[3], "LostPoints"), 0.0);

  vtkNew<vtkPartitionedDataSet> fewer;
  fewer->SetPartition(0, left);
  transfer->SetInputDataObject(1, fewer);
  transfer->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(
    errors.messages().back().find("4 and 1 blocks: give both the same blocks"), std::string::npos)
    << errors.messages().back();
  EXPECT_EQ(transfer->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);

  transfer->SetInputDataObject(1, blocks(left, nullptr, nullptr));
  transfer->Update();
  ASSERT_EQ(errors.messages().size(), 2u);
  EXPECT_NE(errors.messages().back().find("block \"right\": input 2 has no data for this block"),
    std::string::npos)
    << errors.messages().back();

  transfer->SetInputDataObject(1, left);
  transfer->Update();
  EXPECT_EQ(
    figure(leaves(transfer->GetOutputDataObject(0))[0], "TransferredPoints"), left->GetNumberOfPoints());
}

// A selection made in one block leaves the others alone.
TEST(CompositeData, SelectionOfABlock)
{
  const auto left = cap(1.2, 400);
  const auto right = cap(2.0, 600);
  vtkNew<vtkIdTypeArray> ids;
  for (vtkIdType i = 0; i < 50; ++i)
  {
    ids->InsertNextValue(i);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetFieldType(vtkSelectionNode::POINT);
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetSelectionList(ids);
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 1); // left: the root is 0
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);

  vtkNew<vtkAreaWeights> weights;
  weights->SetWeightsFrom(vtkAreaWeights::SELECTION);
  weights->SetFactor(2.0);
  weights->SetInputDataObject(0, blocks(left, nullptr, right));
  weights->SetInputDataObject(1, selection);
  ErrorLog errors(weights);
  weights->Update();
  ASSERT_EQ(errors.messages().size(), 1u);
  EXPECT_NE(errors.messages().front().find(
              "block \"right\": the selection has no points or cells of this block"),
    std::string::npos)
    << errors.messages().front();
  const std::vector<vtkDataObject*> found = leaves(weights->GetOutputDataObject(0));
  EXPECT_EQ(figure(found[0], "RegionPoints"), 50.0);
  EXPECT_EQ(found[3], nullptr);
}

// The same points are selected in a block as in the same data alone, by any expression.
TEST(CompositeData, ASelectionKeepsItsExpression)
{
  const auto left = cap(1.2, 400);
  const auto right = cap(2.0, 600);
  const auto pointsOf = [](vtkIdType first, vtkIdType last)
  {
    vtkNew<vtkIdTypeArray> ids;
    for (vtkIdType i = first; i < last; ++i)
    {
      ids->InsertNextValue(i);
    }
    auto node = vtkSmartPointer<vtkSelectionNode>::New();
    node->SetFieldType(vtkSelectionNode::POINT);
    node->SetContentType(vtkSelectionNode::INDICES);
    node->SetSelectionList(ids);
    node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 1); // left: the root is 0
    return node;
  };
  vtkNew<vtkSelection> selection;
  selection->SetNode("a", pointsOf(0, 50));
  selection->SetNode("b", pointsOf(20, 30));

  vtkNew<vtkAreaWeights> weights;
  weights->SetWeightsFrom(vtkAreaWeights::SELECTION);
  weights->SetFactor(2.0);
  weights->SetInputDataObject(0, blocks(left, nullptr, right));
  weights->SetInputDataObject(1, selection);
  const auto selected = [&weights](const std::string& expression, std::size_t leaf)
  {
    vtkSelection::SafeDownCast(weights->GetInputDataObject(1, 0))->SetExpression(expression);
    weights->Modified();
    weights->Update();
    vtkDataObject* found = leaves(weights->GetOutputDataObject(0))[leaf];
    return found ? figure(found, "RegionPoints") : -1.0;
  };
  const auto inLeft = static_cast<double>(left->GetNumberOfPoints());
  ErrorLog errors(weights);
  EXPECT_EQ(selected("!a", 0), inLeft - 50.0);
  ASSERT_EQ(errors.messages().size(), 1u); // no point of the other block is in a
  EXPECT_NE(errors.messages().front().find("block \"right\": the regions cover the whole surface"),
    std::string::npos)
    << errors.messages().front();
  EXPECT_EQ(selected("a&!b", 0), 40.0);
  EXPECT_EQ(selected("a&!b", 3), -1.0) << "nothing is selected in this block";
  EXPECT_EQ(selected("a&b", 0), 10.0);
  EXPECT_EQ(selected("a&b", 3), -1.0);
}

// Over all blocks progress runs once from 0 to 1.
TEST(CompositeData, ProgressAndAbort)
{
  struct Watch : vtkCommand
  {
    std::vector<double> Fractions;
    double AbortAt = 2.0;
    void Execute(vtkObject* caller, unsigned long, void* fraction) override
    {
      this->Fractions.push_back(*static_cast<double*>(fraction));
      if (this->Fractions.back() >= this->AbortAt)
      {
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
    }
  };
  vtkNew<vtkConformalDiskFilter> filter;
  filter->SetInputDataObject(0, blocks(cap(1.2, 400), cap(1.5, 500), cap(2.0, 600)));
  auto watch = vtkSmartPointer<Watch>::Take(new Watch);
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  ASSERT_GT(watch->Fractions.size(), 10u);
  EXPECT_TRUE(std::is_sorted(watch->Fractions.begin(), watch->Fractions.end()));
  EXPECT_LT(watch->Fractions.front(), 0.1);
  EXPECT_NEAR(watch->Fractions.back(), 1.0, 1e-12);

  watch->AbortAt = 0.5; // in the second block
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  watch->AbortAt = 2.0;
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_NE(leaves(filter->GetOutputDataObject(0))[3], nullptr);
}

} // namespace
