// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceToDiskFilter.h"

#include "Core/Base/Errors.h"
#include "Core/Disk/SeamWayPoints.h"
#include "Core/Mesh/CoordinateFrame.h"
#include "Core/Mesh/MeshMeasures.h"
#include "Core/Regions/ScaledCurvature.h"
#include "Internal/ChosenArray.h"
#include "Internal/CutsOutput.h"
#include "Internal/DiskOutput.h"
#include "Internal/DiskReport.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/SeamLines.h"
#include "Internal/SelectedPoints.h"
#include "Internal/TriangulatedInput.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSurfaceToDiskFilter);

namespace
{

using flattening::InvalidInput;

// Coordinates with steps of a greater share of the mean edge are worth a warning. A convention: the area
// of a face is off by about as much, a tenth of a percent.
constexpr double CoarsestStep = 1e-3;

double meanEdge(const flattening::TriangleMesh& surface)
{
  const flattening::CoordinateFrame frame(surface);
  return frame.restoredLength(flattening::meanEdgeLength(frame.normalised(surface)));
}

std::string roundingWarning(double step)
{
  return "the coordinates are stored in steps of " + flattening::formatted(step) +
         ", which is much beside the edges of the surface, so that its areas are not those that were "
         "measured: store the points in double precision or nearer to the origin";
}

const char* nameOf(int mode, std::initializer_list<const char*> names)
{
  return names.begin()[mode];
}

void print(ostream& os, vtkIndent indent, const char* name, const double x[3])
{
  os << indent << name << ": (" << x[0] << ", " << x[1] << ", " << x[2] << ")\n";
}

} // namespace

vtkSurfaceToDiskFilter::vtkSurfaceToDiskFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

int vtkSurfaceToDiskFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkSurfaceToDiskFilter::SetSeamLinesConnection(vtkAlgorithmOutput* lines)
{
  this->SetInputConnection(1, lines);
}

void vtkSurfaceToDiskFilter::SetSeamLinesData(vtkPolyData* lines)
{
  this->SetInputData(1, lines);
}

void vtkSurfaceToDiskFilter::RemoveSeamLines()
{
  this->SetInputConnection(1, nullptr);
}

vtkPolyData* vtkSurfaceToDiskFilter::GetCuts()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkSurfaceToDiskFilter::GetReport()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

const char* vtkSurfaceToDiskFilter::GetBlockOutputType(int port, vtkInformationVector** inputVector)
{
  return port == 2 ? "vtkTable" : this->Superclass::GetBlockOutputType(port, inputVector);
}

void vtkSurfaceToDiskFilter::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const auto triangles = flattening::triangulate(input);
  const flattening::TriangleMesh surface = flattening::toTriangleMesh(triangles);
  const std::vector<vtkIdType> cells = flattening::cellsOf(triangles);
  flattening::SurfaceToDiskOptions options = this->GetOptions(input);
  if (this->CutMode == SEAM || this->CutMode == AUTOMATIC)
  {
    this->SetSeam(options, vtkPolyData::GetData(inputVector[1]));
  }
  else if (this->CutMode == LABEL)
  {
    options.Labelled = flattening::labelledTriangles(
      triangles, flattening::chosenArray(this, input, "the array of labels", 1), this->CutLabel);
  }
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  const double diskEnd = this->ScaledCurvature ? 0.95 : 1.0;
  const flattening::DiskSurface disk =
    flattening::surfaceToDisk(surface, options, flattening::subrange(progress, 0.0, diskEnd));
  flattening::setDisk(output, input, cells, disk);
  const flattening::SeamSegments seams = flattening::seamSegments(
    disk, options.SeamPoints.empty() ? std::optional<Eigen::Vector3d>() : options.SeamPoints.front());
  flattening::addSeamArrays(output, seams);
  if (this->ScaledCurvature)
  {
    flattening::setScaledCurvature(output,
      flattening::scaledCurvature(disk.Surface.Mesh, flattening::subrange(progress, diskEnd, 1.0)));
  }
  flattening::setCuts(vtkPolyData::GetData(outputVector, 1), output, seams);
  output->GetFieldData()->PassData(input->GetFieldData());
  flattening::setReport(output, disk.Report, input->GetNumberOfVerts() + input->GetNumberOfLines());
  flattening::setReportTable(vtkTable::GetData(outputVector, 2), disk.Report);
  for (const std::string& warning : flattening::warningsOf(disk.Report))
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << warning);
  }
  const double step =
    flattening::coordinateStep(disk.Surface.Mesh.Vertices, input->GetPoints()->GetDataType());
  if (step > CoarsestStep * meanEdge(surface))
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << roundingWarning(step));
  }
}

