// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlatMapSlab.h"

#include "Core/SurfaceWalk.h"
#include "FilterExecution.h"
#include "PolyDataConversion.h"
#include "VolumeSampling.h"
#include "vtkFlatMapImage.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkFlatMapSlab);

namespace
{

using flattening::InvalidInput;
using flattening::Points3;
using flattening::VolumeSamples;

constexpr const char* NormalsName = "SurfaceNormals";

// One entry per depth, each with one per array of the volume.
using Layers = std::vector<std::vector<VolumeSamples>>;

Layers sampleLayers(const flattening::VolumeSampling& volume,
  const Points3& points,
  const Points3& inward,
  const std::vector<double>& depths,
  const flattening::ProgressCallback& progress)
{
  Layers layers;
  for (const double depth : depths)
  {
    flattening::report(
      progress, static_cast<double>(layers.size()) / depths.size(), "Sampling the volume");
    layers.push_back(volume.at(points + depth * inward));
  }
  return layers;
}

std::string textOf(double depth)
{
  std::ostringstream text;
  text << depth;
  return text.str();
}

// Per array of the volume one with the layers side by side, a component each.
void addSlabArrays(vtkPolyData* output, const Layers& layers, const std::vector<double>& depths)
{
  for (std::size_t a = 0; a < layers.front().size(); ++a)
  {
    vtkFloatArray* first = layers.front()[a].Values;
    const int width = first->GetNumberOfComponents();
    vtkNew<vtkFloatArray> slab;
    slab->SetName((std::string(first->GetName()) + "Slab").c_str());
    slab->SetNumberOfComponents(width * static_cast<int>(depths.size()));
    slab->SetNumberOfTuples(first->GetNumberOfTuples());
    for (std::size_t d = 0; d < depths.size(); ++d)
    {
      for (int k = 0; k < width; ++k)
      {
        const int component = static_cast<int>(d) * width + k;
        slab->CopyComponent(component, layers[d][a].Values, k);
        slab->SetComponentName(component,
          (textOf(depths[d]) + (width > 1 ? "_" + std::to_string(k) : std::string())).c_str());
      }
    }
    output->GetPointData()->AddArray(slab);
  }
}

// Returns how many samples are outside.
long long addMask(vtkPolyData* output, const Layers& layers)
{
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("InVolume");
  mask->SetNumberOfComponents(static_cast<int>(layers.size()));
  mask->SetNumberOfTuples(output->GetNumberOfPoints());
  long long outside = 0;
  for (std::size_t d = 0; d < layers.size(); ++d)
  {
    const std::vector<char>& inside = layers[d].front().Inside;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      mask->SetTypedComponent(i, static_cast<int>(d), inside[i] ? 1 : 0);
      outside += !inside[i];
    }
  }
  output->GetPointData()->AddArray(mask);
  return outside;
}

void addVectors(vtkPolyData* data, const char* name, const Points3& vectors)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(vectors.rows());
  for (Eigen::Index i = 0; i < vectors.rows(); ++i)
  {
    array->SetTuple(i, vectors.row(i).data());
  }
  data->GetPointData()->AddArray(array);
}

Points3 vectorsOf(vtkDataArray* array)
{
  Points3 vectors(array->GetNumberOfTuples(), 3);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, vectors.row(i).data());
  }
  return vectors;
}

// The map as an image with nothing but where its pixels are in space, and the normals there.
vtkSmartPointer<vtkImageData> pixelsOf(vtkPolyData* map, int size)
{
  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(map);
  for (const char* name : { flattening::SurfacePointsName, NormalsName })
  {
    bare->GetPointData()->AddArray(map->GetPointData()->GetArray(name));
  }
  vtkNew<vtkFlatMapImage> image;
  image->SetInputData(bare);
  image->SetSize(size);
  image->SetMargin(0);
  image->Update();
  return image->GetOutput();
}

bool haveEqualSteps(const std::vector<double>& depths)
{
  for (std::size_t d = 2; d < depths.size(); ++d)
  {
    const double first = depths[1] - depths[0];
    if (std::abs(depths[d] - depths[d - 1] - first) > 1e-6 * std::abs(first))
    {
      return false;
    }
  }
  return depths.size() > 1 && depths[1] > depths[0];
}

void fillStack(vtkImageData* stack,
  vtkImageData* pixels,
  const Layers& layers,
  const std::vector<double>& depths)
{
  const bool isDepth = haveEqualSteps(depths);
  const auto count = static_cast<int>(depths.size());
  const double length = pixels->GetSpacing()[0];
  stack->SetDimensions(pixels->GetDimensions()[0], pixels->GetDimensions()[1], count);
  stack->SetSpacing(length, length, isDepth ? depths[1] - depths[0] : length);
  stack->SetOrigin(pixels->GetOrigin()[0], pixels->GetOrigin()[1], isDepth ? depths[0] : 0.0);
  const vtkIdType perLayer = pixels->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("InVolume");
  mask->SetNumberOfTuples(perLayer * count);
  for (std::size_t a = 0; a < layers.front().size(); ++a)
  {
    vtkFloatArray* first = layers.front()[a].Values;
    vtkNew<vtkFloatArray> values;
    values->SetName(first->GetName());
    values->SetNumberOfComponents(first->GetNumberOfComponents());
    values->SetNumberOfTuples(perLayer * count);
    for (int d = 0; d < count; ++d)
    {
      values->InsertTuples(d * perLayer, perLayer, 0, layers[d][a].Values);
      for (vtkIdType i = 0; i < perLayer; ++i)
      {
        mask->SetValue(d * perLayer + i, layers[d][a].Inside[i] ? 1 : 0);
      }
    }
    a == 0 ? stack->GetPointData()->SetScalars(values) : stack->GetPointData()->AddArray(values);
  }
  stack->GetPointData()->AddArray(mask);
}

