// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/DiskOutput.h"

#include "Core/Mesh/ClosestPointWalk.h"
#include "Internal/ArrayConversion.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/RegionOutput.h"

#include <Eigen/Geometry>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace flattening
{
namespace
{

// A vector along the normal of each face (m x 3).
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

// Reverses the normals that point away from @p sides, as they do where faces were reoriented: the
// surface would be drawn black there.
void alignNormals(vtkDataArray* normals, const Points3& sides)
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

} // namespace

void setDisk(vtkPolyData* output,
  vtkPolyData* input,
  const std::vector<vtkIdType>& cellOfTriangle,
  const DiskSurface& disk)
{
  const DerivedMesh& surface = disk.Surface;
  setRegion(output, input, surface, cellOfTriangle);
  if (vtkDataArray* normals = output->GetPointData()->GetNormals())
  {
    alignNormals(normals, vertexNormals(surface.Mesh));
  }
  if (vtkDataArray* normals = output->GetCellData()->GetNormals())
  {
    alignNormals(normals, faceSides(surface.Mesh));
  }
  std::vector<char> filled(surface.Faces.size());
  std::transform(
    surface.Faces.begin(), surface.Faces.end(), filled.begin(), [](int origin) { return origin < 0; });
  output->GetPointData()->AddArray(newArray<vtkUnsignedCharArray>("Seam", disk.Seam));
  output->GetCellData()->AddArray(newArray<vtkUnsignedCharArray>("Filled", filled));
}

std::vector<char> banksOf(vtkPolyData* input)
{
  auto* seam = vtkUnsignedCharArray::SafeDownCast(input->GetPointData()->GetArray("Seam"));
  if (!seam || seam->GetNumberOfComponents() != 1)
  {
    return {};
  }
  return { seam->GetPointer(0), seam->GetPointer(0) + seam->GetNumberOfTuples() };
}

void setScaledCurvature(vtkPolyData* disk, const Eigen::VectorXd& curvature)
{
  constexpr const char* name = "ScaledCurvature";
  addPointArray(disk, name, curvature);
  vtkDataArray* scalars = disk->GetPointData()->GetScalars();
  double range[2] = { 0.0, 0.0 };
  if (scalars)
  {
    scalars->GetRange(range, scalars->GetNumberOfComponents() > 1 ? -1 : 0);
  }
  if (!(range[0] < range[1]))
  {
    disk->GetPointData()->SetActiveScalars(name);
  }
}

void setReport(vtkPolyData* output, const SurfaceToDiskReport& report, vtkIdType droppedCells)
{
  vtkFieldData* data = output->GetFieldData();
  const auto count = [data](const char* name, vtkIdType value)
  { setDatum(data, name, static_cast<long long>(value)); };
  const auto measure = [data](const char* name, double value) { setDatum(data, name, value); };
  count("DroppedCells", droppedCells);
  count("MergedPoints", report.Repair.MergedPoints);
  count("UnusedPoints", report.Repair.UnusedPoints);
  count("DroppedFaces", report.Repair.DegenerateFaces + report.Repair.DuplicateFaces);
  count("DroppedDegenerateFaces", report.Repair.DegenerateFaces);
  count("DroppedDuplicateFaces", report.Repair.DuplicateFaces);
  count("ClosedCracks", report.Repair.ClosedTJunctions);
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
  data->AddArray(newArray<vtkDoubleArray>("HandleLoopLengths", report.Handles.LoopLengths));
  measure("HandleAreaRemoved", report.Handles.RemovedArea);
  measure("HandleAreaAdded", report.Handles.AddedArea);
  measure("HandleDisplacement", report.Handles.GreatestDisplacement);
  measure("RemeshEdgeLength", report.RemeshEdgeLength);
  measure("RemeshAreaChange", report.RemeshAreaChange);
  data->AddArray(newTuples<vtkDoubleArray>("HoleCentre", report.HoleCentre.transpose()));
  measure("HoleRadius", report.HoleRadius);
  measure("SeamLength", report.SeamLength);
  count("ChosenCut", report.ChosenCut ? static_cast<vtkIdType>(*report.ChosenCut) : -1);
  setDatum(data, "ReasonOfCut", report.ReasonOfCut);
  count("ReliefBranches", report.ReliefBranches);
  measure("ReliefLength", report.ReliefLength);
  data->AddArray(newTuples<vtkDoubleArray>(
    "ReliefStrain", Eigen::RowVector2d(report.ReliefStrain[0], report.ReliefStrain[1])));
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
