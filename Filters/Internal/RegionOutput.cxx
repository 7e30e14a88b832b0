// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/RegionOutput.h"

#include "Internal/AttributeTransfer.h"
#include "Internal/DiskOutput.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TextureCoordinates.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace flattening
{
namespace
{

vtkSmartPointer<vtkCellArray> cellsOf(const TriangleMesh& mesh)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(mesh.faceCount(), 3 * static_cast<vtkIdType>(mesh.faceCount()));
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const vtkIdType ids[3] = { mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, 2) };
    cells->InsertNextCell(3, ids);
  }
  return cells;
}

vtkSmartPointer<vtkPoints> pointsOf(const TriangleMesh& mesh)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    points->SetPoint(v, mesh.Vertices.row(v).data());
  }
  return points;
}

// -1 if it is made of several.
vtkIdType originalPoint(const VertexOrigins& origins, int v)
{
  const VertexOrigins::InnerIterator first(origins, v);
  return first.value() == 1.0 ? first.col() : -1;
}

} // namespace

void setRegion(vtkPolyData* output, vtkPolyData* original, const DerivedMesh& part)
{
  output->SetPoints(pointsOf(part.Mesh));
  output->SetPolys(cellsOf(part.Mesh));
  vtkNew<vtkIdTypeArray> pointIds;
  pointIds->SetName(OriginalPointIdsName);
  for (int v = 0; v < part.Mesh.vertexCount(); ++v)
  {
    pointIds->InsertNextValue(originalPoint(part.Vertices, v));
  }
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName(OriginalCellIdsName);
  for (const int f : part.Faces)
  {
    cellIds->InsertNextValue(f);
  }
  transferPointData(original->GetPointData(), part.Vertices, output->GetPointData());
  transferCellData(original->GetCellData(),
    std::vector<vtkIdType>(part.Faces.begin(), part.Faces.end()),
    output->GetCellData());
  output->GetPointData()->AddArray(pointIds);
  output->GetCellData()->AddArray(cellIds);
}

void setFlatRegion(vtkPolyData* output,
  vtkPolyData* original,
  const DerivedMesh& part,
  const Points2& positions)
{
  setRegion(output, original, part);
  output->SetPoints(vtk::TakeSmartPointer(newPlanarPoints(positions)));
  addSurfacePoints(output, part.Mesh.Vertices);
  keepSurfaceTextureCoordinates(output);
  setTextureCoordinates(output, positions);
  deactivateNormals(output);
}

} // namespace flattening
