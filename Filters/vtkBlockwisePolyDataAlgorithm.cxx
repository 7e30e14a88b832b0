// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkBlockwisePolyDataAlgorithm.h"

#include "Internal/BlockInputs.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/WholeArrays.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTypes.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <array>

namespace
{

constexpr std::array<const char*, 3> CompositeTypes = { "vtkMultiBlockDataSet",
  "vtkPartitionedDataSet",
  "vtkPartitionedDataSetCollection" };
constexpr const char* BlockErrorsName = "BlockErrors";

bool hasResult(vtkDataObject* data)
{
  return data->GetNumberOfElements(vtkDataObject::POINT) > 0 ||
         data->GetNumberOfElements(vtkDataObject::CELL) > 0 ||
         data->GetNumberOfElements(vtkDataObject::VERTEX) > 0 ||
         data->GetNumberOfElements(vtkDataObject::ROW) > 0;
}

// Appends the errors to those of the filters before, which came with the field data of the input.
void addBlockErrors(vtkFieldData* data, const std::vector<std::string>& errors)
{
  vtkNew<vtkStringArray> all;
  all->SetName(BlockErrorsName);
  if (auto* earlier = vtkStringArray::SafeDownCast(data->GetAbstractArray(BlockErrorsName)))
  {
    all->DeepCopy(earlier);
  }
  for (const std::string& error : errors)
  {
    all->InsertNextValue(error);
  }
  flattening::setDatum(data, "FailedBlocks", static_cast<long long>(all->GetNumberOfValues()));
  if (all->GetNumberOfValues() > 0)
  {
    data->AddArray(all);
  }
}

// Gives every output the field data of the first one. Before, the others have the field data of the
// input, where a value of an earlier filter may have the same name.
void shareFieldData(vtkInformationVector* outputs)
{
  vtkFieldData* data = vtkDataObject::GetData(outputs, 0)->GetFieldData();
  for (int port = 1; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->GetFieldData()->ShallowCopy(data);
  }
}

} // namespace

vtkTypeBool vtkBlockwisePolyDataAlgorithm::ProcessRequest(vtkInformation* request,
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->CreateOutputs(inputVector, outputVector);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    const int leading = flattening::leadingPort(inputVector, this->GetNumberOfInputPorts());
    if (leading >= 0)
    {
      return this->RequestBlocks(inputVector, outputVector, leading);
    }
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

void vtkBlockwisePolyDataAlgorithm::RecordBlockError(const std::string& message)
{
  this->BlockErrors.push_back(message);
}

int vtkBlockwisePolyDataAlgorithm::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  for (const char* type : CompositeTypes)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
  return 1;
}

int vtkBlockwisePolyDataAlgorithm::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

const char* vtkBlockwisePolyDataAlgorithm::GetBlockOutputType(int vtkNotUsed(port),
  vtkInformationVector** vtkNotUsed(inputVector))
{
  return "vtkPolyData";
}

int vtkBlockwisePolyDataAlgorithm::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputVector[port]->GetInformationObject(i);
      if (input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
      {
        input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
          input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()),
          6);
      }
    }
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkBlockwisePolyDataAlgorithm::CreateOutputs(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  const int leading = flattening::leadingPort(inputVector, this->GetNumberOfInputPorts());
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const char* type = leading >= 0 ? vtkDataObject::GetData(inputVector[leading])->GetClassName()
                                    : this->GetBlockOutputType(port, inputVector);
    vtkDataObject* output = vtkDataObject::GetData(outputVector, port);
    if (!output || std::string(output->GetClassName()) != type)
    {
      const auto created = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type));
      outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), created);
    }
  }
  return 1;
}

bool vtkBlockwisePolyDataAlgorithm::HasInputs(vtkInformationVector** inputVector)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    const bool optional =
      this->GetInputPortInformation(port)->Get(vtkAlgorithm::INPUT_IS_OPTIONAL()) != 0;
    if (!optional && flattening::isEmpty(vtkDataObject::GetData(inputVector[port])))
    {
      return false;
    }
  }
  return true;
}

int vtkBlockwisePolyDataAlgorithm::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (!this->HasInputs(inputVector))
  {
    return 1;
  }
  return flattening::runFilter(this,
    outputVector,
    [&]
    {
      flattening::requireWholeArrays(inputVector, this->GetNumberOfInputPorts());
      this->Execute(inputVector, outputVector);
      shareFieldData(outputVector);
    });
}

void vtkBlockwisePolyDataAlgorithm::CreateBlockOutputs(vtkInformationVector** blockInputs,
  vtkInformationVector* results)
{
  vtkDataObject* first = vtkDataObject::GetData(blockInputs[0]);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const auto result = vtk::TakeSmartPointer(
      vtkDataObjectTypes::NewDataObject(this->GetBlockOutputType(port, blockInputs)));
    if (first) // as the pipeline does with inputs that are not composite
    {
      result->GetFieldData()->PassData(first->GetFieldData());
    }
    vtkNew<vtkInformation> information;
    information->Set(vtkDataObject::DATA_OBJECT(), result);
    results->Append(information);
  }
}

void vtkBlockwisePolyDataAlgorithm::ExecuteBlock(flattening::BlockInputs& inputs,
  vtkCompositeDataIterator* leaf,
  const std::vector<vtkCompositeDataSet*>& outputs)
{
  vtkNew<vtkInformationVector> results;
  flattening::runFilter(this,
    results,
    [&]
    {
      vtkInformationVector** blockInputs = inputs.of(leaf);
      this->CreateBlockOutputs(blockInputs, results);
      if (this->HasInputs(blockInputs))
      {
        flattening::requireWholeArrays(blockInputs, this->GetNumberOfInputPorts());
        this->Execute(blockInputs, results);
        shareFieldData(results);
      }
    });
  for (std::size_t port = 0; port < outputs.size(); ++port)
  {
    vtkDataObject* result = vtkDataObject::GetData(results, static_cast<int>(port));
    outputs[port]->SetDataSet(leaf, result && hasResult(result) ? result : nullptr);
  }
}

int vtkBlockwisePolyDataAlgorithm::RequestBlocks(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector,
  int leadingPort)
{
  auto* input = vtkCompositeDataSet::GetData(inputVector[leadingPort]);
  std::vector<vtkCompositeDataSet*> outputs;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs.push_back(vtkCompositeDataSet::GetData(outputVector, port));
    outputs.back()->CopyStructure(input);
  }
  this->BlockErrors.clear();
  flattening::runFilter(this,
    outputVector,
    [&]
    {
      flattening::BlockInputs inputs(this, inputVector, leadingPort);
      const auto names = flattening::leafNames(input);
      auto leaf = vtk::TakeSmartPointer(input->NewIterator()); // the leaves with data
      double count = 0.0;
      for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
      {
        count += 1.0;
      }
      double done = 0.0;
      for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
      {
        this->BlockPrefix = "block " + names.at(leaf->GetCurrentFlatIndex()) + ": ";
        this->SetProgressShiftScale(done / count, 1.0 / count);
        this->ExecuteBlock(inputs, leaf, outputs);
        this->BlockPrefix.clear();
        this->SetProgressShiftScale(0.0, 1.0);
        if (flattening::abortRequested(this))
        {
          throw flattening::Cancelled();
        }
        done += 1.0;
      }
      for (vtkCompositeDataSet* output : outputs)
      {
        addBlockErrors(output->GetFieldData(), this->BlockErrors);
      }
    });
  return 1;
}
