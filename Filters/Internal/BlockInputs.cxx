// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/BlockInputs.h"

#include "Core/Base/Errors.h"

#include <vtkAlgorithm.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTypes.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationStringKey.h>
#include <vtkInformationStringVectorKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <algorithm>

namespace flattening
{
namespace
{

int leafCount(vtkCompositeDataSet* data)
{
  int count = 0;
  auto leaf = leavesOf(data);
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    ++count;
  }
  return count;
}

std::string nameIn(vtkInformation* metaData)
{
  const char* name = metaData ? metaData->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? '"' + std::string(name) + '"' : std::string();
}

// Names the leaves of a tree in the order of their flat indices.
class LeafNaming
{
public:
  std::map<unsigned int, std::string> Names;

  void visit(vtkDataObject* node, const std::string& name)
  {
    const unsigned int index = this->Index++;
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
    {
      this->children(blocks->GetNumberOfBlocks(),
        [&](unsigned int i) { this->visit(blocks->GetBlock(i), childName(blocks, i, name)); });
    }
    else if (auto* sets = vtkPartitionedDataSetCollection::SafeDownCast(node))
    {
      this->children(sets->GetNumberOfPartitionedDataSets(),
        [&](unsigned int i) { this->visit(sets->GetPartitionedDataSet(i), childName(sets, i, name)); });
    }
    else if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(node))
    {
      const unsigned int count = pieces->GetNumberOfPartitions();
      this->children(count,
        [&](unsigned int i)
        {
          const std::string numbered =
            count > 1 && !name.empty() ? name + ", piece " + std::to_string(i + 1) : name;
          this->visit(pieces->GetPartitionAsDataObject(i), childName(pieces, i, numbered));
        });
    }
    else
    {
      this->Names[index] = name.empty() ? std::to_string(index) : name;
    }
  }

private:
  template <typename Visit>
  void children(unsigned int count, const Visit& visit)
  {
    for (unsigned int i = 0; i < count; ++i)
    {
      visit(i);
    }
  }

  template <typename Composite>
  static std::string childName(Composite* parent, unsigned int i, const std::string& inherited)
  {
    const std::string own = parent->HasMetaData(i) ? nameIn(parent->GetMetaData(i)) : std::string();
    return own.empty() ? inherited : own;
  }

  unsigned int Index = 0;
};

// The types of data that a block may have.
std::vector<std::string> leafTypes(vtkInformation* port)
{
  vtkInformationStringVectorKey* key = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  std::vector<std::string> types;
  for (int i = 0; i < port->Length(key); ++i)
  {
    const std::string type = port->Get(key, i);
    if (!vtkDataObjectTypes::TypeIdIsA(
          vtkDataObjectTypes::GetTypeIdFromClassName(type.c_str()), VTK_COMPOSITE_DATA_SET))
    {
      types.push_back(type);
    }
  }
  return types;
}

std::string wordFor(const std::string& type)
{
  return type == "vtkPolyData"    ? "a surface"
         : type == "vtkImageData" ? "an image"
         : type == "vtkGraph"     ? "a graph"
                                  : "a " + type;
}

bool isOfAnotherBlock(vtkSelectionNode* node, unsigned int flatIndex)
{
  vtkInformation* properties = node->GetProperties();
  return properties->Has(vtkSelectionNode::COMPOSITE_INDEX()) &&
         properties->Get(vtkSelectionNode::COMPOSITE_INDEX()) != static_cast<int>(flatIndex);
}

// A node of the same kind of elements that selects none.
vtkSmartPointer<vtkSelectionNode> nothingLike(vtkSelectionNode* node)
{
  auto nothing = vtkSmartPointer<vtkSelectionNode>::New();
  nothing->SetFieldType(node->GetFieldType());
  nothing->SetContentType(vtkSelectionNode::INDICES);
  nothing->SetSelectionList(vtkNew<vtkIdTypeArray>());
  return nothing;
}

vtkSmartPointer<vtkSelectionNode> withoutBlock(vtkSelectionNode* node)
{
  auto copy = vtkSmartPointer<vtkSelectionNode>::New();
  copy->ShallowCopy(node);
  copy->GetProperties()->Remove(vtkSelectionNode::COMPOSITE_INDEX());
  return copy;
}

