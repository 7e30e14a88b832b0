// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlatMapTransfer.h"

#include "Core/Base/Errors.h"
#include "Core/FlatMap/FlatMapTransfer.h"
#include "Core/Mesh/DerivedMesh.h"
#include "Internal/FilterExecution.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/RegionOutput.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkFlatMapTransfer);

namespace
{

using flattening::DerivedMesh;
using flattening::TransferredMap;

// The original faces whose three vertices have a position on the map.
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
  if (faces.empty())
  {
    std::ostringstream message;
    message << "no triangle of the original surface has all of its points within " << map.Tolerance
            << " of the flattened one: raise the tolerance, or set it to 0, for half of the flattened "
               "surface's mean edge length";
    throw flattening::InvalidInput(message.str());
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

} // namespace

vtkFlatMapTransfer::vtkFlatMapTransfer()
{
  this->SetNumberOfInputPorts(2);
}

void vtkFlatMapTransfer::Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* flat = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* original = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  flattening::FlattenedSurface flattened;
  flattened.Surface = flattening::surfaceOfFlattened(flat);
  flattened.Positions = flattening::toPlanarPositions(flat);
  const flattening::TriangleMesh surface = flattening::toTriangleMesh(original);
  flattening::requireOrdinarySize(surface);
  flattening::requireOrdinarySize(flattened.Surface);
  const TransferredMap map =
    flattening::transferFlatMap(flattened, surface, this->Tolerance, flattening::progressOf(this));
  const DerivedMesh part = survivingPart(surface, map);
  const flattening::Points2 positions = positionsOf(part, map);

  flattening::setFlatRegion(output, original, part, positions);

  const auto flipped = (flattening::signedFaceAreas(positions, part.Mesh.Faces).array() <= 0.0).count();
  vtkFieldData* data = output->GetFieldData();
  const auto count = [data](const char* name, vtkIdType value)
  { flattening::setDatum(data, name, static_cast<long long>(value)); };
  count("TransferredPoints", part.Mesh.vertexCount());
  count("LostPoints", surface.vertexCount() - part.Mesh.vertexCount());
  count("LostCells", surface.faceCount() - part.Mesh.faceCount());
  count("FlippedFaces", flipped);
  flattening::setDatum(data, "LargestDistance", map.LargestDistance);
  flattening::setDatum(data, "Tolerance", map.Tolerance);
}

void vtkFlatMapTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
