// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/DiskOutput.h"

#include "Core/Mesh/ClosestPointWalk.h"
#include "Internal/AttributeTransfer.h"
#include "Internal/PolyDataConversion.h"

#include <Eigen/Geometry>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

namespace flattening
{
namespace
{

void setGeometry(vtkPolyData* output, const TriangleMesh& mesh)
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

// A vector along the normal of each face.
Points3 faceSides(const TriangleMesh& mesh)
{
  Points3 sides(mesh.faceCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::RowVector3d corner = mesh.Vertices.row(mesh.Faces(f, 0));
    sides.row(f) =
      (mesh.Vertices.row(mesh.Faces(f, 1)) - corner).cross(mesh.Vertices.row(mesh.Faces(f, 2)) - corner);
  }
  return sides;
}

// Turns over the normals that point away from @p sides, as they do where faces were turned over: the
// surface would be drawn black there.
void turnNormals(vtkDataArray* normals, const Points3& sides)
{
  for (Eigen::Index i = 0; i < sides.rows(); ++i)
  {
    Eigen::Vector3d normal;
    normals->GetTuple(i, normal.data());
    if (normal.dot(sides.row(i)) < 0.0)
    {
      normal = -normal;
      normals->SetTuple(i, normal.data());
    }
  }
}

void addFlags(vtkDataSetAttributes* attributes, const char* name, const std::vector<char>& flags)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(flags.size()));
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), flags[i]);
  }
  attributes->AddArray(array);
}

void addIds(vtkDataSetAttributes* attributes, const char* name, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), ids[i]);
  }
  attributes->AddArray(array);
}

void setVector(vtkFieldData* figures, const char* name, const Eigen::Vector3d& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(value.data());
  figures->AddArray(array);
}

void setLengths(vtkFieldData* figures, const char* name, const std::vector<double>& lengths)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double length : lengths)
  {
    array->InsertNextValue(length);
  }
  figures->AddArray(array);
}

} // namespace

void setDisk(vtkPolyData* output,
  vtkPolyData* input,
  const std::vector<vtkIdType>& cellOfTriangle,
  const DiskSurface& disk)
{
  const DerivedMesh& surface = disk.Surface;
  std::vector<vtkIdType> points(surface.Mesh.vertexCount(), -1);
  for (int v = 0; v < surface.Mesh.vertexCount(); ++v)
  {
    if (surface.Vertices.innerVector(v).nonZeros() == 1)
    {
      points[v] = VertexOrigins::InnerIterator(surface.Vertices, v).col();
    }
  }
  std::vector<vtkIdType> cells(surface.Mesh.faceCount(), -1);
  std::vector<char> filled(surface.Mesh.faceCount(), 1);
  for (int f = 0; f < surface.Mesh.faceCount(); ++f)
  {
    if (surface.Faces[f] >= 0)
    {
      cells[f] = cellOfTriangle[surface.Faces[f]];
      filled[f] = 0;
    }
  }

  setGeometry(output, surface.Mesh);
  transferPointData(input->GetPointData(), surface.Vertices, output->GetPointData());
  transferCellData(input->GetCellData(), cells, output->GetCellData());
  if (vtkDataArray* normals = output->GetPointData()->GetNormals())
  {
    turnNormals(normals, vertexNormals(surface.Mesh));
  }
  if (vtkDataArray* normals = output->GetCellData()->GetNormals())
  {
    turnNormals(normals, faceSides(surface.Mesh));
  }
  addIds(output->GetPointData(), OriginalPointIdsName, points);
  addFlags(output->GetPointData(), "Seam", disk.Seam);
  addIds(output->GetCellData(), OriginalCellIdsName, cells);
  addFlags(output->GetCellData(), "Filled", filled);
}

void setReport(vtkPolyData* output, const SurfaceToDiskReport& report, vtkIdType droppedCells)
{
  vtkFieldData* figures = output->GetFieldData();
  const auto count = [figures](const char* name, vtkIdType value)
  { setDatum(figures, name, static_cast<long long>(value)); };
  const auto measure = [figures](const char* name, double value) { setDatum(figures, name, value); };
  count("DroppedCells", droppedCells);
  count("MergedPoints", report.Repair.MergedPoints);
  count("UnusedPoints", report.Repair.UnusedPoints);
  count("DroppedFaces", report.Repair.DegenerateFaces + report.Repair.DuplicateFaces);
  count("DroppedDegenerateFaces", report.Repair.DegenerateFaces);
  count("DroppedDuplicateFaces", report.Repair.DuplicateFaces);
  count("ClosedCracks", report.Repair.ClosedCracks);
  count("SplitPoints", report.Repair.SplitPoints);
  count("Components", report.Components);
  count("DroppedComponents", report.Components - 1);
  measure("DroppedComponentArea", report.DroppedComponentArea);
  count("ReorientedFaces", report.ReorientedFaces);
  count("RemovedSpikes", report.Folds.Spikes);
  count("RemovedFins", report.Folds.Fins);
  count("LeftFolded", report.Folds.LeftFolded);
  measure("FoldAreaChange", report.Folds.AreaChange);
  count("FilledHoles", report.FilledHoles);
  measure("FilledArea", report.FilledArea);
  count("Genus", report.Genus);
  count("RemovedHandles", report.Handles.Handles);
  setLengths(figures, "HandleLoopLengths", report.Handles.LoopLengths);
  measure("HandleAreaRemoved", report.Handles.RemovedArea);
  measure("HandleAreaAdded", report.Handles.AddedArea);
  measure("HandleDisplacement", report.Handles.GreatestDisplacement);
  measure("RemeshEdgeLength", report.RemeshEdgeLength);
  setVector(figures, "HoleCentre", report.HoleCentre);
  measure("HoleRadius", report.HoleRadius);
  measure("SeamLength", report.SeamLength);
  measure("RemovedArea", report.RemovedArea);
  count("RemovedRegionPoints", report.RemovedRegionPoints);
  count("SeamRegionPoints", report.SeamRegionPoints);
  count("BoundaryVertices", report.BoundaryVertices);
  measure("BoundaryLength", report.BoundaryLength);
  measure("SurfaceArea", report.SurfaceArea);
  measure("SmallestAngle", report.SmallestAngle);
  count("SelfIntersectionsBefore", report.SelfIntersectionsBefore);
  count("SelfIntersections", report.SelfIntersections);
}

} // namespace flattening
