// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkDistortionMetrics.h"

#include "Core/Mesh/CoordinateFrame.h"
#include "Internal/ArrayConversion.h"
#include "Internal/ChosenArray.h"
#include "Internal/FilterExecution.h"
#include "Internal/Labels.h"
#include "Internal/MapMeasures.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TextureCoordinates.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkDistortionMetrics);

namespace
{

using flattening::DistortionSummary;
using flattening::FaceDistortion;
using flattening::InvalidInput;
using flattening::TriangleMesh;

using Label = long long;
using Regions = std::map<Label, std::vector<int>>; // faces of each label

// The growth that was asked of vtkOMTAreaPreservingFilter at each vertex (n); empty if none was.
Eigen::VectorXd weightsFromTargetArea(vtkPolyData* input, const TriangleMesh& surface)
{
  vtkDataArray* targets = input->GetPointData()->GetArray("TargetArea");
  if (!targets)
  {
    return {};
  }
  if (targets->GetNumberOfComponents() != 1)
  {
    throw InvalidInput("the point array TargetArea has " +
                       std::to_string(targets->GetNumberOfComponents()) +
                       " components, not 1: run OMT Area Preserving again or turn UseTargetArea off");
  }
  Eigen::VectorXd weights =
    flattening::vertexAreas(flattening::CoordinateFrame(surface).normalised(surface));
  for (int v = 0; v < surface.vertexCount(); ++v)
  {
    const double target = targets->GetComponent(v, 0);
    if (!(target > 0.0 && std::isfinite(target)) && weights[v] > 0.0)
    {
      throw InvalidInput(
        "point " + std::to_string(v) + " has the TargetArea " + flattening::formatted(target) +
        ", not a positive number: run OMT Area Preserving again or turn UseTargetArea off");
    }
    weights[v] = weights[v] > 0.0 ? target / weights[v] : 1.0;
  }
  return weights;
}

// The label of each face (m), from labels of the faces or of the vertices.
std::vector<Label> faceLabels(const flattening::ChosenArray& chosen, const TriangleMesh& surface)
{
  const std::vector<Label> labels = flattening::labelsOf(chosen, "the region array");
  if (chosen.OnCells)
  {
    return labels;
  }
  std::vector<Label> result(surface.faceCount());
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    const Label a = labels[surface.Faces(f, 0)];
    const Label b = labels[surface.Faces(f, 1)];
    const Label c = labels[surface.Faces(f, 2)];
    result[f] = b == c ? b : a;
  }
  return result;
}

// The faces of each label; empty if no array is chosen.
Regions facesOfRegions(const flattening::ChosenArray& chosen, const TriangleMesh& surface)
{
  Regions regions;
  if (chosen.Array)
  {
    const std::vector<Label> labelOfFace = faceLabels(chosen, surface);
    for (int f = 0; f < surface.faceCount(); ++f)
    {
      regions[labelOfFace[f]].push_back(f);
    }
  }
  return regions;
}

// A row of the table.
struct Row
{
  vtkIdType Id;
  std::string Name;
  DistortionSummary Summary;
};

template <typename Array, typename Value>
void addColumn(vtkTable* table, const char* name, const std::vector<Row>& rows, const Value& valueOf)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Row& row : rows)
  {
    array->InsertNextValue(valueOf(row));
  }
  table->AddColumn(array);
}

void fillTable(vtkTable* table, const std::vector<Row>& rows)
{
  addColumn<vtkIdTypeArray>(table, "RegionId", rows, [](const Row& row) { return row.Id; });
  addColumn<vtkStringArray>(table, "Region", rows, [](const Row& row) { return row.Name; });
  addColumn<vtkIntArray>(table, "Faces", rows, [](const Row& row) { return row.Summary.Faces; });
  addColumn<vtkIntArray>(
    table, "FlippedFaces", rows, [](const Row& row) { return row.Summary.FlippedFaces; });
  addColumn<vtkIntArray>(
    table, "DegenerateFaces", rows, [](const Row& row) { return row.Summary.DegenerateFaces; });
  addColumn<vtkDoubleArray>(
    table, "AreaErrorPercent", rows, [](const Row& row) { return row.Summary.AreaErrorPercent; });

  std::vector<vtkSmartPointer<vtkDoubleArray>> columns;
  for (const Row& row : rows)
  {
    std::size_t column = 0;
    flattening::forEachValue(row.Summary,
      [&](const std::string& name, double value)
      {
        if (column == columns.size())
        {
          columns.push_back(vtkSmartPointer<vtkDoubleArray>::New());
          columns.back()->SetName(name.c_str());
        }
        columns[column++]->InsertNextValue(value);
      });
  }
  for (vtkDoubleArray* column : columns)
  {
    table->AddColumn(column);
  }
}

