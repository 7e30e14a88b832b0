// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkAreaWeights.h"

#include "Core/Regions/RegionWeights.h"
#include "Internal/ArrayConversion.h"
#include "Internal/ChosenArray.h"
#include "Internal/FilterExecution.h"
#include "Internal/Labels.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/SelectedPoints.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImplicitFunction.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkAreaWeights);

namespace
{

// A guard: sums and products of such weights with areas are finite and not 0.
constexpr double GreatestWeight = 1e100;

using flattening::InvalidInput;
using flattening::TriangleMesh;
using flattening::WeightedRegion;

constexpr const char* WeightsName = "AreaWeight";
constexpr long long NoLabel = VTK_LONG_LONG_MIN; // of points that no cell uses

// The weights of an earlier filter (n); all 1 if the input has none.
Eigen::VectorXd earlierWeights(vtkPolyData* input)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(input->GetNumberOfPoints());
  vtkDataArray* array = input->GetPointData()->GetArray(WeightsName);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    weights[i] = array->GetComponent(i, 0);
    if (!(weights[i] > 0.0) || !std::isfinite(weights[i]) || array->GetNumberOfComponents() != 1)
    {
      throw InvalidInput("the input's AreaWeight is not a positive number at point " +
                         std::to_string(i) + ": remove or rename that array");
    }
  }
  return weights;
}

// Values of the cells (m), averaged to the points by area (n).
std::vector<double> averaged(const TriangleMesh& mesh, const std::vector<double>& valuesOfCells)
{
  const Eigen::VectorXd areas = flattening::faceAreas(mesh.Vertices, mesh.Faces);
  const Eigen::Map<const Eigen::VectorXd> values(
    valuesOfCells.data(), static_cast<Eigen::Index>(valuesOfCells.size()));
  const Eigen::VectorXd sums =
    flattening::vertexAreas(mesh.Faces, areas.cwiseProduct(values), mesh.vertexCount());
  const Eigen::VectorXd shares = flattening::vertexAreas(mesh.Faces, areas, mesh.vertexCount());
  // A point that no face uses, or faces without area alone, gets 1.
  const Eigen::VectorXd means =
    (shares.array() > 0.0).select(sums.array() / shares.array(), Eigen::ArrayXd::Ones(shares.size()));
  return { means.begin(), means.end() };
}

constexpr std::array<const char*, 3> RegionReport = { "RegionPoints", "RegionArea", "RegionFlatArea" };

void setRegionReport(vtkFieldData* data,
  const std::vector<WeightedRegion>& regions,
  const Eigen::VectorXd& surfaceAreas,
  const Eigen::VectorXd& weights)
{
  const double scale = surfaceAreas.sum() / surfaceAreas.dot(weights);
  long long count = 0;
  double area = 0.0;
  double flatArea = 0.0;
  for (Eigen::Index v = 0; v < weights.size(); ++v)
  {
    if (std::any_of(
          regions.begin(), regions.end(), [v](const WeightedRegion& r) { return r.Inside[v] != 0; }))
    {
      ++count;
      area += surfaceAreas[v];
      flatArea += scale * weights[v] * surfaceAreas[v];
    }
  }
  flattening::setDatum(data, RegionReport[0], count);
  flattening::setDatum(data, RegionReport[1], area);
  flattening::setDatum(data, RegionReport[2], flatArea);
}

} // namespace

vtkAreaWeights::vtkAreaWeights()
  : TransferCurve(vtkSmartPointer<vtkPiecewiseFunction>::New())
{
  this->SetNumberOfInputPorts(2);
}

vtkAreaWeights::~vtkAreaWeights() = default;

int vtkAreaWeights::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

vtkMTimeType vtkAreaWeights::GetMTime()
{
  vtkMTimeType time = std::max(this->Superclass::GetMTime(), this->TransferCurve->GetMTime());
  return this->ImplicitFunction ? std::max(time, this->ImplicitFunction->GetMTime()) : time;
}

void vtkAreaWeights::AddLabelFactor(double label, double factor)
{
  this->LabelFactors.emplace_back(label, factor);
  this->Modified();
}

