// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkMeshSaliency.h"

#include "Core/Regions/MeshSaliency.h"
#include "Internal/ArrayConversion.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMeshSaliency);

namespace
{

using flattening::InvalidInput;
using flattening::TriangleMesh;

// Removes the regions that an earlier filter has found.
void removeRegions(vtkPolyData* output)
{
  output->GetPointData()->RemoveArray("SaliencyRegion");
  for (const char* name : { "SaliencyRegions", "SaliencyRegionAreas", "SaliencyThreshold" })
  {
    output->GetFieldData()->RemoveArray(name);
  }
}

void addRegions(vtkPolyData* output, const TriangleMesh& mesh, const std::vector<int>& regions)
{
  const Eigen::VectorXd areas = flattening::vertexAreas(mesh);
  const int count = regions.empty() ? 0 : *std::max_element(regions.begin(), regions.end());
  std::vector<double> regionAreas(count, 0.0);
  for (std::size_t v = 0; v < regions.size(); ++v)
  {
    if (regions[v] > 0)
    {
      regionAreas[regions[v] - 1] += areas[static_cast<Eigen::Index>(v)];
    }
  }
  output->GetPointData()->AddArray(flattening::newArray<vtkIntArray>("SaliencyRegion", regions));
  flattening::setDatum(output->GetFieldData(), "SaliencyRegions", static_cast<long long>(count));
  if (count > 0)
  {
    output->GetFieldData()->AddArray(
      flattening::newArray<vtkDoubleArray>("SaliencyRegionAreas", regionAreas));
  }
}

} // namespace

void vtkMeshSaliency::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  for (const double setting :
    { this->Unit, this->Threshold, this->MinimumRegionArea, this->MaximumRegionArea })
  {
    if (!(setting >= 0.0) || !std::isfinite(setting))
    {
      throw InvalidInput(
        "the unit, the threshold and the areas of saliency regions must not be negative or infinite");
    }
  }
  const TriangleMesh mesh = flattening::surfaceInSpace(input);
  flattening::MeshSaliencyOptions options;
  options.Unit = this->Unit;
  options.Scales = this->NumberOfScales;
  options.AreaWeighted = this->AreaWeighted;
  const flattening::MeshSaliency saliency =
    flattening::meshSaliency(mesh, options, flattening::progressOf(this));

  output->ShallowCopy(input);
  removeRegions(output);
  flattening::addPointArray(output, "Saliency", saliency.Saliency);
  output->GetPointData()->SetActiveScalars("Saliency");
  flattening::setDatum(output->GetFieldData(), "SaliencyUnit", saliency.Unit);
  if (this->PerScaleArrays)
  {
    flattening::addPointArray(output, "MeanCurvature", saliency.MeanCurvature);
    for (std::size_t i = 0; i < saliency.PerScale.size(); ++i)
    {
      flattening::addPointArray(
        output, ("SaliencyScale" + std::to_string(i + 2)).c_str(), saliency.PerScale[i]);
    }
  }
  if (this->FindRegions)
  {
    const double threshold =
      this->ThresholdType == VALUE
        ? this->Threshold
        : flattening::areaPercentile(mesh, saliency.Saliency, 0.01 * this->Percentile);
    const double largest =
      this->MaximumRegionArea > 0.0 ? this->MaximumRegionArea : std::numeric_limits<double>::infinity();
    addRegions(output,
      mesh,
      flattening::salientRegions(mesh, saliency.Saliency, threshold, this->MinimumRegionArea, largest));
    flattening::setDatum(output->GetFieldData(), "SaliencyThreshold", threshold);
  }
  flattening::report(flattening::progressOf(this), 1.0, "Done");
}

void vtkMeshSaliency::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Unit: " << this->Unit << "\n";
  os << indent << "NumberOfScales: " << this->NumberOfScales << "\n";
  os << indent << "AreaWeighted: " << this->AreaWeighted << "\n";
  os << indent << "PerScaleArrays: " << this->PerScaleArrays << "\n";
  os << indent << "FindRegions: " << this->FindRegions << "\n";
  os << indent << "ThresholdType: " << this->ThresholdType << "\n";
  os << indent << "Percentile: " << this->Percentile << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "MinimumRegionArea: " << this->MinimumRegionArea << "\n";
  os << indent << "MaximumRegionArea: " << this->MaximumRegionArea << "\n";
}