void setDepths(vtkDataObject* output, const std::vector<double>& depths)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Depths");
  for (const double depth : depths)
  {
    array->InsertNextValue(depth);
  }
  output->GetFieldData()->AddArray(array);
}

} // namespace

vtkFlatMapSlab::vtkFlatMapSlab()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

void vtkFlatMapSlab::SetVolumeData(vtkImageData* volume)
{
  this->SetInputData(1, volume);
}

void vtkFlatMapSlab::AddDepth(double depth)
{
  this->Depths.push_back(depth);
  this->Modified();
}

double vtkFlatMapSlab::GetDepth(int i)
{
  return i >= 0 && i < this->GetNumberOfDepths() ? this->Depths[i]
                                                 : std::numeric_limits<double>::quiet_NaN();
}

void vtkFlatMapSlab::ClearDepths()
{
  this->Depths.clear();
  this->Modified();
}

vtkImageData* vtkFlatMapSlab::GetStack()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkFlatMapSlab::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

const char* vtkFlatMapSlab::GetBlockOutputType(int port)
{
  return port == 1 ? "vtkImageData" : this->Superclass::GetBlockOutputType(port);
}

int vtkFlatMapSlab::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector),
  vtkInformationVector* outputVector)
{
  const int layers = this->StackSize > 0 ? this->GetNumberOfDepths() : 0;
  const int extent[6] = { 0, this->StackSize - 1, 0, this->StackSize - 1, 0, layers - 1 };
  outputVector->GetInformationObject(1)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkFlatMapSlab::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* vtkNotUsed(outputVector))
{
  // Else the extent of the stack would be asked of the volume.
  vtkInformation* volume = inputVector[1]->GetInformationObject(0);
  if (volume && volume->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    volume->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
      volume->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()),
      6);
  }
  return 1;
}

void vtkFlatMapSlab::RequireDepths() const
{
  if (this->Depths.empty())
  {
    throw InvalidInput("there is no depth: add one, such as 0");
  }
  for (std::size_t d = 0; d < this->Depths.size(); ++d)
  {
    const double depth = this->Depths[d];
    if (!std::isfinite(depth))
    {
      throw InvalidInput("a depth is not a number: give lengths in the units of the surface");
    }
    if (std::find(this->Depths.begin(), this->Depths.begin() + d, depth) != this->Depths.begin() + d)
    {
      throw InvalidInput("the depth " + textOf(depth) + " is given twice: leave one");
    }
  }
}

int vtkFlatMapSlab::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* volume = vtkImageData::GetData(inputVector[1]);
  if (flattening::isEmpty(input) || !volume || volume->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  return flattening::runFilter(this,
    outputVector,
    [&]
    {
      const flattening::ProgressCallback progress = flattening::progressOf(this);
      flattening::report(progress, 0.0, "Reading the flat map");
      this->RequireDepths();
      const flattening::TriangleMesh surface = flattening::surfaceOfFlattened(input);
      const Points3 normals = flattening::vertexNormals(surface);
      const double sign = this->Outwards ? 1.0 : -1.0;
      const flattening::VolumeSampling sampling(volume, this->NearestVoxel);
      const Layers layers = sampleLayers(sampling,
        surface.Vertices,
        sign * normals,
        this->Depths,
        flattening::subrange(progress, 0.1, 0.4));

      vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
      output->ShallowCopy(input);
      addVectors(output, NormalsName, normals);
      addSlabArrays(output, layers, this->Depths);
      const long long outside = addMask(output, layers);
      if (outside == surface.vertexCount() * static_cast<long long>(this->Depths.size()))
      {
        throw InvalidInput(
          "no sample lies in the volume: pass the volume that the surface came from, in "
          "the same coordinates");
      }
      setDepths(output, this->Depths);
      flattening::setFigure(output->GetFieldData(), "OutsideSamples", outside);

      vtkImageData* stack = vtkImageData::GetData(outputVector, 1);
      if (this->StackSize > 1)
      {
        flattening::report(progress, 0.4, "Looking up the pixels");
        const vtkSmartPointer<vtkImageData> pixels = pixelsOf(output, this->StackSize);
        // Interpolated normals are shorter than 1.
        const Points3 direction =
          vectorsOf(pixels->GetPointData()->GetArray(NormalsName)).rowwise().normalized();
        fillStack(stack,
          pixels,
          sampleLayers(sampling,
            vectorsOf(pixels->GetPointData()->GetArray(flattening::SurfacePointsName)),
            sign * direction,
            this->Depths,
            flattening::subrange(progress, 0.5, 1.0)),
          this->Depths);
        setDepths(stack, this->Depths);
      }
      if (outside > 0)
      {
        vtkWarningMacro(<< this->GetBlockPrefix() << outside
                        << " samples lie outside of the volume and have no value: see InVolume, and the "
                           "depths");
      }
      flattening::report(progress, 1.0, "Done");
    });
}

void vtkFlatMapSlab::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Depths:";
  for (const double depth : this->Depths)
  {
    os << " " << depth;
  }
  os << "\n";
  os << indent << "Outwards: " << this->Outwards << "\n";
  os << indent << "NearestVoxel: " << this->NearestVoxel << "\n";
  os << indent << "StackSize: " << this->StackSize << "\n";
}
