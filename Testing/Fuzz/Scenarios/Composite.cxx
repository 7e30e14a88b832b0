// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Oracles/FilterRun.h"
#include "../Oracles/SameData.h"
#include "../Surfaces/SurfaceClasses.h"
#include "Scenarios.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPolyData.h>

namespace fuzz
{
namespace
{

using Blocks = std::vector<vtkSmartPointer<vtkPolyData>>;

vtkSmartPointer<vtkDataObject> compositeOf(const Blocks& blocks, bool isPartitioned)
{
  if (isPartitioned)
  {
    const auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
    partitions->SetNumberOfPartitions(static_cast<unsigned int>(blocks.size()));
    for (unsigned int b = 0; b < blocks.size(); ++b)
    {
      partitions->SetPartition(b, blocks[b]);
    }
    return partitions;
  }
  const auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto inner = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  inner->SetNumberOfBlocks(static_cast<unsigned int>(blocks.size()));
  for (unsigned int b = 0; b < blocks.size(); ++b)
  {
    inner->SetBlock(b, blocks[b]);
  }
  tree->SetNumberOfBlocks(2); // the second stays empty
  tree->SetBlock(0, inner);
  return tree;
}

vtkDataObject* blockOf(vtkDataObject* composite, unsigned int block)
{
  if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(composite))
  {
    return block < partitions->GetNumberOfPartitions() ? partitions->GetPartition(block) : nullptr;
  }
  auto* tree = vtkMultiBlockDataSet::SafeDownCast(composite);
  auto* inner = tree ? vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(0)) : nullptr;
  return inner ? inner->GetBlock(block) : nullptr;
}

// Keeps errors and warnings from the terminal.
class Silence : public vtkCommand
{
public:
  void Execute(vtkObject*, unsigned long, void*) override {}
};

// Updates a filter whose blocks may fail one by one.
void updateBlocks(vtkAlgorithm* filter, Findings& findings)
{
  const auto silence = vtkSmartPointer<Silence>::Take(new Silence);
  filter->AddObserver(vtkCommand::ErrorEvent, silence);
  filter->AddObserver(vtkCommand::WarningEvent, silence);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  try
  {
    filter->Update();
  }
  catch (const std::exception& error)
  {
    findings.fail("exception", error.what());
  }
  filter->RemoveObserver(silence);
  filter->GetExecutive()->RemoveObserver(silence);
}

void checkBlock(const Case& one, vtkPolyData* block, vtkDataObject* result, Findings& findings)
{
  if (hasNothing(block))
  {
    findings.require(hasNothing(result), "composite", "a result for an empty block");
    return;
  }
  const Chain alone = newChain(one, false);
  alone.front()->SetInputDataObject(block);
  for (vtkAlgorithm* filter : alone)
  {
    runFilter(filter, findings);
  }
  vtkDataObject* expected = alone.back()->GetOutputDataObject(0);
  if (hasNothing(expected))
  {
    findings.require(hasNothing(result), "composite", "a failed block has data");
    return;
  }
  const std::string differs = difference(expected, result);
  findings.require(differs.empty(), "composite", "a block is not as alone: " + differs);
}

} // namespace

void runComposite(const Case& one, Findings& findings)
{
  Random random = scenarioRandom(one);
  Blocks blocks = { one.Surface };
  for (int n = random.integer(0, 3); n > 0; --n)
  {
    const int kind = random.integer(0, 2);
    const auto place = blocks.begin() + random.integer(0, static_cast<int>(blocks.size()));
    if (kind == 0)
    {
      blocks.insert(place, nullptr);
    }
    else if (kind == 1)
    {
      blocks.insert(place, vtkSmartPointer<vtkPolyData>::New());
    }
    else
    {
      blocks.insert(place, makeSurface("spheres", random));
    }
  }
  const Chain chain = newChain(one, false);
  chain.front()->SetInputDataObject(compositeOf(blocks, random.chance(0.5)));
  for (vtkAlgorithm* filter : chain)
  {
    updateBlocks(filter, findings);
  }
  for (unsigned int b = 0; b < blocks.size(); ++b)
  {
    checkBlock(one, blocks[b], blockOf(chain.back()->GetOutputDataObject(0), b), findings);
  }
}

} // namespace fuzz
