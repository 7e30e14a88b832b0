// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlattenRegion.h"

#include "Core/Areas/AreaPreservingDisk.h"
#include "Core/Conformal/ConformalDisk.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Regions/RegionDisk.h"
#include "Core/Remeshing/LongestEdgeBisection.h"
#include "Core/Untangling/MapPlacement.h"
#include "Internal/ArrayConversion.h"
#include "Internal/ChosenArray.h"
#include "Internal/FilterExecution.h"
#include "Internal/Labels.h"
#include "Internal/MapMeasures.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/RegionOutput.h"
#include "Internal/RegionReport.h"
#include "Internal/SelectedPoints.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkFlattenRegion);

namespace
{

using flattening::DerivedMesh;
using flattening::InvalidInput;
using flattening::RegionDisk;
using flattening::TriangleMesh;

// The least number of boundary vertices of the disk: a regular polygon of 64 corners covers 99.8 % of
// its circle, and each triangle at the boundary loses little of its area.
constexpr int FewestBoundaryVertices = 64;

// The mean length of the sides of the given faces (one flag per face); 0 without faces.
double meanEdge(const TriangleMesh& mesh, const std::vector<char>& faces)
{
  double sum = 0.0;
  double count = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; faces[f] && k < 3; ++k)
    {
      sum +=
        (mesh.Vertices.row(mesh.Faces(f, k)) - mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3))).norm();
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

// The region with the widest margin of at most four edges that leaves a disk.
// @param margin receives the width of the margin.
RegionDisk regionWithMargin(const TriangleMesh& mesh,
  const std::vector<char>& inside,
  double largestHoles,
  double& margin)
{
  constexpr int mostEdges = 4;
  const double edge = meanEdge(mesh, inside);
  for (int edges = mostEdges; edges > 0; --edges)
  {
    try
    {
      margin = edges * edge;
      return flattening::regionDisk(mesh, inside, { margin, largestHoles });
    }
    catch (const flattening::TopologyError&)
    {
      continue; // the margin meets itself, or the region is not a disk, which the last attempt reports
    }
  }
  margin = 0.0;
  return flattening::regionDisk(mesh, inside, { margin, largestHoles });
}

// The map that keeps the areas of the disk, around the origin.
flattening::AreaPreservingMap flatten(const TriangleMesh& disk,
  const flattening::ProgressCallback& progress)
{
  try
  {
    const flattening::ConformalDiskMap conformal =
      flattening::conformalDiskMap(disk, {}, flattening::subrange(progress, 0.1, 0.4));
    flattening::AreaPreservingMap map = flattening::areaPreservingDiskMap(
      disk, conformal.Positions, {}, {}, flattening::subrange(progress, 0.4, 0.7))
                                          .Map;
    const double scale = std::sqrt(flattening::faceAreas(disk.Vertices, disk.Faces).sum() / EIGEN_PI);
    flattening::PlacedMap placed = flattening::placeMap(
      disk, flattening::requireDisk(disk), map.Positions, { scale, Eigen::RowVector2d::Zero() });
    map.Positions = std::move(placed.Positions);
    map.FlippedFaces = placed.FlippedFaces;
    map.Bijective &= placed.FlippedFaces == 0;
    return map;
  }
  catch (const flattening::ConvergenceError&) // its remedies are settings that this filter does not have
  {
    throw flattening::ConvergenceError(
      "no flat map of the region was found, as it has slivers, thin protrusions or points that nearly "
      "coincide: set a wider Margin, or remesh the surface before (Surface To Disk, Remesh)");
  }
}

// Refines the boundary if it has too few vertices for a circle.
RegionDisk withFineBoundary(RegionDisk region)
{
  const std::vector<char> before = region.InRegion;
  DerivedMesh finer = flattening::refineBoundary(region.Disk.Mesh, FewestBoundaryVertices);
  region.InRegion.resize(finer.Faces.size());
  std::transform(finer.Faces.begin(),
    finer.Faces.end(),
    region.InRegion.begin(),
    [&before](int f) { return before[f]; });
  flattening::follow(region.Disk, std::move(finer));
  return region;
}