// The selection with its expression as far as it concerns this block: nodes that were made for another
// block select nothing.
vtkSmartPointer<vtkSelection> selectionIn(unsigned int flatIndex, vtkSelection* selection)
{
  auto result = vtkSmartPointer<vtkSelection>::New();
  const std::string expression = selection->GetExpression();
  bool concernsBlock = expression.find('!') != std::string::npos; // what other nodes leave out
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    const bool isOther = isOfAnotherBlock(node, flatIndex);
    result->SetNode(selection->GetNodeNameAtIndex(i), isOther ? nothingLike(node) : withoutBlock(node));
    concernsBlock |= !isOther;
  }
  result->SetExpression(expression);
  if (!concernsBlock && selection->GetNumberOfNodes() > 0)
  {
    throw InvalidInput(
      "the selection has no points or cells of this block: select some, or pass the other "
      "blocks alone (Extract Block)");
  }
  return result;
}

} // namespace

int leadingPort(vtkInformationVector** inputs, int portCount)
{
  for (int port = 0; port < portCount; ++port)
  {
    if (vtkCompositeDataSet::GetData(inputs[port]))
    {
      return port;
    }
  }
  return -1;
}

vtkSmartPointer<vtkCompositeDataIterator> leavesOf(vtkCompositeDataSet* data)
{
  auto leaf = vtk::TakeSmartPointer(data->NewIterator());
  leaf->SkipEmptyNodesOff();
  return leaf;
}

std::map<unsigned int, std::string> leafNames(vtkCompositeDataSet* data)
{
  LeafNaming naming;
  naming.visit(data, {});
  return naming.Names;
}

BlockInputs::BlockInputs(vtkAlgorithm* filter, vtkInformationVector** inputs, int leadingPort)
  : Filter(filter)
{
  const int expected = leafCount(vtkCompositeDataSet::GetData(inputs[leadingPort]));
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    this->Data.emplace_back(vtkDataObject::GetData(inputs[port]));
    this->Vectors.push_back(vtkSmartPointer<vtkInformationVector>::New());
    this->Pointers.push_back(this->Vectors.back());
    auto* composite = vtkCompositeDataSet::SafeDownCast(this->Data.back());
    const int found = composite ? leafCount(composite) : expected;
    if (found != expected)
    {
      throw InvalidInput("the inputs have " + std::to_string(expected) + " and " +
                         std::to_string(found) +
                         " blocks: give both the same blocks in the same order, or one of them a single "
                         "data set");
    }
  }
}

vtkInformationVector** BlockInputs::of(vtkCompositeDataIterator* leaf)
{
  for (std::size_t port = 0; port < this->Data.size(); ++port)
  {
    vtkSmartPointer<vtkDataObject> data = this->dataOf(static_cast<int>(port), leaf);
    if (auto* selection = vtkSelection::SafeDownCast(data))
    {
      data = selectionIn(leaf->GetCurrentFlatIndex(), selection);
    }
    vtkInformationVector* vector = this->Vectors[port];
    vector->SetNumberOfInformationObjects(0);
    if (data)
    {
      vtkNew<vtkInformation> information;
      information->Set(vtkDataObject::DATA_OBJECT(), data);
      vector->Append(information);
    }
  }
  return this->Pointers.data();
}

vtkDataObject* BlockInputs::dataOf(int port, vtkCompositeDataIterator* leaf) const
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(this->Data[port]);
  if (!composite)
  {
    return this->Data[port]; // used for every block; null if the port has no data
  }
  // The blocks are paired in order, as the structures may differ: one may be multiblock and the other
  // partitioned.
  auto other = leavesOf(composite);
  auto lead = leavesOf(leaf->GetDataSet());
  other->InitTraversal();
  for (lead->InitTraversal(); lead->GetCurrentFlatIndex() != leaf->GetCurrentFlatIndex();
       lead->GoToNextItem())
  {
    other->GoToNextItem();
  }
  vtkDataObject* data = other->GetCurrentDataObject();
  this->requireType(port, data);
  return data;
}

void BlockInputs::requireType(int port, vtkDataObject* data) const
{
  if (!data)
  {
    throw InvalidInput("input " + std::to_string(port + 1) +
                       " has no data for this block: fill or remove the block there");
  }
  const std::vector<std::string> taken = leafTypes(this->Filter->GetInputPortInformation(port));
  if (std::none_of(
        taken.begin(), taken.end(), [data](const std::string& type) { return data->IsA(type.c_str()); }))
  {
    std::string expected;
    for (const std::string& type : taken)
    {
      expected += (expected.empty() ? "" : " or ") + wordFor(type);
    }
    const bool takesSurface = std::find(taken.begin(), taken.end(), "vtkPolyData") != taken.end();
    throw InvalidInput(
      "it is a " + std::string(data->GetClassName()) + ", not " + expected +
      (takesSurface ? ": run Extract Surface first" : ": remove the block, or put one in its place"));
  }
}

} // namespace flattening
