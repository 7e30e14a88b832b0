// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceToDiskFilter.h"

#include "Core/Base/Errors.h"
#include "Core/Mesh/CoordinateFrame.h"
#include "Core/Mesh/MeshMeasures.h"
#include "Internal/ChosenArray.h"
#include "Internal/DiskOutput.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/SelectedPoints.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSurfaceToDiskFilter);

namespace
{

using flattening::InvalidInput;

// Coordinates with steps of a greater share of the mean edge are worth a warning. A convention: the area
// of a face is off by about as much, a tenth of a percent.
constexpr double CoarsestStep = 1e-3;

// A hole of fewer mean triangles is worth a warning. Measured on spheres with a hole of 0.1 % of the
// area: 31 % of the triangles keep their areas within 2 % with a hole as large as 0.7 of them, 75 % with
// 10, 92 % with 39, and 98 % on a brain with 260.
constexpr double FewestHoleFaces = 50.0;

// Checks the points of the cells before triangulation, which needs finite points and changes the ids of
// the cells.
void requireFinitePoints(vtkPolyData* input, vtkCellArray* cells)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= input->GetNumberOfPoints())
      {
        throw InvalidInput("a cell names point " + std::to_string(ids[i]) +
                           ", which does not exist: the data set is damaged");
      }
      double x[3];
      input->GetPoint(ids[i], x);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        throw InvalidInput("point " + std::to_string(ids[i]) +
                           " has a coordinate that is not finite: remove such points first, e.g. with "
                           "Threshold or Extract Selection");
      }
    }
  }
}

// The triangles of all polygons and strips, with the id of the input cell of each.
vtkSmartPointer<vtkPolyData> triangulate(vtkPolyData* input)
{
  requireFinitePoints(input, input->GetPolys());
  requireFinitePoints(input, input->GetStrips());

  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(input);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(flattening::OriginalCellIdsName);
  ids->SetNumberOfTuples(input->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    ids->SetValue(cell, cell);
  }
  bare->GetCellData()->AddArray(ids);

  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(bare);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  return triangles->GetOutput();
}

// The input cell of each triangle.
std::vector<vtkIdType> cellsOf(vtkPolyData* triangles)
{
  auto* ids =
    vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetArray(flattening::OriginalCellIdsName));
  return { ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples() };
}

std::vector<std::string> warningsOf(const flattening::SurfaceToDiskReport& report)
{
  std::vector<std::string> warnings;
  if (report.RemovedRegionPoints > 0)
  {
    warnings.push_back("the hole took " + std::to_string(report.RemovedRegionPoints) +
                       " points of the region of interest, which leaves it no other place: mark a smaller "
                       "region or lower the hole's area");
  }
  if (report.HoleFaces > 0.0 && report.HoleFaces < FewestHoleFaces)
  {
    warnings.push_back("the hole is as large as " + flattening::formatted(report.HoleFaces) +
                       " triangles only, and a flat map cannot keep the areas around so small a hole: set "
                       "Cut to Seam, or raise the hole's area, or set Remesh with a smaller edge length");
  }
  if (report.SeamRegionPoints > 0)
  {
    warnings.push_back("the cut of handles, or of a tube from end to end, runs through " +
                       std::to_string(report.SeamRegionPoints) +
                       " points of the region of interest: set Handles to Remove, or choose points for "
                       "the seam, to keep it whole");
  }
  return warnings;
}

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

void vtkSurfaceToDiskFilter::Execute(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const auto triangles = triangulate(input);
  const flattening::TriangleMesh surface = flattening::toTriangleMesh(triangles);
  const flattening::DiskSurface disk =
    flattening::surfaceToDisk(surface, this->GetOptions(input), flattening::progressOf(this));
  flattening::setDisk(output, input, cellsOf(triangles), disk);
  output->GetFieldData()->PassData(input->GetFieldData());
  flattening::setReport(output, disk.Report, input->GetNumberOfVerts() + input->GetNumberOfLines());
  for (const std::string& warning : warningsOf(disk.Report))
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << warning);
  }
  const double step = flattening::coordinateStep(input);
  if (step > CoarsestStep * meanEdge(surface))
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << roundingWarning(step));
  }
}

flattening::SurfaceToDiskOptions vtkSurfaceToDiskFilter::GetOptions(vtkPolyData* input)
{
  flattening::SurfaceToDiskOptions options;
  options.MergeTolerance = this->MergeTolerance;
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
  if (this->UseSeamPoints && this->CutMode == SEAM)
  {
    if (this->SeamPoints.empty())
    {
      throw InvalidInput("no point of the seam is given: add two or more, or turn Use Seam Points off");
    }
    for (const std::array<double, 3>& point : this->SeamPoints)
    {
      options.SeamPoints.emplace_back(point.data());
    }
  }
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

void vtkSurfaceToDiskFilter::SetNumberOfSeamPoints(int number)
{
  number = std::max(number, 0);
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
  os << indent << "CutMode: " << nameOf(this->CutMode, { "Hole", "Seam", "Plane" }) << "\n";
  os << indent << "UseHolePoint: " << (this->UseHolePoint ? "on" : "off") << "\n";
  print(os, indent, "HolePoint", this->HolePoint);
  os << indent << "HoleAreaFraction: " << this->HoleAreaFraction << "\n";
  os << indent << "UseRegionOfInterest: " << (this->UseRegionOfInterest ? "on" : "off") << "\n";
  os << indent << "UseSeamPoints: " << (this->UseSeamPoints ? "on" : "off") << "\n";
  for (const std::array<double, 3>& point : this->SeamPoints)
  {
    print(os, indent, "SeamPoint", point.data());
  }
  print(os, indent, "PlaneOrigin", this->PlaneOrigin);
  print(os, indent, "PlaneNormal", this->PlaneNormal);
  os << indent << "MinimumBoundaryVertices: " << this->MinimumBoundaryVertices << "\n";
  os << indent << "SmallestAngle: " << this->SmallestAngle << "\n";
  os << indent << "Remesh: " << (this->Remesh ? "on" : "off") << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "RelativeEdgeLength: " << this->RelativeEdgeLength << "\n";
  os << indent << "CountSelfIntersections: " << (this->CountSelfIntersections ? "on" : "off") << "\n";
}