void setReport(vtkFieldData* data,
  const RegionDisk& region,
  double margin,
  const flattening::AreaPreservingMap& map)
{
  const auto count = [data](const char* name, int value)
  { flattening::setDatum(data, name, static_cast<long long>(value)); };
  count("RegionPieces", region.Pieces);
  count("FilledHoles", region.FilledHoles);
  count("FlippedFaces", map.FlippedFaces);
  count("Bijective", map.Bijective ? 1 : 0);
  flattening::setDatum(data, "Margin", margin);
  flattening::setDatum(data, "DroppedArea", region.DroppedArea);
  flattening::setDatum(data, "FilledArea", region.FilledArea);
  flattening::setDatum(data, "MaxCellAreaError", map.MaxCellError);
}

} // namespace

vtkFlattenRegion::vtkFlattenRegion()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkTable* vtkFlattenRegion::GetMeasures()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkFlattenRegion::GetCurves()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkFlattenRegion::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

const char* vtkFlattenRegion::GetBlockOutputType(int port, vtkInformationVector** inputVector)
{
  return port == 1 ? "vtkTable" : this->Superclass::GetBlockOutputType(port, inputVector);
}

std::vector<char> vtkFlattenRegion::LabelledFaces(vtkPolyData* input, const TriangleMesh& mesh)
{
  const flattening::ChosenArray chosen = flattening::chosenArray(this, input);
  if (!chosen.Array)
  {
    throw InvalidInput("no array of labels is chosen: choose a point or cell array, or select triangles "
                       "on the map and set Region From to Selection");
  }
  const std::vector<long long> labels = flattening::labelsOf(chosen);
  std::vector<char> inside(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    int corners = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int element = chosen.OnCells ? f : mesh.Faces(f, k);
      corners += labels[element] == this->Label;
    }
    inside[f] = corners >= 2;
  }
  if (std::none_of(inside.begin(), inside.end(), [](char in) { return in; }))
  {
    throw InvalidInput("no triangle has the label " + std::to_string(this->Label) + "; there are " +
                       flattening::listed(labels));
  }
  return inside;
}

void vtkFlattenRegion::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const flattening::ProgressCallback progress = flattening::progressOf(this);
  flattening::report(progress, 0.0, "Cutting the region out");
  const TriangleMesh mesh = flattening::surfaceInSpace(input);
  const std::vector<char> inside =
    this->RegionFrom == SELECTION
      ? flattening::cellsInSelection(input, vtkSelection::GetData(inputVector[1]))
      : this->LabelledFaces(input, mesh);
  double margin = this->Margin;
  const RegionDisk region = withFineBoundary(
    this->AutomaticMargin ? regionWithMargin(mesh, inside, this->LargestHoles, margin)
                          : flattening::regionDisk(mesh, inside, { margin, this->LargestHoles }));
  const TriangleMesh& disk = region.Disk.Mesh;

  const flattening::AreaPreservingMap map = flatten(disk, progress);
  const flattening::Points2& positions = map.Positions;

  const flattening::RegionReport measures =
    flattening::measureRegion(region, positions, flattening::subrange(progress, 0.7, 1.0));
  flattening::setFlatRegion(output, input, region.Disk, positions);
  flattening::removeEarlierMap(output);
  output->GetCellData()->AddArray(
    flattening::newArray<vtkUnsignedCharArray>("InRegion", region.InRegion));
  flattening::fillMeasures(
    vtkTable::GetData(outputVector, 1), measures, this->LengthUnit, output->GetFieldData());
  flattening::fillCurves(vtkPolyData::GetData(outputVector, 2), measures, disk, positions);
  setReport(output->GetFieldData(), region, margin, map);
  if (const std::string warning = flattening::leftOutWarning(region, measures); !warning.empty())
  {
    vtkWarningMacro(<< this->GetBlockPrefix() << warning);
  }
  flattening::report(progress, 1.0, "Done");
}

void vtkFlattenRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RegionFrom: " << this->RegionFrom << "\n";
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "AutomaticMargin: " << this->AutomaticMargin << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "LargestHoles: " << this->LargestHoles << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
}