std::string regionName(vtkFieldData* fieldData, const char* arrayName, Label label)
{
  auto* names =
    vtkStringArray::SafeDownCast(arrayName ? fieldData->GetAbstractArray(arrayName) : nullptr);
  if (names && label >= 0 && label < names->GetNumberOfValues() && !names->GetValue(label).empty())
  {
    return names->GetValue(label);
  }
  return std::to_string(label);
}

} // namespace

vtkDistortionMetrics::vtkDistortionMetrics()
{
  this->SetNumberOfOutputPorts(2);
  this->SetRegionNamesArray("RegionNames");
}

vtkDistortionMetrics::~vtkDistortionMetrics()
{
  this->SetRegionNamesArray(nullptr);
}

vtkTable* vtkDistortionMetrics::GetSummary()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

const char* vtkDistortionMetrics::GetBlockOutputType(int port, vtkInformationVector** inputVector)
{
  return port == 1 ? "vtkTable" : this->Superclass::GetBlockOutputType(port, inputVector);
}

void vtkDistortionMetrics::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  flattening::report(progress, 0.0, "Reading the flattened surface");
  const TriangleMesh surface = flattening::surfaceOfFlattened(input);
  const flattening::Points2 flat = flattening::toPlanarPositions(input);
  const Eigen::VectorXd weights =
    this->UseTargetArea ? weightsFromTargetArea(input, surface) : Eigen::VectorXd();
  const flattening::ChosenArray chosen = this->UseRegionArray
                                           ? flattening::chosenArray(this, input, "the region array")
                                           : flattening::ChosenArray();
  const Regions regions = facesOfRegions(chosen, surface);

  const double facesBegin = this->MeasureLengths ? 0.02 : 0.2;
  const double regionsBegin = this->MeasureLengths ? 0.06 : 0.6;
  const double lengthsBegin = this->MeasureLengths ? 0.1 : 1.0;
  flattening::report(progress, facesBegin, "Measuring the faces");
  const FaceDistortion distortion = flattening::measureDistortion(surface, flat, weights);
  output->ShallowCopy(input);
  flattening::addMeasures(output, distortion);
  flattening::setTextureCoordinates(output, flat);

  flattening::report(progress, regionsBegin, "Summing up the regions");
  std::vector<Row> rows;
  for (const auto& [label, faces] : regions)
  {
    rows.push_back({ static_cast<vtkIdType>(label),
      regionName(input->GetFieldData(), this->RegionNamesArray, label),
      flattening::summariseDistortion(distortion, faces) });
  }
  rows.push_back({ -1, "Total", flattening::summariseDistortion(distortion) });
  fillTable(table, rows);
  flattening::setMeasures(output->GetFieldData(), rows.back().Summary);
  flattening::removeLengths(output);
  if (this->MeasureLengths)
  {
    flattening::LengthOptions options;
    options.Radius = this->LengthRadius;
    options.Samples = this->LengthSamples;
    flattening::addLengths(output,
      flattening::measureLengths(
        surface, flat, options, flattening::subrange(progress, lengthsBegin, 1.0)));
  }
  flattening::report(progress, 1.0, "Done");
}

void vtkDistortionMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseTargetArea: " << this->UseTargetArea << "\n";
  os << indent << "UseRegionArray: " << this->UseRegionArray << "\n";
  os << indent << "MeasureLengths: " << this->MeasureLengths << "\n";
  os << indent << "LengthRadius: " << this->LengthRadius << "\n";
  os << indent << "LengthSamples: " << this->LengthSamples << "\n";
  os << indent << "RegionNamesArray: " << (this->RegionNamesArray ? this->RegionNamesArray : "(none)")
     << "\n";
}
