// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkVolumeToSurface.h"

#include "Internal/FilterExecution.h"
#include "Internal/PatientMatrix.h"
#include "Internal/VolumeContour.h"
#include "Internal/VolumeReport.h"
#include "vtkPatientSpace.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkVolumeToSurface);

namespace
{

using flattening::InvalidInput;

// Standard deviation of the automatic smoothing, in voxels. Measured on the brain of ch2bet.nii.gz at
// 40: 103 handles and 266 components with 0, 15 and 36 with 1, none and 5 with 2; more closes folds.
constexpr double AutomaticVoxels = 2.0;

bool isWhole(vtkDataArray* values)
{
  return values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE;
}

// Whether the volume, of which only a part was asked for, is too large.
bool isPart(vtkInformation* information, vtkImageData* volume)
{
  vtkInformationIntegerVectorKey* whole = vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT();
  return information->Has(whole) &&
         !std::equal(volume->GetExtent(), volume->GetExtent() + 6, information->Get(whole));
}

void moveToPatient(vtkPolyData* surface)
{
  vtkNew<vtkPatientSpace> patientSpace;
  patientSpace->SetInputData(surface);
  patientSpace->Update();
  surface->ShallowCopy(patientSpace->GetOutput());
}

} // namespace

vtkVolumeToSurface::vtkVolumeToSurface()
{
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkTable* vtkVolumeToSurface::GetReport()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkVolumeToSurface::GetHistogram()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkVolumeToSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  constexpr int PlaceOfPolyData = 0; // after it come the types of composite data sets, which stay
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData", PlaceOfPolyData);
  return 1;
}

const char* vtkVolumeToSurface::GetBlockOutputType(int port, vtkInformationVector** inputVector)
{
  return port > 0 ? "vtkTable" : this->Superclass::GetBlockOutputType(port, inputVector);
}

int vtkVolumeToSurface::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (input && input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    const int* whole = input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    try
    {
      flattening::requireVolumeMemory(whole, this->Margin);
    }
    catch (const InvalidInput&)
    {
      // One voxel, so that no reader fills the memory with what Execute() will refuse.
      const int first[6] = { whole[0], whole[0], whole[2], whole[2], whole[4], whole[4] };
      input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), first, 6);
    }
  }
  return result;
}

void vtkVolumeToSurface::RequireSettings() const
{
  if (!this->AutomaticIsovalue && !std::isfinite(this->Isovalue))
  {
    throw InvalidInput("the isovalue is not a number: give one in the units of the volume");
  }
  if (!this->AutomaticSmoothing && !(this->Smoothing >= 0.0 && std::isfinite(this->Smoothing)))
  {
    throw InvalidInput(
      "the smoothing is " + flattening::formatted(this->Smoothing) + ": give a length of 0 or more");
  }
  constexpr double greatest = std::numeric_limits<float>::max();
  if (!this->AutomaticAir && !(std::abs(this->Air) <= greatest))
  {
    throw InvalidInput(
      "the value of air is not a number that single precision holds: give one below the isovalue");
  }
}

// The chosen array, or the first one if none is chosen. A volume with one array needs no choice: scripts
// of ParaView may choose an array of the source that was active before.
vtkDataArray* vtkVolumeToSurface::VoxelsOf(vtkImageData* volume)
{
  int association = 0;
  vtkDataArray* values = this->GetInputArrayToProcess(0, volume, association);
  if (values && association == vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return values;
  }
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  const bool isChosen = name && *name && std::string(name) != "None";
  if (isChosen && volume->GetPointData()->GetNumberOfArrays() > 1)
  {
    throw InvalidInput(
      "the volume has no point array " + std::string(name) +
      ": choose another, or turn cell arrays into point arrays (Cell Data To Point Data)");
  }
  return volume->GetPointData()->GetArray(0);
}

