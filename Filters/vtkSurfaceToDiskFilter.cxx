// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceToDiskFilter.h"

#include "AttributeTransfer.h"
#include "Core/SurfaceToDisk.h"
#include "FilterExecution.h"
#include "PolyDataConversion.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSurfaceToDiskFilter);

namespace
{

using flattening::DerivedMesh;
using flattening::InvalidInput;
using flattening::setFigure;
using flattening::SurfaceToDiskReport;

constexpr const char* OriginalPointIds = "vtkOriginalPointIds";
constexpr const char* OriginalCellIds = "vtkOriginalCellIds";

// Triangulating a polygon needs finite points, so they are checked before, by the ids the user knows.
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

// The triangles of all polygons and strips, with the input cell of each.
vtkSmartPointer<vtkPolyData> triangulate(vtkPolyData* input)
{
  requireFinitePoints(input, input->GetPolys());
  requireFinitePoints(input, input->GetStrips());

  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(input);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalCellIds);
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

void setGeometry(vtkPolyData* output, const flattening::TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    points->SetPoint(v, mesh.Vertices.row(v).data());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.faceCount(), 3 * static_cast<vtkIdType>(mesh.faceCount()));
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const vtkIdType ids[3] = { mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, 2) };
    cells->InsertNextCell(3, ids);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
}

void setAttributes(vtkPolyData* output,
  vtkPolyData* input,
  vtkIdTypeArray* cellOfTriangle,
  const DerivedMesh& disk)
{
  vtkNew<vtkIdTypeArray> pointIds;
  pointIds->SetName(OriginalPointIds);
  pointIds->SetNumberOfTuples(disk.Mesh.vertexCount());
  for (int v = 0; v < disk.Mesh.vertexCount(); ++v)
  {
    flattening::VertexOrigins::InnerIterator first(disk.Vertices, v);
    const bool kept = disk.Vertices.innerVector(v).nonZeros() == 1;
    pointIds->SetValue(v, kept ? first.col() : -1);
  }

  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName(OriginalCellIds);
  cellIds->SetNumberOfTuples(disk.Mesh.faceCount());
  vtkNew<vtkUnsignedCharArray> filled;
  filled->SetName("Filled");
  filled->SetNumberOfTuples(disk.Mesh.faceCount());
  std::vector<vtkIdType> cells(disk.Mesh.faceCount());
  for (int f = 0; f < disk.Mesh.faceCount(); ++f)
  {
    const int triangle = disk.Faces[f];
    cells[f] = triangle < 0 ? -1 : cellOfTriangle->GetValue(triangle);
    cellIds->SetValue(f, cells[f]);
    filled->SetValue(f, triangle < 0 ? 1 : 0);
  }

  flattening::transferPointData(input->GetPointData(), disk.Vertices, output->GetPointData());
  flattening::transferCellData(input->GetCellData(), cells, output->GetCellData());
  output->GetPointData()->AddArray(pointIds);
  output->GetCellData()->AddArray(cellIds);
  output->GetCellData()->AddArray(filled);
}

void setFigures(vtkFieldData* figures, const SurfaceToDiskReport& report, vtkIdType droppedCells)
{
  const auto count = [figures](const char* name, vtkIdType value)
  { setFigure(figures, name, static_cast<long long>(value)); };
  count("DroppedCells", droppedCells);
  count("MergedPoints", report.Repair.MergedPoints);
  count("UnusedPoints", report.Repair.UnusedPoints);
  count("DroppedFaces", report.Repair.DegenerateFaces + report.Repair.DuplicateFaces);
  count("DroppedDegenerateFaces", report.Repair.DegenerateFaces);
  count("DroppedDuplicateFaces", report.Repair.DuplicateFaces);
  count("SplitPoints", report.Repair.SplitPoints);
  count("Components", report.Components);
  count("DroppedComponents", report.Components - 1);
  count("ReorientedFaces", report.ReorientedFaces);
  count("Genus", report.Genus);
  count("FilledHoles", report.FilledHoles);
  setFigure(figures, "FilledArea", report.FilledArea);
  setFigure(figures, "RemeshEdgeLength", report.RemeshEdgeLength);
  vtkNew<vtkDoubleArray> centre;
  centre->SetName("HoleCentre");
  centre->SetNumberOfComponents(3);
  centre->InsertNextTuple(report.HoleCentre.data());
  figures->AddArray(centre);
  setFigure(figures, "HoleRadius", report.HoleRadius);
  setFigure(figures, "RemovedArea", report.RemovedArea);
  count("BoundaryVertices", report.BoundaryVertices);
  setFigure(figures, "BoundaryLength", report.BoundaryLength);
  setFigure(figures, "SurfaceArea", report.SurfaceArea);
}

} // namespace

int vtkSurfaceToDiskFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (flattening::isEmpty(input))
  {
    return 1;
  }
  return flattening::runFilter(this,
    outputVector,
    [&]
    {
      flattening::SurfaceToDiskOptions options;
      options.MergeTolerance = this->MergeTolerance;
      if (this->ComponentMode == CLOSEST_TO_POINT)
      {
        options.ComponentPoint.emplace(this->ComponentPoint);
      }
      if (this->UseHolePoint)
      {
        options.Hole.Centre.emplace(this->HolePoint);
      }
      options.Hole.AreaFraction = this->HoleAreaFraction;
      options.Hole.BoundaryVertices = this->MinimumBoundaryVertices;
      if (this->Remesh)
      {
        options.RemeshEdgeLength = this->TargetEdgeLength;
      }

      const auto triangles = triangulate(input);
      const flattening::DiskSurface disk = flattening::surfaceToDisk(
        flattening::toTriangleMesh(triangles), options, flattening::progressOf(this));

      setGeometry(output, disk.Surface.Mesh);
      setAttributes(output,
        input,
        vtkIdTypeArray::SafeDownCast(triangles->GetCellData()->GetArray(OriginalCellIds)),
        disk.Surface);
      output->GetFieldData()->PassData(input->GetFieldData());
      setFigures(
        output->GetFieldData(), disk.Report, input->GetNumberOfVerts() + input->GetNumberOfLines());
    });
}

void vtkSurfaceToDiskFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "ComponentMode: " << (this->ComponentMode == LARGEST ? "Largest" : "ClosestToPoint")
     << "\n";
  os << indent << "ComponentPoint: (" << this->ComponentPoint[0] << ", " << this->ComponentPoint[1]
     << ", " << this->ComponentPoint[2] << ")\n";
  os << indent << "UseHolePoint: " << (this->UseHolePoint ? "on" : "off") << "\n";
  os << indent << "HolePoint: (" << this->HolePoint[0] << ", " << this->HolePoint[1] << ", "
     << this->HolePoint[2] << ")\n";
  os << indent << "HoleAreaFraction: " << this->HoleAreaFraction << "\n";
  os << indent << "MinimumBoundaryVertices: " << this->MinimumBoundaryVertices << "\n";
  os << indent << "Remesh: " << (this->Remesh ? "on" : "off") << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
}
