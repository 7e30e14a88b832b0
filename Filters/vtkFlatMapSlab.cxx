// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlatMapSlab.h"

#include "Core/Mesh/ClosestPointWalk.h"
#include "Internal/ArrayConversion.h"
#include "Internal/FilterExecution.h"
#include "Internal/ImageMemory.h"
#include "Internal/InnerError.h"
#include "Internal/InnerProgress.h"
#include "Internal/PatientMatrix.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/SlabLayers.h"
#include "Internal/VolumeSampling.h"
#include "vtkFlatMapImage.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkFlatMapSlab);

namespace
{

using flattening::InvalidInput;
using flattening::Points3;

constexpr const char* NormalsName = "SurfaceNormals";

constexpr const char* PixelsStage = "Looking up the pixels";

// Bytes of a pixel of Flat Map Image, whose arrays are two vectors here, and of the vectors' copies.
constexpr std::size_t BytesPerPixel = 400;

// The map as an image that has only the points of the surface under its pixels and the normals there.
vtkSmartPointer<vtkImageData> pixelsOf(vtkPolyData* map,
  int size,
  const flattening::ProgressCallback& progress)
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
  const flattening::InnerProgress forwarding(image, progress, PixelsStage);
  const flattening::InnerError error(image);
  image->Update();
  error.rethrow();
  flattening::report(progress, 1.0, PixelsStage); // throws if an abort left the image empty
  return image->GetOutput();
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
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 1)
  {
    constexpr int PlaceOfPolyData = 0; // after it come the types of composite data sets, which stay
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData", PlaceOfPolyData);
  }
  return 1;
}

const char* vtkFlatMapSlab::GetBlockOutputType(int port, vtkInformationVector** inputVector)
{
  return port == 1 ? "vtkImageData" : this->Superclass::GetBlockOutputType(port, inputVector);
}

int vtkFlatMapSlab::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (this->StackSize > 1)
  {
    flattening::updateInput(this, 0);
    flattening::updateInput(this, 1);
  }
  if (vtkPolyData* map = vtkPolyData::GetData(inputVector[0])) // not composite
  {
    vtkInformation* stack = outputVector->GetInformationObject(1);
    flattening::announceGridOver(map,
      stack,
      [this](const flattening::TextureSquare& square)
      {
        return this->StackSize > 1
                 ? flattening::stackGrid(flattening::gridOver(square, this->StackSize), this->Depths)
                 : flattening::NoImage;
      });
    if (vtkImageData* volume = vtkImageData::GetData(inputVector[1])) // not composite
    {
      const std::vector<vtkDataArray*> arrays = flattening::sampledArrays(volume);
      vtkDataArray* first = arrays.empty() ? nullptr : arrays.front();
      flattening::announceScalars(
        stack, first, first ? flattening::sampledType(first, this->NearestVoxel) : VTK_DOUBLE);
    }
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
      throw InvalidInput("the depth " + flattening::depthText(depth) + " is given twice: leave one");
    }
  }
}

void vtkFlatMapSlab::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* volume = vtkImageData::GetData(inputVector[1]);
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  flattening::report(progress, 0.0, "Reading the flat map");
  this->RequireDepths();
  const flattening::TriangleMesh surface = flattening::surfaceOfFlattened(input);
  flattening::requireOrdinarySize(surface);
  if (this->StackSize > 1)
  {
    flattening::toPlanarPositions(input); // throws if there is no flat map, which the stack needs
  }
  const Points3 normals = flattening::vertexNormals(surface);
  const double sign = this->Outwards ? 1.0 : -1.0;
  const Eigen::Affine3d toVolume = flattening::surfaceToVolume(input, volume);
  if (flattening::patientMatrix(volume) && !flattening::patientMatrix(input) &&
      !flattening::inPatientSpace(input))
  {
    vtkWarningMacro(
      << this->GetBlockPrefix()
      << "the surface does not say where it lies in the patient, though the volume does: it is "
         "taken to have the coordinates of the voxels");
  }
  const flattening::VolumeSampling sampling(
    volume, this->NearestVoxel, toVolume, flattening::subrange(progress, 0.0, 0.1));
  const flattening::Layers layers = flattening::sampleLayers(
    sampling, surface.Vertices, sign * normals, this->Depths, flattening::subrange(progress, 0.1, 0.4));

  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(flattening::newTuples<vtkDoubleArray>(NormalsName, normals));
  flattening::addSlabArrays(output, layers, this->Depths);
  const long long outside = flattening::addMask(output, layers);
  if (outside == surface.vertexCount() * static_cast<long long>(this->Depths.size()))
  {
    throw InvalidInput("no sample lies in the volume: pass the volume that the surface came from, in "
                       "the same coordinates");
  }
  flattening::setDepths(output, this->Depths);
  flattening::setDatum(output->GetFieldData(), "OutsideSamples", outside);

  vtkImageData* stack = vtkImageData::GetData(outputVector, 1);
  if (this->StackSize > 1)
  {
    flattening::requireImageMemory(this->StackSize,
      this->StackSize,
      BytesPerPixel + 2 * this->Depths.size() * flattening::bytesPerTuple(volume->GetPointData()),
      "set a smaller StackSize");
    const vtkSmartPointer<vtkImageData> pixels =
      pixelsOf(output, this->StackSize, flattening::subrange(progress, 0.4, 0.5));
    // Interpolated normals are shorter than 1.
    const Points3 direction =
      flattening::toMatrix<3>(pixels->GetPointData()->GetArray(NormalsName)).rowwise().normalized();
    flattening::fillStack(stack,
      pixels,
      flattening::sampleLayers(sampling,
        flattening::toMatrix<3>(pixels->GetPointData()->GetArray(flattening::SurfacePointsName)),
        sign * direction,
        this->Depths,
        flattening::subrange(progress, 0.5, 1.0)),
      this->Depths);
    flattening::setDepths(stack, this->Depths);
  }
  if (outside > 0)
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << outside
                    << " samples lie outside of the volume and have no value: see InVolume, and the "
                       "depths");
  }
  flattening::report(progress, 1.0, "Done");
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