void vtkVolumeToSurface::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  flattening::report(progress, 0.0, "Reading the volume");
  this->RequireSettings();
  if (isPart(inputVector[0]->GetInformationObject(0), input))
  {
    flattening::requireVolumeMemory(
      inputVector[0]->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()),
      this->Margin);
  }
  vtkDataArray* values = this->VoxelsOf(input);
  flattening::requireVolume(input, values);
  flattening::requireVolumeMemory(input->GetExtent(), this->Margin);

  flattening::VolumeReport done;
  flattening::FloatingVolume volume =
    flattening::inFloatingPoint(input, values, flattening::subrange(progress, 0.0, 0.1));
  done.Air = this->AutomaticAir ? volume.Range[0] : this->Air;
  flattening::fillNotFinite(volume, done.Air);
  done.NotFinite = volume.NotFinite;
  const flattening::Histogram histogram =
    flattening::histogramOf(vtkFloatArray::SafeDownCast(volume.Image->GetPointData()->GetScalars()),
      std::min(volume.Range[0], done.Air),
      std::max(volume.Range[1], done.Air),
      isWhole(values));
  done.Suggested = this->AutomaticIsovalue;
  done.Smoothing =
    this->AutomaticSmoothing ? AutomaticVoxels * flattening::voxelSize(input) : this->Smoothing;
  double isovalue =
    this->AutomaticIsovalue ? flattening::otsuThreshold(histogram).Value : this->Isovalue;
  if (done.Smoothing == 0.0 && isWhole(values) && isovalue == std::floor(isovalue))
  {
    isovalue -= 0.5;
  }
  if (this->Margin > 0 && done.Air >= isovalue)
  {
    throw InvalidInput("the value of air, " + flattening::formatted(done.Air) +
                       ", is not below the isovalue, " + flattening::formatted(isovalue) +
                       ": lower it, raise the isovalue, or set the margin to 0");
  }
  done.Classes = flattening::classesAt(histogram, isovalue);

  vtkSmartPointer<vtkImageData> image = volume.Image;
  volume.Image = nullptr; // each step frees the volume before it
  done.Margin = this->Margin;
  if (this->Margin > 0)
  {
    image = flattening::padded(image, this->Margin, done.Air, flattening::subrange(progress, 0.1, 0.2));
  }
  if (done.Smoothing > 0.0)
  {
    image = flattening::smoothed(image, done.Smoothing, flattening::subrange(progress, 0.2, 0.7));
  }
  const vtkSmartPointer<vtkPolyData> surface =
    flattening::isosurface(image, isovalue, flattening::subrange(progress, 0.7, 0.8));
  image = nullptr;
  const bool keepLargest = this->ComponentMode == LargestComponent;
  done.Components =
    flattening::takeLargestComponent(surface, keepLargest, flattening::subrange(progress, 0.8, 0.95));
  done.LeftOutArea = keepLargest ? done.Components.Whole - done.Components.Largest : 0.0;

  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  surface->GetFieldData()->PassData(input->GetFieldData());
  flattening::setFieldData(surface->GetFieldData(), done);
  if (this->PatientSpace && flattening::patientMatrix(input))
  {
    moveToPatient(surface);
  }
  output->ShallowCopy(surface);
  flattening::setReportTable(vtkTable::GetData(outputVector, 1), done);
  flattening::setHistogramTable(vtkTable::GetData(outputVector, 2), histogram, isovalue);
  if (const std::string warning = flattening::leftOutWarning(done); !warning.empty())
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << warning);
  }
  flattening::report(progress, 1.0, "Done");
}

void vtkVolumeToSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticIsovalue: " << this->AutomaticIsovalue << "\n";
  os << indent << "Isovalue: " << this->Isovalue << "\n";
  os << indent << "AutomaticSmoothing: " << this->AutomaticSmoothing << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "AutomaticAir: " << this->AutomaticAir << "\n";
  os << indent << "Air: " << this->Air << "\n";
  os << indent << "ComponentMode: " << this->ComponentMode << "\n";
  os << indent << "PatientSpace: " << this->PatientSpace << "\n";
}