flattening::SurfaceToDiskOptions vtkSurfaceToDiskFilter::GetOptions(vtkPolyData* input)
{
  flattening::SurfaceToDiskOptions options;
  options.MergeTolerance = this->MergeTolerance;
  options.Banks = flattening::banksOf(input);
  options.Component.By = static_cast<flattening::ComponentChoice::Rule>(this->ComponentMode);
  options.Component.Point = Eigen::Vector3d(this->ComponentPoint);
  options.Component.Index = this->ComponentIndex;
  options.Boundary.By = static_cast<flattening::BoundaryChoice::Rule>(this->BoundaryMode);
  options.Boundary.Point = Eigen::Vector3d(this->BoundaryPoint);
  options.FillLengthLimit = this->FillLengthLimit;
  options.FlattenFolds = this->FlattenFolds;
  options.Handles = static_cast<flattening::HandleMode>(this->HandleMode);
  options.Cut = static_cast<flattening::CutMode>(this->CutMode);
  if (this->UseHolePoint)
  {
    options.Hole.Centre.emplace(this->HolePoint);
  }
  options.Hole.AreaFraction = this->HoleAreaFraction;
  options.Hole.BoundaryVertices = this->MinimumBoundaryVertices;
  options.Relief.Gain = this->ReliefGain;
  options.Relief.Longest = this->LongestRelief;
  options.FreeOutline = this->FreeOutline;
  options.Plane.Origin = Eigen::Vector3d(this->PlaneOrigin);
  options.Plane.Normal = Eigen::Vector3d(this->PlaneNormal);
  options.SmallestAngle = this->SmallestAngle;
  options.Remesh = this->Remesh;
  options.TargetEdgeLength = this->TargetEdgeLength;
  options.RelativeEdgeLength = this->RelativeEdgeLength;
  options.CountSelfIntersections = this->CountSelfIntersections;
  if (this->UseRegionOfInterest)
  {
    const flattening::ChosenArray chosen =
      flattening::chosenArray(this, input, "the region of interest");
    if (!chosen.Array)
    {
      throw InvalidInput(
        "no array is chosen for the region of interest: choose a point or cell array, or "
        "turn Use Region Of Interest off");
    }
    options.RegionOfInterest = flattening::pointsWhereNotZero(input, chosen);
  }
  return options;
}

void vtkSurfaceToDiskFilter::SetSeam(flattening::SurfaceToDiskOptions& options, vtkPolyData* lines)
{
  if (lines)
  {
    flattening::SeamLines seam = flattening::seamLines(lines);
    options.SeamPoints = std::move(seam.Points);
    options.SeamPathStarts = std::move(seam.PathStarts);
    options.SeamPointsAreDense = true;
  }
  else if (this->UseSeamPoints)
  {
    if (this->SeamPoints.empty())
    {
      throw InvalidInput("no point of the seam is given: add two or more, or turn Use Seam Points off");
    }
    for (const std::array<double, 3>& point : this->SeamPoints)
    {
      options.SeamPoints.emplace_back(point.data());
    }
    options.SeamPathStarts = this->SeamPathStarts;
  }
}

void vtkSurfaceToDiskFilter::SetNumberOfSeamPathStarts(int number)
{
  number = std::clamp(number, 0, flattening::MostSeamPoints);
  if (number != this->GetNumberOfSeamPathStarts())
  {
    this->SeamPathStarts.resize(number, 0);
    this->Modified();
  }
}

int vtkSurfaceToDiskFilter::GetNumberOfSeamPathStarts()
{
  return static_cast<int>(this->SeamPathStarts.size());
}

void vtkSurfaceToDiskFilter::SetSeamPathStart(int index, int point)
{
  if (index < 0 || index >= this->GetNumberOfSeamPathStarts())
  {
    vtkErrorMacro("there is no seam path start " << index << ": call SetNumberOfSeamPathStarts first");
  }
  else if (point != this->SeamPathStarts[index])
  {
    this->SeamPathStarts[index] = point;
    this->Modified();
  }
}

int vtkSurfaceToDiskFilter::GetSeamPathStart(int index)
{
  if (index < 0 || index >= this->GetNumberOfSeamPathStarts())
  {
    vtkErrorMacro("there is no seam path start " << index);
    return 0;
  }
  return this->SeamPathStarts[index];
}

void vtkSurfaceToDiskFilter::AddSeamPathStart(int point)
{
  this->SeamPathStarts.push_back(point);
  this->Modified();
}

void vtkSurfaceToDiskFilter::RemoveAllSeamPathStarts()
{
  this->SetNumberOfSeamPathStarts(0);
}