void vtkAreaWeights::ClearLabelFactors()
{
  this->LabelFactors.clear();
  this->Modified();
}

void vtkAreaWeights::AddCurvePoint(double value, double factor)
{
  this->TransferCurve->AddPoint(value, factor);
  this->Modified();
}

void vtkAreaWeights::ClearCurve()
{
  this->TransferCurve->RemoveAllPoints();
  this->Modified();
}

vtkPiecewiseFunction* vtkAreaWeights::GetTransferCurve()
{
  return this->TransferCurve;
}

void vtkAreaWeights::SetImplicitFunction(vtkImplicitFunction* function)
{
  if (this->ImplicitFunction != function)
  {
    this->ImplicitFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkAreaWeights::GetImplicitFunction()
{
  return this->ImplicitFunction;
}

flattening::ChosenArray vtkAreaWeights::RequireArray(vtkPolyData* input)
{
  const flattening::ChosenArray chosen = flattening::chosenArray(this, input);
  if (!chosen.Array)
  {
    throw InvalidInput("no array is chosen to take the weights from: choose a point or cell array, or "
                       "select points and set Weights From to Selection");
  }
  return chosen;
}

std::vector<WeightedRegion> vtkAreaWeights::LabelRegions(vtkPolyData* input, const TriangleMesh& mesh)
{
  const flattening::ChosenArray chosen = this->RequireArray(input);
  std::vector<long long> labels = flattening::labelsOf(chosen);
  if (chosen.OnCells)
  {
    labels = flattening::vertexLabels(mesh, labels, NoLabel);
  }
  std::vector<std::pair<double, double>> table = this->LabelFactors;
  if (this->WeightsFrom == LABEL)
  {
    table.assign(1, { this->Label, this->Factor });
  }
  if (table.empty())
  {
    throw InvalidInput("the table of labels is empty: add a row with a label and its factor");
  }
  std::vector<WeightedRegion> regions;
  std::set<double> seen;
  for (const auto& [label, factor] : table)
  {
    std::ostringstream name;
    name << "label " << std::setprecision(17) << label;
    if (!seen.insert(label).second)
    {
      throw InvalidInput(name.str() + " is in the table twice: leave one row");
    }
    WeightedRegion region{ name.str(), std::vector<char>(labels.size(), 0), factor };
    std::transform(labels.begin(),
      labels.end(),
      region.Inside.begin(),
      [label = label](long long l) { return static_cast<double>(l) == label; });
    if (std::none_of(region.Inside.begin(), region.Inside.end(), [](char inside) { return inside; }))
    {
      labels.erase(std::remove(labels.begin(), labels.end(), NoLabel), labels.end());
      throw InvalidInput("no point has the " + name.str() + "; there are " + flattening::listed(labels));
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

std::vector<char> vtkAreaWeights::EnclosedPoints(vtkPolyData* input)
{
  const char* name = this->GetInputArrayInformation(1)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* array = nullptr;
  if (name && *name && std::string(name) != "None")
  {
    array = input->GetPointData()->GetArray(name);
    if (!array || array->GetNumberOfComponents() != 3)
    {
      throw InvalidInput("there is no point array " + std::string(name) +
                         " of 3 components for the positions: choose another, or None");
    }
  }
  const flattening::Points3 positions =
    array ? flattening::toMatrix<3>(array) : flattening::pointsOf(input);
  return flattening::pointsInFunction(this->ImplicitFunction, positions, this->InsideOut);
}

std::vector<double> vtkAreaWeights::ScalarFactors(vtkPolyData* input, const TriangleMesh& mesh)
{
  const flattening::ChosenArray chosen = this->RequireArray(input);
  vtkDataArray* array = chosen.Array;
  std::vector<double> values(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values[i] = array->GetComponent(i, 0);
    if (!std::isfinite(values[i]))
    {
      throw InvalidInput("the array " + flattening::nameOf(array) + " has no number at " +
                         std::to_string(i) + ": give every point or cell a value");
    }
  }
  if (chosen.OnCells)
  {
    values = averaged(mesh, values);
  }
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const double value = values[v];
    values[v] = this->TransferCurve->GetSize() > 0 ? this->TransferCurve->GetValue(value) : value;
    if (!(values[v] > 0.0) || !std::isfinite(values[v]))
    {
      std::ostringstream text;
      text << "the factor of point " << v << " is " << values[v] << " (value " << value
           << "): factors must be positive numbers; add points to the transfer curve";
      throw InvalidInput(text.str());
    }
  }
  return values;
}

std::vector<WeightedRegion> vtkAreaWeights::ChosenRegions(vtkPolyData* input,
  vtkSelection* selection,
  const TriangleMesh& mesh)
{
  switch (this->WeightsFrom)
  {
    case SELECTION:
      return { { "the selection", flattening::pointsInSelection(input, selection), this->Factor } };
    case IMPLICIT_FUNCTION:
      return { { "the implicit function", this->EnclosedPoints(input), this->Factor } };
    default:
      return this->LabelRegions(input, mesh);
  }
}

void vtkAreaWeights::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const TriangleMesh mesh = flattening::surfaceInSpace(input);
  const Eigen::VectorXd areas = flattening::vertexAreas(mesh);
  Eigen::VectorXd weights = earlierWeights(input);
  std::vector<WeightedRegion> regions;
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  if (this->WeightsFrom == SCALARS)
  {
    const std::vector<double> factors = this->ScalarFactors(input, mesh);
    weights.array() *=
      Eigen::Map<const Eigen::ArrayXd>(factors.data(), static_cast<Eigen::Index>(factors.size()));
  }
  else
  {
    regions = this->ChosenRegions(input, vtkSelection::GetData(inputVector[1]), mesh);
    flattening::report(progress, 0.3, "Weighting the regions");
    const auto meaning = this->FactorMeaning == MAGNIFICATION
                           ? flattening::FactorMeaning::Magnification
                           : flattening::FactorMeaning::RelativeToRest;
    weights.array() *= flattening::regionWeights(mesh,
      areas.cwiseProduct(weights),
      regions,
      meaning,
      this->EdgeWidth,
      flattening::subrange(progress, 0.3, 0.9))
                         .Weights.array();
  }
  if (!(areas.sum() > 0.0))
  {
    throw InvalidInput("the surface has no area: pass a surface with triangles that are not "
                       "degenerate");
  }
  if (!(weights.array() >= 1.0 / GreatestWeight).all() || !(weights.array() <= GreatestWeight).all())
  {
    throw InvalidInput("the factors make a weight too large or too small for double precision: choose "
                       "factors between 1e-6 and 1e6");
  }
  output->ShallowCopy(input);
  flattening::addPointArray(output, WeightsName, weights);
  // ParaView proposes the active array, to colour by and as the weights of OMT Area Preserving.
  output->GetPointData()->SetActiveScalars(WeightsName);
  vtkFieldData* data = output->GetFieldData();
  for (const char* name : RegionReport) // of an earlier filter
  {
    data->RemoveArray(name);
  }
  if (!regions.empty())
  {
    setRegionReport(data, regions, areas, weights);
  }
  const auto range = flattening::magnificationRange(areas, weights);
  flattening::setDatum(data, "SmallestMagnification", range.Smallest);
  flattening::setDatum(data, "GreatestMagnification", range.Greatest);
  flattening::report(progress, 1.0, "Done");
}

void vtkAreaWeights::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WeightsFrom: " << this->WeightsFrom << "\n";
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "LabelFactors: " << this->LabelFactors.size() << "\n";
  os << indent << "TransferCurve: " << this->TransferCurve->GetSize() << " points\n";
  os << indent << "FactorMeaning: " << this->FactorMeaning << "\n";
  os << indent << "EdgeWidth: " << this->EdgeWidth << "\n";
  os << indent << "InsideOut: " << this->InsideOut << "\n";
  os << indent << "ImplicitFunction: "
     << (this->ImplicitFunction ? this->ImplicitFunction->GetClassName() : "(none)") << "\n";
}
