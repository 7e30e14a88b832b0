// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlatMapTransfer.h"

#include "AttributeTransfer.h"
#include "Core/DerivedMesh.h"
#include "Core/FlatMapTransfer.h"
#include "FilterExecution.h"
#include "PolyDataConversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

vtkStandardNewMacro(vtkFlatMapTransfer);

namespace
{

using flattening::DerivedMesh;
using flattening::TransferredMap;

DerivedMesh survivingPart(const flattening::TriangleMesh& original, const TransferredMap& map)
{
  std::vector<int> faces;
  for (int f = 0; f < original.faceCount(); ++f)
  {
    if (map.Survived[original.Faces(f, 0)] && map.Survived[original.Faces(f, 1)] &&
        map.Survived[original.Faces(f, 2)])
    {
      faces.push_back(f);
    }
  }
  return flattening::extractFaces(original, faces);
}

flattening::Points2 positionsOf(const DerivedMesh& part, const TransferredMap& map)
{
  flattening::Points2 positions(part.Mesh.vertexCount(), 2);
  for (int v = 0; v < part.Mesh.vertexCount(); ++v)
  {
    positions.row(v) =
      map.Positions.row(flattening::VertexOrigins::InnerIterator(part.Vertices, v).col());
  }
  return positions;
}

vtkSmartPointer<vtkCellArray> cellsOf(const flattening::TriangleMesh& mesh)
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

void setAttributes(vtkPolyData* output, vtkPolyData* original, const DerivedMesh& part)
{
  vtkNew<vtkIdTypeArray> pointIds;
  pointIds->SetName("vtkOriginalPointIds");
  for (int v = 0; v < part.Mesh.vertexCount(); ++v)
  {
    pointIds->InsertNextValue(flattening::VertexOrigins::InnerIterator(part.Vertices, v).col());
  }
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName("vtkOriginalCellIds");
  for (const int f : part.Faces)
  {
    cellIds->InsertNextValue(f);
  }
  flattening::transferPointData(original->GetPointData(), part.Vertices, output->GetPointData());
  flattening::transferCellData(original->GetCellData(),
    std::vector<vtkIdType>(part.Faces.begin(), part.Faces.end()),
    output->GetCellData());
  output->GetPointData()->AddArray(pointIds);
  output->GetCellData()->AddArray(cellIds);
  flattening::addSurfacePoints(output, part.Mesh.Vertices);
  flattening::deactivateNormals(output);
}

} // namespace

vtkFlatMapTransfer::vtkFlatMapTransfer()
{
  this->SetNumberOfInputPorts(2);
}

int vtkFlatMapTransfer::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkFlatMapTransfer::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* flat = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* original = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (flattening::isEmpty(flat) || flattening::isEmpty(original))
  {
    return 1;
  }
  return flattening::runFilter(this,
    outputVector,
    [&]
    {
      flattening::FlattenedSurface flattened;
      flattened.Surface = flattening::surfaceOfFlattened(flat);
      flattened.Positions = flattening::toPlanarPositions(flat);
      const flattening::TriangleMesh surface = flattening::toTriangleMesh(original);
      const TransferredMap map =
        flattening::transferFlatMap(flattened, surface, this->Tolerance, flattening::progressOf(this));
      const DerivedMesh part = survivingPart(surface, map);
      const flattening::Points2 positions = positionsOf(part, map);

      output->SetPoints(vtk::TakeSmartPointer(flattening::newPlanarPoints(positions)));
      output->SetPolys(cellsOf(part.Mesh));
      setAttributes(output, original, part);

      const auto flipped =
        (flattening::signedFaceAreas(positions, part.Mesh.Faces).array() <= 0.0).count();
      vtkFieldData* figures = output->GetFieldData();
      const auto count = [figures](const char* name, vtkIdType value)
      { flattening::setFigure(figures, name, static_cast<long long>(value)); };
      count("TransferredPoints", part.Mesh.vertexCount());
      count("LostPoints", surface.vertexCount() - part.Mesh.vertexCount());
      count("LostCells", surface.faceCount() - part.Mesh.faceCount());
      count("FlippedFaces", flipped);
      flattening::setFigure(figures, "LargestDistance", map.LargestDistance);
      flattening::setFigure(figures, "Tolerance", map.Tolerance);
    });
}

void vtkFlatMapTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
