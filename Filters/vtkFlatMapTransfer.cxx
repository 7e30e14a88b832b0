// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFlatMapTransfer.h"

#include "Core/Base/Errors.h"
#include "Core/FlatMap/FlatMapTransfer.h"
#include "Core/Mesh/FaceOrientation.h"
#include "Internal/FilterExecution.h"
#include "Internal/MapMeasures.h"
#include "Internal/PolyDataConversion.h"
#include "Internal/RegionOutput.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <sstream>

vtkStandardNewMacro(vtkFlatMapTransfer);

namespace
{

using flattening::TransferredMap;

void requireFaces(const TransferredMap& map)
{
  if (map.Part.Mesh.faceCount() > 0)
  {
    return;
  }
  std::ostringstream message;
  message << "no triangle of the original surface has all of its points within " << map.Tolerance
          << " of the flattened one: raise the tolerance, or set it to 0, for half of the flattened "
             "surface's mean edge length";
  throw flattening::InvalidInput(message.str());
}

// Replaces what describes the flattened surface by what holds for the map of the original one.
void setReport(vtkPolyData* output,
  const flattening::TriangleMesh& original,
  const TransferredMap& map,
  vtkIdType flipped)
{
  flattening::removeEarlierMap(output);
  vtkFieldData* data = output->GetFieldData();
  const auto count = [data](const char* name, vtkIdType value)
  { flattening::setDatum(data, name, static_cast<long long>(value)); };
  const flattening::TriangleMesh& part = map.Part.Mesh;
  count("TransferredPoints", part.vertexCount());
  count("LostPoints", original.vertexCount() - map.KeptVertices);
  count("RepeatedPoints", map.RepeatedVertices);
  count("LostCells", original.faceCount() - part.faceCount());
  count("CellsAcrossSeams", map.FacesAcrossSeams);
  count("FlippedFaces", flipped);
  flattening::setDatum(data, "SurfaceArea", flattening::faceAreas(part.Vertices, part.Faces).sum());
  flattening::setDatum(data, "LargestDistance", map.LargestDistance);
  flattening::setDatum(data, "Tolerance", map.Tolerance);
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
  requireFaces(map);
  flattening::setFlatRegion(output, original, map.Part, map.PartPositions);
  const vtkIdType flipped = flattening::countFlippedFaces(map.PartPositions, map.Part.Mesh.Faces);
  setReport(output, surface, map, flipped);
  if (flipped > 0)
  {
    vtkWarningMacro(
      << this->GetBlockPrefix() << flipped
      << " triangles of the original surface are flipped on the map, so that it is not one-to-one "
         "there: they are smaller than those of the flattened surface, beside its boundary, or oriented "
         "against their neighbours. Leave them out of what is measured (Distortion Metrics, array "
         "Flipped), or flatten the surface "
         "without Remesh");
  }
}

void vtkFlatMapTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