void vtkSurfaceToDiskFilter::SetNumberOfSeamPoints(int number)
{
  number = std::clamp(number, 0, flattening::MostSeamPoints);
  if (number != this->GetNumberOfSeamPoints())
  {
    this->SeamPoints.resize(number, { 0.0, 0.0, 0.0 });
    this->Modified();
  }
}

int vtkSurfaceToDiskFilter::GetNumberOfSeamPoints()
{
  return static_cast<int>(this->SeamPoints.size());
}

void vtkSurfaceToDiskFilter::SetSeamPoint(int index, double x, double y, double z)
{
  if (index < 0 || index >= this->GetNumberOfSeamPoints())
  {
    vtkErrorMacro("there is no seam point " << index << ": call SetNumberOfSeamPoints first");
    return;
  }
  const std::array<double, 3> point{ x, y, z };
  if (point != this->SeamPoints[index])
  {
    this->SeamPoints[index] = point;
    this->Modified();
  }
}

void vtkSurfaceToDiskFilter::SetSeamPoint(int index, const double point[3])
{
  this->SetSeamPoint(index, point[0], point[1], point[2]);
}

void vtkSurfaceToDiskFilter::GetSeamPoint(int index, double point[3])
{
  if (index < 0 || index >= this->GetNumberOfSeamPoints())
  {
    vtkErrorMacro("there is no seam point " << index);
    return;
  }
  std::copy(this->SeamPoints[index].begin(), this->SeamPoints[index].end(), point);
}

void vtkSurfaceToDiskFilter::AddSeamPoint(double x, double y, double z)
{
  this->SeamPoints.push_back({ x, y, z });
  this->Modified();
}

void vtkSurfaceToDiskFilter::RemoveAllSeamPoints()
{
  this->SetNumberOfSeamPoints(0);
}

void vtkSurfaceToDiskFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent
     << "ComponentMode: " << nameOf(this->ComponentMode, { "Largest", "ClosestToPoint", "ByIndex" })
     << "\n";
  print(os, indent, "ComponentPoint", this->ComponentPoint);
  os << indent << "ComponentIndex: " << this->ComponentIndex << "\n";
  os << indent
     << "BoundaryMode: " << nameOf(this->BoundaryMode, { "Longest", "ClosestToPoint", "FillAll" })
     << "\n";
  print(os, indent, "BoundaryPoint", this->BoundaryPoint);
  os << indent << "FillLengthLimit: " << this->FillLengthLimit << "\n";
  os << indent << "FlattenFolds: " << (this->FlattenFolds ? "on" : "off") << "\n";
  os << indent << "HandleMode: " << nameOf(this->HandleMode, { "Remove", "Cut", "Error" }) << "\n";
  os << indent
     << "CutMode: " << nameOf(this->CutMode, { "Hole", "Seam", "Plane", "Relief", "Label", "Automatic" })
     << "\n";
  os << indent << "UseHolePoint: " << (this->UseHolePoint ? "on" : "off") << "\n";
  print(os, indent, "HolePoint", this->HolePoint);
  os << indent << "HoleAreaFraction: " << this->HoleAreaFraction << "\n";
  os << indent << "UseRegionOfInterest: " << (this->UseRegionOfInterest ? "on" : "off") << "\n";
  os << indent << "UseSeamPoints: " << (this->UseSeamPoints ? "on" : "off") << "\n";
  for (const std::array<double, 3>& point : this->SeamPoints)
  {
    print(os, indent, "SeamPoint", point.data());
  }
  for (const int start : this->SeamPathStarts)
  {
    os << indent << "SeamPathStart: " << start << "\n";
  }
  os << indent << "ReliefGain: " << this->ReliefGain << "\n";
  os << indent << "LongestRelief: " << this->LongestRelief << "\n";
  os << indent << "FreeOutline: " << (this->FreeOutline ? "on" : "off") << "\n";
  os << indent << "CutLabel: " << this->CutLabel << "\n";
  print(os, indent, "PlaneOrigin", this->PlaneOrigin);
  print(os, indent, "PlaneNormal", this->PlaneNormal);
  os << indent << "MinimumBoundaryVertices: " << this->MinimumBoundaryVertices << "\n";
  os << indent << "SmallestAngle: " << this->SmallestAngle << "\n";
  os << indent << "Remesh: " << (this->Remesh ? "on" : "off") << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "RelativeEdgeLength: " << this->RelativeEdgeLength << "\n";
  os << indent << "ScaledCurvature: " << (this->ScaledCurvature ? "on" : "off") << "\n";
  os << indent << "CountSelfIntersections: " << (this->CountSelfIntersections ? "on" : "off") << "\n";
}
