// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/RegionOutput.h"

#include "Internal/ArrayConversion.h"
#include "Internal/AttributeTransfer.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/TextureCoordinates.h"

#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace flattening
{
namespace
{

// The only original of a vertex; -1 if it is interpolated between several.
vtkIdType originalPoint(const VertexOrigins& origins, int v)
{
  const VertexOrigins::InnerIterator first(origins, v);
  return first.value() == 1.0 ? first.col() : -1;
}

} // namespace

void setRegion(vtkPolyData* output, vtkPolyData* original, const DerivedMesh& part)
{
  setTriangles(output, part.Mesh);
  std::vector<vtkIdType> points(part.Mesh.vertexCount());
  for (int v = 0; v < part.Mesh.vertexCount(); ++v)
  {
    points[v] = originalPoint(part.Vertices, v);
  }
  const std::vector<vtkIdType> cells(part.Faces.begin(), part.Faces.end());
  transferPointData(original->GetPointData(), part.Vertices, output->GetPointData());
  transferCellData(original->GetCellData(), cells, output->GetCellData());
  output->GetPointData()->AddArray(newArray<vtkIdTypeArray>(OriginalPointIdsName, points));
  output->GetCellData()->AddArray(newArray<vtkIdTypeArray>(OriginalCellIdsName, cells));
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
