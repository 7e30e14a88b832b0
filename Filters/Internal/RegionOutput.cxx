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

void setRegion(vtkPolyData* output,
  vtkPolyData* original,
  const DerivedMesh& part,
  const std::vector<vtkIdType>& cells)
{
  std::vector<vtkIdType> originalPoints(part.Mesh.vertexCount(), -1);
  for (int v = 0; v < part.Mesh.vertexCount(); ++v)
  {
    if (part.Vertices.innerVector(v).nonZeros() == 1)
    {
      originalPoints[v] = VertexOrigins::InnerIterator(part.Vertices, v).col();
    }
  }
  std::vector<vtkIdType> originalCells(part.Faces.begin(), part.Faces.end());
  for (vtkIdType& cell : originalCells)
  {
    cell = cell < 0 || cells.empty() ? cell : cells[cell];
  }
  setTriangles(output, part.Mesh);
  transferPointData(original->GetPointData(), part.Vertices, output->GetPointData());
  transferCellData(original->GetCellData(), originalCells, output->GetCellData());
  output->GetPointData()->AddArray(newArray<vtkIdTypeArray>(OriginalPointIdsName, originalPoints));
  output->GetCellData()->AddArray(newArray<vtkIdTypeArray>(OriginalCellIdsName, originalCells));
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
